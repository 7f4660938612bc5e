// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_PART_HIERARCHY_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_PART_HIERARCHY_H

#include "Average_linkage.h"
#include "Face_graph.h"
#include "Face_regions.h"
#include "Patches.h"

#include <CGAL/Canonical_pose_3/Segmentation_tree_3.h>
#include <CGAL/Canonical_pose_3/internal/support/Disjoint_sets.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Builds the hierarchy of parts from the similarities of patches: the share of the votes in which
// two patches belong to the same part.
class Part_hierarchy
{
public:
  Part_hierarchy(const Face_graph& graph, const Patches& patches,
                 const Eigen::MatrixXd& similarities)
    : Part_hierarchy(graph, patches, similarities, similarities)
  {}

  // `similarities` decide which cuts are made; `local_similarities`, which may be less regular, where
  // boundaries run.
  Part_hierarchy(const Face_graph& graph, const Patches& patches, Eigen::MatrixXd similarities,
                 Eigen::MatrixXd local_similarities)
    : m_graph(graph), m_patches(patches), m_similarities(std::move(similarities)),
      m_local_similarities(std::move(local_similarities)), m_areas(patch_areas(graph, patches)),
      m_linkage(m_similarities, m_areas, Eigen::MatrixXd::Ones(m_areas.size(), m_areas.size()))
  {
    while(m_linkage.merge_two())
    {}
  }

  // The segmentation with `number_of_parts` is computed first. Its parts are divided into leaves, and
  // merged until there is one part per component.
  Segmentation_tree_3 tree(const std::size_t number_of_parts) const
  {
    const std::size_t number_of_leaves = (std::max)(4 * number_of_parts, std::size_t(32));
    const std::vector<std::size_t> part_of_face = merged_pieces(
      pieces(clusters(number_of_parts), std::vector<std::size_t>(m_graph.number_of_faces(), 0)),
      number_of_parts);
    Segmentation_tree_3 result;
    result.number_of_parts = number_of_parts;
    result.leaf_of_face = pieces(clusters(number_of_leaves), part_of_face);
    merge_leaves(part_of_face, result);
    return result;
  }

  // How well the votes agree with the clusters that they lead to, on whether two points of the surface
  // belong to the same part: 1 if all votes are the same, about 0 if it is chance. (Cohen's kappa.)
  double agreement(const std::size_t number_of_parts) const
  {
    const std::vector<std::size_t> known = clusters(number_of_parts);
    const std::size_t k = number_of_clusters(known);
    const Eigen::MatrixXd means = mean_similarities(known, k);
    Eigen::MatrixXd members = Eigen::MatrixXd::Zero(m_areas.size(), static_cast<Eigen::Index>(k));
    for(std::size_t p = 0; p < known.size(); ++p)
      members(static_cast<Eigen::Index>(p),
              static_cast<Eigen::Index>(nearest_cluster(p, known, means)))
        = m_areas[static_cast<Eigen::Index>(p)];
    const double total = m_areas.sum() * m_areas.sum();
    const double votes = m_areas.dot(m_similarities * m_areas) / total;
    const double together = members.colwise().sum().squaredNorm() / total;
    const double both = (m_similarities * members).cwiseProduct(members).sum() / total;
    const double chance = votes + together - 2 * votes * together;
    return chance > 0 ? 1 - (votes + together - 2 * both) / chance : 1;
  }

private:
  static constexpr std::size_t NONE = Disjoint_sets::NONE;
  static constexpr double BAND = .08; // width in which a boundary moves, by the root of the area
  static constexpr double CONCAVITY = .3;       // scale of angles at boundaries
  static constexpr double DATA_WEIGHT = 40;     // of similarities, by the cost of boundaries
  static constexpr double LEAST_AREA = .001;    // of a part
  static constexpr double LEAST_CLUSTER = .003; // area of a cluster that counts as a part

  // The clusters of patches, numbered from 0, such that `number` of them are large. Patches of the
  // others are assigned to NONE.
  std::vector<std::size_t> clusters(const std::size_t number) const
  {
    const std::vector<Average_linkage::Merge>& merges = m_linkage.merges();
    // Undo merges, from the last one, until there are enough large clusters.
    std::size_t kept = merges.size(), large = 1;
    while(kept + 3 * number + 20 > merges.size() && kept > 0 && large < number)
    {
      --kept;
      large += std::size_t(merges[kept].first_weight > LEAST_CLUSTER
                           && merges[kept].second_weight > LEAST_CLUSTER);
    }
    std::vector<std::size_t> result = m_linkage.clusters(kept);
    std::vector<double> areas(result.size(), 0.);
    for(std::size_t p = 0; p < result.size(); ++p)
      areas[result[p]] += m_areas[static_cast<Eigen::Index>(p)];
    const double largest = *std::max_element(areas.begin(), areas.end());
    std::vector<std::size_t> number_of_cluster(result.size(), NONE);
    std::size_t next = 0;
    for(std::size_t p = 0; p < result.size(); ++p)
      if(areas[p] > (std::min)(LEAST_CLUSTER, largest / 2))
        number_of_cluster[p] = next++;
    for(std::size_t& cluster : result)
      cluster = number_of_cluster[cluster];
    return result;
  }

  // The connected pieces of clusters of patches after their boundaries were refined. Boundaries
  // between parts do not move.
  std::vector<std::size_t> pieces(const std::vector<std::size_t>& cluster_of_patch,
                                  const std::vector<std::size_t>& part_of_face) const
  {
    const std::size_t k = number_of_clusters(cluster_of_patch);
    const Eigen::MatrixXd means = mean_similarities(cluster_of_patch, k);
    std::vector<std::size_t> region_of_face(m_graph.number_of_faces());
    for(std::size_t f = 0; f < region_of_face.size(); ++f)
      region_of_face[f] = k * part_of_face[f]
                          + nearest_cluster(m_patches.patch_of_face[f], cluster_of_patch, means);
    refine_boundaries(part_of_face, k, means, region_of_face);
    return connected_pieces(m_graph, without_specks(connected_pieces(m_graph, region_of_face),
                                                    part_of_face, LEAST_AREA))
      .region_of_face;
  }

  static std::size_t number_of_clusters(const std::vector<std::size_t>& cluster_of_patch)
  {
    std::size_t result = 0;
    for(const std::size_t cluster : cluster_of_patch)
      if(cluster != NONE)
        result = (std::max)(result, cluster + 1);
    return result;
  }

  // The cluster of the patch, or the most similar one if there is none.
  static std::size_t nearest_cluster(const std::size_t patch,
                                     const std::vector<std::size_t>& cluster_of_patch,
                                     const Eigen::MatrixXd& means)
  {
    if(cluster_of_patch[patch] != NONE)
      return cluster_of_patch[patch];
    Eigen::Index nearest;
    means.row(static_cast<Eigen::Index>(patch)).maxCoeff(&nearest);
    return static_cast<std::size_t>(nearest);
  }

  // Refines the boundaries within each part. `region_of_face`: `k` times the part, plus the cluster.
  // The costs of faces are clearly positive: CGAL iterates until their sum decreases by less than a
  // factor, so with a sum of about 0 rounding errors might keep it going.
  void refine_boundaries(const std::vector<std::size_t>& part_of_face, const std::size_t k,
                         const Eigen::MatrixXd& means,
                         std::vector<std::size_t>& region_of_face) const
  {
    const auto cost = [&](const std::size_t face, const std::size_t region) {
      return DATA_WEIGHT * m_graph.areas[static_cast<Eigen::Index>(face)]
             * (2
                - means(static_cast<Eigen::Index>(m_patches.patch_of_face[face]),
                        static_cast<Eigen::Index>(region % k)));
    };
    for(const Region_pair& pair : region_pairs(m_graph, region_of_face, part_of_face, BAND))
      refine_boundary(m_graph, pair, part_of_face, region_of_face, CONCAVITY, cost);
  }

  // For each patch, its mean similarity to the patches of each cluster.
  Eigen::MatrixXd mean_similarities(const std::vector<std::size_t>& cluster_of_patch,
                                    const std::size_t k) const
  {
    Eigen::MatrixXd members = Eigen::MatrixXd::Zero(m_areas.size(), static_cast<Eigen::Index>(k));
    for(std::size_t p = 0; p < cluster_of_patch.size(); ++p)
      if(cluster_of_patch[p] != NONE)
        members(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(cluster_of_patch[p]))
          = m_areas[static_cast<Eigen::Index>(p)];
    const Eigen::VectorXd weights = members.colwise().sum().cwiseInverse();
    return m_local_similarities * members * weights.asDiagonal();
  }

  // Merges neighbors of the same group. Similarities of regions are means over pairs of their patches.
  Average_linkage linkage_of(const Face_regions& regions,
                             const std::vector<std::size_t>& group) const
  {
    const auto n = static_cast<Eigen::Index>(regions.size());
    Eigen::MatrixXd shares = Eigen::MatrixXd::Zero(m_areas.size(), n);
    for(std::size_t f = 0; f < m_graph.number_of_faces(); ++f)
      shares(static_cast<Eigen::Index>(m_patches.patch_of_face[f]),
             static_cast<Eigen::Index>(regions.region_of_face[f]))
        += m_graph.areas[static_cast<Eigen::Index>(f)];
    const Eigen::VectorXd areas = shares.colwise().sum().transpose().cwiseMax(1e-12);
    const Eigen::VectorXd scale = areas.cwiseInverse();
    Eigen::MatrixXd similarities
      = scale.asDiagonal() * (shares.transpose() * m_similarities * shares) * scale.asDiagonal();
    Eigen::MatrixXd are_neighbors = Eigen::MatrixXd::Zero(n, n);
    for(std::size_t a = 0; a < regions.size(); ++a)
      for(const auto& [b, length] : regions.boundaries[a])
        if(group[a] == group[b])
          are_neighbors(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) = 1;
    return Average_linkage(std::move(similarities), areas, std::move(are_neighbors));
  }

  // Merges neighbors until there are at most `number` of them.
  std::vector<std::size_t> merged_pieces(const std::vector<std::size_t>& piece_of_face,
                                         const std::size_t number) const
  {
    const Face_regions regions = connected_pieces(m_graph, piece_of_face);
    Average_linkage linkage = linkage_of(regions, std::vector<std::size_t>(regions.size(), 0));
    while(linkage.number_of_clusters() > number && linkage.merge_two())
    {}
    const std::vector<std::size_t> clusters = linkage.clusters();
    std::vector<std::size_t> result = regions.region_of_face;
    for(std::size_t& region : result)
      region = clusters[region];
    return connected_pieces(m_graph, result).region_of_face; // numbered consecutively
  }

  // First the leaves of each part, then the parts.
  void merge_leaves(const std::vector<std::size_t>& part_of_face, Segmentation_tree_3& tree) const
  {
    const Face_regions leaves = connected_pieces(m_graph, tree.leaf_of_face);
    tree.leaf_of_face = leaves.region_of_face;
    tree.number_of_leaves = leaves.size();
    std::vector<std::size_t> part_of_leaf(leaves.size());
    for(std::size_t f = 0; f < part_of_face.size(); ++f)
      part_of_leaf[tree.leaf_of_face[f]] = part_of_face[f];
    std::vector<std::size_t> node(leaves.size());
    std::iota(node.begin(), node.end(), std::size_t(0));
    const auto record
      = [&](const std::size_t first, const std::size_t second, const double similarity) {
          const double before = tree.merges.empty() ? 0 : tree.merges.back().cost;
          const double cost = (std::min)((std::max)(1 - similarity, before), 1.);
          const std::size_t created = tree.number_of_leaves + tree.merges.size();
          tree.merges.push_back({{node[first], node[second]}, cost});
          node[first] = created;
        };

    Average_linkage within = linkage_of(leaves, part_of_leaf);
    while(within.merge_two())
    {}
    for(const auto& merge : within.merges())
      record(merge.first, merge.second, merge.similarity);

    const Face_regions parts = connected_pieces(m_graph, part_of_face);
    std::vector<std::size_t> node_of_part(parts.size());
    const std::vector<std::size_t> representatives = within.clusters();
    for(std::size_t f = 0; f < part_of_face.size(); ++f)
      node_of_part[parts.region_of_face[f]] = node[representatives[tree.leaf_of_face[f]]];
    node = std::move(node_of_part);
    Average_linkage between = linkage_of(parts, std::vector<std::size_t>(parts.size(), 0));
    while(between.merge_two())
    {}
    for(const auto& merge : between.merges())
      record(merge.first, merge.second, merge.similarity);
  }

  const Face_graph& m_graph;
  const Patches& m_patches;
  const Eigen::MatrixXd m_similarities, m_local_similarities;
  const Eigen::VectorXd m_areas;
  Average_linkage m_linkage; // of the patches
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_PART_HIERARCHY_H
