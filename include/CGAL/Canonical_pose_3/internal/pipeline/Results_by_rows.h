// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_RESULTS_BY_ROWS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_RESULTS_BY_ROWS_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// What the fields and targets of the input have rows for, and how vertices stand for one another.
struct Input_rows
{
  std::vector<std::size_t> representatives; // of each vertex; none: each stands for itself
  std::vector<std::size_t> vertices;        // of each row of fields and targets
  const char* row_name;                     // of such a row, in messages

  // Rows are vertices wherever representatives are given.
  std::size_t representative(const std::size_t v) const
  {
    return representatives.empty() ? v : representatives[v];
  }
};

// The means of what is said of each row: by the copies of a vertex, which may have come apart a little.
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

  // How much was said of the row.
  std::size_t number(const std::size_t row) const { return m_numbers[row]; }

  Eigen::RowVector3d operator[](const std::size_t row) const
  {
    return m_sums.row(static_cast<Eigen::Index>(row)) * (1 / static_cast<double>(m_numbers[row]));
  }

private:
  Point_matrix m_sums;
  std::vector<std::size_t> m_numbers;
};

// Brings fields and targets that are given to the rows of the components, and returns those of the components in
// the rows of the input.
class Results_by_rows
{
public:
  static constexpr std::size_t NONE = std::size_t(-1);

  // Throws `std::invalid_argument` if what is given does not fit the input. `component_of`: of the vertices.
  Results_by_rows(Input_rows rows, const std::vector<Posed_component>& components,
                  const std::vector<std::size_t>& component_of, const Options& options)
    : m_rows(std::move(rows)), m_components(components), m_component_of(component_of),
      m_options(options), m_targets(number_of_rows())
  {
    check_given();
  }

  // What is given, in the rows of a component.
  Intermediate_results given_to(const std::size_t c) const
  {
    const Posed_component& component = m_components[c];
    Intermediate_results result;
    const Eigen::Index n = component.points.rows();
    const auto row = [&](const Eigen::Index i) {
      return static_cast<Eigen::Index>(component.field_rows[static_cast<std::size_t>(i)]);
    };
    if(has_given_fields())
      result.landmark_fields = given_fields(component);
    if(has_given_target())
    {
      result.target.emplace(n, 3);
      for(Eigen::Index i = 0; i < n; ++i)
      {
        result.target->row(i) = m_options.given.target->row(row(i));
        if(!result.target->row(i).allFinite())
          throw std::invalid_argument("the given target of "
                                      + name_of_row(static_cast<std::size_t>(row(i)))
                                      + " is not finite");
      }
    }
    return result;
  }

  // One line if what is given has one row for several copies of a vertex.
  std::optional<std::string> warning() const
  {
    if(!has_given_fields() && !has_given_target())
      return std::nullopt;
    std::vector<std::size_t> copies(number_of_rows(), 0);
    for(const Posed_component& component : m_components)
      for(const std::size_t row : component.field_rows)
        ++copies[row];
    const auto more_than_one = [](const std::size_t number) { return number > 1; };
    const auto first = std::find_if(copies.begin(), copies.end(), more_than_one);
    if(first == copies.end())
      return std::nullopt;
    return "the surface is not manifold at "
           + name_of_row(static_cast<std::size_t>(first - copies.begin())) + ", of "
           + std::to_string(std::count_if(first, copies.end(), more_than_one))
           + " in all: what is given there is taken for all copies of the vertex";
  }

  // Collects what a component returns.
  void take(const std::size_t c, Intermediate_results results)
  {
    const std::vector<std::size_t>& rows = m_components[c].field_rows;
    for(std::size_t i = 0; i < rows.size(); ++i)
      if(m_component_of[m_rows.vertices[rows[i]]] == c)
        m_targets.add(rows[i], results.target->row(static_cast<Eigen::Index>(i)));
    if(m_components.size() == 1 && m_options.return_landmark_fields)
      m_fields = std::move(results.landmark_fields);
  }

  // The target, and the fields if requested; what was given as it is. `pose`: of the vertices.
  Intermediate_results returned(const Point_matrix& pose) const
  {
    Intermediate_results results;
    results.target = has_given_target() ? *m_options.given.target : returned_target(pose);
    if(has_given_fields() && m_options.return_landmark_fields)
      results.landmark_fields = m_options.given.landmark_fields;
    else if(m_fields)
      results.landmark_fields = returned_fields();
    return results;
  }

private:
  std::size_t number_of_rows() const { return m_rows.vertices.size(); }
  bool has_given_fields() const { return m_options.given.landmark_fields.has_value(); }
  bool has_given_target() const { return m_options.given.target.has_value(); }

  void check_given() const
  {
    if(has_given_fields())
    {
      const Landmark_fields_3& fields = *m_options.given.landmark_fields;
      if(m_components.size() > 1)
        throw std::invalid_argument("distances can be given for a single component only");
      if(fields.distances.cols() == 0)
        throw std::invalid_argument("the given distances have no column");
      check_rows(fields.distances.rows(), "the given distances have ");
      if(fields.landmarks.size() != static_cast<std::size_t>(fields.distances.cols()))
        throw std::invalid_argument(
          "there are " + std::to_string(fields.landmarks.size()) + " given landmarks, but "
          + std::to_string(fields.distances.cols()) + " columns of distances");
      for(const std::size_t landmark : fields.landmarks)
        if(landmark >= number_of_rows())
          throw std::invalid_argument("a given landmark is " + name_of_row(landmark)
                                      + ", but there are " + std::to_string(number_of_rows()));
    }
    if(has_given_target())
      check_rows(m_options.given.target->rows(), "the given target has ");
  }

  void check_rows(const Eigen::Index rows, const std::string& what) const
  {
    if(rows != static_cast<Eigen::Index>(number_of_rows()))
      throw std::invalid_argument(what + std::to_string(rows) + " rows, but there are "
                                  + std::to_string(number_of_rows()) + " vertices");
  }

  std::string name_of_row(const std::size_t row) const
  {
    return m_rows.row_name + (' ' + std::to_string(row));
  }

  Landmark_fields_3 given_fields(const Posed_component& component) const
  {
    const Landmark_fields_3& fields = *m_options.given.landmark_fields;
    std::vector<std::size_t> surface_vertex(number_of_rows(), NONE);
    for(std::size_t i = component.field_rows.size(); i-- > 0;)
      surface_vertex[component.field_rows[i]] = i;

    Landmark_fields_3 result;
    result.covering_radius = fields.covering_radius;
    for(const std::size_t landmark : fields.landmarks)
    {
      result.landmarks.push_back(surface_vertex[m_rows.representative(landmark)]);
      if(result.landmarks.back() == NONE)
        throw std::invalid_argument("the given landmark " + name_of_row(landmark)
                                    + " is not on the surface");
    }
    result.distances.resize(component.points.rows(), fields.distances.cols());
    for(Eigen::Index j = 0; j < result.distances.cols(); ++j)
      for(Eigen::Index i = 0; i < result.distances.rows(); ++i)
      {
        const std::size_t row = component.field_rows[static_cast<std::size_t>(i)];
        const double distance = fields.distances(static_cast<Eigen::Index>(row), j);
        if(!(distance >= 0) || !std::isfinite(distance))
          throw std::invalid_argument(
            "the given distance of " + name_of_row(row) + " to landmark "
            + std::to_string(fields.landmarks[static_cast<std::size_t>(j)]) + " is "
            + (distance < 0 ? "negative" : "not finite"));
        result.distances(i, j) = distance;
      }
    return result;
  }

  // Rows that are on no surface have the pose as target.
  Point_matrix returned_target(const Point_matrix& pose) const
  {
    Point_matrix result(static_cast<Eigen::Index>(number_of_rows()), 3);
    for(std::size_t row = 0; row < number_of_rows(); ++row)
    {
      const std::size_t r = m_rows.representative(row);
      if(m_targets.number(r) > 0)
        result.row(static_cast<Eigen::Index>(row)) = m_targets[r];
      else
        result.row(static_cast<Eigen::Index>(row))
          = pose.row(static_cast<Eigen::Index>(m_rows.vertices[row]));
    }
    return result;
  }

  // Of the copies of a vertex the nearest counts.
  Landmark_fields_3 returned_fields() const
  {
    const std::vector<std::size_t>& rows = m_components.front().field_rows;
    Landmark_fields_3 result;
    result.covering_radius = m_fields->covering_radius;
    for(const std::size_t landmark : m_fields->landmarks)
      result.landmarks.push_back(rows[landmark]);
    result.distances.setConstant(static_cast<Eigen::Index>(number_of_rows()),
                                 m_fields->distances.cols(),
                                 std::numeric_limits<double>::infinity());
    for(Eigen::Index j = 0; j < result.distances.cols(); ++j)
    {
      for(std::size_t i = 0; i < rows.size(); ++i)
      {
        double& distance = result.distances(static_cast<Eigen::Index>(rows[i]), j);
        distance = (std::min)(distance, m_fields->distances(static_cast<Eigen::Index>(i), j));
      }
      for(std::size_t v = 0; v < m_rows.representatives.size(); ++v)
        result.distances(static_cast<Eigen::Index>(v), j)
          = result.distances(static_cast<Eigen::Index>(m_rows.representatives[v]), j);
    }
    return result;
  }

  const Input_rows m_rows;
  const std::vector<Posed_component>& m_components;
  const std::vector<std::size_t>& m_component_of;
  const Options& m_options;
  Row_means m_targets;
  std::optional<Landmark_fields_3> m_fields; // of a single component
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_RESULTS_BY_ROWS_H
