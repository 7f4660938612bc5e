// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>

#include <CGAL/Default.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"

namespace CP = CGAL::Canonical_pose_3;
using CP::Point_matrix;
using CP::Registration_summary;

namespace {

// Refuses each matrix but the one of the registration, so that no patch can be untangled.
class Refusing_factor_traits_d : public CP::Default_factor_traits_d
{
public:
  static Eigen::Index rows_of_the_registration;

  bool factor(const Matrix& matrix, NT& denominator)
  {
    return matrix.eigen_object().rows() == rows_of_the_registration
           && CP::Default_factor_traits_d::factor(matrix, denominator);
  }
};

Eigen::Index Refusing_factor_traits_d::rows_of_the_registration = 0;

// Towards the mirror image of the body.
Registration_summary run(const CP::Conforming_body_3& body, Point_matrix& pose)
{
  Refusing_factor_traits_d::rows_of_the_registration = body.points().rows();
  CP::Registration_options options;
  options.detail_length = 0.02; // cells are inverted without
  options.injective = true;
  CP::Tetrahedral_arap_registrar_3<CP::Conforming_body_3, CGAL::Default, Refusing_factor_traits_d>
    registrar(body, Canonical_pose_test::uniform_weights(body.points()), 8., options);
  Point_matrix target = body.points();
  target.col(1) *= -1;
  registrar.set_target(target);
  return registrar.register_to_target(pose);
}

} // namespace

// Where no patch can be untangled, the pose is that of the body at rest: lengths divided by 8 and
// multiplied by it are exact.
TEST(Injective_last_resort, rest_pose)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(8, 4, 4);
  Point_matrix pose;
  const Registration_summary summary = run(body, pose);
  EXPECT_EQ(pose, body.points());
  EXPECT_EQ(summary.inverted, 0u);
  EXPECT_TRUE(summary.warnings.empty());
}
