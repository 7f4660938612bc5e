// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_HANDED_ROUNDS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_HANDED_ROUNDS_H

#include "Rounds.h"
#include "Surface_registration.h"

#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <cmath>
#include <utility>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Refines a target or its mirror image. After the rounds, the handedness hardly depends on the posture,
// and both images can be compared: those of a human are both right side out, twisted to different
// sides, whereas one of those of a quadruped remains inside out.
class Handed_rounds
{
public:
  Handed_rounds(const Surface_registration& registration, const Rounds& rounds)
    : m_registration(registration), m_rounds(rounds)
  {}

  // Returns the image with the handedness of the canonical pose. `first` should be the one that has
  // it more likely. `before`: for times and iterations.
  Registered_body operator()(const Registration_summary& before, const Target_3& first) const
  {
    return chosen(before, first).registered;
  }

  // Returns the image with the opposite handedness.
  Registered_body opposite(const Registration_summary& before, const Target_3& first) const
  {
    const Choice choice = chosen(before, first);
    if(!Surface_registration::is_complete(choice.registered))
      return choice.registered;
    Registered_body result = m_rounds(choice.registered.summary,
                                      choice.is_first ? m_registration.mirrored(first) : first);
    result.target.summary.is_handedness_certain
      = choice.registered.target.summary.is_handedness_certain;
    return result;
  }

private:
  // If the chirality relative to the square of the volume ratio is smaller, mirror images are inside
  // out. Stress: relative to that of the other image; at most 1.1 for humans, and at least 1.3 for
  // quadrupeds with a twisted trunk.
  static constexpr double LEAST_CHIRALITY = 0.1, LEAST_VOLUME = 0.2, LARGEST_STRESS = 1.2;

  struct Choice
  {
    Registered_body registered;
    bool is_first;
  };

  Choice chosen(const Registration_summary& before, const Target_3& first) const
  {
    Choice choice = {m_rounds(before, first), true};
    if(!Surface_registration::is_complete(choice.registered))
      return choice;
    Target_3& target = choice.registered.target;
    const Target_handedness_3 handedness = m_registration.handedness(target);
    target.summary.is_handedness_certain = handedness.is_certain();
    if(!is_questionable(handedness))
      return choice;
    if(m_registration.is_exhausted(choice.registered, before.iterations))
    {
      target.summary.is_handedness_certain = false;
      return choice;
    }
    Registered_body other
      = m_rounds(choice.registered.summary, m_registration.mirrored(first), true);
    Registration_summary& summary = choice.registered.summary;
    take_costs(summary, other.summary);
    if(!other.summary.is_usable())
      return choice;
    if(!Surface_registration::is_complete(other))
    {
      summary.termination = other.summary.termination;
      return choice;
    }
    const Target_handedness_3 of_other = m_registration.handedness(other.target);
    const bool fits = is_similar(other.summary, summary);
    bool is_certain = !fits || std::abs(of_other.volume_ratio) > LEAST_VOLUME;
    if(fits && contradict(handedness, of_other))
    {
      const bool is_first = handedness.volume_ratio < 0;
      Registered_body turned
        = m_rounds.from_a_stiff_body(summary, is_first ? first : m_registration.mirrored(first));
      take_costs(summary, turned.summary);
      take_costs(other.summary, turned.summary);
      if(turned.summary.termination == Registration_summary::CANCELED)
      {
        summary.termination = turned.summary.termination;
        return choice;
      }
      is_certain = false;
      if(turned.summary.is_usable() && is_similar(turned.summary, summary))
      {
        const Target_handedness_3 of_turned = m_registration.handedness(turned.target);
        if(of_turned.volume_ratio >= 0 && of_turned.chirality > 0)
        {
          turned.target.summary.is_handedness_certain = of_turned.is_certain();
          return {std::move(turned), is_first};
        }
      }
    }
    if(handedness.volume_ratio >= 0 ? of_other.volume_ratio >= 0 && fits
                                    : of_other.volume_ratio >= 0 || of_other.chirality > 0)
      choice = {std::move(other), false};
    choice.registered.target.summary.is_handedness_certain = is_certain;
    return choice;
  }

  // Whether one image is inside out, and the chirality of the other one says, or nearly says, that it is
  // the wrong one. The former may be right side out, too, if its rounds start with a stiff body.
  static bool contradict(const Target_handedness_3& a, const Target_handedness_3& b)
  {
    const Target_handedness_3& outside = a.volume_ratio < 0 ? b : a;
    return (a.volume_ratio < 0) != (b.volume_ratio < 0) && outside.chirality < 0
           && (outside.is_decided_by_chirality() || !outside.is_certain());
  }

  // Whether the stress is at most slightly larger.
  static bool is_similar(const Registration_summary& summary, const Registration_summary& reference)
  {
    return !summary.rounds.empty() && !reference.rounds.empty()
           && summary.rounds.back().stress < LARGEST_STRESS * reference.rounds.back().stress;
  }

  static bool is_questionable(const Target_handedness_3& handedness)
  {
    const double v = handedness.volume_ratio;
    return v < 0 || handedness.chirality < -LEAST_CHIRALITY * v * v;
  }

  const Surface_registration& m_registration;
  const Rounds& m_rounds;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_HANDED_ROUNDS_H
