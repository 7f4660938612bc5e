// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_POSES_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_POSES_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Options_constraints.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Results_by_rows.h>
#include <CGAL/Canonical_pose_3/internal/registration/Constraint_element_traits.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/soup/Triangle_tree.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Throws `std::invalid_argument` where powers of lengths could overflow or vanish.
inline void check_unit(const Point_matrix& points)
{
  constexpr double smallest = 1e-90, largest = 1e90;
  const double size = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0;
  if(size > largest || (size > 0 && size < smallest))
  {
    std::ostringstream message;
    message << "the largest coordinate is " << size << ", but must be between " << smallest
            << " and " << largest << ": choose another unit";
    throw std::invalid_argument(message.str());
  }
}

// Throws `std::invalid_argument` for options that do not fit an input of n vertices.
inline void check_options(const Options& options, const std::size_t n)
{
  options.registration.check();
  check_factors(options.matching_weights, static_cast<Eigen::Index>(n), "matching weight", "vertex",
                true);
  if(options.number_of_landmarks == 0)
    throw std::invalid_argument("option number_of_landmarks is 0, but must be >= 1");
  Options_constraints(options, n);
  for(Eigen::Index i = 0; i < options.followers.rows(); ++i)
    if(!options.followers.row(i).allFinite())
      throw std::invalid_argument("follower " + std::to_string(i)
                                  + " has a coordinate that is not finite");
}

// Brings the components of an input into their poses, one after the other. Each gets its share of what is
// given, in its own rows; vertices without component and followers go with the nearest one.
class Component_poses
{
public:
  static constexpr std::size_t NONE = Results_by_rows::NONE;

  // `points`: the vertices of the input. `components`: by decreasing size. `others`: the vertices of each component
  // that gets no pose of its own.
  Component_poses(const Point_matrix& points, const Input_rows& rows,
                  const std::vector<Posed_component>& components,
                  const std::vector<std::vector<std::size_t>>& others, const Options& options)
    : m_points(points), m_representatives(rows.representatives), m_components(components),
      m_options(options), m_results(rows, components, m_component_of, options)
  {
    check_unit(points);
    locate_vertices(rows);
    find_rigid_parts(rows, others);
    m_values.resize(components.size());
    if(options.matching_weights.size() > 0)
      for(std::size_t c = 0; c < components.size(); ++c)
        m_values[c].matching_weights = values_at(options.matching_weights, components[c].vertices);
    distribute(options.springs, &Component_values::springs);
    distribute(options.directions, &Component_values::directions);
    distribute(options.handles, &Component_values::handles);
    distribute(options.symmetric_pairs, &Component_values::symmetric_pairs);
    assign_followers();
  }

  // The values at some indices.
  static Eigen::VectorXd values_at(const Eigen::VectorXd& values,
                                   const std::vector<std::size_t>& indices)
  {
    Eigen::VectorXd result(static_cast<Eigen::Index>(indices.size()));
    for(std::size_t i = 0; i < indices.size(); ++i)
      result[static_cast<Eigen::Index>(i)] = values[static_cast<Eigen::Index>(indices[i])];
    return result;
  }

  // `run(c, values)` brings component c into its pose and returns the result in its rows.
  template <class Function>
  Result run(const Function& run)
  {
    m_pose_of_followers.resize(m_followers.rows(), 3);
    std::optional<Registration_summary> summary;
    for(std::size_t c = m_components.size(); c-- > 0 && (!summary || summary->is_usable());)
    {
      m_values[c].given = m_results.given_to(c);
      Result one = run(c, std::move(m_values[c]));
      summary = summary ? joined(one.summary, *summary) : one.summary;
      if(one.is_usable())
        take(c, std::move(one));
    }
    Result result;
    if(summary->is_usable())
      result = joined_results();
    if(const auto warning = m_results.warning())
      summary->warnings.push_back(*warning);
    if(!m_shared.empty())
      summary->warnings.push_back(
        std::to_string(m_shared.size()) + " vertices belong to several components, vertex "
        + std::to_string(m_shared.front()) + " among them: they go with the largest");
    result.summary = std::move(*summary);
    return result;
  }

private:
  // A vertex of several components belongs to the largest, one that was sewn to another to that one's.
  void locate_vertices(const Input_rows& rows)
  {
    const std::size_t n = static_cast<std::size_t>(m_points.rows());
    m_component_of.assign(n, NONE);
    m_local_of.assign(n, NONE);
    for(std::size_t c = 0; c < m_components.size(); ++c)
      for(std::size_t i = 0; i < m_components[c].vertices.size(); ++i)
      {
        const std::size_t v = m_components[c].vertices[i];
        if(m_component_of[v] == NONE)
        {
          m_component_of[v] = c;
          m_local_of[v] = i;
        }
        else if(m_component_of[v] != c)
          m_shared.push_back(v);
      }
    std::sort(m_shared.begin(), m_shared.end());
    m_shared.erase(std::unique(m_shared.begin(), m_shared.end()), m_shared.end());
    for(std::size_t v = 0; v < n; ++v)
    {
      m_component_of[v] = m_component_of[rows.representative(v)];
      m_local_of[v] = m_local_of[rows.representative(v)];
    }
  }

  // The components that do not touch one with a pose: far from the cells that they follow, these say how they are
  // moved and turned, but would distort them.
  void find_rigid_parts(const Input_rows& rows, const std::vector<std::vector<std::size_t>>& others)
  {
    std::vector<std::size_t> part_of(m_component_of.size(), NONE);
    for(const std::vector<std::size_t>& vertices : others)
      if(!vertices.empty()
         && std::all_of(vertices.begin(), vertices.end(),
                        [&](const std::size_t v) { return m_component_of[v] == NONE; }))
      {
        for(const std::size_t v : vertices)
          part_of[v] = m_rigid_parts.size();
        m_rigid_parts.emplace_back();
      }
    for(std::size_t v = 0; v < part_of.size(); ++v)
      if(part_of[rows.representative(v)] != NONE)
        m_rigid_parts[part_of[rows.representative(v)]].push_back(v);
  }

  // Gives each element of a constraint to the component of its vertices.
  template <class Element>
  void distribute(const std::vector<Element>& elements,
                  std::vector<Element> Component_values::*list)
  {
    using Traits = Constraint_element_traits<Element>;
    for(std::size_t i = 0; i < elements.size(); ++i)
    {
      const std::string name = Traits::name + (' ' + std::to_string(i));
      const auto vertices = vertices_of(elements[i]);
      Element local = elements[i];
      for(std::size_t* const vertex : Traits::pointers_to_vertices(local))
      {
        if(m_component_of[*vertex] == NONE)
          throw std::invalid_argument(name + " names vertex " + std::to_string(*vertex)
                                      + ", which has no pose of its own: it is not on the surface, "
                                        "or on another component");
        if(m_component_of[*vertex] != m_component_of[vertices.front()])
          throw std::invalid_argument(name + " names vertices " + std::to_string(vertices.front())
                                      + " and " + std::to_string(*vertex)
                                      + ", which belong to different components");
        *vertex = m_local_of[*vertex];
      }
      if(!Traits::defect(local).empty())
        throw std::invalid_argument(name + " names vertices " + std::to_string(vertices.front())
                                    + " and " + std::to_string(vertices.back())
                                    + ", which are at the same position and became one");
      (m_values[m_component_of[vertices.front()]].*list).push_back(local);
    }
  }

  // Vertices without component come first.
  void assign_followers()
  {
    for(std::size_t v = 0; v < m_component_of.size(); ++v)
      if(m_component_of[v] == NONE)
        m_attached.push_back(v);
    const Eigen::Index n = static_cast<Eigen::Index>(m_attached.size());
    m_followers.resize(n + m_options.followers.rows(), 3);
    for(Eigen::Index i = 0; i < n; ++i)
      m_followers.row(i)
        = m_points.row(static_cast<Eigen::Index>(m_attached[static_cast<std::size_t>(i)]));
    m_followers.bottomRows(m_options.followers.rows()) = m_options.followers;

    const std::vector<std::size_t> nearest = nearest_components();
    m_followers_of.resize(m_components.size());
    for(std::size_t i = 0; i < nearest.size(); ++i)
      m_followers_of[nearest[i]].push_back(static_cast<Eigen::Index>(i));
    for(std::size_t c = 0; c < m_components.size(); ++c)
    {
      Point_matrix& followers = m_values[c].followers;
      followers.resize(static_cast<Eigen::Index>(m_followers_of[c].size()), 3);
      for(Eigen::Index i = 0; i < followers.rows(); ++i)
        followers.row(i) = m_followers.row(m_followers_of[c][static_cast<std::size_t>(i)]);
    }
  }

  std::vector<std::size_t> nearest_components() const
  {
    std::vector<std::size_t> result(static_cast<std::size_t>(m_followers.rows()), 0);
    if(m_components.size() == 1 || result.empty())
      return result;
    std::vector<Index_triangle> triangles;
    std::vector<std::size_t> component_of_triangle;
    Eigen::Index n = 0;
    for(const Posed_component& component : m_components)
      n += component.points.rows();
    Point_matrix points(n, 3);
    n = 0;
    for(std::size_t c = 0; c < m_components.size(); ++c)
    {
      points.middleRows(n, m_components[c].points.rows()) = m_components[c].points;
      for(Index_triangle t : m_components[c].triangles)
      {
        for(std::size_t& v : t)
          v += static_cast<std::size_t>(n);
        triangles.push_back(t);
        component_of_triangle.push_back(c);
      }
      n += m_components[c].points.rows();
    }
    const Triangle_tree tree(points, triangles);
    for(std::size_t i = 0; i < result.size(); ++i)
      result[i] = component_of_triangle
        [tree.nearest(tree.normalized(m_followers.row(static_cast<Eigen::Index>(i)))).triangle];
    return result;
  }

  void take(const std::size_t c, Result result)
  {
    const std::vector<std::size_t>& vertices = m_components[c].vertices;
    for(std::size_t i = 0; i < vertices.size(); ++i)
      if(m_component_of[vertices[i]] == c)
        m_pose.add(vertices[i], result.pose.row(static_cast<Eigen::Index>(i)));
    for(std::size_t i = 0; i < m_followers_of[c].size(); ++i)
      m_pose_of_followers.row(m_followers_of[c][i])
        = result.pose_of_followers.row(static_cast<Eigen::Index>(i));
    m_results.take(c, std::move(result));
  }

  // In the rows of the input, without the summary.
  Result joined_results() const
  {
    Point_matrix pose(m_points.rows(), 3);
    for(std::size_t v = 0; v < m_component_of.size(); ++v)
      if(m_component_of[v] != NONE)
        pose.row(static_cast<Eigen::Index>(v))
          = m_pose[m_representatives.empty() ? v : m_representatives[v]];
    for(std::size_t i = 0; i < m_attached.size(); ++i)
      pose.row(static_cast<Eigen::Index>(m_attached[i]))
        = m_pose_of_followers.row(static_cast<Eigen::Index>(i));
    for(const std::vector<std::size_t>& part : m_rigid_parts)
      move_rigidly(part, pose);
    Result result{m_results.returned(pose), {}, {}, {}};
    result.pose = std::move(pose);
    result.pose_of_followers = m_pose_of_followers.bottomRows(m_options.followers.rows());
    return result;
  }

  // Replaces the pose of some vertices by the rigid motion nearest to it.
  void move_rigidly(const std::vector<std::size_t>& vertices, Point_matrix& pose) const
  {
    Point_matrix rest(static_cast<Eigen::Index>(vertices.size()), 3), followed(rest.rows(), 3);
    for(std::size_t i = 0; i < vertices.size(); ++i)
    {
      rest.row(static_cast<Eigen::Index>(i)) = m_points.row(static_cast<Eigen::Index>(vertices[i]));
      followed.row(static_cast<Eigen::Index>(i)) = pose.row(static_cast<Eigen::Index>(vertices[i]));
    }
    const Point_matrix moved = align_target(rest, followed, Eigen::VectorXd::Ones(rest.rows()));
    for(std::size_t i = 0; i < vertices.size(); ++i)
      pose.row(static_cast<Eigen::Index>(vertices[i])) = moved.row(static_cast<Eigen::Index>(i));
  }

  // The summary of a component with what adds up over the smaller ones.
  static Registration_summary joined(Registration_summary summary,
                                     const Registration_summary& smaller)
  {
    for(const auto& stage : smaller.stages)
      summary.add_seconds(stage.first, stage.second);
    summary.termination = (std::max)(summary.termination, smaller.termination);
    summary.iterations += smaller.iterations;
    summary.inverted += smaller.inverted;
    summary.flipped_faces += smaller.flipped_faces;
    summary.body.vertices += smaller.body.vertices;
    summary.body.tetrahedra += smaller.body.tetrahedra;
    summary.warnings.insert(summary.warnings.end(), smaller.warnings.begin(),
                            smaller.warnings.end());
    return summary;
  }

  const Point_matrix& m_points;
  const std::vector<std::size_t> m_representatives;
  const std::vector<Posed_component>& m_components;
  const Options& m_options;
  std::vector<std::size_t> m_component_of, m_local_of; // of the vertices; NONE: without component
  std::vector<std::size_t> m_shared;                   // vertices of several components
  std::vector<Component_values> m_values;
  std::vector<std::size_t> m_attached; // vertices without component
  std::vector<std::vector<std::size_t>> m_rigid_parts;
  Point_matrix m_followers; // the attached vertices, and those of the user
  std::vector<std::vector<Eigen::Index>> m_followers_of;
  Row_means m_pose{static_cast<std::size_t>(m_points.rows())};
  Point_matrix m_pose_of_followers;
  Results_by_rows m_results;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_COMPONENT_POSES_H
