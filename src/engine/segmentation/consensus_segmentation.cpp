// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Lines_of_sight.h"
#include "Mirror_symmetry.h"
#include "Part_hierarchy.h"
#include "Patch_graph.h"
#include "Patches.h"
#include "Segmented_surface.h"
#include "Votes.h"
#include "../surface/signed_volume.h"
#include "../support/Thread_limit.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Segmentation_options.h>
#include <CGAL/Canonical_pose_3/Segmentation_tree_3.h>
#include <CGAL/Canonical_pose_3/consensus_segmentation.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

// Replaces values of patches by means over their neighbors.
inline Eigen::VectorXd smoothed(const Face_graph& graph, const Patches& patches,
                                Eigen::VectorXd values)
{
  constexpr int number_of_passes = 2;
  constexpr double weight_of_neighbors = .5;
  const Patch_graph neighbors
    = patch_graph(graph, patches, {1, 0, 0}, Eigen::VectorXd::Zero(graph.areas.size()));
  const Eigen::VectorXd& areas = neighbors.areas;
  for(int pass = 0; pass < number_of_passes; ++pass)
  {
    Eigen::VectorXd sums = areas.cwiseProduct(values), weights = areas;
    for(const Patch_graph::Edge& edge : neighbors.edges)
    {
      const auto a = static_cast<Eigen::Index>(edge.a), b = static_cast<Eigen::Index>(edge.b);
      sums[a] += weight_of_neighbors * areas[b] * values[b];
      sums[b] += weight_of_neighbors * areas[a] * values[a];
      weights[a] += weight_of_neighbors * areas[b];
      weights[b] += weight_of_neighbors * areas[a];
    }
    values = sums.cwiseQuotient(weights);
  }
  return values;
}

// Whether a pose has kept its inside: much of its volume, and of the pairs of patches that see each
// other. Both surfaces have the area 1.
inline bool is_intact(const Viewed_surface& pose, const Viewed_surface& surface,
                      const std::vector<Index_triangle>& closed_triangles)
{
  constexpr double least_share = .2;
  return pose.visibility.sum() >= least_share * surface.visibility.sum()
         && signed_volume(pose.graph.points, closed_triangles)
              >= least_share * signed_volume(surface.graph.points, closed_triangles);
}

// Whether a pose encloses what was outside: a thin wall, such as that of a cup, bulges, since distances
// along it do not tell what it encloses. Both surfaces have the area 1.
inline bool is_swollen(const Viewed_surface& pose, const Viewed_surface& surface,
                       const std::vector<Index_triangle>& closed_triangles)
{
  constexpr double largest_share = 1.1;
  return signed_volume(pose.graph.points, closed_triangles)
         > largest_share * signed_volume(surface.graph.points, closed_triangles);
}

// The hierarchy of the parts if their number is given. If the shape has a mirror symmetry, votes count for
// both of its sides, so that both are cut in the same way. Where limbs are bent, the pose is more
// symmetric.
inline Part_hierarchy symmetric_hierarchy(const std::vector<Viewed_surface>& geometries,
                                          const Patches& patches,
                                          const Eigen::MatrixXd& similarities)
{
  constexpr double largest_distortion = .09;
  const Face_graph& graph = geometries.front().graph;
  for(auto it = geometries.rbegin(); it != geometries.rend(); ++it)
    if(const Mirror_symmetry mirror(it->graph, patches); mirror.distortion() <= largest_distortion)
      return {graph, patches, (similarities + mirror.mirrored(similarities)) / 2, similarities};
  return {graph, patches, similarities};
}

// The hierarchy of the parts if their number is not given: the typical one of the votes, or half as
// many as long as the votes do not agree. If it is 1, votes with two parts divide it into leaves.
inline Segmentation_tree_3 tree_with_agreement(const Face_graph& graph, const Patches& patches,
                                               const Votes& votes, const unsigned int seed)
{
  constexpr double least_agreement = .4;
  for(std::size_t number = votes.typical_number_of_parts(seed);;
      number = (std::max)(number / 2, std::size_t(2)))
  {
    const Part_hierarchy hierarchy(graph, patches,
                                   votes.similarities((std::max)(number, std::size_t(2)), seed));
    if(number <= 2 || hierarchy.agreement(number) >= least_agreement)
      return hierarchy.tree(number);
  }
}

} // namespace internal

Segmentation_tree_3 consensus_segmentation_tree(const Point_matrix& points,
                                                const Face_list& polygons, const Point_matrix& pose,
                                                const Segmentation_options& options)
{
  using namespace internal;
  constexpr double concavity = .3;
  constexpr std::size_t number_of_patches = 300;
  if(const Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute(
      [&] { return consensus_segmentation_tree(points, polygons, pose, options); });
  const Segmented_surface surface(points, polygons, pose);
  const std::vector<Index_triangle> triangles = surface.closed_triangles();

  const Face_graph graph = surface.graph();
  const Patches patches = farthest_point_patches(graph, concave_lengths(graph, concavity),
                                                 number_of_patches, farthest_face(graph));
  const Lines_of_sight lines(graph, triangles, patches.centers);
  const Eigen::VectorXd log_thickness = smoothed(graph, patches, lines.log_thickness());
  const std::size_t requested_number = (std::min)(options.number_of_parts, polygons.size());
  const std::size_t number_of_parts = surface.number_of_parts_of_triangles(requested_number);
  const bool is_number_given = number_of_parts > 0;
  bool is_pose_faithful = false;
  std::vector<Viewed_surface> geometries = {{graph, lines.visibility(), lines.distances()}};
  if(surface.has_pose())
  {
    const Face_graph posed = surface.graph_of_pose();
    const Lines_of_sight lines_of_pose(posed, triangles, patches.centers);
    Viewed_surface pose_view = {posed, lines_of_pose.visibility(), lines_of_pose.distances()};
    if(is_intact(pose_view, geometries.front(), triangles))
    {
      is_pose_faithful = !is_swollen(pose_view, geometries.front(), triangles);
      if(is_number_given || is_pose_faithful)
        geometries.push_back(std::move(pose_view));
    }
  }

  const Votes votes(geometries, is_pose_faithful, patches, log_thickness, is_number_given);
  Segmentation_tree_3 tree
    = is_number_given
        ? symmetric_hierarchy(geometries, patches,
                              votes.similarities(number_of_parts, options.random_seed))
            .tree(number_of_parts)
        : tree_with_agreement(graph, patches, votes, options.random_seed);
  return surface.tree_of_polygons(std::move(tree), requested_number);
}

} // namespace Canonical_pose_3
} // namespace CGAL
