// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_AVERAGE_LINKAGE_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_AVERAGE_LINKAGE_H

#include <Eigen/Core>

#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Clusters items bottom-up: the two most similar clusters are merged next, where the similarity of
// clusters is the mean over their items, weighted.
class Average_linkage
{
public:
  // `similarities`: symmetric. Only pairs for which `may_merge` is not 0 are merged; a merged cluster
  // may be merged with whatever one of its members may be merged with.
  Average_linkage(Eigen::MatrixXd similarities, Eigen::VectorXd weights, Eigen::MatrixXd may_merge)
    : m_similarities(std::move(similarities)), m_weights(std::move(weights)),
      m_may_merge(std::move(may_merge)),
      m_is_cluster(static_cast<std::size_t>(m_weights.size()), true)
  {}

  struct Merge
  {
    std::size_t first, second; // the items that represent the clusters; first represents both
    double first_weight, second_weight;
    double similarity;
  };

  // Merges two clusters, or returns false if no two may be merged.
  bool merge_two()
  {
    const Eigen::Index n = m_weights.size();
    Eigen::Index first = n, second = n;
    for(Eigen::Index j = 0; j < n; ++j)
      if(is_cluster(j))
        for(Eigen::Index i = 0; i < j; ++i)
          if(is_cluster(i) && m_may_merge(i, j) != 0
             && (first == n || m_similarities(i, j) > m_similarities(first, second)))
          {
            first = i;
            second = j;
          }
    if(first == n)
      return false;
    const double a = m_weights[first], b = m_weights[second];
    m_merges.push_back({static_cast<std::size_t>(first), static_cast<std::size_t>(second), a, b,
                        m_similarities(first, second)});
    m_similarities.col(first)
      = (a * m_similarities.col(first) + b * m_similarities.col(second)) / (a + b);
    m_similarities.row(first) = m_similarities.col(first).transpose();
    m_may_merge.col(first) += m_may_merge.col(second);
    m_may_merge.row(first) = m_may_merge.col(first).transpose();
    m_weights[first] += b;
    m_is_cluster[static_cast<std::size_t>(second)] = false;
    return true;
  }

  std::size_t number_of_clusters() const { return m_is_cluster.size() - m_merges.size(); }
  const std::vector<Merge>& merges() const { return m_merges; }

  // The item that represents the cluster of each item, after the first merges.
  std::vector<std::size_t> clusters(const std::size_t number_of_merges) const
  {
    std::vector<std::size_t> result(m_is_cluster.size());
    std::iota(result.begin(), result.end(), std::size_t(0));
    for(std::size_t i = 0; i < number_of_merges; ++i)
      result[m_merges[i].second] = m_merges[i].first;
    for(std::size_t& item : result) // it is represented by one with a smaller number
      item = result[item];
    return result;
  }
  std::vector<std::size_t> clusters() const { return clusters(m_merges.size()); }

private:
  bool is_cluster(const Eigen::Index i) const { return m_is_cluster[static_cast<std::size_t>(i)]; }

  Eigen::MatrixXd m_similarities;
  Eigen::VectorXd m_weights;
  Eigen::MatrixXd m_may_merge;
  std::vector<bool> m_is_cluster; // represents itself
  std::vector<Merge> m_merges;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_AVERAGE_LINKAGE_H
