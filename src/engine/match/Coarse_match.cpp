// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Coarse_match.h"
#include "Deformable_pose.h"
#include "../support/Point_search.h"

#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

namespace {

using Indices = Coarse_match::Indices;

// The nearest one of what is counted of `shape`, in a position that `search` knows, for each one of `points`.
Indices nearest(const Matchable_data& shape, const Point_search& search, const Point_matrix& points)
{
  Indices result;
  for(const Indices& one : search.nearest(points, 1))
    result.push_back(shape.counted[one[0]]);
  return result;
}

Indices nearest(const Matchable_data& shape, const Point_matrix& positions,
                const Point_matrix& points)
{
  return nearest(shape, Point_search(rows_at(positions, shape.counted)), points);
}

// functions^t * values
Eigen::MatrixXd
transposed_product(const Eigen::Ref<const Function_matrix, 0, Eigen::OuterStride<>>& functions,
                   const Function_matrix& values)
{
  constexpr std::size_t size = 16;
  Eigen::MatrixXd result(functions.cols(), values.cols());
  for_each_block(
    static_cast<std::size_t>(values.cols()),
    [&](std::size_t, const std::size_t begin, const std::size_t end) {
      const auto first = static_cast<Eigen::Index>(begin),
                 number = static_cast<Eigen::Index>(end - begin);
      result.middleCols(first, number).noalias()
        = functions.transpose() * values.middleCols(first, number);
    },
    size);
  return result;
}

// functions * coefficients
Function_matrix
combinations(const Eigen::Ref<const Function_matrix, 0, Eigen::OuterStride<>>& functions,
             const Eigen::MatrixXd& coefficients)
{
  Function_matrix result(functions.rows(), coefficients.cols());
  for_each_block(static_cast<std::size_t>(functions.rows()),
                 [&](std::size_t, const std::size_t begin, const std::size_t end) {
                   const auto first = static_cast<Eigen::Index>(begin),
                              number = static_cast<Eigen::Index>(end - begin);
                   result.middleRows(first, number).noalias()
                     = functions.middleRows(first, number) * coefficients;
                 });
  return result;
}

} // namespace

// By what points are compared: positions, functions and reliefs, in units of their residuals.
struct Coarse_match::Features
{
  Function_matrix functions;
  Point_matrix positions;
  const Point_matrix& normals;

  // Or any number that is not less than `limit`, if it is not.
  double squared_distance(const std::size_t i, const Features& other, const std::size_t j,
                          const double limit) const
  {
    constexpr Eigen::Index step = 16;
    const auto row = static_cast<Eigen::Index>(i), row_of_other = static_cast<Eigen::Index>(j);
    double sum = (positions.row(row) - other.positions.row(row_of_other)).squaredNorm();
    for(Eigen::Index k = 0; k < functions.cols() && sum < limit; k += step)
    {
      const Eigen::Index number = (std::min)(step, functions.cols() - k);
      sum += (functions.row(row).segment(k, number)
              - other.functions.row(row_of_other).segment(k, number))
               .squaredNorm();
    }
    return sum;
  }

  // Of candidates on the same side of thin parts, or of all if there is none, the nearest one.
  Indices nearest(const Indices& first, const std::vector<Indices>& nearby,
                  const Features& others) const
  {
    constexpr double least_cosine = -.5;
    Indices result(first.size());
    for_each_block(
      result.size(),
      [&](std::size_t, const std::size_t begin, const std::size_t end) {
        for(std::size_t i = begin; i < end; ++i)
        {
          std::pair<bool, double> least(true, (std::numeric_limits<double>::infinity)());
          for(const std::size_t j : nearby[first[i]])
          {
            const bool is_other_side = normals.row(static_cast<Eigen::Index>(i))
                                         .dot(others.normals.row(static_cast<Eigen::Index>(j)))
                                       < least_cosine;
            if(is_other_side > least.first)
              continue;
            const double limit = is_other_side < least.first
                                   ? (std::numeric_limits<double>::infinity)()
                                   : least.second;
            if(const double distance = squared_distance(i, others, j, limit); distance < limit)
            {
              least = {is_other_side, distance};
              result[i] = j;
            }
          }
        }
      },
      256);
    return result;
  }
};

Coarse_match::Coarse_match(const Matchable_data& a, const Matchable_data& b,
                           const Eigen::Matrix3d& rotation, const Match_options& options,
                           Indices landmarks_of_a, Indices landmarks_of_b)
  : m_a(a), m_b(b), m_options(options), m_rest(a.coarse_pose * rotation), m_position(m_rest),
    m_normals(rows_at(a.normals, a.coarse.vertices) * rotation),
    m_normals_of_b(rows_at(b.normals, b.coarse.vertices)),
    m_landmarks_of_a(std::move(landmarks_of_a)), m_landmarks_of_b(std::move(landmarks_of_b)),
    m_forward(nearest(b, *b.search, m_position)), m_backward(nearest(a, m_position, b.coarse_pose))
{}

void Coarse_match::refine(const Eigen::Index most)
{
  constexpr Eigen::Index fewest = 8;
  const Eigen::Index last = (std::min)(most, number_of_functions());
  while(m_count < last)
  {
    m_count
      = (std::min)(last, (std::max)(fewest, m_count + (std::max)(Eigen::Index(2), m_count / 6)));
    update(m_count, true);
  }
}

void Coarse_match::deform()
{
  constexpr double detail_length = .03, least_detail_length = .02, pose_weight = 3;
  constexpr Eigen::Index most_functions = 60;
  if(m_options.number_of_registrations == 0)
    return;
  Deformable_pose pose(m_rest, m_a.coarse.surface.triangles);
  pose.set_detail_length(detail_length);
  m_pose_weight = pose_weight;
  for(int i = 0; i <= m_options.number_of_registrations; ++i)
  {
    const bool is_last = i == m_options.number_of_registrations;
    if(is_last)
      pose.set_detail_length(least_detail_length);
    m_position = pose.registered_to(rows_at(m_b.coarse_pose, m_forward), m_position);
    if(!is_last)
      update((std::min)(most_functions, number_of_functions()), false);
  }
}

double Coarse_match::cost() const
{
  constexpr double inside_out = 1e6;
  const double residual = m_weights.cwiseInverse().mean(),
               residual_of_reliefs
               = m_weights_of_reliefs.size() == 0 ? 1 : m_weights_of_reliefs.cwiseInverse().mean();
  return strain() * residual * residual_of_reliefs * mean_distance()
         * (preserves_orientation() ? 1 : inside_out);
}

// By how much the match changes the lengths of edges, relative to their sum.
double Coarse_match::strain() const
{
  double changes = 0, sum = 0;
  for(const std::array<std::size_t, 3>& triangle : m_a.coarse.surface.triangles)
    for(std::size_t k = 0; k < 3 && is_counted(triangle); ++k)
    {
      const std::size_t i = triangle[k], j = triangle[(k + 1) % 3];
      const double length = length_of(m_a, i, j);
      changes += std::abs(length_of(m_b, m_forward[i], m_forward[j]) - length);
      sum += length;
    }
  return changes / sum;
}

double Coarse_match::mean_distance() const
{
  double sum = 0;
  for(const std::size_t i : m_a.counted)
    sum += std::sqrt(squared_distance(i, m_forward[i]));
  return sum / static_cast<double>(m_a.counted.size());
}

// Whether most triangles have the side outside that they should have.
bool Coarse_match::preserves_orientation() const
{
  long long sum = 0;
  for(const std::array<std::size_t, 3>& t : m_a.coarse.surface.triangles)
  {
    if(!is_counted(t))
      continue;
    const auto row = [&](const Point_matrix& points, const std::size_t k) {
      return Eigen::Vector3d(points.row(static_cast<Eigen::Index>(m_forward[t[k]])).transpose());
    };
    const Eigen::Vector3d p = row(m_b.coarse_pose, 0);
    const double side
      = (row(m_b.coarse_pose, 1) - p)
          .cross(row(m_b.coarse_pose, 2) - p)
          .dot(row(m_normals_of_b, 0) + row(m_normals_of_b, 1) + row(m_normals_of_b, 2));
    sum += side > 0 ? 1 : side < 0 ? -1 : 0;
  }
  return sum >= 0;
}

bool Coarse_match::is_counted(const std::array<std::size_t, 3>& triangle) const
{
  return m_a.is_counted[m_a.coarse.vertices[triangle[0]]];
}

double Coarse_match::length_of(const Matchable_data& shape, const std::size_t i,
                               const std::size_t j)
{
  const Point_matrix& points = shape.coarse.surface.points;
  return (points.row(static_cast<Eigen::Index>(i)) - points.row(static_cast<Eigen::Index>(j)))
           .norm()
         / shape.root_of_area;
}

Eigen::Index Coarse_match::number_of_functions() const
{
  return (std::min)({static_cast<Eigen::Index>(m_options.number_of_functions), m_a.functions.cols(),
                     m_b.functions.cols()});
}

void Coarse_match::update(const Eigen::Index count, const bool moves)
{
  constexpr int repetitions = 2;
  const Indices first = nearest(m_b, *m_b.search, m_position),
                first_of_b = nearest(m_a, m_position, m_b.coarse_pose);
  for(int i = 0; i < (moves ? repetitions : 1); ++i)
  {
    const Features features = features_of_a(count, moves), others = features_of_b(count);
    m_forward = features.nearest(first, m_b.nearby, others);
    m_backward = others.nearest(first_of_b, m_a.nearby, features);
  }
}

// The functional map is that of least squares over the pairs in both directions and the landmarks; each vertex of the first
// surface has a sum of its partners and a number of them.
Coarse_match::Features Coarse_match::features_of_a(const Eigen::Index count, const bool moves)
{
  constexpr double share = .05; // of each landmark, among all pairs
  constexpr double least = 1e-3;
  const Eigen::Index n = m_a.functions.rows();
  const auto number_of_counted = static_cast<double>(m_a.counted.size() + m_b.counted.size());
  const auto functions = m_a.functions.leftCols(count);
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(n);
  Function_matrix sums = Function_matrix::Zero(n, count), move_sums = Function_matrix::Zero(n, 3);
  Eigen::RowVectorXd squares = Eigen::RowVectorXd::Zero(count);
  double residual = 0;
  const auto add = [&](const std::size_t i, const std::size_t j, const double weight) {
    const auto of_a = static_cast<Eigen::Index>(i), of_b = static_cast<Eigen::Index>(j);
    const auto partner = m_b.functions.row(of_b).head(count);
    numbers[of_a] += weight;
    sums.row(of_a) += weight * partner;
    squares += weight * partner.cwiseAbs2();
    move_sums.row(of_a) += weight * (m_b.coarse_pose.row(of_b) - m_rest.row(of_a));
  };
  for(const std::size_t i : m_a.counted)
    add(i, m_forward[i], 1);
  for(const std::size_t j : m_b.counted)
    add(m_backward[j], j, 1);
  for(std::size_t l = 0; l < m_landmarks_of_a.size(); ++l)
    add(m_landmarks_of_a[l], m_landmarks_of_b[l], share * number_of_counted);

  const Eigen::MatrixXd products
    = transposed_product(functions, Function_matrix(numbers.asDiagonal() * functions)),
    mixed = transposed_product(functions, sums);
  const Eigen::LDLT<Eigen::MatrixXd> factor(
    products + 1e-9 * products.trace() * Eigen::MatrixXd::Identity(count, count));
  m_map = factor.solve(mixed);
  if(moves)
    m_position = m_rest
                 + Point_matrix(
                   combinations(functions, factor.solve(transposed_product(functions, move_sums))));
  m_weights
    = ((m_map.cwiseProduct(products * m_map - 2 * mixed).colwise().sum() + squares) / numbers.sum())
        .cwiseMax(least * least)
        .cwiseSqrt()
        .cwiseInverse();
  for(const std::size_t i : m_a.counted)
    residual += squared_distance(i, m_forward[i]);
  for(const std::size_t j : m_b.counted)
    residual += squared_distance(m_backward[j], j);
  residual = (std::max)(std::sqrt(residual / (3 * number_of_counted)), least / 10);
  m_weight_of_positions = m_pose_weight * m_options.pose_weight / residual;
  set_weights_of_reliefs();
  return {with_reliefs(combinations(functions, m_map * m_weights.asDiagonal()), m_a),
          m_weight_of_positions * m_position, m_normals};
}

Coarse_match::Features Coarse_match::features_of_b(const Eigen::Index count) const
{
  return {with_reliefs(m_b.functions.leftCols(count) * m_weights.asDiagonal(), m_b),
          m_weight_of_positions * m_b.coarse_pose, m_normals_of_b};
}

// Reliefs tell more than functions do where lengths change with the posture.
void Coarse_match::set_weights_of_reliefs()
{
  constexpr double factor = 3, least = 1e-4;
  const Eigen::Index count = (std::min)(m_a.reliefs.cols(), m_b.reliefs.cols());
  Eigen::RowVectorXd squares = Eigen::RowVectorXd::Zero(count);
  for(const std::size_t i : m_a.counted)
    squares += (m_a.reliefs.row(static_cast<Eigen::Index>(i)).head(count)
                - m_b.reliefs.row(static_cast<Eigen::Index>(m_forward[i])).head(count))
                 .cwiseAbs2();
  m_weights_of_reliefs = factor
                         * (squares / static_cast<double>(m_a.counted.size()))
                             .cwiseSqrt()
                             .cwiseMax(least)
                             .cwiseInverse();
}

Function_matrix Coarse_match::with_reliefs(const Function_matrix& functions,
                                           const Matchable_data& shape) const
{
  const Eigen::Index count = m_weights_of_reliefs.size();
  Function_matrix result(functions.rows(), functions.cols() + count);
  result << shape.reliefs.leftCols(count) * m_weights_of_reliefs.asDiagonal(), functions;
  return result;
}

double Coarse_match::squared_distance(const std::size_t i, const std::size_t j) const
{
  return (m_position.row(static_cast<Eigen::Index>(i))
          - m_b.coarse_pose.row(static_cast<Eigen::Index>(j)))
    .squaredNorm();
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
