// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_SHARES_OF_CELLS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_SHARES_OF_CELLS_H

#include "../surface/root_of_area.h"

#include <CGAL/Canonical_pose_3/Surface_component_3.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The areas of components, relative to the largest one.
inline std::vector<double> relative_areas(const std::vector<Surface_component_3>& components)
{
  std::vector<double> result;
  for(const Surface_component_3& component : components)
    result.push_back(root_of_area(component.points, component.triangles));
  const double largest = result.empty() ? 0 : *std::max_element(result.begin(), result.end());
  for(double& root : result)
    root = largest > 0 ? (root / largest) * (root / largest) : 0;
  return result;
}

// For each component, which share of the cells of a single body its own body may have: its share of
// the area of all, or more if it has many faces. So the time grows with the number of faces, not with
// that of the components. `areas`: in any unit.
inline std::vector<double> shares_of_cells(const std::vector<Surface_component_3>& components,
                                           const std::vector<double>& areas)
{
  constexpr double faces_of_a_body = 20000;
  double sum = 0;
  for(const double area : areas)
    sum += area;
  std::vector<double> result;
  for(std::size_t c = 0; c < components.size(); ++c)
    result.push_back((std::max)(
      sum > 0 ? areas[c] / sum : 0,
      (std::min)(static_cast<double>(components[c].triangles.size()) / faces_of_a_body, 1.)));
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_SHARES_OF_CELLS_H
