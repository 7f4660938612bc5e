// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Targets whose volume ratio and chirality are known: by symmetry, by a formula, or from the same
// function of the target alone. A reflection negates both numbers up to rounding.

#include "engine/target/chirality.h"

#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <Eigen/Dense>

#include <cmath>
#include <random>

namespace test_target_handedness {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::Triangle_soup;
using CP::Point_matrix;

CP::Target_handedness_3 handedness(const Point_matrix& target, const Point_matrix& points,
                                   const Triangle_soup& soup)
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

// The rule, on numbers of which it is known whether |chirality| is above 0.45 volume_ratio^2, and by
// at least a factor of 1.2. If both change their sign, only the choice changes.
TEST(Target_handedness, rule)
{
  struct Case
  {
    double volume_ratio, chirality;
    bool is_decided_by_chirality, is_mirror_image, is_certain;
  };
  const Case cases[] = {{1, 0, false, false, true},      {1, 0.4, false, false, true},
                        {1, -0.3, false, false, true},   {1, -0.4, false, false, false},
                        {1, 0.5, true, false, true},     {1, -0.5, true, true, false},
                        {1, -0.6, true, true, true},     {-1, 0.6, true, false, true},
                        {2, -1.4, false, false, true},   {2, -1.7, false, false, false},
                        {2, -2.3, true, true, true},     {0.2, 0.01, false, false, false},
                        {0.1, -0.01, true, true, false}, {0.1, -0.03, true, true, true},
                        {0, 0.03, true, false, true},    {0, 0, false, false, false}};
  for(const Case& c : cases)
  {
    const CP::Target_handedness_3 given{c.volume_ratio, c.chirality},
      reflected{-c.volume_ratio, -c.chirality};
    for(const CP::Target_handedness_3& h : {given, reflected})
    {
      EXPECT_EQ(h.is_decided_by_chirality(), c.is_decided_by_chirality) << c.chirality;
      EXPECT_EQ(h.is_certain(), c.is_certain) << c.volume_ratio << ' ' << c.chirality;
    }
    EXPECT_EQ(given.is_mirror_image(), c.is_mirror_image) << c.volume_ratio << ' ' << c.chirality;
    const bool is_undecided = c.volume_ratio == 0 && c.chirality == 0;
    EXPECT_EQ(reflected.is_mirror_image(), !c.is_mirror_image && !is_undecided);
  }
}

// Four corners of a box in symmetric position about its axes: the variances are the squares of
// half its lengths, and the third moment is the product of these, so the chirality is 1. It does
// not depend on the size of the target, unlike the volume ratio, which decides if the target is
// twice as large. If the input is the mirror image, the two numbers contradict each other.
TEST(Target_handedness, of_a_chiral_tetrahedron)
{
  const Triangle_soup soup{{{3, 2, 1}, {3, -2, -1}, {-3, 2, -1}, {-3, -2, 1}},
                           {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  const Point_matrix points = Canonical_pose_test::to_matrix(soup.points);
  for(const double angle : {0., 0.3, 1.7, 2.5})
    for(const double scale : {1., 2.})
    {
      const Point_matrix target
        = (scale * points * rotation(angle)).rowwise() + Eigen::RowVector3d(5, -6, 7);
      const double volume_ratio = scale * scale * scale;
      const bool is_decided_by_chirality = scale == 1;
      const CP::Target_handedness_3 same = handedness(target, points, soup),
                                    reflected = handedness(mirrored(target), points, soup),
                                    contrary = handedness(target, mirrored(points), soup);
      EXPECT_NEAR(same.volume_ratio, volume_ratio, 1e-12);
      EXPECT_NEAR(same.chirality, 1, 1e-12);
      EXPECT_NEAR(reflected.volume_ratio, -volume_ratio, 1e-12);
      EXPECT_NEAR(reflected.chirality, -1, 1e-12);
      EXPECT_NEAR(contrary.volume_ratio, -volume_ratio, 1e-12);
      EXPECT_NEAR(contrary.chirality, 1, 1e-12);
      for(const CP::Target_handedness_3& h : {same, reflected, contrary})
      {
        EXPECT_EQ(h.is_decided_by_chirality(), is_decided_by_chirality);
        EXPECT_TRUE(h.is_certain());
      }
      EXPECT_FALSE(same.is_mirror_image());
      EXPECT_TRUE(reflected.is_mirror_image());
      EXPECT_EQ(contrary.is_mirror_image(), !is_decided_by_chirality);
    }
}

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
        const CP::Target_handedness_3 same = handedness(twisted, points, soup),
                                      reflected = handedness(mirrored(twisted), points, soup);
        for(const CP::Target_handedness_3& h : {same, reflected})
        {
          EXPECT_EQ(h.volume_ratio, 0) << noise << ' ' << angle << ' ' << offset;
          EXPECT_TRUE(h.is_decided_by_chirality());
          EXPECT_TRUE(h.is_certain());
        }
        EXPECT_NEAR(same.chirality, value, 1e-9);
        EXPECT_NEAR(reflected.chirality, -value, 1e-9);
        EXPECT_EQ(same.is_mirror_image(), value < 0);
        EXPECT_EQ(reflected.is_mirror_image(), value > 0);
      }
}

// Among the open sheets, half a pipe encloses a volume with the cone over it: relative to itself it
// is 1, and -1 for its mirror image; its third moment is 0 by symmetry. The volume of the sheet of
// a cubic parabola is 0, since the point reflection that maps it to itself changes the sign: for
// this input, nothing is certain.
TEST(Target_handedness, of_open_curved_sheets)
{
  const Triangle_soup pipe = sheet([](const double x) { return std::sqrt(17 - x * x); });
  const Triangle_soup wave = sheet([](const double x) { return x * x * x / 32; });
  for(const double angle : {0., 0.3, 1.7, 2.5})
  {
    Point_matrix points = Canonical_pose_test::to_matrix(pipe.points) * rotation(angle);
    for(const bool is_mirrored : {false, true})
    {
      const CP::Target_handedness_3 h
        = handedness(is_mirrored ? mirrored(points) : points, points, pipe);
      EXPECT_NEAR(h.volume_ratio, is_mirrored ? -1 : 1, 1e-9);
      EXPECT_NEAR(h.chirality, 0, 1e-9);
      EXPECT_FALSE(h.is_decided_by_chirality());
      EXPECT_TRUE(h.is_certain());
      EXPECT_EQ(h.is_mirror_image(), is_mirrored);
    }
    const Point_matrix target = Canonical_pose_test::to_matrix(pipe.points);
    points = Canonical_pose_test::to_matrix(wave.points) * rotation(angle);
    const CP::Target_handedness_3 h = handedness(target, points, wave);
    EXPECT_NEAR(h.volume_ratio, 0, 1e-9);
    EXPECT_NEAR(h.chirality, 0, 1e-9);
    EXPECT_FALSE(h.is_certain());
  }
}

// The inside of a closed plate counts, even if it is thin: that of a sheet of paper, and of a
// hundredth of it. For a box relative to itself, the volume ratio is 1 and the chirality 0, in any
// unit, even if squares and cubes of lengths vanish or overflow.
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
        for(const double scale : {1., -1., 2.})
        {
          const CP::Target_handedness_3 h = handedness(scale * points, points, plate);
          const double volume_ratio = scale * scale * scale;
          EXPECT_NEAR(h.volume_ratio, volume_ratio, 1e-6 * std::abs(volume_ratio));
          EXPECT_NEAR(h.chirality, 0, 1e-6);
          EXPECT_FALSE(h.is_decided_by_chirality());
          EXPECT_TRUE(h.is_certain());
          EXPECT_EQ(h.is_mirror_image(), scale < 0);
        }
      }
  }
}

} // namespace test_target_handedness
