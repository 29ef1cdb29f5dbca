// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_COSTS_H
#define CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_COSTS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/Loop.h>
#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Base/internal/named_parameters.h>
#include <CGAL/Approximate_geodesics/Mesh/Triangulation_builder.h>
#include <CGAL/Approximate_geodesics/Solver/Solver_options.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Array_mesh.h>
#include <CGAL/Approximate_geodesics/Solver/internal/Sampled_cost.h>
#include <CGAL/Approximate_geodesics/Surface/Intrinsic_triangulation.h>
#include <CGAL/Geodesic_costs.h>
#include <CGAL/Simple_cartesian.h>

#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics::internal {

using Face_vector = Simple_cartesian<double>::Vector_3;

/*
 * A type-erased cost function of a face index and a direction, which can be interrupted.
 */
class Cost_function
{
public:
  template <typename F,
            typename = std::enable_if_t<!std::is_same_v<std::decay_t<F>, Cost_function>>>
  Cost_function(F f) // NOLINT(google-explicit-constructor)
    : m_cost(f),
      m_formula([f](const std::size_t face, const Space_vector& x, const Space_vector& y) {
        return Cost_formulas{x, y}.of(f, face);
      })
  {
  }

  double operator()(const std::size_t face, const Face_vector& direction) const
  {
    count_call();
    return m_cost(face, direction);
  }

  Gauge_formula formula(const std::size_t face, const Space_vector& x, const Space_vector& y) const
  {
    count_call();
    return m_formula(face, x, y);
  }

private:
  void count_call() const
  {
    constexpr std::size_t calls_between_looks = 1024;
    if(++*m_calls % calls_between_looks == 0)
      check_for_interruption();
  }

  std::function<double(std::size_t, const Face_vector&)> m_cost;
  std::function<Gauge_formula(std::size_t, const Space_vector&, const Space_vector&)> m_formula;
  std::shared_ptr<std::size_t> m_calls = std::make_shared<std::size_t>(0);
};

inline std::size_t numbers_per_face(const Solver_cost& cost)
{
  switch(cost.model)
  {
  case Solver_cost::DRIFT_TIME:
  case Solver_cost::ONE_WAY:
    return 3;
  case Solver_cost::TENSOR_COST:
    return 6;
  case Solver_cost::SAMPLED_COST:
    return Sampled_cost::numbers_per_face(Sampled_cost::number_of_directions(cost));
  default:
    return 0;
  }
}

// Numbers are those of faces, or of other elements that are named so.
inline void check_numbers_of_faces(const Solver_cost& cost,
                                   const std::size_t number_of_faces,
                                   const std::string& element = "face")
{
  const std::size_t per_face = numbers_per_face(cost);
  if(cost.of_faces.size() != per_face * number_of_faces)
    reject("the costs have " + std::to_string(cost.of_faces.size()) + " numbers for " +
           std::to_string(number_of_faces) + " " + element + "s; there must be " +
           std::to_string(per_face) + " per " + element);
  if(cost.model == Solver_cost::SAMPLED_COST)
    return; // it checks them itself: costs may be infinite
  for(std::size_t i = 0; i < cost.of_faces.size(); ++i)
    if(!std::isfinite(cost.of_faces[i]))
      reject(element + " " + std::to_string(i / per_face) + " has the number " +
             text_of(cost.of_faces[i]) + " in its cost; numbers must be finite");
}

inline double parameter_of(const Solver_cost& cost, const std::size_t i)
{
  if(i >= cost.parameters.size())
    reject("the costs have " + std::to_string(cost.parameters.size()) +
           " parameters, too few for their model");
  return cost.parameters[i];
}

inline Cost_function ready_function(const Solver_cost& cost)
{
  const double* const numbers = cost.of_faces.data();
  const auto parameter = [&](const std::size_t i) { return parameter_of(cost, i); };
  const auto vectors =
      boost::make_function_property_map<std::size_t>([numbers](const std::size_t face) {
        const double* const v = numbers + 3 * face;
        return Face_vector(v[0], v[1], v[2]);
      });
  const auto tensors =
      boost::make_function_property_map<std::size_t>([numbers](const std::size_t face) {
        std::array<double, 6> result;
        std::copy_n(numbers + 6 * face, 6, result.begin());
        return result;
      });
  switch(cost.model)
  {
  case Solver_cost::HIKING_TIME:
    return Hiking_time(parameter(0));
  case Solver_cost::WALKING_ENERGY:
    return Walking_energy();
  case Solver_cost::DRIFT_TIME:
    return Drift_time(vectors, parameter(0));
  case Solver_cost::ONE_WAY:
    return One_way(vectors, parameter(0), parameter(1));
  case Solver_cost::TENSOR_COST:
    return Tensor_cost(tensors);
  case Solver_cost::SAMPLED_COST:
    return Sampled_cost(cost);
  case Solver_cost::NAISMITH_TIME:
    return Naismith_time(parameter(0), parameter(1));
  }
  reject("unknown cost model " + std::to_string(int(cost.model)));
}

// Returns a function that refers to `cost`.
inline Cost_function cost_function(const Solver_cost& cost, const std::size_t number_of_faces)
{
  check_numbers_of_faces(cost, number_of_faces);
  return ready_function(cost);
}

/*
 * The face costs and the barriers of a mesh.
 */
class Array_costs
{
  using Vertex = Array_mesh::Vertex_index;
  using Edge = Array_mesh::Edge_index;
  using Face = Array_mesh::Face_index;

public:
  // The mesh is referred to, not copied.
  explicit Array_costs(const Array_mesh& mesh) : m_mesh(mesh) {}

  void set_weights(const double* const weights)
  {
    m_weights.emplace(weights, weights + m_mesh.number_of_faces());
    for(const Face f : faces(m_mesh))
      if(!(weight(f) >= 0))
        reject("face " + std::to_string(f) + " has weight " + text_of(weight(f)) +
               "; it must be a number that is not negative, or infinity");
  }

  // Barriers are given by their end vertices.
  void set_barriers(const std::int64_t* const ends, const std::size_t number)
  {
    m_is_barrier.resize(3 * m_mesh.number_of_faces(), false);
    for(std::size_t i = 0; i < number; ++i)
    {
      const auto [h, is_found] = halfedge(end(ends[2 * i], i), end(ends[2 * i + 1], i), m_mesh);
      if(!is_found)
        reject("barrier " + std::to_string(i) + " is not an edge: no face has both vertex " +
               std::to_string(ends[2 * i]) + " and vertex " + std::to_string(ends[2 * i + 1]));
      m_is_barrier[edge(h, m_mesh)] = true;
    }
  }

  // Changes weights and barriers that the graph of the mesh has accepted.
  void set_weight(const Face f, const double weight)
  {
    if(!m_weights)
      m_weights.emplace(m_mesh.number_of_faces(), 1.);
    (*m_weights)[f] = weight;
  }
  void set_barrier(const Edge e, const bool is_barrier) { m_is_barrier[e] = is_barrier; }

  void set_directional_cost(Solver_cost cost)
  {
    if(m_weights)
      reject("there are both face weights and directional costs; only one of them can be given");
    m_cost = std::move(cost);
  }

  void set_max_slope(const double max_slope) { m_max_slope = max_slope; }

  bool has_weights() const { return m_weights.has_value(); }
  bool has_barriers() const { return !m_is_barrier.empty(); }
  const std::optional<Solver_cost>& directional_cost() const { return m_cost; }
  double max_slope() const { return m_max_slope; }
  double weight(const Face f) const { return (*m_weights)[f]; }
  bool is_barrier(const Edge e) const { return has_barriers() && m_is_barrier[e]; }

  // The bound determines the number of directions in which directional costs are sampled.
  Intrinsic_triangulation triangulation(const std::optional<double> epsilon) const
  {
    const double bound = epsilon > 0. ? *epsilon : 1;
    const auto barriers =
        boost::make_function_property_map<Edge>([this](const Edge e) { return is_barrier(e); });
    if(m_cost)
      return limited(
          parameters::face_weight_map(Approximate_geodesics::directional_cost(
                                          cost_function(*m_cost, m_mesh.number_of_faces())))
              .edge_is_constrained_map(barriers)
              .epsilon(bound));
    if(m_weights)
      return limited(
          parameters::face_weight_map(
              boost::make_iterator_property_map(m_weights->begin(), get(boost::face_index, m_mesh)))
              .edge_is_constrained_map(barriers));
    if(has_barriers() || is_limited())
      return limited(parameters::epsilon(bound).edge_is_constrained_map(barriers));
    return Intrinsic_triangulation(m_mesh);
  }

private:
  bool is_limited() const { return !(m_max_slope == infinity); }

  template <typename NamedParameters>
  Intrinsic_triangulation limited(const NamedParameters& np) const
  {
    return is_limited() ? Intrinsic_triangulation(m_mesh, np.max_slope(m_max_slope))
                        : Intrinsic_triangulation(m_mesh, np);
  }

  Vertex end(const std::int64_t vertex, const std::size_t barrier) const
  {
    if(static_cast<std::uint64_t>(vertex) >= m_mesh.number_of_vertices())
      reject("barrier " + std::to_string(barrier) + " has vertex " + std::to_string(vertex) +
             "; the vertices are numbered from 0, and there are " +
             std::to_string(m_mesh.number_of_vertices()));
    return Vertex(vertex);
  }

  const Array_mesh& m_mesh;
  std::optional<std::vector<double>> m_weights; // of faces
  std::vector<bool> m_is_barrier;               // of edges; empty without barriers
  std::optional<Solver_cost> m_cost;
  double m_max_slope = infinity;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_SOLVER_INTERNAL_ARRAY_COSTS_H
