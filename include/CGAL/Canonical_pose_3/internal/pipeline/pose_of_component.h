// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPONENT_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPONENT_H

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Options_constraints.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Posed_component.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Solver.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/component_body.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/component_fields.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/component_target.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/flipped_faces.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <CGAL/Real_timer.h>

#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

// Adds the seconds of a function to a stage, and returns what it returns.
template <class Function>
auto timed(Registration_summary& summary, const char* stage, const Function& f)
{
  Real_timer timer;
  timer.start();
  auto result = f();
  summary.add_seconds(stage, timer.time());
  return result;
}

// Values of the vertices of a component, brought to the surface vertices of its body.
class Body_rows
{
public:
  Body_rows(const std::vector<std::size_t>& origins, const Eigen::Index n)
    : m_origins(origins), m_copies(Eigen::VectorXd::Zero(n))
  {
    for(const std::size_t row : origins)
      m_copies[static_cast<Eigen::Index>(row)] += 1;
  }

  Eigen::VectorXd sums(const Eigen::VectorXd& values) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(m_copies.size());
    for(std::size_t i = 0; i < m_origins.size(); ++i)
      result[static_cast<Eigen::Index>(m_origins[i])] += values[static_cast<Eigen::Index>(i)];
    return result;
  }

  // Copies of a vertex of the body share its target.
  Point_matrix means(const Point_matrix& points) const
  {
    Point_matrix result = Point_matrix::Zero(m_copies.size(), 3);
    for(std::size_t i = 0; i < m_origins.size(); ++i)
      result.row(static_cast<Eigen::Index>(m_origins[i]))
        += points.row(static_cast<Eigen::Index>(i));
    return m_copies.cwiseMax(1).cwiseInverse().asDiagonal() * result;
  }

  std::vector<Index_triangle> triangles(std::vector<Index_triangle> triangles) const
  {
    for(Index_triangle& t : triangles)
      for(std::size_t& v : t)
        v = m_origins[v];
    return triangles;
  }

private:
  const std::vector<std::size_t>& m_origins;
  Eigen::VectorXd m_copies;
};

inline Eigen::VectorXd body_weights(const Body_rows& rows, const Eigen::VectorXd& shares,
                                    const Options& options, const Component_values& values)
{
  const Eigen::VectorXd weights
    = rows.sums(options.paper_weights ? Eigen::VectorXd::Ones(shares.size()).eval() : shares);
  if(values.matching_weights.size() == 0)
    return weights;
  return weights.cwiseProduct(values.matching_weights);
}

inline Registration_options component_registration_options(const Options& options,
                                                           const Posed_component& component,
                                                           const Body_view& body,
                                                           const double length_scale)
{
  Registration_options result = options.registration;
  if(options.paper_weights)
  {
    result.set_paper_weights(options.paper_weights->alpha, options.paper_weights->beta,
                             static_cast<std::size_t>(component.points.rows()), body.volume(),
                             length_scale);
    result.fairing_passes = (std::max)(result.fairing_passes, 1);
  }
  return result;
}

// What a registrar says, added to what is known already.
inline Registration_summary continued(Registration_summary summary, Registration_summary registered)
{
  for(const Registration_summary::Stage& stage : registered.stages)
    summary.add_seconds(stage.first, stage.second);
  registered.stages = std::move(summary.stages);
  registered.iterations += summary.iterations;
  registered.body.kind = std::move(summary.body.kind);
  registered.input = std::move(summary.input);
  registered.target = std::move(summary.target);
  registered.warnings.insert(registered.warnings.begin(), summary.warnings.begin(),
                             summary.warnings.end());
  return registered;
}

constexpr double TOLERATED_VOLUME_RATIO = 1.15;

// Geodesics lead around a compact body, so that its target is too large: a ball becomes a larger ball.
// The exponent brings the volume of most shapes below 1.2 times that at rest: it grows about as the
// 1.5th power of the scale.
inline Component_target shrunk(Component_target target, const double volume_ratio,
                               const Eigen::VectorXd& shares)
{
  target.summary.scale = std::pow(TOLERATED_VOLUME_RATIO / volume_ratio, 0.65);
  const Eigen::RowVector3d centroid = shares.transpose() * target.points;
  target.points = Point_matrix(
    (target.summary.scale * (target.points.rowwise() - centroid)).rowwise() + centroid);
  return target;
}

// Registers a body to a target. `summary`: of the steps before.
inline Result registered(const Posed_component& component, const Component_values& values,
                         const Options& options, const Factor_maker factor_maker,
                         Component_target target, const Component_body& component_body,
                         const Eigen::VectorXd& shares, Registration_summary summary)
{
  const Body_view body(component_body.body);
  const Body_rows rows(component_body.origins, body.embedding().rows());
  const Eigen::VectorXd weights = body_weights(rows, shares, options, values);
  if(const auto row
     = surface_vertex_of_loose_component(body, weights)) // the registrar would name one of the body
    throw std::invalid_argument("all matching weights are 0 in the part around vertex "
                                + std::to_string(component.vertices[*row]));
  Options_constraints constraints(values, static_cast<std::size_t>(body.embedding().rows()));
  const double length_scale = target.summary.max_geodesic;
  const auto registration
    = make_arap_registration(body, weights, length_scale,
                             component_registration_options(options, component, body, length_scale),
                             component_body.stiffness, default_rotation_routines(), factor_maker);
  constraints.add_to(*registration);

  Registration_visitor visitor;
  if(options.visitor)
    visitor = [&](Registration_progress progress) { // which counts all iterations
      progress.iteration += summary.iterations;
      return options.visitor(progress);
    };
  Point_matrix body_pose;
  const auto run = [&] {
    summary.target = target.summary;
    registration->set_target(rows.means(target.points));
    Registration_summary one = registration->register_to_target(body_pose, visitor);
    summary = continued(std::move(summary), std::move(one));
  };
  run();
  if(!target.is_given && !options.paper_weights && summary.is_usable()
     && summary.volume_ratio > TOLERATED_VOLUME_RATIO
     && summary.termination != Registration_summary::CANCELED)
  {
    target = shrunk(std::move(target), summary.volume_ratio, shares);
    run();
  }

  Result result;
  if(summary.is_usable())
  {
    result.pose = body.embedding() * body_pose;
    const std::vector<Index_triangle> triangles = rows.triangles(component.triangles);
    const Point_matrix rest = body.embedding() * body.points();
    summary.median_edge_strain = timed(
      summary, "diagnosis", [&] { return median_edge_strain(rest, result.pose, triangles); });
    summary.flipped_faces = timed(summary, "diagnosis", [&] {
      return flipped_faces(body, triangles, rest, result.pose, body_pose);
    });
    if(values.followers.rows() > 0)
      result.pose_of_followers = timed(summary, "global_steps", [&] {
        return Point_matrix(Body_deformer_3<Body_view>(body, triangles).embedding(values.followers)
                            * body_pose);
      });
    result.target = std::move(target.points);
    if(summary.termination == Registration_summary::ITERATION_LIMIT)
      summary.warnings.push_back("the registration did not converge within the iterations allowed");
    else if(summary.termination == Registration_summary::CANCELED)
      summary.warnings.push_back("the registration was canceled before it converged");
  }
  result.summary = std::move(summary);
  return result;
}

// canonical_pose_3() for one component, in its rows. `make_body(fields, shares)` returns a `Component_body`.
template <class MakeBody>
Result pose_of_component(const Posed_component& component, const Component_values& values,
                         const Options& options, const Solver& solver, const MakeBody& make_body,
                         const Diagnosis_3& diagnosis)
{
  Registration_summary summary;
  for(const char* stage :
      {"diagnosis", "geodesics", "target", "body", "factorization", "local_steps", "global_steps"})
    summary.add_seconds(stage, 0);
  summary.input = diagnosis;
  const Eigen::VectorXd shares = vertex_area_shares(component.points, component.triangles);

  std::optional<Landmark_fields_3> computed_fields;
  if(!values.given.landmark_fields)
    computed_fields = timed(summary, "geodesics", [&] {
      return component_fields(component, options, solver.lane_factor_maker);
    });
  const Landmark_fields_3& fields
    = computed_fields ? *computed_fields : *values.given.landmark_fields;
  Component_target target = timed(summary, "target", [&] {
    return component_target(component, fields, values.given.target, options, shares);
  });
  const Component_body body = timed(summary, "body", [&] { return make_body(fields, shares); });
  summary.body.kind = body.kind;
  summary.warnings = body.warnings;
  summary.warnings.insert(summary.warnings.end(), target.warnings.begin(), target.warnings.end());

  Result result = registered(component, values, options, solver.factor_maker, std::move(target),
                             body, shares, std::move(summary));
  result.landmark_fields = std::move(computed_fields);
  return result;
}

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_POSE_OF_COMPONENT_H
