// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_FRONTS_H
#define CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_FRONTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Lines_from_curve.h>
#include <CGAL/Approximate_geodesics/Graphs/internal/Saddles/Lines_of_sight.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The waves that cross a face from one of its sides. The frame is that of the side's halfedge: its
 * source is the origin, its target is on the x axis, and the face is to the left.
 */

// The direction of a ray, in single precision: there are many. A point that is beyond the ray, but
// seen by mistake, is farther away than it seems by the square of that precision.
struct Short_vector
{
  float x = 0, y = 0;

  Short_vector() = default;

  explicit Short_vector(const Plane_vector v)
  {
    const double l = length(v);
    x = l > 0 ? static_cast<float>(v.x / l) : 0;
    y = l > 0 ? static_cast<float>(v.y / l) : 0;
  }

  Plane_vector vector() const { return {x, y}; }
};

// From a tip, between two rays; everywhere if these have no direction.
struct Circular_front
{
  double label;     // of the tip
  Plane_vector tip; // unfolded into the plane of the face
  Short_vector right = {}, left = {};

  double distance(const Plane_vector p) const
  {
    constexpr double rounding = 2e-7; // of angles
    const Plane_vector way = p - tip;
    const double l = length(way);
    const bool is_seen =
        cross(right.vector(), way) >= -rounding * l && cross(way, left.vector()) >= -rounding * l;
    return is_seen ? label + l : infinity;
  }
};

// From a segment of a curve, at right angles; of constant distance if the segment has no direction.
struct Straight_front
{
  double label;       // of the segment
  Plane_vector start; // unfolded into the plane of the face
  Plane_vector along; // a unit vector
  double begin, end;  // of the rays, as distances from the start

  double distance(const Plane_vector p) const
  {
    constexpr double rounding = 1e-9;
    const Plane_vector way = p - start;
    const double x = dot(way, along), height = std::abs(cross(along, way));
    const double margin = rounding * (height + end - begin);
    return x >= begin - margin && x <= end + margin ? label + height : infinity;
  }
};

// Fronts by the halfedge of their side, each list in no particular order.
template <typename Front>
class Fronts_of_sides
{
public:
  explicit Fronts_of_sides(const std::size_t number_of_halfedges)
    : m_last(number_of_halfedges, none)
  {
  }

  void add(const Index h, const Front& front)
  {
    if(m_fronts.size() >= none)
      throw std::length_error("an exact search has too many lines to keep them all");
    m_fronts.push_back({front, m_last[h]});
    m_last[h] = static_cast<std::uint32_t>(m_fronts.size() - 1);
  }

  double distance(const Index h, const Plane_vector p) const
  {
    double result = infinity;
    for(std::uint32_t i = m_last[h]; i != none; i = m_fronts[i].previous)
      result = (std::min)(result, m_fronts[i].front.distance(p));
    return result;
  }

private:
  struct Entry
  {
    Front front;
    std::uint32_t previous; // of the same side
  };

  static constexpr std::uint32_t none = std::uint32_t(-1);

  std::deque<Entry> m_fronts;
  std::vector<std::uint32_t> m_last; // by halfedge
};

/*
 * The distances of all points up to a limit, after an exact search. All lines are followed once
 * more with the final labels, and given up as in the search; each leaves a front in the faces it
 * crosses. The smallest distance that a front or a corner of the face gives is exact.
 */
template <typename Search>
class Fronts
{
  using Run = std::decay_t<decltype(std::declval<const Search&>().search().graph_run())>;
  using Labels = std::decay_t<decltype(std::declval<const Search&>().search().labels())>;

public:
  // The limit is in units of the triangulation; up to there, labels are final.
  Fronts(const Search& search, const double limit)
    : m_triangulation(search.graph().triangulation()),
      m_run(search.search().graph_run()),
      m_labels(search.search().labels()),
      m_limit(limit),
      m_circular(m_triangulation.number_of_halfedges()),
      m_straight(m_triangulation.number_of_halfedges())
  {
    for(Index v = 0; v < m_triangulation.number_of_vertices(); ++v)
      if(m_labels.is_reached(v) && m_labels.distance(v) <= limit &&
         (m_run.arrival(v).is_none() || m_run.tables().bends.is_possible(v)))
        add_vertex(v);
    for(const auto& source : search.sources())
      if(!source.point.is_vertex())
        add_point(source.point, source.distance / m_triangulation.unit());
    for(const Intrinsic_curve& curve : search.curves())
      add_curve(curve, curve.distance / m_triangulation.unit());
  }

  // At a vector from the source of `h` across the face to its left, where `h` is the x axis: the
  // smallest distance over that side or that vertex, in units of the triangulation.
  double distance(const Index h, const Plane_vector way) const
  {
    return (std::min)({bound(m_triangulation.source(h)) + length(way), m_circular.distance(h, way),
                       m_straight.distance(h, way)});
  }

private:
  // Turns vectors into the frame of a halfedge, given as a vector.
  class Frame
  {
  public:
    explicit Frame(const Plane_vector edge) : m_x_axis(unit(edge)) {}

    Plane_vector operator()(const Plane_vector v) const { return turned_right(v, m_x_axis); }

  private:
    Plane_vector m_x_axis;
  };

  // Of no length where the vector has none.
  static Plane_vector unit(const Plane_vector v)
  {
    const double l = length(v);
    return l > 0 ? 1 / l * v : Plane_vector{0, 0};
  }

  struct Visitor : Sight_visitor_base
  {
    static constexpr bool knows_arrivals = true;
    static constexpr bool wants_faces = true;

    double bound(const Index v) const { return fronts.bound(v); }
    double label(const Index v) const { return fronts.m_labels.distance(v); }
    const Arrival& arrival(const Index v) const { return fronts.m_run.arrival(v); }
    bool has_predecessor(const Index v) const
    {
      return fronts.m_labels.predecessor(v) != Intrinsic_triangulation::null_index;
    }

    void on_vertex(Index, const Sight_path&, const Sight&, Plane_vector, Plane_vector) {}
    void on_face(const Sight& sight, Plane_vector /* apex */) { fronts.add(sight, label_of_tip); }

    Fronts& fronts;
    double label_of_tip;
  };

  // Takes the lines from a curve; those to vertices are known.
  struct Curve_visitor
  {
    void operator()(Index, double, const Arrival&, const Intrinsic_point&) const {}
    void on_face(const Sight& sight) const { fronts.add(sight, label); }
    void on_face(const Strip& strip) const { fronts.add(strip, label); }

    Fronts& fronts;
    double label;
  };

  // No shortest path to a vertex is longer, or the vertex is of no interest.
  double bound(const Index v) const { return (std::min)(m_labels.distance(v), m_limit); }

  void add_vertex(const Index v)
  {
    Visitor visitor{{}, *this, m_labels.distance(v)};
    Sight_expansion<Visitor> expansion(m_run.tables(), visitor.label_of_tip, visitor);
    Vertex_sights(m_triangulation, m_run.tables())
        .for_each(
            v, m_run.arrival(v), [](Index) {},
            [&](const Sight& sight, const Index left_end, const Index right_end) {
              expansion.look(sight, left_end, right_end);
            });
  }

  void add_point(const Intrinsic_point& point, const double label)
  {
    add_around(point, label);
    Visitor visitor{{}, *this, label};
    Sight_expansion<Visitor> expansion(m_run.tables(), label, visitor);
    Lines_of_sight(m_triangulation, m_run.tables(), point)
        .for_each_sight([&](const Sight& sight, const Index left_end, const Index right_end) {
          expansion.look(sight, left_end, right_end);
        });
  }

  // In the faces of a point.
  void add_around(const Intrinsic_point& point, const double label)
  {
    Lines_of_sight(m_triangulation, m_run.tables(), point)
        .for_each_side([&](const Index side, const Face_point&, const Plane_vector start,
                           const Plane_vector end) {
          m_circular.add(side, {label, Frame(end - start)(-1. * start), {}, {}});
        });
  }

  void add_curve(const Intrinsic_curve& curve, const double label)
  {
    const Lines_from_curve lines(m_triangulation, m_run.tables());
    const auto bounds = [&](const Index v) { return bound(v); };
    for(const auto& polyline : curve.polylines)
    {
      lines.for_each_line(polyline, label, bounds, Curve_visitor{*this, label});
      for(std::size_t i = 0; i < polyline.size(); ++i)
      {
        if(!polyline[i].is_vertex())
          add_around(polyline[i], label);
        if(i > 0)
          for_each_segment(m_triangulation, polyline[i - 1], polyline[i],
                           [&](const Curve_segment& s) { add_beside(s, label); });
      }
    }
    for(const Index h : curve.faces)
      m_straight.add(h, {label, {0, 0}, {0, 0}, 0, 0});
  }

  // In the face of a segment.
  void add_beside(const Curve_segment& segment, const double label)
  {
    const Segment_layout layout(m_triangulation, segment);
    const Frame frame(layout.edge(0, 1));
    if(layout.length() > 0)
      m_straight.add(layout.halfedge(0),
                     {label, frame(-1. * layout.corner(0)), frame({1, 0}), 0, layout.length()});
  }

  void add(const Sight& sight, const double label)
  {
    check_for_interruption_at(m_number_of_sights++);
    const Frame frame(sight.edge);
    m_circular.add(sight.halfedge,
                   {label, frame(-1. * sight.left), Short_vector(frame(sight.right_ray.direction)),
                    Short_vector(frame(sight.left_ray.direction))});
  }

  void add(const Strip& strip, const double label)
  {
    const Frame frame(strip.edge);
    m_straight.add(strip.halfedge,
                   {label, frame(-1. * strip.left), frame({1, 0}), strip.begin, strip.end});
  }

  const Intrinsic_triangulation& m_triangulation;
  const Run& m_run;
  const Labels& m_labels;
  const double m_limit;
  Fronts_of_sides<Circular_front> m_circular;
  Fronts_of_sides<Straight_front> m_straight;
  std::size_t m_number_of_sights = 0;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_GRAPHS_INTERNAL_SADDLES_FRONTS_H
