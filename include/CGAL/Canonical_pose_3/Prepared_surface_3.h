// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_PREPARED_SURFACE_3_H
#define CGAL_CANONICAL_POSE_3_PREPARED_SURFACE_3_H

#include <CGAL/Canonical_pose_3/Diagnosis_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/Vertex_map.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds an input as the steps of `canonical_pose_3()` require it: its components, connected and
without defects, with the options that apply to each.

\sa `prepare_surface()`, `joined_result()`
*/
struct Prepared_surface_3
{
  /// a component with its options, which refer to its own vertices instead of those of the input.
  struct Component
  {
    Surface_component_3 surface; ///< the surface.
    Component_options options;   ///< the options.
  };

  /// what was found in the input.
  Diagnosis_3 diagnosis;

  /// the components to be posed, by decreasing size.
  std::vector<Component> components;

  /// the components that follow others.
  std::vector<Registration_summary::Follower> followers;

  /// \cond SKIP_IN_MANUAL
  Point_matrix points; // of the input
  internal::Vertex_map vertex_map;
  /// \endcond
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_PREPARED_SURFACE_3_H
