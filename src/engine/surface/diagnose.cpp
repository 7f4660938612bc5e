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
#include <limits>
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

namespace {

// The defects of values that are neither positions nor indices. Where there are some, there are no shapes to examine.
template <class Elements>
Diagnosis_3 diagnosis_of_values(const Point_matrix& points, const Elements& elements,
                                const std::string& kind_of_element)
{
  Diagnosis_3 result;
  const std::size_t n = result.vertices = static_cast<std::size_t>(points.rows());
  result.faces = elements.size();
  Soup_finding positions, indices;
  for(std::size_t v = 0; v < n; ++v)
    if(!points.row(static_cast<Eigen::Index>(v)).allFinite())
      positions.add({v});
  std::size_t wrong_index = 0; // of the first element
  for(std::size_t i = 0; i < elements.size(); ++i)
  {
    const auto wrong = std::find_if(elements[i].begin(), elements[i].end(),
                                    [&](const std::size_t v) { return v >= n; });
    if(wrong == elements[i].end())
      continue;
    if(indices.count == 0)
      wrong_index = *wrong;
    indices.add({i});
  }
  if(positions.count > 0)
    result.defects.push_back(
      {"not_finite", positions.count, "vertex", positions.examples,
       "vertex " + positions.first() + " has a coordinate that is not finite"});
  if(indices.count > 0)
    result.defects.push_back(
      {"wrong_indices", indices.count, kind_of_element, indices.examples,
       kind_of_element + ' ' + indices.first() + " names "
         + (wrong_index >= (std::numeric_limits<Face_list::Index>::max)()
              ? "a vertex that does not exist"
              : "vertex " + std::to_string(wrong_index) + ", but there are " + std::to_string(n))});
  if(!result.defects.empty())
    result.first_defect = result.defects.front().message;
  return result;
}

} // namespace

} // namespace internal

Diagnosis_3 diagnose(const Point_matrix& points, const Face_list& polygons)
{
  Diagnosis_3 of_values = internal::diagnosis_of_values(points, polygons, "face");
  return of_values.defects.empty() ? internal::diagnose_soup(points, polygons, true) : of_values;
}

Diagnosis_3 diagnose(const Point_matrix& points,
                     const std::vector<std::array<std::size_t, 4>>& cells)
{
  Diagnosis_3 of_values = internal::diagnosis_of_values(points, cells, "cell");
  return of_values.defects.empty() ? internal::examine_boundary(points, cells, true) : of_values;
}

} // namespace Canonical_pose_3
} // namespace CGAL
