// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_EXPANSION_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_EXPANSION_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

// A straight line from one vertex to another, across the faces that it meets.
struct Straight_arc
{
  using Index = Intrinsic_triangulation::Index;

  Index target;
  double length;
  Plane_vector position; // of the target, where the source is the origin and `start` lies along x
  Index start;           // the halfedge that starts from the source, to the right of the line; if
                         // the source is not a vertex, what `expand_through()` was given
  std::uint32_t way;     // that of the last window on the line
};

/*
 * One boundary ray of a cone: through a vertex that can be reached from the tip. A point x that is
 * seen from the tip and from the vertex is *served* by the vertex if the way over it is good
 * enough, which is the case if it saves enough of the rest of the way: |tip x| - |vertex x| >=
 * saving. Such points are the inside of a branch of a hyperbola, which is convex, and with x it
 * contains all that lies behind it, seen from the tip.
 */
struct Cone_side
{
  Plane_vector direction; // of length 1
  double distance;        // of the vertex
  double saving;          // at which the cone may end
  double large_saving;    // at which a vertex needs no arc

  Plane_vector vertex() const { return distance * direction; }

  // Whether x, which is `outside` out of the cone on this side, is out of sight. Where faces have
  // no area, it may be on the ray, between the tip and the vertex, or on the ray of the other side.
  bool is_passed(const Plane_vector x, const double outside) const
  {
    constexpr double rounding = 1e-14;
    if(outside < 0)
      return false;
    const double along = dot(direction, x);
    return along >= distance || outside > rounding * std::abs(along);
  }

  bool serves(const Plane_vector x, const double distance_of_x, const double wanted) const
  {
    return distance * dot(direction, x) - (distance - wanted) * (distance + wanted) / 2 >=
           wanted * distance_of_x;
  }

  // How far along `ray`, a vector of the given length, x has to be in order to be served.
  double start_of_service(const Plane_vector ray, const double length_of_ray) const
  {
    const double gain = distance * dot(direction, ray) - saving * length_of_ray;
    return gain > 0 ? (distance - saving) * (distance + saving) / 2 / gain
                    : std::numeric_limits<double>::infinity();
  }
};

/*
 * A part of an edge that is seen from the tip.
 */
struct Window
{
  using Index = Intrinsic_triangulation::Index;

  Index halfedge;            // its edge; the face ahead is to its left
  Index left_end, right_end; // source and target of the halfedge, ...
  Plane_vector left_position, right_position;
  double left_distance, right_distance; // ... and their distances, if the filter wants them
  std::uint32_t way;                    // what the filter knows of how one gets there
};

/*
 * What is seen through a window, between two rays.
 */
struct Cone
{
  using Index = Window::Index;

  Window window;
  Cone_side left, right;
  std::uint32_t depth;          // the number of faces on the way
  Index checkpoint;             // one of the halfedges on the way
  bool has_middle = false;      // whether the next two are known
  Plane_vector middle = {0, 0}; // somewhere between the two rays
  double end_of_interest = 0;   // in multiples of `middle`: both sides serve what lies behind

  // Finds the middle, and where on it both sides serve: there, the window can be cut in two parts,
  // each of which is served by its side, so the cone may end. Where one side serves the vertex of
  // the other, it serves all that is seen. That is the case in every narrow cone.
  void find_middle()
  {
    has_middle = true;
    if(dot(left.direction, right.direction) > 0)
      middle = left.direction + right.direction;
    else // the same direction, found in a way that suits blunt angles, and a straight one
      middle = {left.direction.y - right.direction.y, right.direction.x - left.direction.x};
    if(left.serves(right.vertex(), right.distance, left.large_saving) ||
       right.serves(left.vertex(), left.distance, right.large_saving))
    {
      end_of_interest = 0;
      return;
    }
    const double length_of_middle = length(middle);
    end_of_interest = (std::max)(left.start_of_service(middle, length_of_middle),
                                 right.start_of_service(middle, length_of_middle));
  }
};

// What filters have in common: they look through all windows, and do not remember them.
struct Look_at_everything
{
  static constexpr bool wants_distances = false;
  static constexpr bool wants_faces = false; // to be told of, by `on_face(cone, apex)`
  static constexpr double slack =
      0; // how far out of sight vertices are seen, as part of their distance
  bool operator()(const Window& /* window */) const { return false; }
  std::uint32_t way_through(Window::Index /* halfedge */, std::uint32_t /* way */) const
  {
    return 0;
  }
};

// Leaves out arcs that a detour replaces well enough.
struct Leave_out_detours : Look_at_everything
{
  static constexpr bool leaves_out_arcs = true;
};

// Leaves out no arc that leads to a vertex in sight.
struct Leave_out_nothing : Look_at_everything
{
  static constexpr bool leaves_out_arcs = false;
};

// Sees all that others have seen, although they rounded in another way, as compilers make them do.
struct Leave_out_nothing_in_doubt : Leave_out_nothing
{
  static constexpr double slack = 1e-9;
};

/*
 * Finds the arcs of a vertex in a discrete geodesic graph: unfolds the faces around it outwards and
 * follows the cones of straight lines through them. See the user manual for why this gives the
 * error bound.
 */
template <typename Unfolding>
class Cone_expansion
{
  using Index = Intrinsic_triangulation::Index;
  using Stack = boost::container::small_vector<Cone, 32>;

  static constexpr Index null_index = Intrinsic_triangulation::null_index;

public:
  // The share of epsilon that ends cones. The whole of it would do. This is where the largest
  // errors on scanned models stay below a fourth of epsilon.
  static constexpr double SHARE_OF_ENDS = 5. / 6;

  // The share of epsilon that a detour may take which makes an arc dispensable. A larger one means
  // fewer arcs and larger errors.
  static constexpr double SHARE_OF_DETOURS = 0.1;

  Cone_expansion(const Intrinsic_triangulation& triangulation,
                 const Unfolding& unfolding,
                 const double epsilon,
                 const double share_of_detours = SHARE_OF_DETOURS)
    : m_triangulation(triangulation),
      m_unfolding(unfolding),
      m_part_saved(1 / (1 + SHARE_OF_ENDS * epsilon)),
      m_large_part_saved(1 / (1 + share_of_detours * epsilon))
  {
  }

  // Calls `f` with the arcs that start from `source`; there may be several to the same vertex.
  // Windows for which `filter(window)` is true are not looked through.
  template <typename F, typename Filter = Leave_out_detours>
  void expand(const Index source, F f, const Filter filter = Filter()) const
  {
    Stack cones;
    Cone cone{};
    for(Index h = m_triangulation.first_halfedge(source);
        h < m_triangulation.beyond_halfedge(source); ++h)
    {
      const double distance = m_triangulation.length(h);
      f(Straight_arc{m_triangulation.target(h), distance, {distance, 0}, h, 0});
      bool is_open = open_first_cone(cone, source, h, filter);
      while(is_open || pop(cones, cone))
        is_open = advance(cone, cones, source, h, f, filter);
    }
  }

  // The same for what is seen from the origin, which is not a vertex, through a window whose ends
  // have distances above 0. All arcs get `start`.
  template <typename F, typename Filter>
  void expand_through(const Window& window, const Index start, F f, const Filter filter) const
  {
    const bool has_angle = cross(window.right_position, window.left_position) > 0 ||
                           dot(window.right_position, window.left_position) < 0; // a straight one
    if(!has_angle || filter(window))
      return;
    Stack cones;
    Cone cone{window, side(window.left_position, window.left_distance),
              side(window.right_position, window.right_distance), 0, null_index};
    cone.window.way = filter.way_through(window.halfedge, 0);
    bool is_open = true;
    while(is_open || pop(cones, cone))
      is_open = advance(cone, cones, null_index, start, f, filter);
  }

private:
  static bool pop(Stack& cones, Cone& cone)
  {
    if(cones.empty())
      return false;
    cone = cones.back();
    cones.pop_back();
    return true;
  }

  Cone_side side(const Plane_vector position, const double distance) const
  {
    return {1 / distance * position, distance, m_part_saved * distance,
            m_large_part_saved * distance};
  }

  // What is seen across the face to the left of `h`, from its source. All functions that open a
  // cone or change its window return whether there is something to be seen.
  template <typename Filter>
  bool open_first_cone(Cone& cone, const Index source, const Index h, const Filter& filter) const
  {
    const Unfolded_face& face = m_unfolding.face(h);
    if(face.apex == null_index || face.right == null_index)
      return false;
    const double distance = m_triangulation.length(h);
    const bool has_angle = face.across > 0 || face.along < 0; // the latter a straight one
    if(!(distance > 0 && has_angle))
      return false;
    const double distance_of_apex =
        m_triangulation.length(m_triangulation.counterclockwise(source, h));
    const Plane_vector right{distance, 0};
    const Plane_vector left{distance * face.along, distance * face.across};
    cone.window = {face.right,       face.apex, m_triangulation.target(h),        left, right,
                   distance_of_apex, distance,  filter.way_through(face.right, 0)};
    if(filter(cone.window))
      return false;
    cone.left = side(left, distance_of_apex);
    cone.right = side(right, distance);
    cone.has_middle = false;
    cone.depth = 0;
    cone.checkpoint = null_index;
    return true;
  }

  // Takes `cone` across the face ahead of it; a second part of it goes onto the stack.
  template <typename F, typename Filter>
  bool advance(Cone& cone,
               Stack& cones,
               const Index source,
               const Index start,
               F& f,
               const Filter& filter) const
  {
    if(has_ended(cone))
      return false;
    const Unfolded_face& face = m_unfolding.face(cone.window.halfedge);
    if(face.apex == source)
      return false; // a shortest path does not come back to a face that it has left
    const Plane_vector apex =
        face.position_of_apex(cone.window.left_position, cone.window.right_position);
    if constexpr(Filter::wants_faces)
      filter.on_face(cone, apex);
    double slack = 0;
    if constexpr(Filter::slack > 0)
      slack = Filter::slack * length(apex);
    if(cone.left.is_passed(apex, cross(cone.left.direction, apex) - slack))
      return go_right(cone.window, face, apex, filter);
    if(cone.right.is_passed(apex, cross(apex, cone.right.direction) - slack))
      return go_left(cone.window, face, apex, filter);

    const double distance = length(apex);
    if(!(distance > 0)) // the apex is where the source is, and sees the same
    {
      f(Straight_arc{face.apex, 0, apex, start, cone.window.way});
      return false;
    }
    if constexpr(Filter::leaves_out_arcs)
    {
      const bool left = cone.left.serves(apex, distance, cone.left.large_saving);
      const bool right = cone.right.serves(apex, distance, cone.right.large_saving);
      if(left || right)
        return !(left && right) && pass(cone, face, apex, distance, left, filter);
    }
    f(Straight_arc{face.apex, distance, apex, start, cone.window.way});
    return split(cone, cones, face, apex, distance, filter);
  }

  // Whether nothing that lies behind the window is of interest.
  static bool has_ended(Cone& cone)
  {
    if(!cone.has_middle)
      cone.find_middle();
    const Plane_vector edge = cone.window.left_position - cone.window.right_position;
    const double area = cross(cone.window.right_position, cone.window.left_position);
    const double slope = cross(cone.middle, edge);
    if(!(area >= 0 && slope > 0))
      return true; // no more than rounding errors
    return area >= cone.end_of_interest * slope || is_back(cone);
  }

  // A shortest path meets a face only once. Straight lines may do so often, where they wind round a
  // spike. To notice that they have come round again, they remember one halfedge that they met, a
  // later one each time that the way is twice as long, as Brent does to find a cycle (R. P. Brent,
  // An improved Monte Carlo factorization algorithm, 1980).
  static bool is_back(Cone& cone)
  {
    if(cone.window.halfedge == cone.checkpoint)
      return true;
    if((cone.depth & (cone.depth + 1)) == 0)
      cone.checkpoint = cone.window.halfedge;
    ++cone.depth;
    return false;
  }

  // The window becomes part of the edge between the apex and the right end.
  template <typename Filter>
  static bool
  go_right(Window& window, const Unfolded_face& face, const Plane_vector apex, const Filter& filter)
  {
    window.halfedge = face.right;
    window.left_end = face.apex;
    window.left_position = apex;
    if(Filter::wants_distances)
      window.left_distance = length(apex);
    if(face.right == null_index || filter(window))
      return false;
    window.way = filter.way_through(face.right, window.way);
    return true;
  }

  template <typename Filter>
  static bool
  go_left(Window& window, const Unfolded_face& face, const Plane_vector apex, const Filter& filter)
  {
    window.halfedge = face.left;
    window.right_end = face.apex;
    window.right_position = apex;
    if(Filter::wants_distances)
      window.right_distance = length(apex);
    if(face.left == null_index || filter(window))
      return false;
    window.way = filter.way_through(face.left, window.way);
    return true;
  }

  // The vertex is reached over `side`, and takes its place: the ray goes through it from now on.
  static void replace(Cone_side& side, const Plane_vector position, const double distance)
  {
    const double way = length(position - side.vertex());
    side = {1 / distance * position, distance, (std::min)(side.saving + way, distance),
            (std::min)(side.large_saving + way, distance)};
  }

  // One of the sides serves the apex, and so all that is seen between the two.
  template <typename Filter>
  static bool pass(Cone& cone,
                   const Unfolded_face& face,
                   const Plane_vector apex,
                   const double distance,
                   const bool left,
                   const Filter& filter)
  {
    replace(left ? cone.left : cone.right, apex, distance);
    cone.has_middle = false;
    return left ? go_right(cone.window, face, apex, filter)
                : go_left(cone.window, face, apex, filter);
  }

  template <typename Filter>
  bool split(Cone& cone,
             Stack& cones,
             const Unfolded_face& face,
             const Plane_vector apex,
             const double distance,
             const Filter& filter) const
  {
    const Cone_side between = side(apex, distance);
    cone.has_middle = false;
    Window window = cone.window;
    if(go_right(window, face, apex, filter))
      cones.push_back({window, between, cone.right, cone.depth, cone.checkpoint});
    cone.right = between;
    return go_left(cone.window, face, apex, filter);
  }

  const Intrinsic_triangulation& m_triangulation;
  const Unfolding& m_unfolding;
  double m_part_saved;
  double m_large_part_saved;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_EXPANSION_H
