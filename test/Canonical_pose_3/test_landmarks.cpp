// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <iterator>
#include <set>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;

// A model of GeodesicDistances_3 whose distances are exact: those of points in space.
struct Straight_distances
{
  typedef Mesh Triangle_mesh;
  typedef Mesh::Vertex_index vertex_descriptor;

  const Mesh& triangle_mesh() const { return mesh; }
  std::size_t index(const vertex_descriptor v) const { return v; }
  Eigen::VectorXd distances(const vertex_descriptor v) const
  {
    ++number_of_fields;
    const CP::Point_matrix points = CP::point_matrix(mesh);
    return (points.rowwise() - points.row(static_cast<Eigen::Index>(index(v)))).rowwise().norm();
  }

  const Mesh& mesh;
  mutable int number_of_fields = 0;
};

} // namespace

// Greedy: each landmark is as far from those before it as any vertex is, and the radius returned is
// the distance of the farthest vertex that is left. Both are checked against the definition.
TEST(Farthest_point_landmarks, are_farthest_and_cover)
{
  const Mesh mesh = Canonical_pose_test::icosphere<Mesh>(3, 1.);
  const Straight_distances geodesics{mesh};
  std::vector<Mesh::Vertex_index> landmarks;
  const auto fields = CP::farthest_point_landmarks(geodesics, 25, Mesh::Vertex_index(3),
                                                   std::back_inserter(landmarks));
  ASSERT_EQ(fields.landmarks.size(), 25u);
  EXPECT_EQ(geodesics.number_of_fields, 25);
  EXPECT_EQ(landmarks.front(), Mesh::Vertex_index(3));
  for(Eigen::Index j = 1; j < 25; ++j)
  {
    const Eigen::VectorXd nearest = fields.distances.leftCols(j).rowwise().minCoeff();
    EXPECT_EQ(nearest[static_cast<Eigen::Index>(fields.landmarks[j])], nearest.maxCoeff());
  }
  EXPECT_EQ(fields.covering_radius, fields.distances.rowwise().minCoeff().maxCoeff());
}

TEST(Farthest_point_landmarks, more_than_there_are_vertices)
{
  const Mesh mesh = Canonical_pose_test::icosphere<Mesh>(0, 1.);
  const auto fields
    = CP::farthest_point_landmarks(Straight_distances{mesh}, 80, Mesh::Vertex_index(0));
  EXPECT_EQ(std::set<std::size_t>(fields.landmarks.begin(), fields.landmarks.end()).size(), 12u);
  EXPECT_EQ(fields.distances.cols(), 12);
  EXPECT_EQ(fields.covering_radius, 0.);
  EXPECT_THROW(CP::farthest_point_landmarks(Straight_distances{mesh}, 0, Mesh::Vertex_index(0)),
               CGAL::Precondition_exception);
}

// A rigid motion is undone exactly but for rounding, a reflection only when it is allowed; the size
// is never changed.
TEST(Align_target, undoes_motions_and_keeps_size)
{
  const CP::Point_matrix points = Canonical_pose_test::to_matrix(
    Canonical_pose_test::tetrahedral_box(3, 2, 4, {{1., 2., 3.}}).points);
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(points.rows(), 1, 2);
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const CP::Point_matrix moved
    = (points * rotation.transpose()).rowwise() + Eigen::RowVector3d(5, -6, 7);
  EXPECT_LT((CP::align_target(moved, points, weights) - points).norm(), 1e-12);
  const CP::Point_matrix mirrored = moved * Eigen::Vector3d(-1, 1, 1).asDiagonal();
  EXPECT_LT((CP::align_target(mirrored, points, weights, true) - points).norm(), 1e-12);
  EXPECT_GT((CP::align_target(mirrored, points, weights) - points).norm(), 1.);
  const CP::Point_matrix enlarged = CP::align_target(3 * mirrored, points, weights);
  EXPECT_NEAR(Canonical_pose_test::radius_of_gyration(enlarged),
              3 * Canonical_pose_test::radius_of_gyration(points), 1e-12);
}

// Extra points in one corner of a square pull the mean of the vertices there, but not the centroid
// of area, which lies in the middle; of the others the corner lifted by a tenth is then the
// farthest.
TEST(Extremal_point, is_farthest_from_the_centroid_of_area)
{
  CP::Point_matrix points(6, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1.1, 0, 1, 1, 0, 1, 1, 0;
  EXPECT_EQ(CP::extremal_point(points, {{0, 1, 2}, {0, 2, 3}}), 3u);
}

// Both parts of the number are pseudo-scalars: a reflection changes the sign and nothing else, a
// rigid motion or a scaling
// of a target that is as large as the input leaves it. Of the input itself the volume part is 1;
// the corner drawn out of
// the box makes it chiral.
TEST(Target_handedness, changes_sign_by_reflection_only)
{
  auto soup
    = Canonical_pose_test::boundary(Canonical_pose_test::tetrahedral_box(3, 4, 5, {{1., 2., 3.}}));
  soup.points[0] = {{-1., -1.5, -2.5}};
  const CP::Point_matrix points = Canonical_pose_test::to_matrix(soup.points);
  const Eigen::VectorXd weights = Canonical_pose_test::uniform_weights(points);
  const auto handedness = [&](const CP::Point_matrix& target) {
    return CP::target_handedness(target, points, soup.triangles, weights);
  };
  const double value = handedness(points);
  EXPECT_GT(std::abs(value - 1), 1e-3);
  EXPECT_NEAR(handedness(points * Eigen::Vector3d(1, 1, -1).asDiagonal()), -value, 1e-12);
  EXPECT_NEAR(handedness(-points), -value, 1e-12);
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  EXPECT_NEAR(handedness((points * rotation).rowwise() + Eigen::RowVector3d(5, -6, 7)), value,
              1e-12);
  // flat: inside out or not cannot be told
  EXPECT_EQ(handedness(points * Eigen::Vector3d(1, 1, 0).asDiagonal()), 0.);
}
