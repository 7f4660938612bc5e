// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_SURFACE_REGISTRATION_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_SURFACE_REGISTRATION_H

#include "Body_rows.h"
#include "Options_constraints.h"
#include "Registered_body.h"
#include "solver_of_options.h"
#include "timed.h"
#include "../registration/flipped_faces.h"
#include "../surface/closed.h"
#include "../surface/planar.h"

#include <CGAL/Canonical_pose_3/Body_deformer_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/check_registration.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

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
namespace internal {

// Registers the body of a surface to one target after the other.
class Surface_registration
{
public:
  Surface_registration(const Surface_component_3& surface, const Surface_body_3& body,
                       const Component_options& options)
    : m_surface(surface), m_body(body), m_options(options), m_view(body.body),
      m_rows(body.surface_vertices, m_view.embedding().rows()),
      m_shares(vertex_area_shares(surface.points, surface.triangles)),
      m_triangles(m_rows.triangles(surface.triangles)),
      m_rest(m_view.embedding() * m_view.points()),
      m_registration_options(registration_options(options, surface, m_view, body.length_scale)),
      m_constraints(options.constraints, static_cast<std::size_t>(m_view.embedding().rows())),
      m_registration(registration(body_weights(m_rows, m_shares, options)))
  {
    m_constraints.add_to(*m_registration, surface.body_origins);
  }

  // Registers to the target of `previous`, starting at its pose if there is one. If the visitor
  // canceled, only inverted cells are untangled in the best pose for the target.
  Registered_body operator()(const Registered_body& previous) const
  {
    Registered_body result
      = is_canceled(previous) ? previous : registered(previous, m_registration_options);
    if(!is_canceled(result))
      return result;
    if(has_best_pose(result))
      result.points = result.best_pose.points;
    Registration_options last = m_registration_options;
    last.number_of_iterations = 0;
    result = registered(result, last);
    result.summary.termination = Registration_summary::CANCELED;
    return result;
  }

  // Registers in the same way, to measure distances. A target that is partly inside out squeezes a
  // soft body flat; so a body that collapses starts again as a stiff one, whose target will be right
  // side out. `stiff`: its factor of the detail length.
  Registered_body measured(const Registered_body& previous, const double stiff) const
  {
    constexpr double soft = 0.5;
    Registered_body result
      = registered(previous, measurement_options(m_registration_options, soft));
    if(!is_complete(result) || !is_collapsed(result.summary))
      return result;
    Registered_body start = previous;
    take_costs(start.summary, result.summary);
    start.best_pose = result.best_pose;
    start.target_of_best_pose = result.target_of_best_pose;
    return measured_stiff(start, stiff);
  }

  Registered_body measured_stiff(const Registered_body& previous, const double stiff) const
  {
    Registered_body result
      = registered(previous, measurement_options(m_registration_options, stiff));
    result.is_stiff = true;
    return result;
  }

  // Takes one step with the full detail length from a pose that was registered to measure distances.
  // Its rotations remain, so limbs stay straight, but they regain the lengths that a soft body gave
  // up to reach the target. The step is prolonged, since a single one hardly reaches the minimum.
  Registered_body relaxed(const Registered_body& measured) const
  {
    constexpr double prolongation = 1.25;
    Registered_body result = measured;
    Registration_options options = measurement_options(m_registration_options, 1);
    options.number_of_iterations = 1;
    m_registration->set_options(options);
    run(result);
    if(!is_complete(result))
      return result;
    result.points = measured.points + prolongation * (result.points - measured.points);
    if(result.summary.termination == Registration_summary::ITERATION_LIMIT)
      result.summary.termination = measured.summary.termination;
    return result;
  }

  // Whether there is a pose, and the visitor did not cancel the registration.
  static bool is_complete(const Registered_body& registered)
  {
    return registered.summary.is_usable() && !is_canceled(registered);
  }

  // Whether rounds took so many iterations that they do not converge: nothing else is tried.
  // `before`: iterations before these rounds.
  bool is_exhausted(const Registered_body& registered, const int before = 0) const
  {
    return registered.summary.iterations - before
           >= (std::max)(m_registration_options.number_of_iterations,
                         Registration_options().number_of_iterations);
  }

  // `pose`: of the surface vertices of the body.
  double median_strain(const Point_matrix& pose) const
  {
    return median_edge_strain(m_rest, pose, m_triangles);
  }

  // How far two targets are apart after alignment: the root mean square distance by the length
  // scale.
  double difference(const Target_3& target, const Target_3& other) const
  {
    const Point_matrix aligned = align_target(target.points, other.points, m_shares);
    return std::sqrt((aligned - other.points).rowwise().squaredNorm().dot(m_shares)
                     / m_shares.sum())
           / m_body.length_scale;
  }

  // The pose of the surface vertices of the body.
  Point_matrix pose(const Registered_body& registered) const
  {
    return m_view.embedding() * registered.points;
  }

  // The pose of the vertices of the surface.
  Point_matrix surface_pose(const Point_matrix& pose) const
  {
    return rows_at(pose, m_body.surface_vertices);
  }

  Target_handedness_3 handedness(const Target_3& target) const
  {
    return target_handedness(target.points, m_surface.points, closed(m_surface), m_shares);
  }

  // In the plane of its first two principal axes.
  Target_3 flattened(Target_3 target) const
  {
    target.points = align_target(flattened(target.points), m_surface.points, m_shares);
    return target;
  }

  Point_matrix flattened(const Point_matrix& pose) const
  {
    return internal::flattened(pose, m_shares);
  }

  Target_3 mirrored(Target_3 target) const
  {
    target.points = align_target(target.points, m_surface.points, m_shares, true);
    target.summary.reflected = !target.summary.reflected;
    return target;
  }

  // Whether the pose can be projected onto the plane of its target, which a sheet that is compressed leaves a
  // little.
  bool is_unfolded_in_plane(const Registered_body& registered) const
  {
    return is_unfolded(projected(pose(registered), registered.target.points), m_triangles);
  }

  // `is_in_plane`: whether to project the pose.
  Result result(Registered_body registered, const bool is_in_plane = false) const
  {
    Result result;
    Registration_summary& summary = result.summary = std::move(registered.summary);
    summary.target = registered.target.summary;
    summary.body.kind = m_body.kind;
    if(!summary.is_usable())
      return result;
    result.pose = pose(registered);
    if(is_in_plane)
      result.pose = projected(result.pose, registered.target.points);
    summary.median_edge_strain
      = timed(summary, "diagnosis", [&] { return median_strain(result.pose); });
    summary.flipped_faces = timed(summary, "diagnosis", [&] {
      return flipped_faces(m_view, m_triangles, m_rest, result.pose, registered.points);
    });
    if(m_options.followers.rows() > 0)
      result.pose_of_followers = timed(summary, "global_steps", [&] {
        return Point_matrix(
          Body_deformer_3<Body_view>(m_view, m_triangles).embedding(m_options.followers)
          * registered.points);
      });
    if(is_in_plane && are_followers_in_plane())
      result.pose_of_followers = projected(result.pose_of_followers, registered.target.points);
    if(summary.termination == Registration_summary::ITERATION_LIMIT)
      summary.warnings.push_back("the registration did not converge within the iterations allowed");
    else if(summary.termination == Registration_summary::CANCELED)
      summary.warnings.push_back("the registration was canceled before it converged");
    if(is_collapsed(summary))
      summary.warnings.push_back(
        "the body lost more than half of its volume: a part of the target is inside out or flat");
    result.target = std::move(registered.target.points);
    return result;
  }

private:
  static bool has_best_pose(const Registered_body& registered)
  {
    const Point_matrix& target = registered.target_of_best_pose;
    return target.rows() == registered.target.points.rows() && target == registered.target.points;
  }

  bool are_followers_in_plane() const
  {
    Point_matrix points(m_surface.points.rows() + m_options.followers.rows(), 3);
    points << m_surface.points, m_options.followers;
    return m_options.followers.rows() > 0 && is_planar(points, m_surface.triangles);
  }

  static bool is_canceled(const Registered_body& registered)
  {
    return registered.summary.termination == Registration_summary::CANCELED;
  }

  Registered_body registered(const Registered_body& previous,
                             const Registration_options& options) const
  {
    Registered_body result = previous;
    result.is_stiff = false;
    result.summary.warnings = m_body.warnings;
    result.summary.warnings.insert(result.summary.warnings.end(), result.target.warnings.begin(),
                                   result.target.warnings.end());
    Registration_options without_untangling = options; // which is done once, at the end
    without_untangling.injective = false;
    m_registration->set_options(without_untangling);
    run(result);
    const double limit = volume_ratio_limit(m_options, previous.target);
    if(options.number_of_iterations > 0 && is_complete(result)
       && result.summary.volume_ratio > limit)
      shrink(previous.target, limit, result);
    if(options.is_injective() && is_complete(result))
      m_registration->untangle(result.points, result.summary);
    return result;
  }

  std::unique_ptr<Arap_registration> registration(const Eigen::VectorXd& weights) const
  {
    if(const auto row = surface_vertex_of_loose_component(
         m_view, weights)) // the registrar would name one of the body
      throw std::invalid_argument("all matching weights are 0 in the part around vertex "
                                  + std::to_string(origin_of_body_row(*row)));
    return make_arap_registration(m_view, weights, m_body.length_scale, m_registration_options,
                                  m_body.stiffness, default_rotation_routines(),
                                  solver_of_options(m_options).factor_maker());
  }

  // The vertex of the input of a surface vertex of the body, or one near it.
  std::size_t origin_of_body_row(const std::size_t row) const
  {
    if(row < m_surface.body_origins.size())
      return m_surface.body_origins[row];
    const std::size_t number = m_surface.origins.size();
    std::size_t v = number + (row - m_surface.body_origins.size());
    while(v >= number)
      v = m_surface.added[v - number].vertices[0];
    return m_surface.body_origins[m_body.surface_vertices[v]];
  }

  // Scales the target down, until the volume is near the limit. It grows approximately as the 1.5th
  // power of the scale for most shapes, but as the third power for a ball; the second scale follows
  // from the power that the first one reveals.
  void shrink(const Target_3& target, const double limit, Registered_body& registered) const
  {
    const double ratio = registered.summary.volume_ratio;
    double scale = std::pow(limit / ratio, 0.65);
    registered.target = shrunk(target, scale, m_shares);
    run(registered);
    const double shrunk_ratio = registered.summary.volume_ratio;
    if(!is_complete(registered) || !(shrunk_ratio > 0) || !(shrunk_ratio < ratio)
       || (shrunk_ratio > limit / 1.1 && shrunk_ratio < limit * 1.08))
      return;
    constexpr double most = 3;
    scale
      = std::pow(scale, (std::min)(std::log(limit / ratio) / std::log(shrunk_ratio / ratio), most));
    registered.target = shrunk(target, scale, m_shares);
    run(registered);
  }

  void run(Registered_body& registered) const
  {
    const Registration_summary before = std::move(registered.summary);
    Registration_visitor visitor;
    bool is_stopped = false; // even if it has converged in the same iteration: more would follow
    if(m_options.visitor)
      visitor = [&](Registration_progress progress) { // counts all iterations
        progress.iteration += before.iterations;
        progress.round = registered.round;
        is_stopped = !m_options.visitor(progress);
        return !is_stopped;
      };
    m_registration->set_target(m_rows.means(registered.target.points));
    if(visitor && !has_best_pose(registered))
    {
      registered.best_pose = {m_registration_options.detail_length};
      registered.target_of_best_pose = registered.target.points;
    }
    registered.summary
      = m_registration->register_to_target(registered.points, visitor, &registered.best_pose);
    Registration_summary& summary = registered.summary;
    if(is_stopped)
      summary.termination = Registration_summary::CANCELED;
    Registration_summary times = before;
    for(const Registration_summary::Stage& stage : summary.stages)
      times.add_seconds(stage.first, stage.second);
    summary.stages = std::move(times.stages);
    summary.iterations += before.iterations;
    summary.rounds = before.rounds;
    summary.warnings.insert(summary.warnings.begin(), before.warnings.begin(),
                            before.warnings.end());
  }

  const Surface_component_3& m_surface;
  const Surface_body_3& m_body;
  const Component_options& m_options;
  const Body_view m_view;
  const Body_rows m_rows;
  const Eigen::VectorXd m_shares;
  const std::vector<Index_triangle> m_triangles; // of surface vertices of the body
  const Point_matrix m_rest;
  const Registration_options m_registration_options;
  Options_constraints m_constraints;
  const std::unique_ptr<Arap_registration> m_registration;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_SURFACE_REGISTRATION_H
