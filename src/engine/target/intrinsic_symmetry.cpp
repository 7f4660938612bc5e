// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "intrinsic_symmetry.h"
#include "../support/Point_search.h"
#include "../support/plane_normals.h"

#include <CGAL/Canonical_pose_3/Intrinsic_symmetry_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/internal/support/Principal_axes.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_index.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

using Images = std::vector<std::size_t>;

// Of landmark multidimensional scaling (de Silva and Tenenbaum 2004): one row per point, and a column for each of the leading
// eigenvalues that is positive.
Eigen::MatrixXd embedding(const Landmark_fields_3& fields)
{
  constexpr Eigen::Index most = 10;
  constexpr double least = 1e-3; // by the first one
  const auto number = static_cast<Eigen::Index>(fields.landmarks.size());
  const Eigen::MatrixXd squared = fields.distances.cwiseAbs2();
  Eigen::MatrixXd between(number, number);
  for(Eigen::Index i = 0; i < number; ++i)
    between.row(i)
      = squared.row(static_cast<Eigen::Index>(fields.landmarks[static_cast<std::size_t>(i)]));
  between = (between + between.transpose()).eval() / 2;
  const Eigen::RowVectorXd means = between.colwise().mean();
  const Eigen::MatrixXd centered
    = -.5
      * (((between.rowwise() - means).colwise() - means.transpose()).array() + means.mean())
          .matrix();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(centered);
  const Eigen::VectorXd values = solver.eigenvalues().reverse();
  const Eigen::MatrixXd vectors = solver.eigenvectors().rowwise().reverse();
  Eigen::Index count = 0;
  while(count < (std::min)(most, number) && values[count] > least * values[0])
    ++count;
  return -.5 * (squared.rowwise() - means) * vectors.leftCols(count)
         * values.head(count).cwiseSqrt().cwiseInverse().asDiagonal();
}

Eigen::MatrixXd every(const Eigen::MatrixXd& rows, const Eigen::Index most)
{
  const Eigen::Index step = (std::max)(Eigen::Index(1), (rows.rows() + most - 1) / most);
  return rows(Eigen::seq(0, Eigen::last, step), Eigen::all);
}

// The orthogonal matrix that brings rows nearest to others (Schoenemann 1966).
Eigen::MatrixXd orthogonal_map(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& others)
{
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(rows.transpose() * others,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  return svd.matrixU() * svd.matrixV().transpose();
}

// For each row, the nearest one of others.
Images nearest_rows(const Eigen::MatrixXd& rows, const Eigen::MatrixXd& others)
{
  constexpr Eigen::Index size = 64;
  const Eigen::VectorXd squares = others.rowwise().squaredNorm();
  Images result(static_cast<std::size_t>(rows.rows()));
  for_each_block(
    result.size(),
    [&](std::size_t, const std::size_t begin, const std::size_t end) {
      const auto first = static_cast<Eigen::Index>(begin),
                 number = static_cast<Eigen::Index>(end - begin);
      Eigen::MatrixXd table = -2 * others * rows.middleRows(first, number).transpose();
      table.colwise() += squares;
      for(Eigen::Index i = 0; i < number; ++i)
      {
        Eigen::Index nearest = 0;
        table.col(i).minCoeff(&nearest);
        result[begin + static_cast<std::size_t>(i)] = static_cast<std::size_t>(nearest);
      }
    },
    size);
  return result;
}

std::vector<Eigen::Matrix3d> rotations_and_reflections(const Eigen::Matrix3d& axes)
{
  const Eigen::Matrix3d identity = Eigen::Matrix3d::Identity();
  std::vector<Eigen::Matrix3d> result;
  for(const Eigen::Vector3d& normal : plane_normals(axes))
    result.push_back(identity - 2 * normal * normal.transpose());
  for(Eigen::Index i = 0; i < 3; ++i)
    result.push_back(2 * axes.col(i) * axes.col(i).transpose() - identity);
  return result;
}

double root_mean_square(const Eigen::MatrixXd& rows)
{
  return std::sqrt(rows.squaredNorm() / static_cast<double>(rows.rows()));
}

class Symmetry_search
{
public:
  Symmetry_search(const Eigen::MatrixXd& embedding, const Eigen::MatrixXd& pose)
    : m_embedding(embedding), m_fixed(every(embedding, MOST_FIXED)),
      m_fixed_pose(every(pose, MOST_FIXED)), m_moving(every(m_fixed, MOST_MOVING)),
      m_moving_pose(every(m_fixed_pose, MOST_MOVING)), m_search(m_fixed_pose)
  {}

  struct Candidate
  {
    Images images; // of the moving points, among the fixed ones
    double distortion;
    double distance_from_identity; // the root mean square, relative to the radius of gyration
    bool is_rotation;
  };

  Candidate fitted(const Eigen::Matrix3d& start) const
  {
    constexpr int most = 30;
    Candidate result;
    Eigen::Matrix3d map = start;
    for(int i = 0; i < most; ++i)
    {
      Images images;
      for(const Images& nearest : m_search.nearest(m_moving_pose * map, 1))
        images.push_back(nearest[0]);
      if(images == result.images)
        break;
      result.images = std::move(images);
      map = orthogonal_map(m_moving_pose, m_fixed_pose(result.images, Eigen::all));
    }
    for(int i = 0; i < most; ++i)
    {
      Images images = nearest_rows(m_moving * embedded_map(result), m_fixed);
      if(images == result.images)
        break;
      result.images = std::move(images);
    }
    const Eigen::MatrixXd moved = m_fixed_pose(result.images, Eigen::all);
    result.distortion = distortion(result);
    result.distance_from_identity
      = root_mean_square(moved - m_moving_pose) / root_mean_square(m_fixed_pose);
    result.is_rotation = orthogonal_map(m_moving_pose, moved).determinant() > 0;
    return result;
  }

  Intrinsic_symmetry_3 of_all_points(const Candidate& candidate) const
  {
    return {nearest_rows(m_embedding * embedded_map(candidate), m_embedding), candidate.distortion};
  }

private:
  static constexpr Eigen::Index MOST_FIXED = 1200, MOST_MOVING = 400;

  Eigen::MatrixXd embedded_map(const Candidate& candidate) const
  {
    return orthogonal_map(m_moving, m_fixed(candidate.images, Eigen::all));
  }

  double distortion(const Candidate& candidate) const
  {
    const Eigen::MatrixXd moved = m_fixed(candidate.images, Eigen::all);
    double changes = 0, sum = 0;
    for(Eigen::Index i = 0; i < m_moving.rows(); ++i)
    {
      const Eigen::VectorXd before = (m_moving.rowwise() - m_moving.row(i)).rowwise().norm(),
                            after = (moved.rowwise() - moved.row(i)).rowwise().norm();
      changes += (after - before).squaredNorm();
      sum += before.squaredNorm();
    }
    return std::sqrt(changes / sum);
  }

  const Eigen::MatrixXd& m_embedding;
  const Eigen::MatrixXd m_fixed, m_fixed_pose, m_moving, m_moving_pose;
  const Point_search m_search;
};

} // namespace

std::optional<Intrinsic_symmetry_3> symmetry_of_pose(const Landmark_fields_3& fields,
                                                     const Point_matrix& pose,
                                                     const Eigen::VectorXd& shares)
{
  // Wrong maps of animals change distances by 1.4 times as much as the right one, or more. Maps of persons that exchange arms
  // alone, or legs alone, hardly differ from the one that exchanges both, the only rotation, and might undo the twist.
  constexpr double largest_distortion = .065, largest_ratio = 1.35, least_distance = .25;
  if(fields.landmarks.size() < 4 || !fields.distances.allFinite())
    return std::nullopt;
  const Eigen::MatrixXd rows = embedding(fields);
  const Principal_axes axes(pose, shares);
  const Eigen::MatrixXd centered = pose.rowwise() - axes.centroid;
  if(rows.cols() == 0 || !(centered.squaredNorm() > 0))
    return std::nullopt;
  const Symmetry_search search(rows, centered);
  const std::vector<Eigen::Matrix3d> starts = rotations_and_reflections(axes.axes);
  std::vector<Symmetry_search::Candidate> candidates(starts.size());
  for_each_index(starts.size(),
                 [&](const std::size_t i) { candidates[i] = search.fitted(starts[i]); });
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const auto& a, const auto& b) { return a.distortion < b.distortion; });
  const Symmetry_search::Candidate* best = nullptr;
  for(const Symmetry_search::Candidate& candidate : candidates)
    if(candidate.distance_from_identity >= least_distance
       && candidate.distortion
            <= (std::min)(largest_distortion, best ? largest_ratio * best->distortion : 1)
       && (!best || (candidate.is_rotation && !best->is_rotation)))
      best = &candidate;
  if(!best)
    return std::nullopt;
  return search.of_all_points(*best);
}

Point_matrix symmetric_pose(const Point_matrix& pose, const std::vector<std::size_t>& images,
                            const Eigen::VectorXd& shares)
{
  const Eigen::VectorXd weights = shares / shares.sum();
  Point_matrix moved = rows_at(pose, images);
  const Eigen::RowVector3d mean = weights.transpose() * pose,
                           mean_of_images = weights.transpose() * moved;
  const Point_matrix centered = pose.rowwise() - mean;
  moved.rowwise() -= mean_of_images;
  moved = moved * orthogonal_map(weights.asDiagonal() * moved, centered);
  return ((centered + moved) / 2).rowwise() + mean;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
