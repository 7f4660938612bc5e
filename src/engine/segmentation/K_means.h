// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_SEGMENTATION_K_MEANS_H
#define CANONICAL_POSE_3_ENGINE_SEGMENTATION_K_MEANS_H

#include "Random_numbers.h"

#include <Eigen/Core>

#include <cstddef>
#include <limits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Clusters the rows of a matrix by Lloyd's iteration from k-means++ centers (Arthur & Vassilvitskii
// 2007).
class K_means
{
public:
  // `weights`: positive, one per row.
  K_means(const Eigen::MatrixXd& rows, const Eigen::VectorXd& weights, const std::size_t k)
    : m_rows(rows.transpose()), m_weights(weights), m_k(static_cast<Eigen::Index>(k))
  {}

  // Returns the cluster of each row: the best of several runs.
  std::vector<std::size_t> run(Random_numbers& random, const int number_of_runs)
  {
    std::vector<std::size_t> best;
    double least = std::numeric_limits<double>::infinity();
    for(int i = 0; i < number_of_runs; ++i)
    {
      choose_centers(random);
      const double error = iterate();
      if(best.empty() || error < least)
      {
        least = error;
        best = m_clusters;
        m_best_centers = m_centers;
      }
    }
    return best;
  }

  // The cluster of the best run whose center is nearest to a point.
  std::size_t nearest_cluster(const Eigen::VectorXd& point) const
  {
    Eigen::Index result;
    (m_best_centers.colwise() - point).colwise().squaredNorm().minCoeff(&result);
    return static_cast<std::size_t>(result);
  }

private:
  void choose_centers(Random_numbers& random)
  {
    m_centers.resize(m_rows.rows(), m_k);
    Eigen::VectorXd distances = Eigen::VectorXd::Ones(m_rows.cols());
    for(Eigen::Index c = 0; c < m_k; ++c)
    {
      m_centers.col(c) = m_rows.col(draw(distances.cwiseProduct(m_weights), random));
      const Eigen::VectorXd to_center
        = (m_rows.colwise() - m_centers.col(c)).colwise().squaredNorm().transpose();
      distances = c == 0 ? to_center : distances.cwiseMin(to_center);
    }
  }

  // Draws an index with the given probabilities, up to a factor.
  static Eigen::Index draw(const Eigen::VectorXd& probabilities, Random_numbers& random)
  {
    double rest = random.between(0, probabilities.sum());
    for(Eigen::Index i = 0; i < probabilities.size(); ++i)
    {
      rest -= probabilities[i];
      if(rest < 0)
        return i;
    }
    return probabilities.size() - 1;
  }

  double iterate()
  {
    constexpr int most_iterations = 100;
    const std::size_t none = static_cast<std::size_t>(m_k);
    m_clusters.assign(static_cast<std::size_t>(m_rows.cols()), none);
    double error = 0;
    for(int iteration = 0; iteration < most_iterations; ++iteration)
    {
      error = 0;
      bool is_changed = false;
      for(std::size_t i = 0; i < m_clusters.size(); ++i)
      {
        const auto column = static_cast<Eigen::Index>(i);
        Eigen::Index nearest;
        error += m_weights[column]
                 * (m_centers.colwise() - m_rows.col(column))
                     .colwise()
                     .squaredNorm()
                     .minCoeff(&nearest);
        const auto cluster = static_cast<std::size_t>(nearest);
        is_changed = is_changed || cluster != m_clusters[i];
        m_clusters[i] = cluster;
      }
      if(!is_changed)
        break;
      move_centers();
    }
    return error;
  }

  // The centers of empty clusters do not move.
  void move_centers()
  {
    Eigen::MatrixXd sums = Eigen::MatrixXd::Zero(m_centers.rows(), m_k);
    Eigen::VectorXd weights = Eigen::VectorXd::Zero(m_k);
    for(std::size_t i = 0; i < m_clusters.size(); ++i)
    {
      const auto column = static_cast<Eigen::Index>(i);
      const auto cluster = static_cast<Eigen::Index>(m_clusters[i]);
      sums.col(cluster) += m_weights[column] * m_rows.col(column);
      weights[cluster] += m_weights[column];
    }
    for(Eigen::Index c = 0; c < m_k; ++c)
      if(weights[c] > 0)
        m_centers.col(c) = sums.col(c) / weights[c];
  }

  const Eigen::MatrixXd m_rows; // transposed
  const Eigen::VectorXd m_weights;
  const Eigen::Index m_k;
  Eigen::MatrixXd m_centers, m_best_centers; // as columns
  std::vector<std::size_t> m_clusters;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_SEGMENTATION_K_MEANS_H
