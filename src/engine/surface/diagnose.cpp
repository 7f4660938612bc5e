// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Soup_diagnosis.h"
#include "Soup_topology.h"
#include "examine_surface.h"

#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/surface/boundary_triangles.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

Diagnosis_3 diagnose_soup(const Point_matrix& points, const Face_list& polygons,
                          const bool searches_self_intersections)
{
  const Checked_soup soup(points, polygons);
  return diagnosis_of(Soup_topology(soup, polygons), searches_self_intersections);
}

Diagnosis_3 examine_boundary(const Point_matrix& points,
                             const std::vector<std::array<std::size_t, 4>>& cells,
                             const bool searches_self_intersections)
{
  check_elements(cells, static_cast<std::size_t>(points.rows()), "cell");
  std::vector<std::array<int, 4>> indexed(cells.size());
  for(std::size_t t = 0; t < cells.size(); ++t)
    for(std::size_t k = 0; k < 4; ++k)
    {
      indexed[t][k] = static_cast<int>(cells[t][k]);
      if(std::count(cells[t].begin(), cells[t].end(), cells[t][k]) > 1)
        throw std::invalid_argument("cell " + std::to_string(t) + " names a vertex twice");
    }
  Diagnosis_3 result
    = diagnose_soup(points, boundary_triangles(points, indexed), searches_self_intersections);
  const auto is_of_inner_vertices
    = [](const Diagnosis_3::Defect& defect) { return defect.kind == "isolated_vertices"; };
  result.defects.erase(
    std::remove_if(result.defects.begin(), result.defects.end(), is_of_inner_vertices),
    result.defects.end());
  result.vertices -= std::exchange(result.isolated_vertices, 0);
  result.first_defect = result.defects.empty() ? std::string() : result.defects.front().message;
  return result;
}

} // namespace internal

Diagnosis_3 diagnose(const Point_matrix& points, const Face_list& polygons)
{
  return internal::diagnose_soup(points, polygons, true);
}

Diagnosis_3 diagnose(const Point_matrix& points,
                     const std::vector<std::array<std::size_t, 4>>& cells)
{
  return internal::examine_boundary(points, cells, true);
}

} // namespace Canonical_pose_3
} // namespace CGAL
