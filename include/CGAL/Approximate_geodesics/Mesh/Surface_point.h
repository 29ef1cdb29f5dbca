// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_POINT_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_POINT_H

#include <CGAL/license/Approximate_geodesics.h>

#include <boost/graph/graph_traits.hpp>

#include <array>
#include <utility>
#include <variant>

namespace CGAL::Approximate_geodesics {

/*!
 * \ingroup PkgApproximateGeodesicsPoints
 *
 * a point of the surface of a mesh, given by a face and barycentric coordinates: the weights of the
 * source and the target of `halfedge(f, tmesh)`, and of the third vertex. \cgal's functions for
 * locating points use this representation.
 */
template <typename TriangleMesh>
using Face_location =
    std::pair<typename boost::graph_traits<TriangleMesh>::face_descriptor, std::array<double, 3>>;

/*!
 * \ingroup PkgApproximateGeodesicsPoints
 *
 * a point of the surface of a mesh: a vertex; or a halfedge, and a parameter along it from `0` at
 * its source to `1` at its target; or a face, and barycentric coordinates in it.
 */
template <typename TriangleMesh>
using Surface_point =
    std::variant<typename boost::graph_traits<TriangleMesh>::vertex_descriptor,
                 std::pair<typename boost::graph_traits<TriangleMesh>::halfedge_descriptor, double>,
                 Face_location<TriangleMesh>>;

} // namespace CGAL::Approximate_geodesics

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_SURFACE_POINT_H
