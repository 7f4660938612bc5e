// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "pose_rotations.h"
#include "../support/Point_search.h"
#include "../target/aligning_motion.h"

#include <CGAL/Canonical_pose_3/internal/support/values_at.h>

#include <CGAL/number_utils.h>

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace {

// Bring principal axes of similar lengths onto each other and, where two axes of a surface are similar, onto directions between
// them.
std::vector<Eigen::Matrix3d> first_rotations(const Eigen::Vector3d& lengths,
                                             const Eigen::Vector3d& lengths_of_other)
{
  constexpr double largest_ratio = 1.25, half_a_right_angle = CGAL_PI / 4;
  const auto are_similar = [](const double length, const double other) {
    return length < largest_ratio * other && other < largest_ratio * length;
  };
  std::vector<Eigen::Matrix3d> result;
  std::array<Eigen::Index, 3> axes = {0, 1, 2};
  do
  {
    bool is_similar = true;
    for(std::size_t k = 0; k < 3; ++k)
      is_similar = is_similar
                   && are_similar(lengths[axes[k]], lengths_of_other[static_cast<Eigen::Index>(k)]);
    if(!is_similar && axes != std::array<Eigen::Index, 3>{0, 1, 2})
      continue;
    for(int signs = 0; signs < 8; ++signs)
    {
      Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
      for(std::size_t k = 0; k < 3; ++k)
        matrix(axes[k], static_cast<Eigen::Index>(k)) = (signs >> k) % 2 == 0 ? 1 : -1;
      if(matrix.determinant() > 0)
        result.push_back(matrix);
    }
  } while(std::next_permutation(axes.begin(), axes.end()));
  const std::size_t number = result.size();
  for(Eigen::Index k = 0; k < 3; ++k)
  {
    const Eigen::Index i = (k + 1) % 3, j = (k + 2) % 3;
    if(are_similar(lengths[i], lengths[j]) || are_similar(lengths_of_other[i], lengths_of_other[j]))
      for(std::size_t r = 0; r < number; ++r)
        result.push_back(
          result[r]
          * Eigen::AngleAxisd(half_a_right_angle, Eigen::Vector3d::Unit(k)).toRotationMatrix());
  }
  return result;
}

// Iterated closest points (Besl and McKay 1992), of both surfaces to each other.
class Rotation_search
{
public:
  Rotation_search(const Point_matrix& points, const Point_matrix& others)
    : m_points(points), m_others(others), m_search(points), m_search_others(others),
      m_from(points.rows() + others.rows(), 3), m_to(m_from.rows(), 3),
      m_shares(Eigen::VectorXd::Constant(m_from.rows(), 1. / static_cast<double>(m_from.rows())))
  {
    m_from.topRows(points.rows()) = points;
    m_to.bottomRows(others.rows()) = others;
  }

  Pose_rotation nearest_to(const Eigen::Matrix3d& start)
  {
    constexpr int most = 10;
    constexpr double least_change = 1e-2;
    Pose_rotation last = {start, set_pairs(start)}, result = last;
    for(int i = 0; i < most; ++i)
    {
      const Eigen::Matrix3d matrix = aligning_rotation(m_from, m_to, m_shares).transpose();
      const double change = (matrix - last.matrix).norm();
      last = {matrix, set_pairs(matrix)};
      if(last.distance < result.distance)
        result = last;
      if(change < least_change)
        break;
    }
    return result;
  }

private:
  // Of nearest points; returns the mean of their distances.
  double set_pairs(const Eigen::Matrix3d& matrix)
  {
    const auto nearest = m_search_others.nearest(m_points * matrix, 1),
               nearest_of_others = m_search.nearest(m_others * matrix.transpose(), 1);
    for(std::size_t i = 0; i < nearest.size(); ++i)
      m_to.row(static_cast<Eigen::Index>(i))
        = m_others.row(static_cast<Eigen::Index>(nearest[i][0]));
    for(std::size_t j = 0; j < nearest_of_others.size(); ++j)
      m_from.row(m_points.rows() + static_cast<Eigen::Index>(j))
        = m_points.row(static_cast<Eigen::Index>(nearest_of_others[j][0]));
    const Eigen::VectorXd distances = (m_from * matrix - m_to).rowwise().norm();
    return .5 * (distances.head(m_points.rows()).mean() + distances.tail(m_others.rows()).mean());
  }

  const Point_matrix &m_points, &m_others;
  const Point_search m_search, m_search_others;
  Point_matrix m_from,
    m_to; // pairs: the nearest other of each point, and the nearest point of each other
  const Eigen::VectorXd m_shares;
};

} // namespace

std::vector<Pose_rotation> pose_rotations(const Matchable_data& a, const Matchable_data& b)
{
  constexpr std::size_t number_of_points = 500;
  constexpr double same = .2; // norm of the difference of matrices
  const Point_matrix points = rows_at(a.coarse_pose, a.samples(number_of_points)),
                     others = rows_at(b.coarse_pose, b.samples(number_of_points));
  Rotation_search search(points, others);
  std::vector<Pose_rotation> all, result;
  for(const Eigen::Matrix3d& start : first_rotations(a.lengths_of_axes, b.lengths_of_axes))
    all.push_back(search.nearest_to(start));
  std::stable_sort(all.begin(), all.end(), [](const Pose_rotation& r, const Pose_rotation& s) {
    return r.distance < s.distance;
  });
  for(const Pose_rotation& rotation : all)
    if(std::none_of(result.begin(), result.end(), [&](const Pose_rotation& other) {
         return (rotation.matrix - other.matrix).norm() < same;
       }))
      result.push_back(rotation);
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
