// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/internal/support/Indexed_vector.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {

// The mean for each index over the copies of a vertex, which may have been separated slightly.
template <class Index>
class Means
{
public:
  explicit Means(const std::size_t n)
    : m_sums(Point_matrix::Zero(static_cast<Eigen::Index>(n), 3)), m_numbers(n, 0)
  {}

  void add(const Index i, const Eigen::RowVector3d& value)
  {
    rows_by<Index>(m_sums)[i] += value;
    ++m_numbers[i];
  }

  bool has(const Index i) const { return m_numbers[i] > 0; }

  Eigen::RowVector3d operator[](const Index i) const
  {
    return rows_by<Index>(m_sums)[i] * (1 / static_cast<double>(m_numbers[i]));
  }

private:
  Point_matrix m_sums;
  Indexed_vector<Index, std::size_t> m_numbers;
};

// Replaces the pose of some vertices by the nearest rigid motion.
inline void move_rigidly(const Rigid_part& part, const Point_matrix& points, Point_matrix& pose)
{
  const auto pose_of = rows_by<Vertex_index>(pose);
  const Point_matrix rest = rows_at(rows_by<Vertex_index>(points), part.vertices);
  const Point_matrix moved
    = align_target(rest, rows_at(pose_of, part.vertices),
                   Eigen::Map<const Eigen::VectorXd>(
                     part.weights.data(), static_cast<Eigen::Index>(part.weights.size())));
  for(std::size_t i = 0; i < part.vertices.size(); ++i)
    pose_of[part.vertices[i]] = moved.row(static_cast<Eigen::Index>(i));
}

// The pose of attached vertices, followed by that of the followers of the options.
inline Point_matrix joined_followers(const Vertex_map& map, const std::vector<Result>& results)
{
  std::size_t n = 0;
  for(const std::vector<std::size_t>& followers : map.followers_of)
    n += followers.size();
  Point_matrix joined(static_cast<Eigen::Index>(n), 3);
  for(std::size_t c = 0; c < results.size(); ++c)
  {
    const std::vector<std::size_t>& followers = map.followers_of[Component_index(c)];
    for(std::size_t i = 0; i < followers.size(); ++i)
      joined.row(static_cast<Eigen::Index>(followers[i]))
        = results[c].pose_of_followers.row(static_cast<Eigen::Index>(i));
  }
  return joined;
}

inline Point_matrix joined_pose(const Prepared_surface_3& surface,
                                const std::vector<Result>& results, const Point_matrix& attached)
{
  const Vertex_map& map = surface.vertex_map;
  Means<Vertex_index> means(map.number_of_vertices());
  for(std::size_t c = results.size(); c-- > 0;)
  {
    const Surface_component_3& component = surface.components[c].surface;
    for(std::size_t i = 0; i < component.body_origins.size(); ++i)
      if(const Vertex_index v = vertex_of(component, i); map.component_of[v] == Component_index(c))
        means.add(v, results[c].pose.row(static_cast<Eigen::Index>(i)));
  }
  Point_matrix pose(surface.points.rows(), 3);
  const auto pose_of = rows_by<Vertex_index>(pose);
  map.representatives.for_each_index([&](const Vertex_index v) {
    if(map.component_of[v] != Component_index::NONE)
      pose_of[v] = means[map.representatives[v]];
  });
  for(std::size_t i = 0; i < map.attached.size(); ++i)
    pose_of[map.attached[i]] = attached.row(static_cast<Eigen::Index>(i));
  for(const Rigid_part& part : map.rigid_parts)
    move_rigidly(part, surface.points, pose);
  for(const Vertex_index v : map.fixed)
    pose_of[v] = rows_by<Vertex_index>(surface.points)[v];
  return pose;
}

// The target of rows that are not on a surface is the pose.
inline Point_matrix joined_target(const Prepared_surface_3& surface,
                                  const std::vector<Result>& results, const Point_matrix& pose)
{
  const Vertex_map& map = surface.vertex_map;
  Means<Row_index> means(map.number_of_rows());
  for(std::size_t c = results.size(); c-- > 0;)
  {
    const Surface_component_3& component = surface.components[c].surface;
    for(std::size_t i = 0; i < component.origins.size(); ++i)
      if(const Row_index row = row_of(component, i);
         map.component_of_row[row] == Component_index(c))
        means.add(row, results[c].target->row(static_cast<Eigen::Index>(i)));
  }
  Point_matrix target(static_cast<Eigen::Index>(map.number_of_rows()), 3);
  map.representative_rows.for_each_index([&](const Row_index row) {
    const Row_index r = map.representative_rows[row];
    if(means.has(r))
      rows_by<Row_index>(target)[row] = means[r];
    else
      rows_by<Row_index>(target)[row] = rows_by<Vertex_index>(pose)[map.vertex_of_row[row]];
  });
  return target;
}

// Of the copies of a vertex, the smallest distance counts.
inline Landmark_fields_3 joined_fields(const Vertex_map& map, const Surface_component_3& component,
                                       const Landmark_fields_3& fields)
{
  Landmark_fields_3 joined;
  joined.covering_radius = fields.covering_radius;
  for(const std::size_t landmark : fields.landmarks)
    joined.landmarks.push_back(static_cast<std::size_t>(row_of(component, landmark)));
  joined.distances.setConstant(static_cast<Eigen::Index>(map.number_of_rows()),
                               fields.distances.cols(), std::numeric_limits<double>::infinity());
  for(Eigen::Index j = 0; j < joined.distances.cols(); ++j)
  {
    auto column = joined.distances.col(j);
    const auto distance_of = rows_by<Row_index>(column);
    for(std::size_t i = 0; i < component.origins.size(); ++i)
    {
      double& distance = distance_of[row_of(component, i)](0);
      distance = (std::min)(distance, fields.distances(static_cast<Eigen::Index>(i), j));
    }
    map.representative_rows.for_each_index(
      [&](const Row_index row) { distance_of[row] = distance_of[map.representative_rows[row]]; });
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
  for(const std::string& warning : smaller.warnings)
    if(std::find(summary.warnings.begin(), summary.warnings.end(), warning)
       == summary.warnings.end())
      summary.warnings.push_back(warning);
  return summary;
}

// A one-line warning if given results have one row for several copies of a vertex.
inline std::optional<std::string> warning_of_copies(const Prepared_surface_3& surface)
{
  const Intermediate_results& given = surface.components.front().options.given;
  if(!given.landmark_fields && !given.target)
    return std::nullopt;
  Indexed_vector<Row_index, std::size_t> copies(surface.vertex_map.number_of_rows(), 0);
  for(const Prepared_surface_3::Component& component : surface.components)
    for(std::size_t i = 0; i < component.surface.origins.size(); ++i)
      ++copies[row_of(component.surface, i)];
  const auto more_than_one = [](const std::size_t number) { return number > 1; };
  const auto first = std::find_if(copies.begin(), copies.end(), more_than_one);
  if(first == copies.end())
    return std::nullopt;
  return "the surface is not manifold at "
         + surface.vertex_map.name_of_row(Row_index(first - copies.begin())) + ", of "
         + std::to_string(std::count_if(first, copies.end(), more_than_one))
         + " in all: what is given there is taken for all copies of the vertex";
}

// What was repaired that changes how the surface is connected.
std::optional<std::string> warning_of_repair(const Diagnosis_3& diagnosis)
{
  const std::size_t number = diagnosis.non_manifold_edges + diagnosis.non_manifold_vertices;
  const auto first = std::find_if(
    diagnosis.defects.begin(), diagnosis.defects.end(), [](const Diagnosis_3::Defect& defect) {
      return defect.kind == "non_manifold_edges" || defect.kind == "inconsistent_orientation"
             || defect.kind == "non_manifold_vertices";
    });
  if(number == 0 || first == diagnosis.defects.end())
    return std::nullopt;
  return "the surface was repaired internally: " + first->message
         + (number == 1 ? "" : ", one of " + std::to_string(number) + " such edges and vertices");
}

} // namespace internal

Result joined_result(const Prepared_surface_3& surface, const std::vector<Result>& results)
{
  CANONICAL_POSE_3_PRECONDITION(results.size() == surface.components.size());
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
      joined.landmark_fields = internal::joined_fields(map, surface.components.front().surface,
                                                       *results.front().landmark_fields);
  }
  if(const auto warning = internal::warning_of_repair(surface.diagnosis))
    summary->warnings.push_back(*warning);
  if(const auto warning = internal::warning_of_copies(surface))
    summary->warnings.push_back(*warning);
  for(const Prepared_surface_3::Component& component : surface.components)
    for(const std::size_t vertex : component.surface.contacts)
      summary->warnings.push_back("a false contact was cut at vertex " + std::to_string(vertex));
  if(!map.shared.empty())
    summary->warnings.push_back("vertices that belong to several components go with the largest: "
                                + std::to_string(map.shared.size()) + ", vertex "
                                + std::to_string(static_cast<std::size_t>(map.shared.front()))
                                + " among them");
  summary->input = surface.diagnosis;
  summary->followers = surface.followers;
  joined.summary = std::move(*summary);
  return joined;
}

} // namespace Canonical_pose_3
} // namespace CGAL
