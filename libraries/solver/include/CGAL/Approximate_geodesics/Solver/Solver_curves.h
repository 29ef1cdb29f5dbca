// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CURVES_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CURVES_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Solver/Solver.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Solver_visitor.h>
#include <CGAL/Geodesic_constructions/offset_curves.h>
#include <CGAL/approximate_geodesic_distances.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgGeodesicLibrariesArrays
 *
 * Distances from curves and regions on the surface of a `Solver`, and curves at constant distance
 * from them. They are exact, and depend neither on the bound of the solver nor on its costs and
 * barriers. The header is not part of `Solver.h`, as most programs do not need it.
 *
 * All member functions are thread-safe, and throw `std::invalid_argument` for points and faces that
 * do not exist, and where `approximate_geodesic_distances()` and `offset_curves()` do; the latter
 * also throws `std::length_error`. They throw `Solver_interrupted` if a watch ends the call.
 */
class Solver_curves
{
  using Kernel = Simple_cartesian<double>;
  using Mesh = Solver::Mesh;

public:
  /// a curve of a mesh.
  using Curve = Source_curve<Mesh>;

  /// a set of its faces.
  using Region = Source_region<Mesh>;

  /// A curve at constant distance.
  struct Offset
  {
    double distance;                 ///< the distance
    std::vector<double> coordinates; ///< those of its points, three each; the first point of a
                                     ///< closed curve is also the last
  };

  /// refers to a solver, and does not copy it.
  explicit Solver_curves(const Solver& solver) : m_solver(solver) {}

  /// returns the curve through some points. Those that have no face in common with the next one are
  /// joined to it by a shortest path.
  Curve curve(const std::vector<Solver_point>& points, const bool is_closed) const
  {
    Curve result{{}, is_closed};
    for(const Solver_point& p : points)
      result.points.push_back(
          m_solver.surface_point(p, "point " + std::to_string(result.points.size())));
    return result;
  }

  /// returns the set of some faces.
  Region region(const std::vector<std::int64_t>& faces) const
  {
    Region result;
    for(const std::int64_t f : faces)
    {
      if(f < 0 || static_cast<std::size_t>(f) >= m_solver.number_of_faces())
        internal::reject("face " + std::to_string(f) + " of the region does not exist; there are " +
                         std::to_string(m_solver.number_of_faces()));
      result.faces.emplace_back(f);
    }
    return result;
  }

  /// writes the distance of each vertex from a curve or a region, infinity if it is not reached. If
  /// `is_signed`, distances are negative to the left of the curve, as with `signed_distances`.
  template <typename Source>
  void find_distances(const Source& source,
                      double* const distances,
                      const bool is_signed = false,
                      const Solver_watch& watch = Solver_watch()) const
  {
    internal::Solver_visitor visitor(watch);
    const Mesh& mesh = m_solver.mesh();
    approximate_geodesic_distances(
        mesh, boost::make_iterator_property_map(distances, get(boost::vertex_index, mesh)), source,
        parameters::epsilon(0).signed_distances(is_signed));
    visitor.finish();
  }

  /// returns the curves at some distances from a curve or a region, ordered by distance.
  template <typename Source>
  std::vector<Offset> offsets(const Source& source,
                              const std::vector<double>& distances,
                              const Solver_watch& watch = Solver_watch()) const
  {
    internal::Solver_visitor visitor(watch);
    std::vector<Offset_curve<Kernel::Point_3>> curves;
    offset_curves(m_solver.mesh(), source, distances, std::back_inserter(curves));
    visitor.finish();
    std::vector<Offset> result;
    for(auto& c : curves)
    {
      if(c.is_closed)
        c.points.push_back(c.points.front());
      Offset& offset = result.emplace_back();
      offset.distance = c.distance;
      for(const auto& p : c.points)
        offset.coordinates.insert(offset.coordinates.end(), {p.x(), p.y(), p.z()});
    }
    visitor.finish();
    return result;
  }

private:
  const Solver& m_solver;
};

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_SOLVER_CURVES_H
