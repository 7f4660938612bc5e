// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_POSE_OF_SURFACE_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_POSE_OF_SURFACE_H

#include <CGAL/Canonical_pose_3/internal/configuration.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/Canonical_pose_pipeline.h>
#include <CGAL/Canonical_pose_3/internal/Disjoint_sets.h>
#include <CGAL/Canonical_pose_3/internal/Options_constraints.h>
#include <CGAL/Canonical_pose_3/internal/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/inline_definition.h>
#include <CGAL/Canonical_pose_3/internal/with_solver.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <CGAL/Real_timer.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// canonical_pose_3() for any polygons: examines and repairs them, brings the components wished into
// their pose, and carries the pose back to the vertices of the input.
template <typename FactorTraits>
class Pose_of_surface
{
public:
  Pose_of_surface(const Point_matrix& points, const std::vector<std::vector<std::size_t>>& polygons,
                  const Options& options)
    : m_points(points), m_polygons(polygons), m_options(options),
      m_results(options.intermediate_results != nullptr ? *options.intermediate_results
                                                        : m_own_results)
  {}

  Registration_summary run(Point_matrix& pose)
  {
    m_options.registration.check();
    check_factors(m_options.matching_weights, m_points.rows(), "matching weight", "vertex", true);
    check_factors(m_options.stiffness, m_points.rows(), "stiffness", "vertex", false);
    Real_timer timer;
    timer.start();
    const Diagnosis_3 diagnosis = diagnose(m_points, m_polygons);
    const Repaired_surface_3 surface = repair_surface(m_points, m_polygons);
    const std::vector<std::size_t> components = components_to_pose(surface, diagnosis);
    if((m_results.landmark_fields || m_results.target) && components.size() > 1)
      throw std::invalid_argument(
        "distances or a target can be handed in for a single component only");
    timer.stop();

    m_pose = Point_matrix::Zero(m_points.rows(), 3);
    m_is_posed.assign(static_cast<std::size_t>(m_points.rows()), false);
    Registration_summary summary;
    // the largest component last: it carries what has no pose of its own
    for(std::size_t i = components.size(); i-- > 0 && (is_first(summary) || summary.is_usable());)
      summary = joined(run_component(component_of_surface(surface, components[i]), diagnosis,
                                     i == 0, components.size() > 1),
                       summary);
    summary.add_seconds("diagnosis", timer.time());
    if(summary.is_usable())
      pose = std::move(m_pose);
    return summary;
  }

private:
  // Components that hang together at vertices where the surface was split count as one if all but the
  // largest are crumbs; these get no pose of their own.
  static constexpr double SHARE_OF_CRUMBS = 0.05;

  std::vector<std::size_t> components_to_pose(const Repaired_surface_3& surface,
                                              const Diagnosis_3& diagnosis) const
  {
    const std::size_t n = surface.number_of_components;
    std::vector<double> areas(n, 0.);
    Disjoint_sets groups(n);
    std::vector<std::size_t> component_of_row(static_cast<std::size_t>(m_points.rows()), n);
    Point_matrix points = surface.points;
    normalize(points);
    for(std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
      const std::size_t component = surface.component_of_triangle[t];
      areas[component] += twice_area(points, surface.triangles[t]);
      for(const std::size_t v : surface.triangles[t])
      {
        std::size_t& other = component_of_row[surface.origins[v]];
        if(other == n)
          other = component;
        groups.unite(component, other);
      }
    }
    // components come by decreasing area, so the first of a group is its largest
    std::vector<std::size_t> first(n, n);
    std::vector<double> area_of_rest(n, 0.);
    for(std::size_t c = 0; c < n; ++c)
    {
      std::size_t& f = first[groups.representative(c)];
      if(f == n)
        f = c;
      else
        area_of_rest[f] += areas[c];
    }
    std::vector<std::size_t> result;
    for(std::size_t c = 0; c < n; ++c)
    {
      const std::size_t f = first[groups.representative(c)];
      if(areas[c] > 0 && (c == f || area_of_rest[f] > SHARE_OF_CRUMBS * areas[f]))
        result.push_back(c);
    }
    if(result.size() > 1 && m_options.components == Options::Components::REFUSE)
      throw std::invalid_argument(
        diagnosis.components > 1
          ? "the surface has " + std::to_string(result.size()) + " connected components"
          : "the surface falls into " + std::to_string(result.size())
              + " components where it is not manifold: " + diagnosis.first_defect);
    if(m_options.components == Options::Components::LARGEST)
      result.resize(1);
    return result;
  }

  Registration_summary run_component(const Repaired_surface_3& surface,
                                     const Diagnosis_3& diagnosis, const bool is_largest,
                                     const bool is_one_of_several)
  {
    const std::vector<std::size_t> copies = first_copies(surface);
    std::vector<std::size_t> carried;
    if(is_largest)
      for(std::size_t v = 0; v < m_is_posed.size(); ++v)
        if(!m_is_posed[v] && copies[v] == surface.origins.size())
          carried.push_back(v);

    Options options = m_options;
    Intermediate_results results;
    options.intermediate_results = &results;
    hand_in(surface, carried, is_largest, is_one_of_several, results);
    Options_constraints::for_each_list(options, [&](auto& elements) {
      bring_to_surface(elements, copies, surface, is_one_of_several);
    });
    for(Eigen::VectorXd* const factors : {&options.matching_weights, &options.stiffness})
      if(factors->size() > 0)
        *factors = of_copies(surface, *factors);
    Point_matrix pose;
    Canonical_pose_pipeline<FactorTraits> pipeline(surface, options, diagnosis);
    Registration_summary summary = pipeline.run(pose);
    if(summary.is_usable())
    {
      take_pose(surface, copies, pose, results, carried);
      if(m_options.intermediate_results != nullptr)
        hand_out(surface, copies, results, carried, is_one_of_several);
    }
    return summary;
  }

  void hand_in(const Repaired_surface_3& surface, const std::vector<std::size_t>& carried,
               const bool is_largest, const bool is_one_of_several,
               Intermediate_results& results) const
  {
    if(m_results.landmark_fields && !is_one_of_several)
    {
      const Landmark_fields_3& fields = *m_results.landmark_fields;
      if(fields.distances.cols() == 0)
        throw std::invalid_argument("the distances handed in have no column");
      check_rows(fields.distances.rows(), "the distances handed in have ");
      results.landmark_fields = fields;
      results.landmark_fields->distances.resize(surface.points.rows(), fields.distances.cols());
      for(Eigen::Index i = 0; i < surface.points.rows(); ++i)
        results.landmark_fields->distances.row(i) = fields.distances.row(origin(surface, i));
    }
    if(m_results.target && !is_one_of_several)
    {
      check_rows(m_results.target->rows(), "the target handed in has ");
      results.target.emplace(surface.points.rows(), 3);
      for(Eigen::Index i = 0; i < surface.points.rows(); ++i)
        results.target->row(i) = m_results.target->row(origin(surface, i));
    }
    const Eigen::Index n = static_cast<Eigen::Index>(carried.size());
    const Eigen::Index m = is_largest ? m_results.followers.rows() : 0;
    results.followers.resize(n + m, 3);
    for(Eigen::Index i = 0; i < n; ++i)
      results.followers.row(i)
        = m_points.row(static_cast<Eigen::Index>(carried[static_cast<std::size_t>(i)]));
    if(m > 0)
      results.followers.bottomRows(m) = m_results.followers;
  }

  // The value of each vertex of the surface, given those of the input.
  static Eigen::VectorXd of_copies(const Repaired_surface_3& surface, const Eigen::VectorXd& values)
  {
    Eigen::VectorXd result(surface.points.rows());
    for(Eigen::Index i = 0; i < result.size(); ++i)
      result[i] = values[origin(surface, i)];
    return result;
  }

  static Eigen::Index origin(const Repaired_surface_3& surface, const Eigen::Index i)
  {
    return static_cast<Eigen::Index>(surface.origins[static_cast<std::size_t>(i)]);
  }

  void check_rows(const Eigen::Index rows, const std::string& what) const
  {
    if(rows != m_points.rows())
      throw std::invalid_argument(what + std::to_string(rows) + " rows, but there are "
                                  + std::to_string(m_points.rows()) + " vertices");
  }

  // Puts the vertices of the surface into the elements of a constraint; of several components each takes
  // those of its own.
  template <typename Element>
  static void bring_to_surface(std::vector<Element>& elements,
                               const std::vector<std::size_t>& copies,
                               const Repaired_surface_3& surface, const bool is_one_of_several)
  {
    std::vector<Element> result;
    for(std::size_t i = 0; i < elements.size(); ++i)
    {
      typedef Constraint_element_traits<Element> Traits;
      const std::string name = Traits::name + (' ' + std::to_string(i));
      bool is_here = true;
      for(std::size_t* const vertex : Traits::pointers_to_vertices(elements[i]))
      {
        if(*vertex >= copies.size())
          throw std::invalid_argument(name + " names vertex " + std::to_string(*vertex)
                                      + ", but there are " + std::to_string(copies.size()));
        const std::size_t copy = copies[*vertex];
        if(copy == surface.origins.size() && !is_one_of_several)
          throw std::invalid_argument(name + " names vertex " + std::to_string(*vertex)
                                      + ", which is not on the surface");
        is_here = is_here && copy != surface.origins.size();
        *vertex = copy;
      }
      if(is_here)
        result.push_back(elements[i]);
    }
    elements = std::move(result);
  }

  // Copies of a vertex may have come apart a little: it lies in their middle.
  void take_pose(const Repaired_surface_3& surface, const std::vector<std::size_t>& copies,
                 const Point_matrix& pose, const Intermediate_results& results,
                 const std::vector<std::size_t>& carried)
  {
    const Point_matrix of_rows = mean_over_copies(surface, pose);
    for(std::size_t v = 0; v < m_is_posed.size(); ++v)
      if(copies[v] < surface.origins.size())
      {
        m_pose.row(static_cast<Eigen::Index>(v))
          = of_rows.row(static_cast<Eigen::Index>(surface.representatives[v]));
        m_is_posed[v] = true;
      }
    for(std::size_t i = 0; i < carried.size(); ++i)
      m_pose.row(static_cast<Eigen::Index>(carried[i]))
        = results.pose_of_followers.row(static_cast<Eigen::Index>(i));
  }

  Point_matrix mean_over_copies(const Repaired_surface_3& surface, const Point_matrix& rows) const
  {
    Point_matrix sum = Point_matrix::Zero(m_points.rows(), 3);
    Eigen::VectorXd count = Eigen::VectorXd::Zero(m_points.rows());
    for(Eigen::Index i = 0; i < rows.rows(); ++i)
    {
      sum.row(origin(surface, i)) += rows.row(i);
      count[origin(surface, i)] += 1;
    }
    return count.cwiseMax(1).cwiseInverse().asDiagonal() * sum;
  }

  // Rows of vertices that are not on the surface: no distance, and the pose as target.
  void hand_out(const Repaired_surface_3& surface, const std::vector<std::size_t>& copies,
                Intermediate_results& results, const std::vector<std::size_t>& carried,
                const bool is_one_of_several)
  {
    if(!m_results.target)
      m_results.target = m_points;
    const Point_matrix targets = mean_over_copies(surface, *results.target);
    for(Eigen::Index v = 0; v < m_points.rows(); ++v)
    {
      const std::size_t row = static_cast<std::size_t>(v);
      if(copies[row] < surface.origins.size())
        m_results.target->row(v)
          = targets.row(static_cast<Eigen::Index>(surface.representatives[row]));
    }
    for(const std::size_t v : carried)
      m_results.target->row(static_cast<Eigen::Index>(v))
        = m_pose.row(static_cast<Eigen::Index>(v));
    const Eigen::Index m
      = results.pose_of_followers.rows() - static_cast<Eigen::Index>(carried.size());
    m_results.pose_of_followers = results.pose_of_followers.bottomRows(m);
    if(is_one_of_several || m_results.landmark_fields)
      return;
    const Landmark_fields_3& fields = *results.landmark_fields;
    m_results.landmark_fields = fields;
    for(std::size_t& landmark : m_results.landmark_fields->landmarks)
      landmark = surface.origins[landmark];
    m_results.landmark_fields->distances.setConstant(m_points.rows(), fields.distances.cols(),
                                                     std::numeric_limits<double>::infinity());
    for(Eigen::Index v = 0; v < m_points.rows(); ++v)
    {
      const std::size_t copy = copies[static_cast<std::size_t>(v)];
      if(copy < surface.origins.size())
        m_results.landmark_fields->distances.row(v)
          = fields.distances.row(static_cast<Eigen::Index>(copy));
    }
  }

  static bool is_first(const Registration_summary& summary) { return summary.stages.empty(); }

  // The summary of a component with what adds up over the smaller ones.
  static Registration_summary joined(Registration_summary summary,
                                     const Registration_summary& smaller)
  {
    if(is_first(smaller))
      return summary;
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
  const std::vector<std::vector<std::size_t>>& m_polygons;
  const Options& m_options;
  Intermediate_results m_own_results;
  Intermediate_results& m_results;
  Point_matrix m_pose;
  std::vector<bool> m_is_posed;
};

CGAL_CANONICAL_POSE_3_DEFINITION Registration_summary
pose_of_surface(const Point_matrix& points, const std::vector<std::vector<std::size_t>>& polygons,
                const Options& options, Point_matrix& pose)
{
  return with_solver(options, [&](const auto factor_traits) {
    typedef std::decay_t<decltype(factor_traits)> Factor_traits;
    return Pose_of_surface<Factor_traits>(points, polygons, options).run(pose);
  });
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_POSE_OF_SURFACE_H
