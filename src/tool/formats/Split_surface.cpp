// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Split_surface.h"

#include <CGAL/Canonical_pose_3/triangulate_polygons.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Of all corners of the polygons; empty if no vertex is split.
std::vector<Vertex_copy> copies_of_corners(const Shown_surface& surface)
{
  std::vector<Vertex_copy> corners;
  const auto& coordinates = surface.mesh.appearance.texture_coordinates;
  const auto& normals = surface.mesh.appearance.normals;
  const bool has_normals = surface.other_shapes.empty() && !normals.empty();
  if(surface.part_of_face.empty() && coordinates.empty() && !has_normals)
    return corners;
  for(std::size_t f = 0; f < surface.mesh.faces.size(); ++f)
    for(const std::size_t v : surface.mesh.faces[f])
    {
      Vertex_copy copy{v};
      if(!surface.part_of_face.empty())
        copy.part = static_cast<long long>(surface.part_of_face[f]);
      if(!coordinates.empty())
        copy.texture_coordinates = coordinates[corners.size()];
      if(has_normals)
        copy.normal = normals[corners.size()];
      corners.push_back(copy);
    }
  return corners;
}

} // namespace

Split_surface::Split_surface(const CGAL::Canonical_pose_3::Point_matrix& points,
                             const Shown_surface& surface)
{
  CGAL::Canonical_pose_3::Triangulated_polygons polygons
    = CGAL::Canonical_pose_3::triangulate_polygons(points, surface.mesh.faces);
  faces = polygons.triangles;
  triangles = std::move(polygons.triangles);
  polygon_of_triangle = std::move(polygons.polygon_of_triangle);
  const std::size_t n = surface.mesh.points.size();
  const std::vector<Vertex_copy> corners = copies_of_corners(surface);
  if(corners.empty())
  {
    for(std::size_t v = 0; v < n; ++v)
      copies.push_back({v});
    return;
  }
  std::vector<bool> has_face(n, false);
  for(const Vertex_copy& copy : corners)
    has_face[copy.vertex] = true;
  copies = corners;
  for(std::size_t v = 0; v < n; ++v)
    if(!has_face[v])
      copies.push_back({v});
  std::sort(copies.begin(), copies.end());
  copies.erase(std::unique(copies.begin(), copies.end()), copies.end());
  std::size_t first = 0; // corner of the polygon
  for(std::size_t t = 0, polygon = 0; t < faces.size(); ++t)
  {
    for(; polygon < polygon_of_triangle[t]; ++polygon)
      first += surface.mesh.faces[polygon].size();
    for(std::size_t& v : triangles[t])
    {
      std::size_t corner = first;
      while(corners[corner].vertex != v)
        ++corner;
      v = static_cast<std::size_t>(std::lower_bound(copies.begin(), copies.end(), corners[corner])
                                   - copies.begin());
    }
  }
}

} // namespace Canonical_pose_tool
