// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_ARAP_REGISTRATION_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_ARAP_REGISTRATION_H

#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Unfolding.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/Rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/registration/Registration_constraint_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <limits>
#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The pose of the body with the least energy among all iterates that a visitor has seen. The energy is
// that for a detail length which may differ from those of the registrations.
struct Best_pose
{
  double detail_length;
  double energy = (std::numeric_limits<double>::infinity)();
  Point_matrix points = Point_matrix(0, 3);
};

// The implementation of `Tetrahedral_arap_registrar_3` for any body, rotations and solver.
class Arap_registration
{
public:
  virtual ~Arap_registration() = default;
  virtual const Registration_options& options() const = 0;
  virtual void set_options(const Registration_options& options) = 0;
  virtual void set_number_of_iterations(int number_of_iterations) = 0;
  virtual void set_detail_length(double detail_length) = 0;
  virtual void add_constraint(std::unique_ptr<Registration_constraint_base> constraint) = 0;
  virtual void remove_constraint(const void* constraint) = 0;
  virtual void set_target(const Point_matrix& target) = 0;
  virtual void set_unfolding(const Unfolding& unfolding) = 0;
  virtual void factor() = 0;
  // If the visitor cancels, the result is the best iterate, or, with `best`, which is updated, the
  // last one.
  virtual Registration_summary register_to_target(Point_matrix& body_points,
                                                  const Registration_visitor& visitor,
                                                  Best_pose* best = nullptr)
    = 0;
  // Untangles inverted cells of the body that was registered last, and updates the summary.
  virtual void untangle(Point_matrix& body_points, Registration_summary& summary) = 0;
  virtual Point_matrix surface_points(const Point_matrix& body_points) const = 0;
};

std::unique_ptr<Arap_registration>
make_arap_registration(const Body_view& body, const Eigen::VectorXd& matching_weights,
                       double length_scale, const Registration_options& options,
                       const Eigen::VectorXd& stiffness, const Rotation_routines& rotations,
                       Factor_maker factor_maker);

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_REGISTRATION_ARAP_REGISTRATION_H
