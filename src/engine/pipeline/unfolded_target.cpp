// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Surface_registration.h"
#include "check_method_options.h"
#include "solver_of_options.h"
#include "../surface/root_of_area.h"
#include "../support/Thread_limit.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/support/values_at.h>
#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>

#include <memory>
#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {

Target_3 unfolded_target(const Surface_component_3& surface, const Surface_body_3& body,
                         const Method_options& options)
{
  internal::check_method_options(options);
  if(const internal::Thread_limit limit(options.number_of_threads); limit.is_exceeded())
    return limit.execute([&] { return unfolded_target(surface, body, options); });
  const internal::Body_view view(body.body);
  const Eigen::VectorXd shares = vertex_area_shares(surface.points, surface.triangles);
  Registration_options registration_options;
  registration_options.injective = false;
  registration_options.number_of_iterations = options.registration.number_of_iterations;
  const std::unique_ptr<internal::Arap_registration> registration
    = internal::make_arap_registration(
      view, internal::Body_rows(body.surface_vertices, view.embedding().rows()).sums(shares),
      body.length_scale, registration_options, body.stiffness,
      internal::default_rotation_routines(), internal::solver_of_options(options).factor_maker());
  registration->set_unfolding(options.unfolding);
  Point_matrix pose;
  if(!registration->register_to_target(pose, Registration_visitor()).is_usable())
    throw std::runtime_error("the body cannot be unfolded: numbers are not finite");
  Target_3 target;
  target.points = internal::rows_at(Point_matrix(view.embedding() * pose), body.surface_vertices);
  target.points *= internal::root_of_area(surface.points, surface.triangles)
                   / internal::root_of_area(target.points, surface.triangles);
  target.points = align_target(target.points, surface.points, shares);
  target.summary.kernel = "unfolding";
  target.summary.max_geodesic = body.length_scale;
  return target;
}

} // namespace Canonical_pose_3
} // namespace CGAL
