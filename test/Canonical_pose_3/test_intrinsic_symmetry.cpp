// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Stars of segments: the distance between points of different segments is the sum of those to the center. If two segments are as
// long, exchanging them is the only symmetry but for the identity, and changes no distance. Exact, up to rounding.

#include "../../examples/Canonical_pose_3/Articulated_animal.h"
#include "engine/target/intrinsic_symmetry.h"

#include <CGAL/Canonical_pose_3/pose_steps.h>
#include <CGAL/Canonical_pose_3/surface_measures.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Simple_cartesian.h>

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

namespace test_intrinsic_symmetry {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_animal;
using Canonical_pose_test::to_matrix;

struct Star
{
  explicit Star(const std::array<int, 4>& lengths)
  {
    const std::array<Eigen::RowVector3d, 4> directions
      = {Eigen::RowVector3d(.8, .6, 0), Eigen::RowVector3d(-.8, .6, 0),
         Eigen::RowVector3d(0, -1, 0), Eigen::RowVector3d(0, 0, 1)};
    std::vector<std::array<int, 2>> points = {{0, 0}}; // segment, and distance to the center
    for(int segment = 0; segment < 4; ++segment)
      for(int k = 1; k <= lengths[std::size_t(segment)]; ++k)
        points.push_back({segment, k});
    const auto n = Eigen::Index(points.size());
    pose.resize(n, 3);
    fields.distances.resize(n, n);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const auto [segment, k] = points[std::size_t(i)];
      pose.row(i) = k * directions[std::size_t(segment)];
      fields.landmarks.push_back(std::size_t(i));
      for(Eigen::Index j = 0; j < n; ++j)
      {
        const auto [other, l] = points[std::size_t(j)];
        fields.distances(i, j) = segment == other ? std::abs(k - l) : k + l;
      }
    }
    shares = Eigen::VectorXd::Constant(n, 1. / double(n));
  }

  CP::Point_matrix pose;
  CP::Landmark_fields_3 fields;
  Eigen::VectorXd shares;
};

// Half of the root mean square distance of a pose from its image, in units of the radius of gyration.
double asymmetry(CP::Point_matrix pose, const std::vector<std::size_t>& images)
{
  pose.rowwise() -= pose.colwise().mean().eval();
  CP::Point_matrix moved(pose.rows(), 3);
  for(Eigen::Index i = 0; i < pose.rows(); ++i)
    moved.row(i) = pose.row(Eigen::Index(images[std::size_t(i)]));
  moved.rowwise() -= moved.colwise().mean().eval();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(moved.transpose() * pose,
                                              Eigen::ComputeFullU | Eigen::ComputeFullV);
  moved = moved * svd.matrixU() * svd.matrixV().transpose();
  return (pose - moved).norm() / (2 * pose.norm());
}

TEST(Intrinsic_symmetry, exchanges_segments_of_the_same_length)
{
  const int length = 20;
  const Star star({length, length, 12, 6});
  const auto symmetry = CP::internal::symmetry_of_pose(star.fields, star.pose, star.shares);
  ASSERT_TRUE(symmetry);
  EXPECT_LT(symmetry->distortion, 1e-10);
  for(std::size_t i = 0; i < symmetry->images.size(); ++i)
    EXPECT_EQ(symmetry->images[i], i == 0            ? 0
                                   : i <= length     ? i + length
                                   : i <= 2 * length ? i - length
                                                     : i);
}

TEST(Intrinsic_symmetry, none_of_segments_of_four_lengths)
{
  const Star star({20, 13, 8, 4});
  EXPECT_FALSE(CP::internal::symmetry_of_pose(star.fields, star.pose, star.shares));
}

// The reflection that is closest for a map that is its own inverse is its own inverse, too, so the mean is symmetric, exactly,
// and a pose that is symmetric remains.
TEST(Intrinsic_symmetry, mean_pose_is_symmetric)
{
  const Star star({20, 20, 12, 6});
  const auto symmetry = CP::internal::symmetry_of_pose(star.fields, star.pose, star.shares);
  ASSERT_TRUE(symmetry);
  EXPECT_LT(
    (CP::internal::symmetric_pose(star.pose, symmetry->images, star.shares) - star.pose).norm(),
    1e-10 * star.pose.norm());
  CP::Point_matrix bent = star.pose;
  const Eigen::AngleAxisd rotation(.5, Eigen::Vector3d(1, 2, 3).normalized());
  bent.middleRows(1, 20) = (bent.middleRows(1, 20) * rotation.toRotationMatrix()).eval();
  EXPECT_GT(asymmetry(bent, symmetry->images), .05);
  EXPECT_LT(
    asymmetry(CP::internal::symmetric_pose(bent, symmetry->images, star.shares), symmetry->images),
    1e-10);
}

// The target of a ball is symmetric up to its mesh, but a reflection moves vertices by up to half of an edge from the
// nearest ones: the target remains, exactly.
TEST(Intrinsic_symmetry, of_a_target_that_is_symmetric_already)
{
  const auto ball = Canonical_pose_test::icosphere_soup(2, 1);
  const auto prepared = CP::prepare_surface(to_matrix(ball.points), ball.triangles);
  const CP::Surface_component_3& surface = prepared.components.front().surface;
  const CP::Component_options options;
  const auto coarse = CP::coarse_surface(surface, options);
  const auto fields = CP::landmark_fields(coarse, options);
  const auto symmetry = CP::intrinsic_symmetry(coarse, fields, surface.points);
  ASSERT_TRUE(symmetry);
  EXPECT_EQ(CP::symmetric_target(coarse, *symmetry, surface.points), surface.points);
}

// The animal is symmetric at rest, its mesh up to the length of an edge, .05 radii of gyration. In any posture, the target is
// symmetric to the same extent, though the distances that lead to it are not, and it is not without the option.
TEST(Intrinsic_symmetry, targets_of_a_symmetric_animal)
{
  const Articulated_animal animal(3000);
  const auto poses = Articulated_animal::named_poses();
  const CP::Point_matrix rest = to_matrix(animal.points());
  std::vector<std::size_t> images(std::size_t(rest.rows()));
  for(Eigen::Index i = 0; i < rest.rows(); ++i)
  {
    const Eigen::RowVector3d mirrored = rest.row(i).cwiseProduct(Eigen::RowVector3d(-1, 1, 1));
    Eigen::Index nearest = 0;
    (rest.rowwise() - mirrored).rowwise().squaredNorm().minCoeff(&nearest);
    images[std::size_t(i)] = std::size_t(nearest);
  }
  ASSERT_LT(asymmetry(rest, images), .03);
  using Point = CGAL::Simple_cartesian<double>::Point_3;
  double largest_without = 0;
  for(const auto& named : poses)
  {
    const CP::Point_matrix points = to_matrix(animal.points(named.angles));
    std::vector<Point> input, pose;
    for(Eigen::Index i = 0; i < points.rows(); ++i)
      input.emplace_back(points(i, 0), points(i, 1), points(i, 2));
    CP::Options options;
    const CP::Result result = CGAL::canonical_pose_3(input, animal.triangles(), pose, options);
    EXPECT_LT(asymmetry(*result.target, images), .03) << named.name;
    const double distortion = result.summary.target.symmetry_distortion.value();
    EXPECT_GT(distortion, 0);
    EXPECT_LT(distortion, .065);
    options.symmetry = CP::Options::Symmetry::NONE;
    const CP::Result without = CGAL::canonical_pose_3(input, animal.triangles(), pose, options);
    EXPECT_FALSE(without.summary.target.symmetry_distortion);
    largest_without = (std::max)(largest_without, asymmetry(*without.target, images));
  }
  EXPECT_GT(largest_without, .03);
}

} // namespace test_intrinsic_symmetry
