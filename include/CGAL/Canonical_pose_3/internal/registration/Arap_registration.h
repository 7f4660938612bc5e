// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_ARAP_REGISTRATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_ARAP_REGISTRATION_H

#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/registration/Registration_constraint_base.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
namespace internal {

class Arap_registration_state;

// What `Tetrahedral_arap_registrar_3` does, for any body, rotations and solver; see there.
class Arap_registration
{
public:
  Arap_registration(const Body_view& body, const Eigen::VectorXd& matching_weights,
                    double length_scale, const Registration_options& options,
                    const Eigen::VectorXd& stiffness, const Rotation_routines& rotations,
                    Factor_maker factor_maker);
  Arap_registration(Arap_registration&&) noexcept;
  Arap_registration& operator=(Arap_registration&&) noexcept;
  ~Arap_registration();

  const Registration_options& options() const;
  void set_number_of_iterations(int number_of_iterations);
  void add_constraint(std::unique_ptr<Registration_constraint_base> constraint);
  void remove_constraint(const void* constraint);
  void set_target(const Point_matrix& target);
  void factor();
  Registration_summary register_to_target(Point_matrix& body_points,
                                          const Registration_visitor& visitor);
  Point_matrix surface_points(const Point_matrix& body_points) const;

private:
  std::unique_ptr<Arap_registration_state> m_state;
};

} // namespace internal
} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#ifndef CGAL_CANONICAL_POSE_3_COMPILED
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration_impl.h>
#endif

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_ARAP_REGISTRATION_H
