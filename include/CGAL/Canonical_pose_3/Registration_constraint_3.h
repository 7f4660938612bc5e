// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_REGISTRATION_CONSTRAINT_3_H
#define CGAL_CANONICAL_POSE_3_REGISTRATION_CONSTRAINT_3_H

#include <CGAL/Canonical_pose_3/internal/registration/Registration_constraint_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/SparseCore>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds a constraint of any type, which can thus be chosen at run time.

Copies share the constraint.

\cgalModels `RegistrationConstraint_3`

\sa `Constraints_3::function`
*/
class Registration_constraint_3
{
public:
  /// stores a constraint.
  /// \tparam Constraint a model of `RegistrationConstraint_3`, move constructible
  template <class Constraint,
            std::enable_if_t<
              std::conjunction<std::negation<std::is_same<Constraint, Registration_constraint_3>>,
                               internal::Is_registration_constraint<Constraint>>::value,
              int> = 0>
  Registration_constraint_3(Constraint constraint)
  {
    struct Owner
    {
      explicit Owner(Constraint&& c) : constraint(std::move(c)), model(constraint) {}
      Constraint constraint;
      internal::Registration_constraint_model<Constraint> model;
    };
    const auto owner = std::make_shared<Owner>(std::move(constraint));
    m_constraint = std::shared_ptr<internal::Registration_constraint_base>(owner, &owner->model);
  }

  /// returns a number that changes whenever the matrix does.
  std::size_t matrix_revision() const { return m_constraint->matrix_revision(); }

  /// appends the entries of the matrix.
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    m_constraint->add_to_matrix(matrix);
  }

  /// adds the right-hand side at `points`.
  void add_to_right_hand_side(const Point_matrix& points, Point_matrix& right_hand_side)
  {
    m_constraint->add_to_right_hand_side(points, right_hand_side);
  }

  /// returns the energy at `points`.
  double energy(const Point_matrix& points) const { return m_constraint->energy(points); }

private:
  std::shared_ptr<internal::Registration_constraint_base> m_constraint;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_REGISTRATION_CONSTRAINT_3_H
