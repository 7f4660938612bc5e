// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Part_hierarchy.h"
#include "Patch_graph.h"
#include "Patches.h"
#include "Segmented_surface.h"
#include "sweep_cuts.h"
#include "../support/Thread_limit.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Segmentation_options.h>
#include <CGAL/Canonical_pose_3/Segmentation_tree_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/sweep_segmentation.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

// For each pair of patches, the number of splits until they are separated, by that of the parts.
inline Eigen::MatrixXd similarities_of_splits(const Sweep_partition& partition)
{
  const std::size_t k = partition.number_of_parts;
  Eigen::MatrixXd of_parts
    = Eigen::MatrixXd::Ones(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(k));
  for(std::size_t split = 0; split < partition.parents.size(); ++split)
  {
    const auto created = static_cast<Eigen::Index>(split + 1);
    const auto parent = static_cast<Eigen::Index>(partition.parents[split]);
    for(Eigen::Index other = 0; other < created; ++other)
      of_parts(created, other) = of_parts(other, created)
        = other == parent ? static_cast<double>(split) / static_cast<double>(k)
                          : of_parts(parent, other);
  }
  const auto n = static_cast<Eigen::Index>(partition.part_of_patch.size());
  Eigen::MatrixXd result(n, n);
  for(Eigen::Index j = 0; j < n; ++j)
    for(Eigen::Index i = 0; i < n; ++i)
      result(i, j)
        = of_parts(static_cast<Eigen::Index>(partition.part_of_patch[static_cast<std::size_t>(i)]),
                   static_cast<Eigen::Index>(partition.part_of_patch[static_cast<std::size_t>(j)]));
  return result;
}

} // namespace internal

Segmentation_tree_3 sweep_segmentation_tree(const Point_matrix& points, const Face_list& polygons,
                                            const Point_matrix& pose,
                                            const Segmentation_options& options)
{
  using namespace internal;
  constexpr Boundary_preferences preferences = {1, .3, 0};
  constexpr Cut_preferences cuts = {.7, 0};
  constexpr double cost_limit = 2;
  constexpr std::size_t number_of_patches = 250, least_number_of_leaves = 32;
  if(const Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return sweep_segmentation_tree(points, polygons, pose, options); });
  const Segmented_surface surface(points, polygons, pose);
  const std::size_t requested_number = (std::min)(options.number_of_parts, polygons.size());
  std::size_t number_of_parts = surface.number_of_parts_of_triangles(requested_number);
  const Face_graph graph = surface.has_pose() ? surface.graph_of_pose() : surface.graph();
  const Patches patches
    = farthest_point_patches(graph, concave_lengths(graph, preferences.edge_concavity),
                             number_of_patches, farthest_face(graph));
  const Patch_graph neighbors
    = patch_graph(graph, patches, preferences, Eigen::VectorXd::Zero(graph.areas.size()));
  Sweep_partition partition;
  if(number_of_parts == 0)
  {
    partition = sweep_partition(neighbors,
                                {cuts.exponent, cuts.least_area, cost_limit, are_coarse(patches)},
                                1, patches.size(), cost_limit);
    number_of_parts = partition.number_of_parts;
  }
  partition
    = sweep_partition(neighbors, cuts, (std::max)(4 * number_of_parts, least_number_of_leaves),
                      patches.size(), 0, std::move(partition));
  Segmentation_tree_3 tree
    = Part_hierarchy(graph, patches, similarities_of_splits(partition)).tree(number_of_parts);
  return surface.tree_of_polygons(std::move(tree), requested_number);
}

} // namespace Canonical_pose_3
} // namespace CGAL
