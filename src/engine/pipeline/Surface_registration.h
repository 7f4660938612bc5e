// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_SURFACE_REGISTRATION_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_SURFACE_REGISTRATION_H

#include "Options_constraints.h"
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
                                    const Component_options& options)
{
  const Eigen::VectorXd weights
    = rows.sums(options.paper_weights ? Eigen::VectorXd::Ones(shares.size()).eval() : shares);
  if(options.matching_weights.size() == 0)
    return weights;
  return weights.cwiseProduct(options.matching_weights);
}

// The options of the registrar for one component.
inline Registration_options registration_options(const Method_options& options,
                                                 const Surface_component_3& surface,
                                                 const Body_view& body, const double length_scale)
{
  using R = Registration_options;
  R result = options.registration;
  if(options.paper_weights)
  {
    const double alpha = options.paper_weights->alpha;
    result.set_paper_weights(alpha, options.paper_weights->beta,
                             static_cast<std::size_t>(surface.points.rows()), body.volume(),
                             length_scale);
    require_option(result.detail_length >= R::SMALLEST_DETAIL_LENGTH
                     && result.detail_length <= R::LARGEST_DETAIL_LENGTH,
                   "paper_weights.alpha", alpha,
                   "such that the detail length, which is " + shortest_number(result.detail_length)
                     + ", is from " + shortest_number(R::SMALLEST_DETAIL_LENGTH) + " to "
                     + shortest_number(R::LARGEST_DETAIL_LENGTH));
    result.fairing_passes = (std::max)(result.fairing_passes, 1);
  }
  return result;
}

inline double volume_ratio_limit(const Method_options& options, const Target_3& target)
{
  constexpr double limit = 1.15;
  return options.volume_ratio_limit.value_or(
    target.is_given || options.paper_weights ? std::numeric_limits<double>::infinity() : limit);
}

inline Target_3 shrunk(Target_3 target, const double scale, const Eigen::VectorXd& shares)
{
  target.summary.scale = scale;
  const Eigen::RowVector3d centroid = shares.transpose() * target.points;
  target.points = Point_matrix(
    (target.summary.scale * (target.points.rowwise() - centroid)).rowwise() + centroid);
  return target;
}

// Times and iterations of one summary include those of another one that was computed before it.
inline void take_costs(Registration_summary& summary, const Registration_summary& latest)
{
  summary.stages = latest.stages;
  summary.iterations = latest.iterations;
}

// Whether the body lost so much volume that a part of it must be squeezed flat or turned inside out.
inline bool is_collapsed(const Registration_summary& summary) { return summary.volume_ratio < 0.5; }

// A pose of the body, and how it was reached.
struct Registered_body
{
  Registration_summary summary; // times and iterations are those of all registrations so far
  Point_matrix points;
  Target_3 target;
  bool is_stiff = false; // since it collapsed
  // If there is a visitor: that of least energy for this target, with the detail length of the call.
  Best_pose best_pose = {1};
  Point_matrix target_of_best_pose = Point_matrix(0, 3);
  // After all rounds: the distances of the target, and by how much it changed in the last round,
  // relative to the one before.
  Landmark_fields_3 fields;
  double contraction = (std::numeric_limits<double>::infinity)();
};

// The options of the registrar for poses on which distances are measured: the shape of details and
// inverted cells do not matter, but limbs should be straight. `factor`: of the detail length.
inline Registration_options measurement_options(Registration_options options, const double factor)
{
  using R = Registration_options;
  options.detail_length = std::clamp(factor * options.detail_length, R::SMALLEST_DETAIL_LENGTH,
                                     R::LARGEST_DETAIL_LENGTH);
  options.injective = false;
  options.energy_tolerance = (std::max)(options.energy_tolerance, 1e-3);
  options.move_tolerance = (std::max)(options.move_tolerance, 5e-3);
  return options;
}

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
