// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TRIANGLE_SOUP_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TRIANGLE_SOUP_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/surface/Corner_table.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/internal/surface/Loop_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Triangles, and the polygon to which each belongs.
struct Triangle_soup
{
  std::vector<Index_triangle> triangles;
  std::vector<std::size_t> face_of_triangle;

  // Keeps the triangles for which f(index) holds.
  template <class Function>
  void keep_if(const Function& f)
  {
    std::size_t kept = 0;
    for(std::size_t t = 0; t < triangles.size(); ++t)
      if(f(t))
      {
        triangles[kept] = triangles[t];
        face_of_triangle[kept++] = face_of_triangle[t];
      }
    triangles.resize(kept);
    face_of_triangle.resize(kept);
  }
};

inline bool names_a_vertex_twice(const Index_triangle& t)
{
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

// Whether a triangle has no area; exact.
inline bool is_degenerate(const Point_matrix& points, const Index_triangle& t)
{
  const auto point = [&](const std::size_t v) {
    const auto p = points.row(static_cast<Eigen::Index>(v));
    return Indexed_mesh_kernel::Point_3(p[0], p[1], p[2]);
  };
  return CGAL::collinear(point(t[0]), point(t[1]), point(t[2]));
}

// Subdivides polygons into triangles with the same vertices. Repeated consecutive corners are
// skipped, and so are triangles in which a vertex occurs twice.
inline Triangle_soup triangle_soup(const Point_matrix& points, const Face_list& polygons)
{
  Triangle_soup result;
  result.triangles.reserve(polygons.size());
  for(std::size_t f = 0; f < polygons.size(); ++f)
  {
    const Face_list::Face polygon = polygons[f];
    if(polygon.size() == 3)
      result.triangles.push_back({polygon[0], polygon[1], polygon[2]});
    else
    {
      std::vector<std::size_t> corners(polygon.begin(), polygon.end());
      corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
      while(corners.size() > 1 && corners.front() == corners.back())
        corners.pop_back();
      Loop_triangulation(points, std::move(corners)).run(result.triangles);
    }
    result.face_of_triangle.resize(result.triangles.size(), f);
  }
  result.keep_if([&](const std::size_t t) { return !names_a_vertex_twice(result.triangles[t]); });
  return result;
}

// For each face, whether an earlier one has the same vertices, in any order.
inline std::vector<bool> is_duplicate_face(const std::size_t number_of_vertices,
                                           const Face_list& polygons)
{
  const Buckets<std::size_t> faces_of_smallest_vertices(number_of_vertices, [&](const auto& put) {
    for(std::size_t f = 0; f < polygons.size(); ++f)
      if(const Face_list::Face polygon = polygons[f]; !polygon.empty())
        put(*std::min_element(polygon.begin(), polygon.end()), f);
  });

  std::vector<bool> result(polygons.size(), false);
  std::vector<std::pair<std::vector<std::size_t>, std::size_t>> bucket; // its memory is reused
  for(std::size_t v = 0; v < number_of_vertices; ++v)
  {
    const auto faces = faces_of_smallest_vertices[v];
    if(bucket.size() < faces.size())
      bucket.resize(faces.size());
    auto end = bucket.begin();
    for(const std::size_t f : faces)
    {
      auto& [vertices, face] = *end++;
      vertices.assign(polygons[f].begin(), polygons[f].end());
      std::sort(vertices.begin(), vertices.end());
      face = f;
    }
    std::sort(bucket.begin(), end);
    for(std::size_t i = 1; i < faces.size(); ++i)
      if(bucket[i].first == bucket[i - 1].first)
        result[bucket[i].second] = true;
  }
  return result;
}

// For each vertex, the one that represents its position: the first boundary vertex there (an end of
// an edge with only one face), otherwise itself. Closed surfaces that touch remain separate.
inline std::vector<std::size_t> places_of_boundary(const Point_matrix& points,
                                                   const Corner_table& corners)
{
  std::vector<std::size_t> result(static_cast<std::size_t>(points.rows()));
  std::vector<bool> is_on_boundary(result.size(), false);
  corners.for_each_edge([&](const Corner_table::Edge& sides) {
    if(sides.size() == 1)
      is_on_boundary[corners.vertex(sides[0])] = is_on_boundary[corners.target(sides[0])] = true;
  });
  std::vector<std::pair<std::array<double, 3>, std::size_t>> placed;
  for(std::size_t v = 0; v < result.size(); ++v)
    if(is_on_boundary[v])
    {
      const auto p = points.row(static_cast<Eigen::Index>(v));
      placed.push_back({{p[0], p[1], p[2]}, v});
    }
  std::sort(placed.begin(), placed.end());
  std::iota(result.begin(), result.end(), std::size_t(0));
  for(std::size_t i = 1; i < placed.size(); ++i)
    if(placed[i].first == placed[i - 1].first)
      result[placed[i].second] = result[placed[i - 1].second];
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_SURFACE_TRIANGLE_SOUP_H
