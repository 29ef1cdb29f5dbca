// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_FUNCTION_PROPERTY_MAP_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_FUNCTION_PROPERTY_MAP_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/property_map/property_map.hpp>

#include <functional>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Approximate_geodesics {
namespace internal {

/*
 * A readable property map of any type behind one of a known type: it keeps the types of the
 * property maps that a constructor is given out of the class's template arguments.
 */
template <typename Key, typename Value>
class Function_property_map
{
public:
  using key_type = Key;
  using value_type = Value;
  using reference = Value;
  using category = boost::readable_property_map_tag;

  template <typename Map, typename = std::enable_if_t<!std::is_same_v<Map, Function_property_map>>>
  Function_property_map(const Map& map)
    : m_get([map](const Key& key) { return static_cast<Value>(get(map, key)); })
  {
  }

  friend Value get(const Function_property_map& map, const Key& key) { return map.m_get(key); }

private:
  std::function<Value(const Key&)> m_get;
};

} // namespace internal
} // namespace Approximate_geodesics
} // namespace CGAL

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_INTERNAL_FUNCTION_PROPERTY_MAP_H
