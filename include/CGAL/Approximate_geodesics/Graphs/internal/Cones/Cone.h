// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Surface/internal/Unfolding.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace CGAL::Approximate_geodesics::internal {

/*
 * When cones end, and which arcs are left out, for a given epsilon. The search for arcs, the
 * drawing of paths and the file of a graph have to agree on this.
 */
struct Cone_rules
{
  // The share of epsilon at which cones end. The error bound holds for any share up to 1. With this
  // one, the largest errors on scanned models are below a fourth of epsilon.
  static constexpr double SHARE_OF_ENDS = 5. / 6;

  // The share of epsilon by which a detour may be longer than the arc that it replaces. A larger
  // one means fewer arcs and larger errors.
  static constexpr double SHARE_OF_DETOURS = 0.08;

  // When the side of a cone turns to another vertex, the server stays if it loses at most this
  // share of the difference of its two savings: see `Cone_side::move_to()`. If the share is 0,
  // cones that run along the rows of a lattice never end; a larger one means fewer faces crossed,
  // and larger errors.
  static constexpr double SHARE_OF_BENDS = 1. / 512;

  // The share of epsilon at which cones end in a search, where labels end cones, too, with all of
  // epsilon. For a large epsilon, labels end most cones, so that a small share costs little time
  // and makes errors small.
  static double share_of_ends_beside_labels(const double epsilon)
  {
    constexpr double smallest = 0.3;
    return (std::max)(smallest, SHARE_OF_ENDS - 6 * epsilon);
  }

  explicit Cone_rules(const double bound, const double share_of_detours = SHARE_OF_DETOURS)
    : epsilon(bound), large_part_saved(1 / (1 + share_of_detours * bound))
  {
  }

  // The rules for a part of epsilon, by which cones end farther away.
  Cone_rules farther(const double part) const { return Cone_rules(part * epsilon); }

  // The largest relative error of distances from samples of what a search starts from, in place of
  // those from all of its points. It takes most of the part of epsilon that cones do not use.
  // Searches from samples that end cones by labels use no more of it than these, either.
  double largest_error_of_samples() const
  {
    constexpr double part = 0.8;
    return part * ((1 + epsilon) / longest_detour - 1);
  }

  // The bound that is left for the lines from samples: the product of both errors is within
  // epsilon.
  double epsilon_from_samples() const
  {
    return (1 + epsilon) / (1 + largest_error_of_samples()) - 1;
  }

  double epsilon;
  // as a multiple of the straight line, at which a cone may end
  double longest_detour = 1 + SHARE_OF_ENDS * epsilon;
  // of the distance of a vertex, by going over it: a cone may end ...
  double part_saved = 1 / longest_detour;
  double large_part_saved; // ... and an arc to the vertex is not needed
};

// A straight line from one vertex to another, across the faces that it meets.
struct Straight_arc
{
  Index target;
  double length;
  Plane_vector position; // of the target, where the source is the origin and `start` lies along x
  Index start;           // the halfedge that starts from the source, to the right of the line;
                         // or, if the source is not a vertex, `View::start`
  std::uint32_t trail;   // of the last window on the line
};

/*
 * One boundary ray of a cone, which goes through a vertex that can be reached from the tip. A point
 * x that is seen from the tip is *served* by a vertex, the server, if the path over it is
 * short enough, which is the case if it saves enough of the remaining length: |tip x| - |server x|
 * >= saving. Such points are the inside of a branch of a hyperbola, which is convex, and with x it
 * contains all that lies behind it, seen from the tip. At first, the server is the vertex on the
 * ray. When the ray moves on to a vertex that has no arc, the server may stay behind: see
 * `move_to()`.
 */
struct Cone_side
{
  Plane_vector direction; // of length 1
  double distance;        // of the vertex on the ray
  Plane_vector server;
  double distance_of_server;
  double saving;       // at which the cone may end
  double large_saving; // at which a vertex needs no arc

  Plane_vector vertex() const { return distance * direction; }

  // Whether x is out of sight on this side. `outside` is its distance from the ray, positive if it
  // is outside the cone. Where faces have no area, x may be on the ray between the tip and the
  // vertex, or on the ray of the other side. `Cone_bounds` has the same test without
  // branches.
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
    return dot(server, x) - (distance_of_server - wanted) * (distance_of_server + wanted) / 2 >=
           wanted * distance_of_x;
  }

  // The smallest multiple of `ray`, a vector of the given length, that is served.
  double start_of_service(const Plane_vector ray, const double length_of_ray) const
  {
    const double gain = dot(server, ray) - saving * length_of_ray;
    return gain > 0 ? (distance_of_server - saving) * (distance_of_server + saving) / 2 / gain
                    : infinity;
  }

  // Turns the ray to x, which is served with the large saving. Paths from the server to points
  // behind x may have to bend at x, which makes them longer, by at most `bend`. If that is little,
  // the server stays, and has to save that much more; if not, x becomes the server.
  void move_to(const Plane_vector x, const double distance_of_x)
  {
    direction = 1 / distance_of_x * x;
    distance = distance_of_x;
    const double way = length(x - server);
    const double bend = (std::max)(way - distance + dot(server, direction), 0.);
    const bool stays = bend <= Cone_rules::SHARE_OF_BENDS * (large_saving - saving);
    const double loss = stays ? bend : way;
    saving = (std::min)(saving + loss, distance);
    large_saving = (std::min)(large_saving + loss, distance);
    if(!stays)
    {
      server = x;
      distance_of_server = distance;
    }
  }
};

/*
 * A part of an edge that is seen from the tip.
 */
struct Window
{
  // The position of the apex of the face ahead.
  Plane_vector apex(const Unfolded_face& face, const bool has_vector) const
  {
    return has_vector ? left_position + face.left_side(edge)
                      : face.position_of_apex(left_position, right_position);
  }

  // Moves to a side of that face. Does not change distances.
  void go_on(const Intrinsic_triangulation& triangulation,
             const Unfolded_face& face,
             const Plane_vector apex,
             const bool goes_left,
             const bool has_vector)
  {
    if(has_vector)
      edge = goes_left ? face.left_side(edge) : right_side(triangulation, halfedge, face, edge);
    (goes_left ? right_end : left_end) = face.apex;
    (goes_left ? right_position : left_position) = apex;
    halfedge = goes_left ? face.left : face.right;
  }

  Index halfedge;            // its edge; the face ahead is to its left
  Index left_end, right_end; // source and target of the halfedge, ...
  Plane_vector left_position, right_position;
  double left_distance, right_distance; // ... and their distances, if the visitor wants them
  Plane_vector edge;   // from left to right, more accurate than positions: see `Cone_expansion`
  std::uint32_t trail; // the windows before it, as the visitor records them
};

// What a vertex sees across the face to the left of `h`, a halfedge that starts there and lies
// along x.
inline Window window_across(const Intrinsic_triangulation& triangulation,
                            const Index source,
                            const Index h,
                            const Unfolded_face& face)
{
  const double distance = triangulation.length(h);
  const Plane_vector right{distance, 0};
  return {face.right,
          face.apex,
          triangulation.target(h),
          {distance * face.along, distance * face.across},
          right,
          triangulation.length(triangulation.counterclockwise(source, h)),
          distance,
          {},
          0};
}

// What a point sees through a side of a face that contains it.
struct View
{
  Window window;
  Index start; // the opposite of the window's halfedge, inside the face
};

/*
 * What is seen through a window, between two rays.
 */
struct Cone
{
  Window window;
  Cone_side left, right;
  std::uint32_t depth;          // the number of faces on the way
  Crossing milestone;           // one of the halfedges on the way
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
    else // the same direction, accurate for obtuse and straight angles
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

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_CONES_CONE_H
