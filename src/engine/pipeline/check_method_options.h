// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_CHECK_METHOD_OPTIONS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_CHECK_METHOD_OPTIONS_H

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Throws `std::invalid_argument` that names a member which is out of range. Any value of the members
// that are not mentioned is valid.
inline void check_method_options(const Method_options& options)
{
  using O = Method_options;
  require_enumerator("geodesics", options.geodesics, O::Geodesics::WAVEFRONT);
  require_option(options.number_of_landmarks > 0, "number_of_landmarks",
                 options.number_of_landmarks, ">= 1");
  require_enumerator("kernel", options.kernel, O::Kernel::UNCENTERED_GAUSSIAN);
  require_enumerator("target_mode", options.target_mode, O::Target_mode::UNFOLDING);
  options.unfolding.check();
  if(options.number_of_rounds)
    require_option(*options.number_of_rounds >= 0, "number_of_rounds", *options.number_of_rounds,
                   ">= 0");
  require_enumerator("body", options.body, O::Body::MESH_3);
  require_lattice_spacing(options.lattice_spacing);
  require_enumerator("components", options.components, O::Components::EACH);
  require_enumerator("contacts", options.contacts, O::Contacts::CUT);
  require_enumerator("symmetry", options.symmetry, O::Symmetry::NONE);
  require_enumerator("stance", options.stance, O::Stance::STAND);
  require_enumerator("frame", options.frame, O::Frame::BODY);
  options.registration.check();
  if(options.paper_weights)
  {
    require_positive("paper_weights.alpha", options.paper_weights->alpha);
    require_in_range("paper_weights.beta", options.paper_weights->beta, 0,
                     Registration_options::LARGEST_WEIGHT);
  }
  if(options.volume_ratio_limit)
    require_option(*options.volume_ratio_limit > 0, "volume_ratio_limit",
                   *options.volume_ratio_limit, "> 0");
  require_enumerator("solver", options.solver, O::Solver::CHOLMOD);
  require_option(options.number_of_threads >= 0, "number_of_threads", options.number_of_threads,
                 ">= 0");
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_CHECK_METHOD_OPTIONS_H
