// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGLE_SOUP_MESH_H
#define CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGLE_SOUP_MESH_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Base/internal/messages.h>
#include <CGAL/Approximate_geodesics/Mesh/internal/Paired_sides.h>
#include <CGAL/Iterator_range.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/tags.h>

#include <boost/graph/graph_traits.hpp>
#include <boost/graph/properties.hpp>
#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/filter_iterator.hpp>
#include <boost/property_map/property_map.hpp>
#include <boost/type_traits/is_detected.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <iterator>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Approximate_geodesics {
namespace internal {

enum class Kind_of_element
{
  VERTEX,
  HALFEDGE,
  EDGE,
  FACE
};

/*
 * The number of an element of a mesh. Elements of different kinds have different types. An integer
 * that is out of range becomes a null element.
 */
template <Kind_of_element KIND>
class Element_index
{
public:
  Element_index() = default;

  template <typename Integer, typename = std::enable_if_t<std::is_integral_v<Integer>>>
  explicit Element_index(const Integer number)
    : m_number(static_cast<std::uint64_t>(number) < null_index ? static_cast<Index>(number)
                                                               : null_index)
  {
  }

  operator Index() const { return m_number; }

  Element_index& operator++()
  {
    ++m_number;
    return *this;
  }

  Element_index& operator--()
  {
    --m_number;
    return *this;
  }

  Element_index& operator+=(const std::ptrdiff_t n)
  {
    m_number = static_cast<Index>(static_cast<std::ptrdiff_t>(m_number) + n);
    return *this;
  }

  friend std::ptrdiff_t operator-(const Element_index a, const Element_index b)
  {
    return static_cast<std::ptrdiff_t>(a.m_number) - static_cast<std::ptrdiff_t>(b.m_number);
  }

  friend std::size_t hash_value(const Element_index i) { return i.m_number; }

private:
  Index m_number = null_index;
};

// The point type for an entry of an array: itself, or that of a kernel for an array of coordinates.
template <typename T>
struct Point_of_entry
{
  using type = T;
  static const T& point(const T& entry) { return entry; }
};

template <typename FT>
struct Point_of_entry<std::array<FT, 3>>
{
  using type = typename Simple_cartesian<FT>::Point_3;
  static type point(const std::array<FT, 3>& p) { return type(p[0], p[1], p[2]); }
};

template <typename Key>
struct Element_index_map
{
  using key_type = Key;
  using value_type = Index;
  using reference = Index;
  using category = boost::readable_property_map_tag;

  friend Index get(const Element_index_map& /* map */, const Key key) { return key; }
};

template <typename Mesh>
struct Soup_point_map
{
  using key_type = typename Mesh::Vertex_index;
  using value_type = typename Mesh::Point;
  using reference = decltype(std::declval<const Mesh&>().point(key_type()));
  using category = boost::readable_property_map_tag;

  friend reference get(const Soup_point_map& map, const key_type v) { return map.mesh->point(v); }

  const Mesh* mesh;
};

// The property map of a mesh for a tag.
template <typename Mesh, typename Tag>
struct Soup_property_map;

template <typename Mesh>
struct Soup_property_map<Mesh, boost::vertex_index_t>
{
  using type = Element_index_map<typename Mesh::Vertex_index>;
  static type get(const Mesh& /* mesh */) { return {}; }
};

template <typename Mesh>
struct Soup_property_map<Mesh, boost::halfedge_index_t>
{
  using type = Element_index_map<typename Mesh::Halfedge_index>;
  static type get(const Mesh& /* mesh */) { return {}; }
};

template <typename Mesh>
struct Soup_property_map<Mesh, boost::face_index_t>
{
  using type = Element_index_map<typename Mesh::Face_index>;
  static type get(const Mesh& /* mesh */) { return {}; }
};

template <typename Mesh>
struct Soup_property_map<Mesh, vertex_point_t>
{
  using type = Soup_point_map<Mesh>;
  static type get(const Mesh& mesh) { return {&mesh}; }
};

} // namespace internal

/*!
 * \ingroup PkgApproximateGeodesicsSoups
 *
 * A triangle mesh on arrays of points and of triangles, for meshes that are too large to be copied.
 *
 * It refers to the arrays, and adds 28 bytes per vertex; a `CGAL::Surface_mesh` takes about 130.
 * Elements have the numbers of the arrays. All functions and classes of this package take it as a
 * mesh, with the same results as for a `CGAL::Surface_mesh` that has the same faces and the same
 * `halfedge(v)` for each vertex. So do functions of \cgal that read such a graph, as
 * `CGAL::copy_face_graph()`, but for `CGAL::is_valid_polygon_mesh()`: it asks for edges that know
 * from which of their halfedges they were made, and returns `false`.
 *
 * \code
 * std::vector<std::array<float, 3>> points;
 * std::vector<std::array<std::uint32_t, 3>> triangles;
 * // ...
 * const CGAL::Approximate_geodesics::Triangle_soup_mesh mesh(points, triangles);
 * std::vector<double> distances(points.size());
 * CGAL::approximate_geodesic_distances(
 *     mesh, boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, mesh)),
 *     mesh.vertex(0));
 * \endcode
 *
 * An array that is not in a container can be given as a range of two pointers. `halfedge(f)` starts
 * at the first corner of `f`, to which barycentric coordinates refer.
 *
 * \tparam PointRange a model of `ConstRange` with random access iterators, whose value type is a
 *         `%Point_3` of a kernel, or a `std::array` of three coordinates
 * \tparam TriangleRange a model of `ConstRange` with random access iterators, whose value type has
 *         an `operator[]`, which returns an integer for `0`, `1` and `2`
 *
 * \cgalModels{FaceListGraph,HalfedgeListGraph,EdgeListGraph}
 */
template <typename PointRange, typename TriangleRange>
class Triangle_soup_mesh
{
  using Point_iterator = decltype(std::begin(std::declval<const PointRange&>()));
  using Triangle_iterator = decltype(std::begin(std::declval<const TriangleRange&>()));
  using Triangle = typename std::iterator_traits<Triangle_iterator>::value_type;
  using Entry = internal::Point_of_entry<typename std::iterator_traits<Point_iterator>::value_type>;
  using Index = internal::Index;
  using Kind = internal::Kind_of_element;

public:
  /// \name Types
  /// @{

  /// the type of points.
  using Point = typename Entry::type;

  /// a vertex; it converts to its number, as do the other elements.
  using Vertex_index = internal::Element_index<Kind::VERTEX>;

  /// a halfedge: number `3 f + i` is that from corner `i` of face `f` to its next corner, and
  /// border halfedges follow.
  using Halfedge_index = internal::Element_index<Kind::HALFEDGE>;

  /// an edge, by the smaller number of its two halfedges.
  using Edge_index = internal::Element_index<Kind::EDGE>;

  /// a face.
  using Face_index = internal::Element_index<Kind::FACE>;

  /// @}

  /*!
   * pairs the halfedges of triangles.
   *
   * \param points the points of the vertices
   * \param triangles the vertices of the faces, counterclockwise seen from one side of the surface
   *
   * \warning Both are referred to, not copied: arrays must outlive the mesh, and must not change
   *          while it is used.
   *
   * \throws std::invalid_argument if a face has a vertex that does not exist, or twice, or does not
   *         have three, if two faces have the same vertices in the same order, if an edge or a
   *         vertex is not manifold, or if faces at an edge have opposite orientations. The message
   *         names the element. Vertices may be isolated. Coordinates are checked when they are
   *         read.
   * \throws std::length_error if there are too many faces for 32-bit indices.
   *
   * Run time is \cgalBigO{n} for `n` vertices. It takes 32 bytes per vertex more than the result.
   */
  Triangle_soup_mesh(const PointRange& points, const TriangleRange& triangles)
    : m_points(std::begin(points)),
      m_triangles(std::begin(triangles)),
      m_number_of_faces(
          static_cast<std::size_t>(std::distance(std::begin(triangles), std::end(triangles)))),
      m_sides(static_cast<std::size_t>(std::distance(std::begin(points), std::end(points))),
              m_number_of_faces,
              Corners{m_triangles})
  {
  }

#ifndef DOXYGEN_RUNNING
  // A temporary vector would not outlive the mesh. A temporary view may.
  template <typename T>
  Triangle_soup_mesh(std::vector<T>&& points, const TriangleRange& triangles) = delete;
  template <typename T>
  Triangle_soup_mesh(const PointRange& points, std::vector<T>&& triangles) = delete;
#endif

  /// returns the number of vertices.
  std::size_t number_of_vertices() const { return m_sides.number_of_vertices(); }

  /// returns the number of faces.
  std::size_t number_of_faces() const { return m_number_of_faces; }

  /// returns the number of halfedges, border halfedges included.
  std::size_t number_of_halfedges() const { return m_sides.number_of_halfedges(); }

  /// returns a vertex by its number.
  static Vertex_index vertex(const std::size_t number) { return Vertex_index(number); }

  /// returns the point of a vertex.
  decltype(auto) point(const Vertex_index v) const
  {
    const Point_iterator entry = m_points + static_cast<std::ptrdiff_t>(Index(v));
    if constexpr(std::is_lvalue_reference_v<decltype(*entry)>)
      return Entry::point(*entry);
    else
      return Point(Entry::point(*entry)); // the iterator returns a value, which ends here
  }

  /// returns the size in bytes, without the arrays.
  std::size_t memory() const { return m_sides.memory(); }

#ifndef DOXYGEN_RUNNING
  // The functions of the concepts, found by argument-dependent lookup.

  friend auto vertices(const Triangle_soup_mesh& m)
  {
    return all<Vertex_index>(m.number_of_vertices());
  }
  friend auto halfedges(const Triangle_soup_mesh& m)
  {
    return all<Halfedge_index>(m.number_of_halfedges());
  }
  friend auto edges(const Triangle_soup_mesh& m)
  {
    const auto sides = all<Edge_index>(m.m_sides.number_of_sides());
    const Is_edge is_edge{&m.m_sides};
    return make_range(Edge_iterator(is_edge, sides.begin(), sides.end()),
                      Edge_iterator(is_edge, sides.end(), sides.end()));
  }
  friend auto faces(const Triangle_soup_mesh& m) { return all<Face_index>(m.number_of_faces()); }

  friend std::size_t num_vertices(const Triangle_soup_mesh& m) { return m.number_of_vertices(); }
  friend std::size_t num_halfedges(const Triangle_soup_mesh& m) { return m.number_of_halfedges(); }
  friend std::size_t num_edges(const Triangle_soup_mesh& m) { return m.number_of_halfedges() / 2; }
  friend std::size_t num_faces(const Triangle_soup_mesh& m) { return m.number_of_faces(); }

  friend Vertex_index source(const Halfedge_index h, const Triangle_soup_mesh& m)
  {
    return m.m_sides.is_border(h) ? target(opposite(h, m), m) : m.corner(h);
  }
  friend Vertex_index target(const Halfedge_index h, const Triangle_soup_mesh& m)
  {
    return m.corner(m.m_sides.is_border(h) ? m.m_sides.opposite(h)
                                           : internal::Paired_sides::side_after(h));
  }
  friend Vertex_index source(const Edge_index e, const Triangle_soup_mesh& m)
  {
    return source(halfedge(e, m), m);
  }
  friend Vertex_index target(const Edge_index e, const Triangle_soup_mesh& m)
  {
    return target(halfedge(e, m), m);
  }

  friend Halfedge_index opposite(const Halfedge_index h, const Triangle_soup_mesh& m)
  {
    return Halfedge_index(m.m_sides.opposite(h));
  }
  friend Halfedge_index next(const Halfedge_index h, const Triangle_soup_mesh& m)
  {
    return Halfedge_index(m.m_sides.next(h));
  }
  friend Halfedge_index prev(const Halfedge_index h, const Triangle_soup_mesh& m)
  {
    return Halfedge_index(m.m_sides.is_border(h) ? m.m_sides.halfedge(source(h, m))
                                                 : internal::Paired_sides::side_before(h));
  }

  friend Face_index face(const Halfedge_index h, const Triangle_soup_mesh& m)
  {
    return m.m_sides.is_border(h) ? Face_index() : Face_index(h / 3);
  }
  friend Edge_index edge(const Halfedge_index h, const Triangle_soup_mesh& m)
  {
    return Edge_index((std::min)(Index(h), m.m_sides.opposite(h)));
  }
  friend Halfedge_index halfedge(const Edge_index e, const Triangle_soup_mesh& /* m */)
  {
    return Halfedge_index(Index(e));
  }
  friend Halfedge_index halfedge(const Face_index f, const Triangle_soup_mesh& /* m */)
  {
    return Halfedge_index(3 * Index(f));
  }
  friend Halfedge_index halfedge(const Vertex_index v, const Triangle_soup_mesh& m)
  {
    return Halfedge_index(m.m_sides.halfedge(v));
  }
  friend std::pair<Halfedge_index, bool>
  halfedge(const Vertex_index u, const Vertex_index v, const Triangle_soup_mesh& m)
  {
    const Halfedge_index first = halfedge(v, m);
    Halfedge_index h = first;
    if(first != Halfedge_index())
      do
      {
        if(source(h, m) == u)
          return {h, true};
        h = opposite(next(h, m), m);
      } while(h != first);
    return {Halfedge_index(), false};
  }

  friend std::size_t degree(const Vertex_index v, const Triangle_soup_mesh& m)
  {
    const Halfedge_index first = halfedge(v, m);
    std::size_t result = 0;
    if(first != Halfedge_index())
      for(Halfedge_index h = first; result == 0 || h != first; ++result)
        h = opposite(next(h, m), m);
    return result;
  }
  friend std::size_t degree(const Face_index /* f */, const Triangle_soup_mesh& /* m */)
  {
    return 3;
  }

  template <typename Tag>
  friend auto get(const Tag /* tag */, const Triangle_soup_mesh& m) ->
      typename internal::Soup_property_map<Triangle_soup_mesh, Tag>::type
  {
    return internal::Soup_property_map<Triangle_soup_mesh, Tag>::get(m);
  }
  template <typename Tag, typename Key>
  friend auto get(const Tag tag, const Triangle_soup_mesh& m, const Key& key)
      -> decltype(get(get(tag, m), key))
  {
    return get(get(tag, m), key);
  }
#endif

private:
  template <typename Element>
  using Iterator =
      boost::counting_iterator<Element, boost::random_access_traversal_tag, std::ptrdiff_t>;

  // Whether a side has the number of its edge.
  struct Is_edge
  {
    bool operator()(const Index side) const { return side < sides->opposite(side); }

    const internal::Paired_sides* sides = nullptr;
  };

  using Edge_iterator = boost::filter_iterator<Is_edge, Iterator<Edge_index>>;

  friend struct boost::graph_traits<Triangle_soup_mesh>;

  template <typename Element>
  static Iterator_range<Iterator<Element>> all(const std::size_t size)
  {
    return {Iterator<Element>(Element(0)), Iterator<Element>(Element(size))};
  }

  template <typename T>
  using Size_of = decltype(std::declval<const T&>().size());

  // The corners of a face, which must be three.
  struct Corners
  {
    decltype(auto) operator()(const std::size_t f) const
    {
      decltype(auto) triangle = *(triangles + static_cast<std::ptrdiff_t>(f));
      if constexpr(boost::is_detected_v<Size_of, Triangle>)
        if(triangle.size() != 3)
          internal::reject("face " + std::to_string(f) + " has " + std::to_string(triangle.size()) +
                           " vertices; it must have three");
      return triangle;
    }

    Triangle_iterator triangles;
  };

  Vertex_index corner(const Index side) const
  {
    return Vertex_index((*(m_triangles + static_cast<std::ptrdiff_t>(side / 3)))[side % 3]);
  }

  Point_iterator m_points;
  Triangle_iterator m_triangles;
  std::size_t m_number_of_faces;
  internal::Paired_sides m_sides;
};

} // namespace CGAL::Approximate_geodesics

namespace boost {

template <typename PointRange, typename TriangleRange>
struct graph_traits<CGAL::Approximate_geodesics::Triangle_soup_mesh<PointRange, TriangleRange>>
{
private:
  using Mesh = CGAL::Approximate_geodesics::Triangle_soup_mesh<PointRange, TriangleRange>;

public:
  using vertex_descriptor = typename Mesh::Vertex_index;
  using halfedge_descriptor = typename Mesh::Halfedge_index;
  using edge_descriptor = typename Mesh::Edge_index;
  using face_descriptor = typename Mesh::Face_index;
  using vertex_iterator = typename Mesh::template Iterator<vertex_descriptor>;
  using halfedge_iterator = typename Mesh::template Iterator<halfedge_descriptor>;
  using edge_iterator = typename Mesh::Edge_iterator;
  using face_iterator = typename Mesh::template Iterator<face_descriptor>;
  using vertices_size_type = std::size_t;
  using halfedges_size_type = std::size_t;
  using edges_size_type = std::size_t;
  using faces_size_type = std::size_t;
  using degree_size_type = std::size_t;
  using directed_category = boost::undirected_tag;
  using edge_parallel_category = boost::allow_parallel_edge_tag;
  struct traversal_category : boost::vertex_list_graph_tag, boost::edge_list_graph_tag
  {
  };

  static vertex_descriptor null_vertex() { return {}; }
  static halfedge_descriptor null_halfedge() { return {}; }
  static face_descriptor null_face() { return {}; }
};

} // namespace boost

#define CGAL_APPROXIMATE_GEODESICS_PROPERTY_OF_SOUP(TAG)                                           \
  template <typename PointRange, typename TriangleRange>                                           \
  struct boost::property_map<                                                                      \
      CGAL::Approximate_geodesics::Triangle_soup_mesh<PointRange, TriangleRange>, TAG>             \
    : CGAL::Approximate_geodesics::internal::Soup_property_map<                                    \
          CGAL::Approximate_geodesics::Triangle_soup_mesh<PointRange, TriangleRange>, TAG>         \
  {                                                                                                \
    using const_type = typename CGAL::Approximate_geodesics::internal::Soup_property_map<          \
        CGAL::Approximate_geodesics::Triangle_soup_mesh<PointRange, TriangleRange>,                \
        TAG>::type;                                                                                \
  };                                                                                               \
  template <typename PointRange, typename TriangleRange>                                           \
  struct CGAL::graph_has_property<                                                                 \
      CGAL::Approximate_geodesics::Triangle_soup_mesh<PointRange, TriangleRange>, TAG>             \
    : CGAL::Tag_true                                                                               \
  {                                                                                                \
  };
CGAL_APPROXIMATE_GEODESICS_PROPERTY_OF_SOUP(boost::vertex_index_t)
CGAL_APPROXIMATE_GEODESICS_PROPERTY_OF_SOUP(boost::halfedge_index_t)
CGAL_APPROXIMATE_GEODESICS_PROPERTY_OF_SOUP(boost::face_index_t)
CGAL_APPROXIMATE_GEODESICS_PROPERTY_OF_SOUP(boost::vertex_point_t)
#undef CGAL_APPROXIMATE_GEODESICS_PROPERTY_OF_SOUP

template <CGAL::Approximate_geodesics::internal::Kind_of_element KIND>
struct std::hash<CGAL::Approximate_geodesics::internal::Element_index<KIND>>
{
  std::size_t
  operator()(const CGAL::Approximate_geodesics::internal::Element_index<KIND> i) const noexcept
  {
    return hash_value(i);
  }
};

#include <CGAL/Approximate_geodesics/Mesh/internal/Soup_links.h>

#endif // CGAL_APPROXIMATE_GEODESICS_MESH_TRIANGLE_SOUP_MESH_H
