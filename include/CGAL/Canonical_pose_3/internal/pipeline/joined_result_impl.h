// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_JOINED_RESULT_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_JOINED_RESULT_IMPL_H

#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

namespace internal {

// The mean for each row over the copies of a vertex, which may have been separated slightly.
class Row_means
{
public:
  explicit Row_means(const std::size_t n)
    : m_sums(Point_matrix::Zero(static_cast<Eigen::Index>(n), 3)), m_numbers(n, 0)
  {}

  void add(const std::size_t row, const Eigen::RowVector3d& value)
  {
    m_sums.row(static_cast<Eigen::Index>(row)) += value;
    ++m_numbers[row];
  }

  bool has(const std::size_t row) const { return m_numbers[row] > 0; }

  Eigen::RowVector3d operator[](const std::size_t row) const
  {
    return m_sums.row(static_cast<Eigen::Index>(row)) * (1 / static_cast<double>(m_numbers[row]));
  }

private:
  Point_matrix m_sums;
  std::vector<std::size_t> m_numbers;
};

// Replaces the pose of some vertices by the nearest rigid motion.
inline void move_rigidly(const std::vector<std::size_t>& vertices, const Point_matrix& points,
                         Point_matrix& pose)
{
  const Point_matrix rest = rows_at(points, vertices);
  const Point_matrix moved
    = align_target(rest, rows_at(pose, vertices), Eigen::VectorXd::Ones(rest.rows()));
  for(std::size_t i = 0; i < vertices.size(); ++i)
    pose.row(static_cast<Eigen::Index>(vertices[i])) = moved.row(static_cast<Eigen::Index>(i));
}

// The pose of attached vertices, followed by that of the followers of the options.
inline Point_matrix joined_followers(const Vertex_map& map, const std::vector<Result>& results)
{
  std::size_t n = 0;
  for(const std::vector<std::size_t>& followers : map.followers_of)
    n += followers.size();
  Point_matrix joined(static_cast<Eigen::Index>(n), 3);
  for(std::size_t c = 0; c < results.size(); ++c)
    for(std::size_t i = 0; i < map.followers_of[c].size(); ++i)
      joined.row(static_cast<Eigen::Index>(map.followers_of[c][i]))
        = results[c].pose_of_followers.row(static_cast<Eigen::Index>(i));
  return joined;
}

inline Point_matrix joined_pose(const Prepared_surface_3& surface,
                                const std::vector<Result>& results, const Point_matrix& attached)
{
  const Vertex_map& map = surface.vertex_map;
  Row_means means(map.component_of.size());
  for(std::size_t c = results.size(); c-- > 0;)
  {
    const std::vector<std::size_t>& vertices = surface.components[c].surface.body_origins;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(map.component_of[vertices[i]] == c)
        means.add(vertices[i], results[c].pose.row(static_cast<Eigen::Index>(i)));
  }
  Point_matrix pose(surface.points.rows(), 3);
  for(std::size_t v = 0; v < map.component_of.size(); ++v)
    if(map.component_of[v] != Vertex_map::NONE)
      pose.row(static_cast<Eigen::Index>(v)) = means[map.representatives[v]];
  for(std::size_t i = 0; i < map.attached.size(); ++i)
    pose.row(static_cast<Eigen::Index>(map.attached[i]))
      = attached.row(static_cast<Eigen::Index>(i));
  for(const std::vector<std::size_t>& part : map.rigid_parts)
    move_rigidly(part, surface.points, pose);
  return pose;
}

// The target of rows that are not on a surface is the pose.
inline Point_matrix joined_target(const Prepared_surface_3& surface,
                                  const std::vector<Result>& results, const Point_matrix& pose)
{
  const Vertex_map& map = surface.vertex_map;
  Row_means means(map.number_of_rows());
  for(std::size_t c = results.size(); c-- > 0;)
  {
    const std::vector<std::size_t>& rows = surface.components[c].surface.origins;
    for(std::size_t i = 0; i < rows.size(); ++i)
      if(map.component_of[map.vertex_of_row[rows[i]]] == c)
        means.add(rows[i], results[c].target->row(static_cast<Eigen::Index>(i)));
  }
  Point_matrix target(static_cast<Eigen::Index>(map.number_of_rows()), 3);
  for(std::size_t row = 0; row < map.number_of_rows(); ++row)
  {
    const std::size_t r = map.representatives[row];
    if(means.has(r))
      target.row(static_cast<Eigen::Index>(row)) = means[r];
    else
      target.row(static_cast<Eigen::Index>(row))
        = pose.row(static_cast<Eigen::Index>(map.vertex_of_row[row]));
  }
  return target;
}

// Of the copies of a vertex, the smallest distance counts.
inline Landmark_fields_3 joined_fields(const Vertex_map& map, const std::vector<std::size_t>& rows,
                                       const Landmark_fields_3& fields)
{
  Landmark_fields_3 joined;
  joined.covering_radius = fields.covering_radius;
  for(const std::size_t landmark : fields.landmarks)
    joined.landmarks.push_back(rows[landmark]);
  joined.distances.setConstant(static_cast<Eigen::Index>(map.number_of_rows()),
                               fields.distances.cols(), std::numeric_limits<double>::infinity());
  for(Eigen::Index j = 0; j < joined.distances.cols(); ++j)
  {
    for(std::size_t i = 0; i < rows.size(); ++i)
    {
      double& distance = joined.distances(static_cast<Eigen::Index>(rows[i]), j);
      distance = (std::min)(distance, fields.distances(static_cast<Eigen::Index>(i), j));
    }
    for(std::size_t row = 0; row < map.number_of_rows(); ++row)
      joined.distances(static_cast<Eigen::Index>(row), j)
        = joined.distances(static_cast<Eigen::Index>(map.representatives[row]), j);
  }
  return joined;
}

// Adds the summary of a smaller component.
inline Registration_summary joined_summary(Registration_summary summary,
                                           const Registration_summary& smaller)
{
  for(const auto& stage : smaller.stages)
    summary.add_seconds(stage.first, stage.second);
  summary.termination = (std::max)(summary.termination, smaller.termination);
  summary.iterations += smaller.iterations;
  summary.target.is_handedness_certain
    = summary.target.is_handedness_certain && smaller.target.is_handedness_certain;
  summary.inverted += smaller.inverted;
  summary.flipped_faces += smaller.flipped_faces;
  summary.body.vertices += smaller.body.vertices;
  summary.body.tetrahedra += smaller.body.tetrahedra;
  summary.warnings.insert(summary.warnings.end(), smaller.warnings.begin(), smaller.warnings.end());
  return summary;
}

// A one-line warning if given results have one row for several copies of a vertex.
inline std::optional<std::string> warning_of_copies(const Prepared_surface_3& surface)
{
  const Intermediate_results& given = surface.components.front().options.given;
  if(!given.landmark_fields && !given.target)
    return std::nullopt;
  std::vector<std::size_t> copies(surface.vertex_map.number_of_rows(), 0);
  for(const Prepared_surface_3::Component& component : surface.components)
    for(const std::size_t row : component.surface.origins)
      ++copies[row];
  const auto more_than_one = [](const std::size_t number) { return number > 1; };
  const auto first = std::find_if(copies.begin(), copies.end(), more_than_one);
  if(first == copies.end())
    return std::nullopt;
  return "the surface is not manifold at "
         + surface.vertex_map.name_of_row(static_cast<std::size_t>(first - copies.begin()))
         + ", of " + std::to_string(std::count_if(first, copies.end(), more_than_one))
         + " in all: what is given there is taken for all copies of the vertex";
}

} // namespace internal

CGAL_CANONICAL_POSE_3_INLINE Result joined_result(const Prepared_surface_3& surface,
                                                  const std::vector<Result>& results)
{
  CGAL_precondition(results.size() == surface.components.size());
  const internal::Vertex_map& map = surface.vertex_map;
  std::optional<Registration_summary> summary;
  for(std::size_t c = results.size(); c-- > 0 && (!summary || summary->is_usable());)
    summary = summary ? internal::joined_summary(results[c].summary, *summary) : results[c].summary;
  Result joined;
  if(summary->is_usable())
  {
    const Point_matrix followers = internal::joined_followers(map, results);
    const auto number_of_attached = static_cast<Eigen::Index>(map.attached.size());
    joined.pose = internal::joined_pose(surface, results, followers.topRows(number_of_attached));
    joined.pose_of_followers = followers.bottomRows(followers.rows() - number_of_attached);
    joined.target = internal::joined_target(surface, results, joined.pose);
    if(results.size() == 1 && results.front().landmark_fields)
      joined.landmark_fields = internal::joined_fields(
        map, surface.components.front().surface.origins, *results.front().landmark_fields);
  }
  if(const auto warning = internal::warning_of_copies(surface))
    summary->warnings.push_back(*warning);
  for(const Prepared_surface_3::Component& component : surface.components)
    for(const std::size_t vertex : component.surface.contacts)
      summary->warnings.push_back("a false contact was cut at vertex " + std::to_string(vertex));
  if(!map.shared.empty())
    summary->warnings.push_back(
      std::to_string(map.shared.size()) + " vertices belong to several components, vertex "
      + std::to_string(map.shared.front()) + " among them: they go with the largest");
  summary->input = surface.diagnosis;
  joined.summary = std::move(*summary);
  return joined;
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_JOINED_RESULT_IMPL_H
