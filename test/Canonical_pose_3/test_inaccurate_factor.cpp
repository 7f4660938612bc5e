// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/Default_factor_traits_d.h>

#include <CGAL/Default.h>

#include <gtest/gtest.h>

#include "bar_body.h"
#include "matchers.h"
#include "registrar.h"

namespace test_inaccurate_factor {

namespace CP = CGAL::Canonical_pose_3;
using CP::Point_matrix;

// Its solutions are wrong by up to one percent.
class Inaccurate_factor_traits_d : public CP::Default_factor_traits_d
{
public:
  using CP::Default_factor_traits_d::linear_solver;

  bool linear_solver(const Eigen::Ref<const Eigen::MatrixXd>& right_hand_sides,
                     Eigen::MatrixXd& solutions) const
  {
    const bool is_solved = CP::Default_factor_traits_d::linear_solver(right_hand_sides, solutions);
    for(Eigen::Index i = 0; i < solutions.rows(); ++i)
      solutions.row(i) *= 1 + 0.01 * static_cast<double>(i % 3 - 1);
    return is_solved;
  }
};

template <class Registrar>
Point_matrix pose(const CP::Conforming_body_3& body, const Point_matrix& target)
{
  Registrar registrar(body, Canonical_pose_test::uniform_weights(body.points()), 8.,
                      Canonical_pose_test::to_the_end());
  registrar.set_target(target);
  Point_matrix result;
  EXPECT_TRUE(registrar.register_to_target(result).converged());
  return result;
}

// Each iteration solves for a step, given the current gradient: an inaccurate factor leads to the
// same result as an accurate one. The bound is the difference permitted between two runs that end
// with moves of 1e-10.
TEST(Inaccurate_factor, leads_to_the_same_pose)
{
  const CP::Conforming_body_3 body = Canonical_pose_test::bar_body(20, 3, 3);
  const Point_matrix target = Canonical_pose_test::bar_points(20, 3, 3, 1.);
  using Inaccurate_registrar
    = CP::Tetrahedral_arap_registrar_3<CP::Conforming_body_3, CGAL::Default,
                                       Inaccurate_factor_traits_d>;
  const Point_matrix accurate = pose<Canonical_pose_test::Registrar>(body, target),
                     inaccurate = pose<Inaccurate_registrar>(body, target);
  EXPECT_LT((inaccurate - accurate).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_GT((accurate - target).cwiseAbs().maxCoeff(), 1e-3);
}

} // namespace test_inaccurate_factor
