// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "extremities.h"

#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

// The distances to all points: those to the landmarks, by the areas that are nearest to them.
Eigen::VectorXd mean_distances(const Surface_component_3& surface, const Landmark_fields_3& fields)
{
  const Eigen::VectorXd shares = vertex_area_shares(surface.points, surface.triangles);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(fields.distances.cols());
  for(Eigen::Index v = 0; v < shares.size(); ++v)
  {
    Eigen::Index nearest;
    fields.distances.row(v).minCoeff(&nearest);
    weights[nearest] += shares[v];
  }
  return fields.distances * weights / weights.sum();
}

} // namespace

std::vector<Extremity> extremities(const Surface_component_3& surface,
                                   const Landmark_fields_3& fields)
{
  const Eigen::VectorXd height = mean_distances(surface, fields);
  const auto n = static_cast<std::size_t>(height.size());
  std::vector<std::vector<std::size_t>> neighbors(n);
  for(const auto& triangle : surface.triangles)
    for(std::size_t k = 0; k < 3; ++k)
      for(const std::size_t other : {triangle[(k + 1) % 3], triangle[(k + 2) % 3]})
        neighbors[triangle[k]].push_back(other);
  const auto height_of = [&](const std::size_t v) { return height[static_cast<Eigen::Index>(v)]; };
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t a, const std::size_t b) {
    return height_of(a) > height_of(b);
  });

  // From the highest vertex downward, sets grow around maxima.
  Disjoint_sets sets(n);
  std::vector<std::size_t> maximum_of_set(n);
  std::iota(maximum_of_set.begin(), maximum_of_set.end(), std::size_t(0));
  std::vector<bool> is_reached(n, false);
  const double range
    = (std::max)(height.maxCoeff() - height.minCoeff(), (std::numeric_limits<double>::min)());
  std::vector<Extremity> result;
  for(const std::size_t v : order)
  {
    is_reached[v] = true;
    for(const std::size_t neighbor : neighbors[v])
    {
      if(!is_reached[neighbor])
        continue;
      std::size_t lower = maximum_of_set[sets.representative(v)],
                  higher = maximum_of_set[sets.representative(neighbor)];
      if(lower == higher)
        continue;
      if(lower != v && height_of(lower) > height_of(higher))
        std::swap(lower, higher);
      sets.unite(v, neighbor);
      maximum_of_set[sets.representative(v)] = higher;
      if(lower != v)
        result.push_back({lower, (height_of(lower) - height_of(v)) / range});
    }
  }
  if(n > 0)
    result.push_back({order.front(), 1});
  std::stable_sort(result.begin(), result.end(), [](const Extremity& a, const Extremity& b) {
    return a.prominence > b.prominence;
  });
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
