// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/Canonical_pose_3/internal/target/chirality.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <Eigen/Dense>

#include <cmath>
#include <random>

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Triangle_soup;
using CP::Point_matrix;

namespace {

double handedness(const Point_matrix& target, const Point_matrix& points, const Triangle_soup& soup)
{
  return CP::target_handedness(target, points, soup.triangles,
                               Canonical_pose_test::uniform_weights(points));
}

Point_matrix mirrored(const Point_matrix& points)
{
  return points * Eigen::Vector3d(1, 1, -1).asDiagonal();
}

Eigen::Matrix3d rotation(const double angle)
{
  return Eigen::AngleAxisd(angle, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
}

// A sheet of 8 x 6, bent to z = f(x).
template <class Function>
Triangle_soup sheet(const Function& f)
{
  Triangle_soup result = Canonical_pose_test::plane_grid_soup(16, 12, 8, 6);
  for(auto& p : result.points)
    p = {{p[0] - 4, p[1] - 3, f(p[0] - 4)}};
  return result;
}

} // namespace

// A flat sheet has no inside, regardless of rounding: only the third moment counts, which does not
// depend on the input. The target is a twisted sheet, so its moment is not 0.
TEST(Target_handedness, of_a_flat_sheet_is_that_of_its_target)
{
  const Triangle_soup soup = sheet([](double) { return 0.; });
  const Point_matrix flat = Canonical_pose_test::to_matrix(soup.points);
  Point_matrix twisted = flat;
  twisted.col(2) = (flat.col(0).array() * flat.col(1).array() / 24 + 1).square();
  const double value = CP::internal::chirality(twisted, Canonical_pose_test::uniform_weights(flat));
  EXPECT_GT(std::abs(value), 0.1);
  std::mt19937 random(1);
  for(const double noise : {0., 1e-15, 1e-8}) // the last one corresponds to single precision
    for(const double angle : {0., 0.3, 1.7, 2.5})
      for(const double offset : {0., 1e3, 1e12})
      {
        Point_matrix points = flat;
        for(Eigen::Index i = 0; i < points.rows(); ++i)
          points(i, 2) += 8 * noise * std::uniform_real_distribution<double>(-1, 1)(random);
        points = (points * rotation(angle)).rowwise() + offset * Eigen::RowVector3d(1, -1, 1);
        EXPECT_NEAR(handedness(twisted, points, soup), value, 1e-3 * std::abs(value))
          << noise << ' ' << angle << ' ' << offset;
        EXPECT_NEAR(handedness(mirrored(twisted), points, soup), -value, 1e-3 * std::abs(value));
      }
}

// Among the open sheets, half a pipe encloses a volume with the cone over it: relative to itself it
// is 1, and -1 for its mirror image; its third moment is 0 by symmetry. The volume of the sheet of
// a cubic parabola is 0, since the point reflection that maps it to itself changes the sign.
TEST(Target_handedness, of_open_curved_sheets)
{
  const Triangle_soup pipe = sheet([](const double x) { return std::sqrt(17 - x * x); });
  const Triangle_soup wave = sheet([](const double x) { return x * x * x / 32; });
  for(const double angle : {0., 0.3, 1.7, 2.5})
  {
    Point_matrix points = Canonical_pose_test::to_matrix(pipe.points) * rotation(angle);
    EXPECT_NEAR(handedness(points, points, pipe), 1., 1e-9);
    EXPECT_NEAR(handedness(mirrored(points), points, pipe), -1., 1e-9);
    const Point_matrix target = Canonical_pose_test::to_matrix(pipe.points);
    points = Canonical_pose_test::to_matrix(wave.points) * rotation(angle);
    EXPECT_NEAR(handedness(target, points, wave), 0., 1e-9);
  }
}

// The inside of a closed plate counts, even if it is thin: that of a sheet of paper, and of a
// hundredth of it. For a box relative to itself, the volume part is 1 and the other 0, in any unit,
// even if squares and cubes of lengths vanish or overflow.
TEST(Target_handedness, of_a_thin_plate_in_any_unit)
{
  const double thickness = 0.1; // mm
  for(const double factor : {1., 0.01})
  {
    const Triangle_soup plate = Canonical_pose_test::boundary(
      Canonical_pose_test::tetrahedral_box(6, 8, 1, {{210., 297., factor * thickness}}));
    for(const double unit : {1., 1e-3, std::ldexp(1., 900), std::ldexp(1., -900)})
      for(const double angle : {0., 0.3, 1.7})
      {
        const Point_matrix points
          = unit * (Canonical_pose_test::to_matrix(plate.points) * rotation(angle));
        EXPECT_NEAR(handedness(points, points, plate), 1., 1e-6);
        EXPECT_NEAR(handedness(-points, points, plate), -1., 1e-6);
        EXPECT_NEAR(handedness(2 * points, points, plate), 8., 1e-5);
      }
  }
}
