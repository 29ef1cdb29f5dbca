// Copyright (c) 2026  The Approximate Geodesics authors.
// All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SOURCE_LIST_H
#define CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SOURCE_LIST_H

#include <CGAL/license/Approximate_geodesics.h>

#include <CGAL/Approximate_geodesics/Mesh/Surface_point.h>
#include <CGAL/Approximate_geodesics/Paths/Surface_search.h>

#include <boost/iterator/iterator_adaptor.hpp>

#include <cstddef>
#include <list>

namespace CGAL::Approximate_geodesics::internal {

/*
 * The sources of a search, in the order in which they were added. Iterators stay valid until their
 * source is removed; like those of the exact class, they refer to face locations.
 */
template <typename TriangleMesh>
class Source_list
{
  using Face_location = Approximate_geodesics::Face_location<TriangleMesh>;

  struct Listed_source
  {
    Source_point source;
    Face_location location;
  };
  using List = std::list<Listed_source>;
  using List_iterator = typename List::const_iterator;

public:
  class Iterator : public boost::iterator_adaptor<Iterator,
                                                  List_iterator,
                                                  Face_location,
                                                  std::bidirectional_iterator_tag,
                                                  const Face_location&>
  {
  public:
    Iterator() = default;

  private:
    friend class Source_list;
    friend class boost::iterator_core_access;

    explicit Iterator(const List_iterator it) : Iterator::iterator_adaptor_(it) {}
    const Face_location& dereference() const { return this->base()->location; }
  };

  static const Source_point& source(const Iterator it) { return it.base()->source; }

  Iterator begin() const { return Iterator(m_sources.begin()); }
  Iterator end() const { return Iterator(m_sources.end()); }
  std::size_t size() const { return m_sources.size(); }

  Iterator add(const Source_point& source, const Face_location& location)
  {
    return Iterator(m_sources.insert(m_sources.end(), Listed_source{source, location}));
  }

  void remove(const Iterator it) { m_sources.erase(it.base()); }
  void clear() { m_sources.clear(); }

private:
  List m_sources;
};

} // namespace CGAL::Approximate_geodesics::internal

#endif // CGAL_APPROXIMATE_GEODESICS_QUERIES_INTERNAL_SOURCE_LIST_H
