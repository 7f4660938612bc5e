// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../target/nearest_in_triangle.h"
#include "Deformable_pose.h"
#include "Matchable_data.h"
#include "Point_search.h"

#include <CGAL/Canonical_pose_3/Match_options.h>
#include <CGAL/Canonical_pose_3/Matchable_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_match_3.h>
#include <CGAL/Canonical_pose_3/call_with_threads.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/match_surfaces.h>

#include <Eigen/Core>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace matching {
namespace {

using Indices = std::vector<std::size_t>;

// ---- rotation ------------------------------------------------------------------------------------------

struct Rotation
{
  Eigen::Matrix3d matrix; // for rows: point * matrix
  double distance;        // mean of nearest points, both ways
};

Point_matrix every(const Point_matrix& points, const Eigen::Index most)
{
  const Eigen::Index step = (std::max)(Eigen::Index(1), points.rows() / most);
  Point_matrix result((points.rows() + step - 1) / step, 3);
  for(Eigen::Index i = 0; i < result.rows(); ++i)
    result.row(i) = points.row(i * step);
  return result;
}

double mean_distance(const Point_matrix& points, const Point_search& search,
                     const Point_matrix& others)
{
  const auto nearest = search.nearest(points, 1);
  double sum = 0;
  for(std::size_t i = 0; i < nearest.size(); ++i)
    sum += (points.row(static_cast<Eigen::Index>(i))
            - others.row(static_cast<Eigen::Index>(nearest[i][0])))
             .norm();
  return sum / static_cast<double>(nearest.size());
}

// All that bring principal axes of similar length onto each other, the best first.
std::vector<Rotation> rotations(const Matchable_data& a, const Matchable_data& b)
{
  constexpr double largest_ratio = 1.25;
  constexpr Eigen::Index number_of_points = 1000;
  const Point_matrix points = every(a.coarse_pose, number_of_points),
                     others = every(b.coarse_pose, number_of_points);
  const Point_search search_others(others);
  std::vector<Rotation> result;
  std::array<Eigen::Index, 3> axes = {0, 1, 2};
  do
  {
    bool is_similar = true;
    for(std::size_t k = 0; k < 3; ++k)
    {
      const double ratio
        = a.lengths_of_axes[axes[k]] / b.lengths_of_axes[static_cast<Eigen::Index>(k)];
      is_similar = is_similar && ratio < largest_ratio && ratio > 1 / largest_ratio;
    }
    if(!is_similar && axes != std::array<Eigen::Index, 3>{0, 1, 2})
      continue;
    for(int signs = 0; signs < 8; ++signs)
    {
      Eigen::Matrix3d matrix = Eigen::Matrix3d::Zero();
      for(std::size_t k = 0; k < 3; ++k)
        matrix(axes[k], static_cast<Eigen::Index>(k)) = (signs >> k) % 2 == 0 ? 1 : -1;
      if(matrix.determinant() < 0)
        continue;
      const Point_matrix turned = points * matrix;
      result.push_back({matrix, .5
                                  * (mean_distance(turned, search_others, others)
                                     + mean_distance(others, Point_search(turned), turned))});
    }
  } while(std::next_permutation(axes.begin(), axes.end()));
  std::stable_sort(result.begin(), result.end(),
                   [](const Rotation& r, const Rotation& s) { return r.distance < s.distance; });
  return result;
}

// ---- coarse surfaces -----------------------------------------------------------------------------------

// By what points are compared: positions, and functions in units of their residual.
struct Features
{
  Function_matrix functions;
  Point_matrix positions, normals;

  double squared_distance(const std::size_t i, const Features& other, const std::size_t j) const
  {
    const auto row = static_cast<Eigen::Index>(i), row_of_other = static_cast<Eigen::Index>(j);
    return (functions.row(row) - other.functions.row(row_of_other)).squaredNorm()
           + (positions.row(row) - other.positions.row(row_of_other)).squaredNorm();
  }

  // Whether it is not the other side of a thin part.
  bool is_same_side(const std::size_t i, const Features& other, const std::size_t j) const
  {
    constexpr double least = -.5; // the cosine of an angle
    return normals.row(static_cast<Eigen::Index>(i))
             .dot(other.normals.row(static_cast<Eigen::Index>(j)))
           >= least;
  }
};

// Of candidates on the same side, or of all if there is none, the one with the nearest features.
Indices nearest_features(const Features& features, const std::vector<Indices>& candidates,
                         const Features& others)
{
  Indices result(candidates.size());
  for_each_block(
    result.size(),
    [&](std::size_t, const std::size_t begin, const std::size_t end) {
      for(std::size_t i = begin; i < end; ++i)
      {
        std::pair<bool, double> least(true, (std::numeric_limits<double>::infinity)());
        for(const std::size_t j : candidates[i])
          if(const std::pair<bool, double> distance(!features.is_same_side(i, others, j),
                                                    features.squared_distance(i, others, j));
             distance < least)
          {
            least = distance;
            result[i] = j;
          }
      }
    },
    256);
  return result;
}

// The match of two coarse surfaces.
class Coarse_match
{
public:
  Coarse_match(const Matchable_data& a, const Matchable_data& b, const Eigen::Matrix3d& rotation,
               const Match_options& options, Indices landmarks_of_a, Indices landmarks_of_b)
    : m_a(a), m_b(b), m_options(options), m_rest(a.coarse_pose * rotation), m_position(m_rest),
      m_normals(rows_at(a.normals, a.coarse.vertices) * rotation),
      m_normals_of_b(rows_at(b.normals, b.coarse.vertices)), m_search(b.coarse_pose),
      m_landmarks_of_a(std::move(landmarks_of_a)), m_landmarks_of_b(std::move(landmarks_of_b))
  {
    const Point_search search(m_position);
    for(const Indices& nearest : m_search.nearest(m_position, 1))
      m_forward.push_back(nearest[0]);
    for(const Indices& nearest : search.nearest(b.coarse_pose, 1))
      m_backward.push_back(nearest[0]);
  }

  // Compares by more and more functions, up to `most`; goes on where it ended before.
  void refine(const Eigen::Index most)
  {
    const Eigen::Index last = (std::min)(most, number_of_functions());
    for(const Eigen::Index next : {10, 14, 20, 28, 40, 56, 78, 100})
      if(const Eigen::Index count = (std::min)(next, last); count > m_count)
      {
        update(count, true);
        m_count = count;
      }
  }

  // By how much the match changes the lengths of edges, relative to their sum.
  double strain() const
  {
    double changes = 0, sum = 0;
    for(const std::array<std::size_t, 3>& triangle : m_a.coarse.surface.triangles)
      for(std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t i = triangle[k], j = triangle[(k + 1) % 3];
        const double length = length_of(m_a, i, j);
        changes += std::abs(length_of(m_b, m_forward[i], m_forward[j]) - length);
        sum += length;
      }
    return changes / sum;
  }

  // Registers the pose to the other one.
  void deform()
  {
    if(m_options.number_of_registrations == 0)
      return;
    constexpr double detail_length = .05, pose_weight = 3;
    constexpr Eigen::Index most_functions = 60;
    Deformable_pose pose(m_rest, m_a.coarse.surface.triangles, detail_length);
    m_pose_weight = pose_weight;
    for(int i = 0; i < m_options.number_of_registrations; ++i)
    {
      m_position = pose.registered_to(rows_at(m_b.coarse_pose, m_forward), m_position);
      update((std::min)(most_functions, number_of_functions()), false);
    }
  }

  // Whether most triangles keep their orientation, as seen from outside.
  bool preserves_orientation() const
  {
    long long sum = 0;
    for(const std::array<std::size_t, 3>& t : m_a.coarse.surface.triangles)
    {
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

  const Eigen::MatrixXd& functional_map() const { return m_map; }
  const Point_matrix& position() const { return m_position; }
  const Indices& forward() const { return m_forward; }
  const Indices& backward() const { return m_backward; }
  const Eigen::VectorXd& weights() const { return m_weights; } // of the functions
  double weight_of_positions() const { return m_weight_of_positions; }

private:
  // In units of the root of the area.
  static double length_of(const Matchable_data& shape, const std::size_t i, const std::size_t j)
  {
    const Point_matrix& points = shape.coarse.surface.points;
    return (points.row(static_cast<Eigen::Index>(i)) - points.row(static_cast<Eigen::Index>(j)))
             .norm()
           / shape.root_of_area;
  }

  Eigen::Index number_of_functions() const
  {
    return (std::min)({static_cast<Eigen::Index>(m_options.number_of_functions),
                       m_a.functions.cols(), m_b.functions.cols()});
  }

  // `moves`: whether to move the pose smoothly.
  void update(const Eigen::Index count, const bool moves)
  {
    constexpr int repetitions = 3;
    constexpr std::size_t number_of_candidates = 48;
    std::vector<Indices> forward, backward;
    for(int i = 0; i < (moves ? repetitions : 1); ++i)
    {
      const Features features = features_of_a(count, moves), others = features_of_b(count);
      if(i == 0)
      {
        forward = m_search.nearest(m_position, number_of_candidates);
        backward = Point_search(m_position).nearest(m_b.coarse_pose, number_of_candidates);
      }
      m_forward = nearest_features(features, forward, others);
      m_backward = nearest_features(others, backward, features);
    }
  }

  // Updates the functional map, the positions, and the weights.
  Features features_of_a(const Eigen::Index count, const bool moves)
  {
    const Eigen::Index n = m_a.functions.rows(), m = m_b.functions.rows(),
                       landmarks = static_cast<Eigen::Index>(m_landmarks_of_a.size());
    Function_matrix x(n + m + landmarks, count), y(x.rows(), count);
    Point_matrix moves_of_pairs(x.rows(), 3);
    const auto set
      = [&](const Eigen::Index row, const std::size_t i, const std::size_t j, const double weight) {
          const auto of_a = static_cast<Eigen::Index>(i), of_b = static_cast<Eigen::Index>(j);
          x.row(row) = weight * m_a.functions.row(of_a).head(count);
          y.row(row) = weight * m_b.functions.row(of_b).head(count);
          moves_of_pairs.row(row) = weight * (m_b.coarse_pose.row(of_b) - m_rest.row(of_a));
        };
    for(Eigen::Index i = 0; i < n; ++i)
      set(i, static_cast<std::size_t>(i), m_forward[static_cast<std::size_t>(i)], 1);
    for(Eigen::Index j = 0; j < m; ++j)
      set(n + j, m_backward[static_cast<std::size_t>(j)], static_cast<std::size_t>(j), 1);
    constexpr double share = .05; // of each landmark
    for(Eigen::Index l = 0; l < landmarks; ++l)
      set(n + m + l, m_landmarks_of_a[static_cast<std::size_t>(l)],
          m_landmarks_of_b[static_cast<std::size_t>(l)],
          std::sqrt(share * static_cast<double>(n + m)));
    const Eigen::MatrixXd products = x.transpose() * x;
    const Eigen::LDLT<Eigen::MatrixXd> factor(
      products + 1e-9 * products.trace() * Eigen::MatrixXd::Identity(count, count));
    m_map = factor.solve(x.transpose() * y);
    if(moves)
      m_position
        = m_rest + m_a.functions.leftCols(count) * factor.solve(x.transpose() * moves_of_pairs);
    Function_matrix mapped = m_a.functions.leftCols(count) * m_map;
    const double number = static_cast<double>(x.rows());
    constexpr double least = 1e-3;
    m_weights = ((x * m_map - y).colwise().squaredNorm() / number)
                  .cwiseSqrt()
                  .cwiseMax(least)
                  .cwiseInverse()
                  .transpose();
    double sum = 0;
    for(std::size_t i = 0; i < m_forward.size(); ++i)
      sum += squared_distance(i, m_forward[i]);
    for(std::size_t j = 0; j < m_backward.size(); ++j)
      sum += squared_distance(m_backward[j], j);
    const double residual
      = (std::max)(std::sqrt(sum / (3 * static_cast<double>(n + m))), least / 10);
    m_weight_of_positions = m_pose_weight * m_options.pose_weight / residual;
    mapped *= m_weights.asDiagonal();
    return {std::move(mapped), m_weight_of_positions * m_position, m_normals};
  }

  Features features_of_b(const Eigen::Index count) const
  {
    return {m_b.functions.leftCols(count) * m_weights.asDiagonal(),
            m_weight_of_positions * m_b.coarse_pose, m_normals_of_b};
  }

  double squared_distance(const std::size_t i, const std::size_t j) const
  {
    return (m_position.row(static_cast<Eigen::Index>(i))
            - m_b.coarse_pose.row(static_cast<Eigen::Index>(j)))
      .squaredNorm();
  }

  const Matchable_data &m_a, &m_b;
  const Match_options& m_options;
  const Point_matrix m_rest;
  Point_matrix m_position;
  const Point_matrix m_normals, m_normals_of_b;
  const Point_search m_search; // of the other pose
  const Indices m_landmarks_of_a, m_landmarks_of_b;
  Indices m_forward, m_backward;
  Eigen::MatrixXd m_map;
  Eigen::VectorXd m_weights;
  double m_weight_of_positions = 0, m_pose_weight = 1;
  Eigen::Index m_count = 0; // of the functions so far
};

// ---- all vertices --------------------------------------------------------------------------------------

// The triangles at each vertex.
Buckets<std::size_t> triangles_of_vertices(const Repaired_surface_3& surface)
{
  return Buckets<std::size_t>(static_cast<std::size_t>(surface.points.rows()),
                              [&](const auto& put) {
                                for(std::size_t t = 0; t < surface.triangles.size(); ++t)
                                  for(const std::size_t v : surface.triangles[t])
                                    put(v, t);
                              });
}

// The point nearest to a position on the triangles around a row.
template <class Triangles>
Surface_match_3::Location location(const Matchable_data& b, const Triangles& triangles,
                                   const Eigen::RowVector3d& position)
{
  Surface_match_3::Location result = {};
  double least = (std::numeric_limits<double>::infinity)();
  for(const std::size_t t : triangles)
  {
    const std::array<std::size_t, 3>& triangle = b.surface.triangles[t];
    std::array<Eigen::Vector3d, 3> corners;
    for(std::size_t k = 0; k < 3; ++k)
      corners[k] = b.pose.row(static_cast<Eigen::Index>(triangle[k])).transpose();
    const std::array<double, 3> weights
      = nearest_in_triangle(position.transpose(), corners[0], corners[1], corners[2]);
    const double distance = (weights[0] * corners[0] + weights[1] * corners[1]
                             + weights[2] * corners[2] - position.transpose())
                              .squaredNorm();
    if(distance < least)
    {
      least = distance;
      result.face = b.surface.face_of_triangle[t];
      result.weights = weights;
      for(std::size_t k = 0; k < 3; ++k)
        result.vertices[k] = b.surface.origins[triangle[k]];
    }
  }
  return result;
}

void locate(const Matchable_data& a, const Matchable_data& b, const Coarse_match& match,
            const Eigen::Matrix3d& rotation, Surface_match_3& result)
{
  constexpr std::size_t number_of_candidates = 24;
  const Eigen::Index count = match.weights().size();
  const Function_matrix moves
    = a.coarse.interpolated(Function_matrix(match.position() - a.coarse_pose * rotation));
  const Point_matrix position = a.pose * rotation + Point_matrix(moves);
  const auto full = [&](const Matchable_data& shape, const Eigen::MatrixXd& map) {
    return shape.coarse.interpolated(
      Function_matrix(shape.functions.leftCols(count) * map * match.weights().asDiagonal()));
  };
  const Features features = {full(a, match.functional_map()),
                             match.weight_of_positions() * position, a.normals * rotation};
  const Features others = {full(b, Eigen::MatrixXd::Identity(count, count)),
                           match.weight_of_positions() * b.pose, b.normals};
  const Point_search search(b.pose);
  const Indices nearest
    = nearest_features(features, search.nearest(position, number_of_candidates), others);
  const Buckets<std::size_t> triangles = triangles_of_vertices(b.surface);

  Function_matrix trips(a.coarse_pose.rows(), 1);
  for(std::size_t i = 0; i < match.forward().size(); ++i)
    trips(static_cast<Eigen::Index>(i))
      = (a.coarse_pose.row(static_cast<Eigen::Index>(i))
         - a.coarse_pose.row(static_cast<Eigen::Index>(match.backward()[match.forward()[i]])))
          .norm();
  trips = a.coarse.interpolated(trips);

  // Of several copies of a vertex, the last one counts; vertices without faces are compared by positions.
  result.round_trips = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(a.number_of_vertices));
  result.locations.resize(a.number_of_vertices);
  std::vector<bool> is_known(a.number_of_vertices, false);
  for(std::size_t row = 0; row < nearest.size(); ++row)
  {
    const std::size_t v = a.surface.origins[row];
    result.locations[v]
      = location(b, triangles[nearest[row]], position.row(static_cast<Eigen::Index>(row)));
    result.round_trips[static_cast<Eigen::Index>(v)] = trips(static_cast<Eigen::Index>(row));
    is_known[v] = true;
  }
  Indices unknown;
  for(std::size_t v = 0; v < is_known.size(); ++v)
    if(!is_known[v])
      unknown.push_back(v);
  const Point_matrix positions = rows_at(a.pose_of_vertices, unknown) * rotation;
  const auto nearest_of_unknown = search.nearest(positions, 1);
  for(std::size_t i = 0; i < unknown.size(); ++i)
    result.locations[unknown[i]] = location(b, triangles[nearest_of_unknown[i][0]],
                                            positions.row(static_cast<Eigen::Index>(i)));
}

// The coarse vertices nearest to vertices of the input.
Indices coarse_vertices(const Matchable_data& shape, const Indices& vertices)
{
  Indices result;
  for(const Indices& nearest :
      Point_search(shape.coarse_pose).nearest(rows_at(shape.pose_of_vertices, vertices), 1))
    result.push_back(nearest[0]);
  return result;
}

void check(const Matchable_surface_3& a, const Matchable_surface_3& b, const Match_options& options)
{
  for(const auto& [v, w] : options.landmarks)
    if(v >= a.number_of_vertices() || w >= b.number_of_vertices())
      throw std::invalid_argument("the landmark " + std::to_string(v) + ", " + std::to_string(w)
                                  + " is out of range: there are "
                                  + std::to_string(a.number_of_vertices()) + " and "
                                  + std::to_string(b.number_of_vertices()) + " vertices");
  if(options.number_of_functions < 4)
    throw std::invalid_argument("the number of functions is "
                                + std::to_string(options.number_of_functions)
                                + ", but must be at least 4");
  if(!(options.pose_weight > 0) || !std::isfinite(options.pose_weight))
    throw std::invalid_argument("the weight of the pose must be positive");
  if(options.number_of_registrations < 0 || options.number_of_threads < 0)
    throw std::invalid_argument("numbers of registrations and threads must not be negative");
}

// The rotations that bring the poses nearly as close as the best one differ by what is seen on the surface.
Surface_match_3 match(const Matchable_data& a, const Matchable_data& b,
                      const Match_options& options)
{
  constexpr double largest_ratio = 1.4, certain_ratio = 1.05;
  constexpr Eigen::Index few_functions = 28, all_functions = 100;
  Indices landmarks_of_a, landmarks_of_b;
  for(const auto& [v, w] : options.landmarks)
  {
    landmarks_of_a.push_back(v);
    landmarks_of_b.push_back(w);
  }
  landmarks_of_a = coarse_vertices(a, landmarks_of_a);
  landmarks_of_b = coarse_vertices(b, landmarks_of_b);
  std::vector<Rotation> candidates = rotations(a, b);
  candidates.erase(std::find_if(candidates.begin() + 1, candidates.end(),
                                [&](const Rotation& rotation) {
                                  return rotation.distance
                                         > largest_ratio * candidates.front().distance;
                                }),
                   candidates.end());
  std::unique_ptr<Coarse_match> best;
  Surface_match_3 result;
  double least = (std::numeric_limits<double>::infinity)(), second = least;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  for(const Rotation& candidate : candidates)
  {
    auto match = std::make_unique<Coarse_match>(a, b, candidate.matrix, options, landmarks_of_a,
                                                landmarks_of_b);
    match->refine(few_functions);
    const double strain // matches with the wrong orientation come last
      = match->strain() + (match->preserves_orientation() ? 0 : 10);
    second = (std::min)(second, (std::max)(strain, least));
    if(strain >= least)
      continue;
    least = strain;
    best = std::move(match);
    rotation = candidate.matrix;
    result.mean_distance = candidate.distance;
  }
  best->refine(all_functions);
  best->deform();
  result.is_rotation_certain = second > certain_ratio * least;
  result.functional_map = best->functional_map();
  locate(a, b, *best, rotation, result);
  return result;
}

} // namespace
} // namespace matching
} // namespace internal

Surface_match_3 match_surfaces(const Matchable_surface_3& surface, const Matchable_surface_3& other,
                               const Match_options& options)
{
  internal::matching::check(surface, other, options);
  Surface_match_3 result;
  call_with_threads(options.number_of_threads, [&] {
    result = internal::matching::match(surface.data(), other.data(), options);
  });
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
