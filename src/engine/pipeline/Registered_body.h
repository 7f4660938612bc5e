// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_REGISTERED_BODY_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_REGISTERED_BODY_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <limits>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

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
  int round = 0;         // from 1, if distances are measured on it
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

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_REGISTERED_BODY_H
