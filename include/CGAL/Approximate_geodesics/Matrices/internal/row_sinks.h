// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_ROW_SINKS_H
#define CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_ROW_SINKS_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Matrices/Distance_matrix_plan.h>
#include <CGAL/Approximate_geodesics/Matrices/Distance_row.h>

#include <boost/type_traits/detected_or.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <cstddef>
#include <type_traits>
#include <utility>

namespace CGAL::Approximate_geodesics::internal {

// Detection of the optional members of models of `DistanceRowSink`.

template <typename Rows>
using Block_of = typename Rows::Block;
template <typename Rows>
using Number_of_nearest = decltype(std::declval<const Rows&>().number_of_nearest());
template <typename Rows>
using Next_block = decltype(std::declval<Rows&>().next_block());
template <typename Rows>
using Number_done = decltype(std::declval<const Rows&>().number_of_rows_done());
template <typename Rows>
using Can_be_symmetric = std::bool_constant<Rows::can_be_symmetric>;

// Rows are received by a sink, in blocks, or by a function object, one by one.
template <typename Rows>
constexpr bool is_row_sink = boost::is_detected_v<Block_of, Rows>;

template <typename Rows>
constexpr bool is_row_function = std::is_invocable_v<Rows&, std::size_t, const Distance_row&>;

template <typename Rows>
constexpr bool deals_out_blocks = boost::is_detected_v<Next_block, Rows>;

template <typename Rows>
constexpr bool knows_rows_done = boost::is_detected_v<Number_done, Rows>;

template <typename Rows>
constexpr bool can_be_symmetric =
    boost::detected_or_t<std::false_type, Can_be_symmetric, Rows>::value;

template <typename Rows>
constexpr bool check_rows()
{
  using T = std::remove_reference_t<Rows>;
  constexpr bool takes_rows = is_row_sink<T> || is_row_function<T>;
  constexpr bool can_change = !is_row_sink<T> || !std::is_const_v<T>;
  static_assert(takes_rows,
                "rows must be a row sink, such as Dense_rows, or callable with the number of a row "
                "and a `const Distance_row&`");
  static_assert(can_change, "a row sink must not be const");
  return takes_rows && can_change;
}

// Returns the number of nearest columns that a sink keeps per row; 0 means all.
template <typename Rows>
std::size_t number_of_nearest([[maybe_unused]] const Rows& rows)
{
  if constexpr(boost::is_detected_v<Number_of_nearest, Rows>)
    return rows.number_of_nearest();
  else
    return 0;
}

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_MATRICES_INTERNAL_ROW_SINKS_H
