// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_REGISTERED_POSE_IMPL_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_REGISTERED_POSE_IMPL_H

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Options_constraints.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Thread_limit.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/solver_of_options.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/timed.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/flipped_faces.h>
#include <CGAL/Canonical_pose_3/internal/soup/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <CGAL/assertions.h>

#include <Eigen/SparseCore>

#include <algorithm>
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
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

namespace internal {

// Values at the vertices of a surface, transferred to the surface vertices of its body.
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

  // Copies of a vertex of the body have the same target.
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
                                    const Options& options)
{
  const Eigen::VectorXd weights
    = rows.sums(options.paper_weights ? Eigen::VectorXd::Ones(shares.size()).eval() : shares);
  if(options.matching_weights.size() == 0)
    return weights;
  return weights.cwiseProduct(options.matching_weights);
}

// The options of the registrar for one component.
inline Registration_options registration_options(const Options& options,
                                                 const Surface_component_3& surface,
                                                 const Body_view& body, const double length_scale)
{
  Registration_options result = options.registration;
  if(options.paper_weights)
  {
    result.set_paper_weights(options.paper_weights->alpha, options.paper_weights->beta,
                             static_cast<std::size_t>(surface.points.rows()), body.volume(),
                             length_scale);
    result.fairing_passes = (std::max)(result.fairing_passes, 1);
  }
  return result;
}

inline double volume_ratio_limit(const Options& options, const Target_3& target)
{
  constexpr double limit = 1.15;
  return options.volume_ratio_limit.value_or(
    target.is_given || options.paper_weights ? std::numeric_limits<double>::infinity() : limit);
}

// The volume grows approximately as the 1.5th power of the scale; with this exponent, the volume of
// most shapes is reduced to about the limit.
inline Target_3 shrunk(Target_3 target, const double volume_ratio, const double limit,
                       const Eigen::VectorXd& shares)
{
  target.summary.scale = std::pow(limit / volume_ratio, 0.65);
  const Eigen::RowVector3d centroid = shares.transpose() * target.points;
  target.points = Point_matrix(
    (target.summary.scale * (target.points.rowwise() - centroid)).rowwise() + centroid);
  return target;
}

// Adds the summary of a registrar to what is already known.
inline Registration_summary continued(Registration_summary summary, Registration_summary registered)
{
  for(const Registration_summary::Stage& stage : registered.stages)
    summary.add_seconds(stage.first, stage.second);
  registered.stages = std::move(summary.stages);
  registered.iterations += summary.iterations;
  registered.body.kind = std::move(summary.body.kind);
  registered.warnings.insert(registered.warnings.begin(), summary.warnings.begin(),
                             summary.warnings.end());
  return registered;
}

// A registrar for the body of a surface.
inline std::unique_ptr<Arap_registration> surface_registration(const Surface_component_3& surface,
                                                               const Surface_body_3& body,
                                                               const Eigen::VectorXd& weights,
                                                               const Options& options)
{
  const Body_view view(body.body);
  if(const auto row
     = surface_vertex_of_loose_component(view, weights)) // the registrar would name one of the body
    throw std::invalid_argument("all matching weights are 0 in the part around vertex "
                                + std::to_string(surface.body_origins[*row]));
  return make_arap_registration(view, weights, body.length_scale,
                                registration_options(options, surface, view, body.length_scale),
                                body.stiffness, default_rotation_routines(),
                                solver_of_options(options).factor_maker());
}

// Completes a result that has a summary: pose of surface and followers, and measures.
inline void add_poses(const Surface_component_3& surface, const Surface_body_3& body,
                      const Body_rows& rows, const Point_matrix& body_pose,
                      const Point_matrix& followers, Result& result)
{
  const Body_view view(body.body);
  Registration_summary& summary = result.summary;
  result.pose = view.embedding() * body_pose;
  const std::vector<Index_triangle> triangles = rows.triangles(surface.triangles);
  const Point_matrix rest = view.embedding() * view.points();
  summary.median_edge_strain
    = timed(summary, "diagnosis", [&] { return median_edge_strain(rest, result.pose, triangles); });
  summary.flipped_faces = timed(summary, "diagnosis", [&] {
    return flipped_faces(view, triangles, rest, result.pose, body_pose);
  });
  if(followers.rows() > 0)
    result.pose_of_followers = timed(summary, "global_steps", [&] {
      return Point_matrix(Body_deformer_3<Body_view>(view, triangles).embedding(followers)
                          * body_pose);
    });
  if(summary.termination == Registration_summary::ITERATION_LIMIT)
    summary.warnings.push_back("the registration did not converge within the iterations allowed");
  else if(summary.termination == Registration_summary::CANCELED)
    summary.warnings.push_back("the registration was canceled before it converged");
}

} // namespace internal

CGAL_CANONICAL_POSE_3_INLINE Result registered_pose(const Surface_component_3& surface,
                                                    const Target_3& given_target,
                                                    const Surface_body_3& body,
                                                    const Options& options)
{
  const internal::Thread_limit limit(options);
  CGAL_precondition(given_target.points.rows() == surface.points.rows());
  Target_3 target = given_target;
  Result result;
  Registration_summary& summary = result.summary;
  summary.body.kind = body.kind;
  summary.warnings = body.warnings;
  summary.warnings.insert(summary.warnings.end(), target.warnings.begin(), target.warnings.end());

  const Eigen::VectorXd shares = vertex_area_shares(surface.points, surface.triangles);
  const internal::Body_rows rows(body.surface_vertices, body.body.embedding().rows());
  const auto registration = internal::surface_registration(
    surface, body, internal::body_weights(rows, shares, options), options);
  internal::Options_constraints constraints(options.constraints,
                                            static_cast<std::size_t>(body.body.embedding().rows()));
  constraints.add_to(*registration, surface.body_origins);

  Registration_visitor visitor;
  if(options.visitor)
    visitor = [&](Registration_progress progress) { // counts all iterations
      progress.iteration += summary.iterations;
      return options.visitor(progress);
    };
  Point_matrix body_pose;
  const auto run = [&] {
    registration->set_target(rows.means(target.points));
    Registration_summary one = registration->register_to_target(body_pose, visitor);
    summary = internal::continued(std::move(summary), std::move(one));
    summary.target = target.summary;
  };
  run();
  const double volume_limit = internal::volume_ratio_limit(options, target);
  if(summary.is_usable() && summary.volume_ratio > volume_limit
     && summary.termination != Registration_summary::CANCELED)
  {
    target = internal::shrunk(std::move(target), summary.volume_ratio, volume_limit, shares);
    run();
  }
  if(summary.is_usable())
  {
    internal::add_poses(surface, body, rows, body_pose, options.followers, result);
    result.target = std::move(target.points);
  }
  return result;
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_PIPELINE_REGISTERED_POSE_IMPL_H
