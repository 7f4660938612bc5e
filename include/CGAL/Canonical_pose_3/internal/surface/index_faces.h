// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_INDEX_FACES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_INDEX_FACES_H

#include <CGAL/Canonical_pose_3/Face_list.h>

#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

using Index_triangle = std::array<std::size_t, 3>;

// A number per vertex or halfedge, for hashable descriptors.
template <class Descriptor>
struct Hashed_numbers
{
  friend void put(Hashed_numbers& map, const Descriptor& d, const std::size_t number)
  {
    map.numbers[d] = number;
  }
  friend std::size_t get(const Hashed_numbers& map, const Descriptor& d)
  {
    return map.numbers.at(d);
  }

  std::unordered_map<Descriptor, std::size_t> numbers;
};

// Dynamic properties are faster, but no concept requires them.
template <class FaceGraph>
auto vertex_number_map(const FaceGraph&, long)
{
  return Hashed_numbers<typename boost::graph_traits<FaceGraph>::vertex_descriptor>();
}

template <class FaceGraph>
auto vertex_number_map(const FaceGraph& mesh, int)
  -> decltype(get(dynamic_vertex_property_t<std::size_t>(), mesh))
{
  return get(dynamic_vertex_property_t<std::size_t>(), mesh);
}

template <class FaceGraph>
auto halfedge_number_map(const FaceGraph&, long)
{
  return Hashed_numbers<typename boost::graph_traits<FaceGraph>::halfedge_descriptor>();
}

template <class FaceGraph>
auto halfedge_number_map(const FaceGraph& mesh, int)
  -> decltype(get(dynamic_halfedge_property_t<std::size_t>(), mesh))
{
  return get(dynamic_halfedge_property_t<std::size_t>(), mesh);
}

// The row of each vertex: its index in the range of vertices.
template <class FaceGraph>
auto number_vertices(const FaceGraph& mesh)
{
  auto rows = vertex_number_map(mesh, 0);
  std::size_t row = 0;
  for(const typename boost::graph_traits<FaceGraph>::vertex_descriptor v : vertices(mesh))
    put(rows, v, row++);
  return rows;
}

template <class FaceGraph>
using Vertex_number_map = decltype(number_vertices(std::declval<const FaceGraph&>()));

// The faces of a mesh as sequences of rows. Each starts with its smallest row, so that the result
// does not depend on which halfedge a data structure stores for a face.
template <class FaceGraph>
Face_list index_polygons(const FaceGraph& mesh)
{
  const auto rows = number_vertices(mesh);
  Face_list polygons;
  std::vector<std::size_t> corners;
  for(const auto f : faces(mesh))
  {
    corners.clear();
    for(const auto h : halfedges_around_face(halfedge(f, mesh), mesh))
      corners.push_back(get(rows, target(h, mesh)));
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    polygons.push_back(corners);
  }
  return polygons;
}

// The same for a triangle mesh; throws std::invalid_argument if a face is not a triangle.
template <class FaceGraph>
std::vector<Index_triangle> index_triangles(const FaceGraph& tmesh)
{
  std::vector<Index_triangle> triangles;
  for(const Face_list::Face corners : index_polygons(tmesh))
  {
    if(corners.size() != 3)
      throw std::invalid_argument("face " + std::to_string(triangles.size())
                                  + " is not a triangle");
    triangles.push_back({corners[0], corners[1], corners[2]});
  }
  return triangles;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_INDEX_FACES_H
