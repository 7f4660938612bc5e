// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_ROUNDS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_ROUNDS_H

#include "Surface_registration.h"

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/Face_defect.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Real_timer.h>

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Refines targets by distances that are measured on poses.
class Rounds
{
public:
  struct Refined_target
  {
    Target_3 target;
    Landmark_fields_3 fields;
  };

  // Returns the refined target for distances that are measured on a pose of the surface, and adds
  // the times to a summary.
  using Refinement = std::function<Refined_target(const Point_matrix&, Registration_summary&)>;

  // At most `number_of_rounds`.
  Rounds(const Surface_registration& registration, Refinement refined, const int number_of_rounds)
    : m_registration(registration), m_refined(std::move(refined)),
      m_number_of_rounds(number_of_rounds)
  {}

  // Refines `first`; ends when the target is inside out, if that is of no use. Returns the target,
  // and the last pose that was measured. After a collapse, the stress has several minima within
  // reach: a softer body may find a lower one. `before`: for times and iterations.
  Registered_body operator()(const Registration_summary& before, const Target_3& first,
                             const bool ends_inside_out = false) const
  {
    bool has_collapsed = false;
    Registered_body result = refined(before, first, ends_inside_out, STIFF, has_collapsed);
    if(!has_collapsed || !Surface_registration::is_complete(result)
       || m_registration.is_exhausted(result, before.iterations))
      return result;
    Registered_body other = refined(result.summary, first, ends_inside_out, SOFTER, has_collapsed);
    if(Surface_registration::is_complete(other) && has_lower_stress(other.summary, result.summary))
      return other;
    take_costs(result.summary, other.summary);
    if(other.summary.termination == Registration_summary::CANCELED)
      result.summary.termination = Registration_summary::CANCELED;
    return result;
  }

  // Refines `first` in the same way, starting with a stiff body.
  Registered_body from_a_stiff_body(const Registration_summary& before, const Target_3& first) const
  {
    bool has_collapsed = false;
    return refined(before, first, false, STIFF, has_collapsed, true);
  }

private:
  static constexpr double STIFF = 3, SOFTER = 1.5, SMALLEST_CHANGE = 1e-3, LARGEST_GROWTH = 1.1;

  static bool has_lower_stress(const Registration_summary& summary,
                               const Registration_summary& reference)
  {
    return !summary.rounds.empty()
           && (reference.rounds.empty()
               || summary.rounds.back().stress < reference.rounds.back().stress);
  }

  // `stiff`: the factor of the detail length of a body that collapses, or of the first one.
  Registered_body refined(const Registration_summary& before, const Target_3& first,
                          const bool ends_inside_out, const double stiff, bool& has_collapsed,
                          const bool starts_stiff = false) const
  {
    Registered_body current;
    current.summary = before;
    current.target = first;
    current.summary.rounds.clear();
    double last_change = (std::numeric_limits<double>::infinity)();
    for(int round = 0; round < m_number_of_rounds && last_change > SMALLEST_CHANGE; ++round)
    {
      Real_timer timer;
      timer.start();
      current.round = round + 1;
      Registered_body measured = starts_stiff && round == 0
                                   ? m_registration.measured_stiff(current, stiff)
                                   : m_registration.measured(current, stiff);
      const bool is_last = round + 1 == m_number_of_rounds;
      if(is_last && !measured.is_stiff && Surface_registration::is_complete(measured))
        measured = m_registration.relaxed(measured);
      if(!Surface_registration::is_complete(measured))
        return measured;
      has_collapsed = has_collapsed || measured.is_stiff;
      const Point_matrix pose = m_registration.pose(measured);
      Refined_target refined;
      try
      {
        refined = m_refined(m_registration.surface_pose(pose), measured.summary);
      }
      catch(const Face_defect& error) // of our own distances: the pose may have faces without area
      {
        current = std::move(measured);
        current.target.warnings.push_back(
          std::string("distances on the pose could not be computed: ") + error.what());
        break;
      }
      const double change = m_registration.difference(refined.target, current.target);
      current = std::move(measured);
      if(change > LARGEST_GROWTH * last_change) // it drifts
        break;
      current.fields = std::move(refined.fields);
      if(is_last && std::isfinite(last_change) && !current.is_stiff)
        current.contraction = change / last_change;
      // after a collapse, the target moves to another place
      last_change = current.is_stiff ? (std::numeric_limits<double>::infinity)() : change;
      current.summary.rounds.push_back({refined.target.summary.stress, current.summary.energy,
                                        m_registration.median_strain(pose), timer.time()});
      current.target.points = std::move(refined.target.points);
      current.target.summary = first.summary;
      if(m_registration.is_exhausted(current, before.iterations)
         || (ends_inside_out && m_registration.handedness(current.target).volume_ratio < 0))
        break;
    }
    current.round = 0;
    return current;
  }

  const Surface_registration& m_registration;
  const Refinement m_refined;
  const int m_number_of_rounds;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_ROUNDS_H
