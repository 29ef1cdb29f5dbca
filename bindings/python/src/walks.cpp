// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "walks.h"

#include "running.h"

#include <CGAL/Approximate_geodesics/Solver/Solver_walks.h>

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace python {
namespace {

using Vector = AG::Solver_walks::Vector;

// Returns `f(v, watch)` for the vector in space, or the tangent vector, that an array holds. It is
// read with the lock, and `f` is called without.
template <typename F>
auto run_with_vector(const Array<double>& vector, const F& f)
{
  const double *const v = vector.data(), z = vector.size() == 3 ? v[2] : 0;
  const Vector in_space{v[0], v[1], z};
  const bool is_in_space = vector.size() == 3;
  return run(py::none(), [&](const AG::Solver_watch& watch) {
    return is_in_space ? f(in_space, watch)
                       : f(AG::Tangent_vector{in_space[0], in_space[1]}, watch);
  });
}

Array<double> array_of(const std::vector<double>& numbers)
{
  return Array<double>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

py::object python_point(const AG::Solver_point& p)
{
  const auto& c = p.coordinates;
  if(p.kind == AG::Solver_point::VERTEX)
    return py::int_(p.element);
  if(p.kind == AG::Solver_point::EDGE)
    return py::make_tuple(py::make_tuple(p.element, p.second_vertex), c[1]);
  return py::make_tuple(p.element, array_of({c[0], c[1], c[2]}));
}

py::tuple python_curve(AG::Solver_walks::Curve curve)
{
  return py::make_tuple(moved_points(std::move(curve.coordinates)), curve.length);
}

} // namespace

Walks::Walks(const AG::Solver& solver)
  : m_walks(run(py::none(),
                [&](const AG::Solver_watch& watch) {
                  return std::make_unique<AG::Solver_walks>(solver, watch);
                })),
    m_number_of_vertices(static_cast<py::ssize_t>(solver.number_of_vertices()))
{
}

Walks::~Walks() = default;

py::tuple Walks::trace(const Elements& elements,
                       const Coordinates& coordinates,
                       const Array<double>& direction,
                       const double length) const
{
  const auto start = points(elements, coordinates);
  auto walk = run_with_vector(direction, [&](const auto& v, const AG::Solver_watch& watch) {
    return m_walks->trace(start.at(0), v, length, watch);
  });
  const auto& d = walk.direction;
  return py::make_tuple(moved_points(std::move(walk.coordinates)), array_of({d[0], d[1], d[2]}),
                        walk.length, walk.meets_border);
}

Array<double> Walks::logarithmic_map(const Elements& elements, const Coordinates& coordinates) const
{
  const auto source = points(elements, coordinates);
  Array<double> result({m_number_of_vertices, py::ssize_t(2)});
  double* const data = result.mutable_data();
  run(py::none(),
      [&](const AG::Solver_watch& watch) { m_walks->find_logarithms(source.at(0), data, watch); });
  return result;
}

Array<double> Walks::transport(const Elements& elements,
                               const Coordinates& coordinates,
                               const Elements& target_elements,
                               const Coordinates& target_coordinates,
                               const Array<double>& vector) const
{
  const auto source = points(elements, coordinates);
  const auto target = points(target_elements, target_coordinates);
  const AG::Tangent_vector v =
      run_with_vector(vector, [&](const auto& w, const AG::Solver_watch& watch) {
        return m_walks->transport(source.at(0), target.at(0), w, watch);
      });
  if(vector.size() == 2)
    return array_of({v.x, v.y});
  const Vector in_space = m_walks->vector_3(target.at(0), v);
  return array_of({in_space[0], in_space[1], in_space[2]});
}

Array<double> Walks::extend_vectors(const Elements& elements,
                                    const Coordinates& coordinates,
                                    const Array<double>& vectors) const
{
  const auto sources = points(elements, coordinates);
  std::vector<AG::Tangent_vector> given;
  for(py::ssize_t i = 0; i < vectors.shape(0); ++i)
    given.push_back({vectors.at(i, 0), vectors.at(i, 1)});
  Array<double> result({m_number_of_vertices, py::ssize_t(2)});
  double* const data = result.mutable_data();
  run(py::none(),
      [&](const AG::Solver_watch& watch) { m_walks->extend_vectors(sources, given, data, watch); });
  return result;
}

py::tuple Walks::mean(const Elements& elements,
                      const Coordinates& coordinates,
                      const Array<double>& weights) const
{
  const auto places = points(elements, coordinates);
  const std::vector<double> shares(weights.data(), weights.data() + weights.size());
  const auto mean = run(py::none(), [&](const AG::Solver_watch& watch) {
    return m_walks->find_mean(places, shares, watch);
  });
  return py::make_tuple(python_point(mean.point), mean.deviation, mean.has_converged);
}

py::tuple Walks::shorten_loop(const Elements& elements, const Coordinates& coordinates) const
{
  const auto curve = points(elements, coordinates);
  return python_curve(run(py::none(), [&](const AG::Solver_watch& watch) {
    return m_walks->shorten_loop(curve, watch);
  }));
}

py::tuple Walks::shorten_curve(const Elements& elements, const Coordinates& coordinates) const
{
  const auto curve = points(elements, coordinates);
  return python_curve(run(py::none(), [&](const AG::Solver_watch& watch) {
    return m_walks->shorten_curve(curve, watch);
  }));
}

py::tuple Walks::shortest_loop_through(const Elements& elements,
                                       const Coordinates& coordinates) const
{
  const auto base = points(elements, coordinates);
  return python_curve(run(py::none(), [&](const AG::Solver_watch& watch) {
    return m_walks->shortest_loop_through(base.at(0), watch);
  }));
}

py::tuple Walks::frames() const
{
  const auto make = [&] { return Array<double>({m_number_of_vertices, py::ssize_t(3)}); };
  Array<double> x = make(), y = make(), normals = make();
  m_walks->find_frames(x.mutable_data(), y.mutable_data(), normals.mutable_data());
  return py::make_tuple(x, y, normals);
}

} // namespace python
