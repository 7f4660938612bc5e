// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Coarse_match.h"
#include "Deformable_pose.h"
#include "../support/Point_search.h"
#include "edge_strain.h"

#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

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

constexpr std::size_t ALL = (std::numeric_limits<std::size_t>::max)();

// The nearest one of what is counted of `shape`, in a position that `search` knows, for each one of `points`.
Indices nearest(const Matchable_data& shape, const Point_search& search, const Point_matrix& points)
{
  Indices result;
  for(const Indices& one : search.nearest(points, 1))
    result.push_back(shape.counted[one[0]]);
  return result;
}

// functions^t * values
Eigen::MatrixXd
transposed_product(const Eigen::Ref<const Function_matrix, 0, Eigen::OuterStride<>>& functions,
                   const Function_matrix& values)
{
  constexpr std::size_t size = 16;
  Eigen::MatrixXf result(functions.cols(), values.cols());
  for_each_block(
    static_cast<std::size_t>(values.cols()),
    [&](std::size_t, const std::size_t begin, const std::size_t end) {
      const auto first = static_cast<Eigen::Index>(begin),
                 number = static_cast<Eigen::Index>(end - begin);
      result.middleCols(first, number).noalias()
        = functions.transpose() * values.middleCols(first, number);
    },
    size);
  return result.cast<double>();
}

// functions * coefficients
Function_matrix
combinations(const Eigen::Ref<const Function_matrix, 0, Eigen::OuterStride<>>& functions,
             const Eigen::MatrixXd& given_coefficients)
{
  const Eigen::MatrixXf coefficients = given_coefficients.cast<float>();
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

// Means of each row and of the mean of its neighbors.
Point_matrix halfway_to_neighbors(const Point_matrix& rows,
                                  const std::vector<std::array<std::size_t, 3>>& triangles)
{
  Point_matrix sums = Point_matrix::Zero(rows.rows(), 3);
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(rows.rows());
  for(const std::array<std::size_t, 3>& triangle : triangles)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const auto i = static_cast<Eigen::Index>(triangle[k]),
                 j = static_cast<Eigen::Index>(triangle[(k + 1) % 3]);
      sums.row(i) += rows.row(j);
      sums.row(j) += rows.row(i);
      numbers[i] += 1;
      numbers[j] += 1;
    }
  return .5 * (rows + numbers.cwiseInverse().asDiagonal() * sums);
}

} // namespace

// By what points are compared, in units of its residuals: functions, reliefs, normals and positions. The first columns are zero,
// for the number of columns to be a multiple of `STEP`.
struct Coarse_match::Features
{
  static constexpr Eigen::Index STEP = 16;
  Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> values;
  Point_matrix normals;

  // Or any number that is not less than `limit`, if it is not. The last columns differ most among neighbors.
  float squared_distance(const std::size_t i, const Features& other, const std::size_t j,
                         const float limit) const
  {
    const auto row = values.row(static_cast<Eigen::Index>(i)),
               row_of_other = other.values.row(static_cast<Eigen::Index>(j));
    float sum = 0;
    for(Eigen::Index k = values.cols(); k > 0 && sum < limit; k -= STEP)
      sum += (row.segment<STEP>(k - STEP) - row_of_other.segment<STEP>(k - STEP)).squaredNorm();
    return sum;
  }

  // Sets the partners of samples: of candidates on the same side of thin parts, or of all if there is none, the nearest one.
  // Candidates are the previous one and those that are nearby `first`, which has one for each sample.
  void set_partners(const Indices& samples, const Indices& first,
                    const std::vector<Indices>& nearby, const Features& others,
                    Indices& partners) const
  {
    constexpr double least_cosine = -.5;
    constexpr float infinity = (std::numeric_limits<float>::infinity)();
    for_each_block(
      samples.size(),
      [&](std::size_t, const std::size_t begin, const std::size_t end) {
        for(std::size_t s = begin; s < end; ++s)
        {
          const std::size_t i = samples[s], previous = partners[i];
          std::pair<bool, float> least(true, infinity);
          const auto is_other_side = [&](const std::size_t j) {
            return normals.row(static_cast<Eigen::Index>(i))
                     .dot(others.normals.row(static_cast<Eigen::Index>(j)))
                   < least_cosine;
          };
          const auto compare = [&](const std::size_t j) {
            const bool is_first_of_this_side = least.first && !is_other_side(j);
            const float limit = is_first_of_this_side ? infinity : least.second;
            const float distance = squared_distance(i, others, j, limit);
            if(distance < limit && (least.first || !is_other_side(j)))
            {
              least = {!is_first_of_this_side && least.first, distance};
              partners[i] = j;
            }
          };
          compare(previous);
          for(const std::size_t j : nearby[first[s]])
            compare(j);
        }
      },
      64);
  }
};

Coarse_match::Coarse_match(const Matchable_data& a, const Matchable_data& b,
                           const Eigen::Matrix3d& rotation, const Match_options& options,
                           Indices landmarks_of_a, Indices landmarks_of_b)
  : m_a(a), m_b(b), m_options(options), m_rotation(rotation), m_rest(a.coarse_pose * rotation),
    m_position(m_rest), m_normals_of_b(rows_at(b.normals, b.coarse.vertices)),
    m_landmarks_of_a(std::move(landmarks_of_a)), m_landmarks_of_b(std::move(landmarks_of_b)),
    m_forward(nearest(b, *b.search, m_position)),
    m_backward(nearest(a, Point_search(rows_at(m_position, a.counted)), b.coarse_pose)),
    m_samples_of_a(a.counted), m_samples_of_b(b.counted)
{}

// Only some of the vertices are compared, except at last.
void Coarse_match::refine(const Eigen::Index most)
{
  constexpr Eigen::Index fewest = 8, few = 40;
  constexpr std::size_t few_samples = 900, more_samples = 1500;
  const Eigen::Index last = (std::min)(most, number_of_functions());
  while(m_count < last)
  {
    m_count
      = (std::min)(last, (std::max)(fewest, m_count + (std::max)(Eigen::Index(2), m_count / 6)));
    update(m_count, true, m_count == last ? ALL : m_count < few ? few_samples : more_samples);
  }
}

void Coarse_match::deform()
{
  constexpr double detail_length = .03, least_detail_length = .004;
  if(m_options.number_of_registrations == 0)
    return;
  Deformable_pose pose(m_a.deformable_body());
  pose.set_detail_length(detail_length);
  for(int i = 0; i <= m_options.number_of_registrations; ++i)
  {
    const bool is_last = i == m_options.number_of_registrations;
    if(is_last)
      pose.set_detail_length(least_detail_length);
    m_position
      = pose.registered_to(targets() * m_rotation.transpose(), m_position * m_rotation.transpose())
        * m_rotation;
    if(!is_last)
      update(m_count, false, ALL);
  }
}

double Coarse_match::cost() const
{
  constexpr double inside_out = 1e6;
  // What is less is due to the vertices that happen to be there: of a symmetric shape, one rotation may match them exactly.
  constexpr double least_strain = .3, least_residual = .05, least_residual_of_reliefs = 2e-4,
                   least_distance = .02;
  const double residual = m_weights.cwiseInverse().mean(),
               residual_of_reliefs
               = m_weights_of_reliefs.size() == 0 ? 1 : m_weights_of_reliefs.cwiseInverse().mean();
  return (std::max)(strain(), least_strain) * (std::max)(residual, least_residual)
         * (std::max)(residual_of_reliefs, least_residual_of_reliefs)
         * (std::max)(mean_distance(), least_distance) * (preserves_orientation() ? 1 : inside_out);
}

// By how much the match changes the lengths of edges, relative to their sum.
double Coarse_match::strain() const
{
  return edge_strain(
    m_a.coarse.surface.points, m_a.root_of_area, rows_at(m_b.coarse.surface.points, m_forward),
    m_b.root_of_area, m_a.coarse.surface.triangles,
    [&](const std::array<std::size_t, 3>& triangle) { return is_counted(triangle); });
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

Eigen::Index Coarse_match::number_of_functions() const
{
  return (std::min)({static_cast<Eigen::Index>(m_options.number_of_functions), m_a.functions.cols(),
                     m_b.functions.cols()});
}

// Compares at least this number of vertices.
void Coarse_match::update(const Eigen::Index count, const bool moves, const std::size_t number)
{
  constexpr int repetitions = 2;
  const Indices samples_of_a = m_a.samples(number), samples_of_b = m_b.samples(number);
  const Indices first = nearest(m_b, *m_b.search, rows_at(m_position, samples_of_a)),
                first_of_b = nearest(m_a, Point_search(rows_at(m_position, m_a.counted)),
                                     rows_at(m_b.coarse_pose, samples_of_b));
  for(int i = 0; i < (moves ? repetitions : 1); ++i)
  {
    const Features features = features_of_a(count, moves), others = features_of_b(count);
    features.set_partners(samples_of_a, first, m_b.nearby, others, m_forward);
    others.set_partners(samples_of_b, first_of_b, m_a.nearby, features, m_backward);
    m_samples_of_a = samples_of_a;
    m_samples_of_b = samples_of_b;
  }
}

// Calls function(vertex of a, vertex of b, weight) for the samples, in both directions, and for the landmarks.
template <class Function>
void Coarse_match::for_each_pair(const Function& function) const
{
  constexpr double share = .05; // of each landmark, among all pairs
  for(const std::size_t i : m_samples_of_a)
    function(i, m_forward[i], 1.);
  for(const std::size_t j : m_samples_of_b)
    function(m_backward[j], j, 1.);
  const double weight = share * static_cast<double>(m_samples_of_a.size() + m_samples_of_b.size());
  for(std::size_t l = 0; l < m_landmarks_of_a.size(); ++l)
    function(m_landmarks_of_a[l], m_landmarks_of_b[l], weight);
}

// Where the pairs say that vertices are; those without any stay. Moves are smoothed: partners are vertices, so they are noisy.
Point_matrix Coarse_match::targets() const
{
  constexpr int number_of_smoothings = 2;
  Point_matrix moves = Point_matrix::Zero(m_position.rows(), 3);
  Eigen::VectorXd numbers = Eigen::VectorXd::Zero(m_position.rows());
  for_each_pair([&](const std::size_t i, const std::size_t j, const double weight) {
    const auto row = static_cast<Eigen::Index>(i);
    moves.row(row)
      += weight * (m_b.coarse_pose.row(static_cast<Eigen::Index>(j)) - m_position.row(row));
    numbers[row] += weight;
  });
  for(Eigen::Index i = 0; i < numbers.size(); ++i)
    if(numbers[i] > 0)
      moves.row(i) /= numbers[i];
  for(int k = 0; k < number_of_smoothings; ++k)
    moves = halfway_to_neighbors(moves, m_a.coarse.surface.triangles);
  return m_position + moves;
}

// The functional map is that of least squares over the pairs; each vertex of the first surface has a sum of its partners and a
// number of them.
Coarse_match::Features Coarse_match::features_of_a(const Eigen::Index count, const bool moves)
{
  constexpr double least = 1e-3, factor_of_normals = 4;
  constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  const auto functions = m_a.functions.leftCols(count);
  Indices vertices, place(m_a.counted.back() + 1, none); // that have partners
  for_each_pair([&](const std::size_t i, std::size_t, double) {
    if(place[i] == none)
    {
      place[i] = vertices.size();
      vertices.push_back(i);
    }
  });
  const auto n = static_cast<Eigen::Index>(vertices.size());
  Eigen::VectorXf numbers = Eigen::VectorXf::Zero(n);
  Function_matrix sums = Function_matrix::Zero(n, count), move_sums = Function_matrix::Zero(n, 3);
  Eigen::RowVectorXd squares = Eigen::RowVectorXd::Zero(count);
  for_each_pair([&](const std::size_t i, const std::size_t j, const double given_weight) {
    const auto of_a = static_cast<Eigen::Index>(i), of_b = static_cast<Eigen::Index>(j),
               row = static_cast<Eigen::Index>(place[i]);
    const auto partner = m_b.functions.row(of_b).head(count);
    const auto weight = static_cast<float>(given_weight);
    numbers[row] += weight;
    sums.row(row) += weight * partner;
    squares += weight * partner.cwiseAbs2().cast<double>();
    move_sums.row(row) += weight * (m_b.coarse_pose.row(of_b) - m_rest.row(of_a)).cast<float>();
  });

  const Function_matrix sampled = rows_at(functions, vertices);
  const Eigen::MatrixXd products
    = transposed_product(sampled, Function_matrix(numbers.asDiagonal() * sampled)),
    mixed = transposed_product(sampled, sums);
  const Eigen::LDLT<Eigen::MatrixXd> factor(
    products + 1e-9 * products.trace() * Eigen::MatrixXd::Identity(count, count));
  m_map = factor.solve(mixed);
  if(moves)
    m_position = m_rest
                 + combinations(functions, factor.solve(transposed_product(sampled, move_sums)))
                     .cast<double>();
  m_weights
    = ((m_map.cwiseProduct(products * m_map - 2 * mixed).colwise().sum() + squares) / numbers.sum())
        .cwiseMax(least * least)
        .cwiseSqrt()
        .cwiseInverse();
  const Point_matrix normals = vertex_normals(m_position, m_a.coarse.surface.triangles);
  set_weights_of_details(normals, moves ? 0 : factor_of_normals);
  return features(m_a, combinations(functions, m_map * m_weights.asDiagonal()), normals,
                  m_position);
}

Coarse_match::Features Coarse_match::features_of_b(const Eigen::Index count) const
{
  return features(m_b, m_b.functions.leftCols(count) * m_weights.cast<float>().asDiagonal(),
                  m_normals_of_b, m_b.coarse_pose);
}

// Reliefs tell more than functions do where lengths change with the posture; and once limbs have been turned, normals do.
void Coarse_match::set_weights_of_details(const Point_matrix& normals,
                                          const double factor_of_normals)
{
  constexpr double factor_of_reliefs = 2.5, least = 1e-4;
  const Eigen::Index count = (std::min)(m_a.reliefs.cols(), m_b.reliefs.cols());
  double sum = 0, squares_of_positions = 0, squares_of_normals = 0;
  Eigen::RowVectorXd squares_of_reliefs = Eigen::RowVectorXd::Zero(count);
  for_each_pair([&](const std::size_t i, const std::size_t j, const double weight) {
    const auto of_a = static_cast<Eigen::Index>(i), of_b = static_cast<Eigen::Index>(j);
    sum += weight;
    squares_of_positions += weight * squared_distance(i, j);
    squares_of_normals += weight * (normals.row(of_a) - m_normals_of_b.row(of_b)).squaredNorm();
    squares_of_reliefs += weight
                          * (m_a.reliefs.row(of_a).head(count) - m_b.reliefs.row(of_b).head(count))
                              .cast<double>()
                              .cwiseAbs2();
  });
  const auto inverse_residual
    = [&](const double squares) { return 1 / (std::max)(std::sqrt(squares / (3 * sum)), least); };
  m_weight_of_positions = m_options.pose_weight * inverse_residual(squares_of_positions);
  m_weight_of_normals = factor_of_normals * inverse_residual(squares_of_normals);
  m_weights_of_reliefs
    = factor_of_reliefs * (squares_of_reliefs / sum).cwiseSqrt().cwiseMax(least).cwiseInverse();
}

Coarse_match::Features Coarse_match::features(const Matchable_data& shape,
                                              const Function_matrix& functions,
                                              const Point_matrix& normals,
                                              const Point_matrix& positions) const
{
  const Eigen::Index count = m_weights_of_reliefs.size(), number = functions.cols() + count + 6,
                     blocks = (number + Features::STEP - 1) / Features::STEP;
  Features result = {{functions.rows(), Features::STEP * blocks}, normals};
  result.values.leftCols(result.values.cols() - number).setZero();
  result.values.rightCols(number) << functions,
    shape.reliefs.leftCols(count) * m_weights_of_reliefs.cast<float>().asDiagonal(),
    (m_weight_of_normals * normals).cast<float>(),
    (m_weight_of_positions * positions).cast<float>();
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
