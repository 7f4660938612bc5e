// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TEST_CONFORMING_BAR_H
#define CGAL_CANONICAL_POSE_3_TEST_CONFORMING_BAR_H

#include "bar_body.h"
#include "registrar.h"

namespace Canonical_pose_test {

/// a bar of 12 times 2 times 2 boxes, 8 long and 1 thick, bent by an angle
inline CGAL::Canonical_pose_3::Conforming_body_3 conforming_bar(const double angle)
{
  return bar_body(12, 2, 2, angle);
}

/// the result of the registrar
struct Bar_result
{
  CGAL::Canonical_pose_3::Registration_summary summary;
  Point_matrix pose;
};

/// pulls a bar to a target, with length scale 8; starts from rest, whose energy bounds all
/// energies. Inverted cells remain: to untangle them may increase the energy.
inline Bar_result register_bar(const CGAL::Canonical_pose_3::Conforming_body_3& body,
                               const Point_matrix& target, const Eigen::VectorXd& weights,
                               CGAL::Canonical_pose_3::Registration_options options
                               = CGAL::Canonical_pose_3::Registration_options(),
                               const Eigen::VectorXd& stiffness = Eigen::VectorXd())
{
  options.injective = false;
  Registrar registrar(body, weights, 8, options, stiffness);
  registrar.set_target(target);
  Bar_result result = {CGAL::Canonical_pose_3::Registration_summary(), body.points()};
  result.summary = registrar.register_to_target(result.pose);
  return result;
}

/// a number for all cells
inline Eigen::VectorXd cells_with(const CGAL::Canonical_pose_3::Conforming_body_3& body,
                                  const double value)
{
  return Eigen::VectorXd::Constant(static_cast<Eigen::Index>(body.cells().size()), value);
}

} // namespace Canonical_pose_test

#endif // CGAL_CANONICAL_POSE_3_TEST_CONFORMING_BAR_H
