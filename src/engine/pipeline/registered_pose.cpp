// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Handed_rounds.h"
#include "Rounds.h"
#include "Surface_registration.h"
#include "check_method_options.h"
#include "fields_of_function.h"
#include "is_posed_in_plane.h"
#include "timed.h"
#include "../support/Thread_limit.h"
#include "../support/precondition.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Whether the target is on a line, as that of a needle: it cannot become straighter.
inline bool is_straight(const Target_3& target)
{
  constexpr double smallest = 1e-9; // that counts as positive, see Landmark_mds_target_builder_3
  const std::vector<double>& values = target.summary.eigenvalues;
  return values.size() > 1 && !(values[1] > smallest * values[0]);
}

inline int number_of_rounds(const Method_options& options, const Target_3& target)
{
  constexpr int rounds = 3;
  const bool is_uncentered = options.mds_kernel
                               ? !options.mds_kernel->is_centered()
                               : options.kernel == Options::Kernel::UNCENTERED_GAUSSIAN;
  return options.number_of_rounds.value_or(
    target.is_given || options.paper_weights || is_uncentered
        || options.target_mode == Options::Target_mode::UNFOLDING || is_straight(target)
      ? 0
      : rounds);
}

// By how much distances are extrapolated: the further, the faster the rounds converge.
inline double extrapolation_factor(const double contraction)
{
  constexpr double largest = .6, full = .6, none = .75;
  return largest * std::clamp((none - contraction) / (none - full), 0., 1.);
}

// The target of the final registration, and the pose where it starts. `before`: for times and iterations.
inline Registered_body refined_in_rounds(const Surface_registration& registration,
                                         const Surface_component_3& surface,
                                         const Coarse_surface_3& coarse,
                                         const Landmark_fields_3& fields, const Target_3& target,
                                         const Component_options& options,
                                         const Registration_summary& before, const bool is_in_plane)
{
  const auto fields_on = [&](const Surface_component_3& posed) {
    return options.target_fields_function
             ? fields_of_function(options.target_fields_function, posed, options, fields.landmarks)
             : landmark_fields(posed, fields.landmarks, options);
  };
  const auto target_of = [&](const Landmark_fields_3& measured, const Point_matrix& pose) {
    return refined_target(surface, coarse, measured,
                          is_in_plane ? registration.flattened(pose) : pose, options);
  };
  const auto refined = [&](const Point_matrix& pose, Registration_summary& times) {
    Rounds::Refined_target result;
    result.fields = timed(times, "geodesics", [&] { return fields_on(coarse.posed(pose)); });
    result.target = timed(times, "target", [&] { return target_of(result.fields, pose); });
    return result;
  };
  const auto extrapolated = [&](Registered_body& measured, const double factor) {
    const bool is_same_kind = !options.target_fields_function && !options.given.landmark_fields;
    const Landmark_fields_3 fields_of_input = timed(measured.summary, "geodesics", [&] {
      return is_same_kind ? fields : fields_on(coarse.surface);
    });
    return timed(measured.summary, "target", [&] {
      const Point_matrix pose = registration.surface_pose(registration.pose(measured));
      return target_of(extrapolated_fields(coarse, fields_of_input, measured.fields, pose, factor),
                       pose)
        .points;
    });
  };
  const int number = number_of_rounds(options, target);
  const Rounds rounds(registration, refined, number);
  const Handed_rounds handed_rounds(registration, rounds);
  Registered_body result = number == 0 || target.is_given || is_in_plane ? rounds(before, target)
                           : options.takes_mirror_image
                             ? handed_rounds.opposite(before, registration.mirrored(target))
                             : handed_rounds(before, target);
  if(result.fields.distances.cols() == 0 || !Surface_registration::is_complete(result))
    return result;
  if(const double factor = extrapolation_factor(result.contraction); factor > 0)
    result.target.points = extrapolated(result, factor);
  if(!is_in_plane && options.symmetry == Options::Symmetry::AUTOMATIC)
  {
    Target_3& last = result.target;
    last.points = timed(result.summary, "target", [&] {
      const auto symmetry = intrinsic_symmetry(coarse, result.fields, last.points);
      if(!symmetry)
        return last.points;
      last.summary.symmetry_distortion = symmetry->distortion;
      return symmetric_target(coarse, *symmetry, last.points);
    });
  }
  return result;
}

} // namespace internal

Result registered_pose(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                       const Landmark_fields_3& fields, const Target_3& target,
                       const Surface_body_3& body, const Component_options& options)
{
  internal::check_method_options(options);
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute(
      [&] { return registered_pose(surface, coarse, fields, target, body, options); });
  CANONICAL_POSE_3_PRECONDITION(target.points.rows() == surface.points.rows());
  CANONICAL_POSE_3_PRECONDITION(coarse.number_of_surface_vertices()
                                == static_cast<std::size_t>(surface.points.rows()));
  CANONICAL_POSE_3_PRECONDITION(fields.distances.rows() == coarse.surface.points.rows());
  const internal::Surface_registration registration(surface, body, options);
  const auto registered
    = [&](const Target_3& first, const Registration_summary& before, const bool is_in_plane) {
        return registration(internal::refined_in_rounds(registration, surface, coarse, fields,
                                                        first, options, before, is_in_plane));
      };
  Registration_summary before;
  if(!target.is_given && internal::is_posed_in_plane(surface, coarse, fields, options))
  {
    const internal::Registered_body planar
      = registered(registration.flattened(target), before, true);
    const bool is_complete = internal::Surface_registration::is_complete(planar);
    if(!is_complete || registration.is_unfolded_in_plane(planar))
      return registration.result(planar, is_complete);
    before = planar.summary;
  }
  return registration.result(registered(target, before, false));
}

} // namespace Canonical_pose_3
} // namespace CGAL
