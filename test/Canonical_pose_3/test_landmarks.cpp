// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/align_target.h>
#include <CGAL/Canonical_pose_3/farthest_point_landmarks.h>
#include <CGAL/Canonical_pose_3/front_landmarks.h>
#include <CGAL/Canonical_pose_3/make_triangle_mesh.h>
#include <CGAL/Canonical_pose_3/target_handedness.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/copy_face_graph.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

namespace test_landmarks {

namespace CP = CGAL::Canonical_pose_3;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// A model of GeodesicDistances_3 with exact distances: those of points in space.
struct Straight_distances
{
  using Triangle_mesh = Mesh;
  using vertex_descriptor = Mesh::Vertex_index;

  const Mesh& triangle_mesh() const { return mesh; }
  std::size_t index(const vertex_descriptor v) const { return v; }
  Eigen::VectorXd distances(const vertex_descriptor v) const
  {
    ++number_of_fields;
    const CP::Point_matrix points = CP::point_matrix(mesh);
    return (points.rowwise() - points.row(static_cast<Eigen::Index>(index(v)))).rowwise().norm();
  }
  Eigen::MatrixXd distances(const std::vector<vertex_descriptor>& sources) const
  {
    ++number_of_batches;
    Eigen::MatrixXd result(static_cast<Eigen::Index>(mesh.number_of_vertices()),
                           static_cast<Eigen::Index>(sources.size()));
    for(std::size_t k = 0; k < sources.size(); ++k)
      result.col(static_cast<Eigen::Index>(k)) = distances(sources[k]);
    return result;
  }

  const Mesh& mesh;
  mutable int number_of_fields = 0, number_of_batches = 0;
};

// Greedy: each landmark is as far from the previous ones as any vertex, and the returned radius is
// the distance of the farthest remaining vertex. Both are checked against the definition.
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

// Distances alone determine the same landmarks and the same covering radius; points that are not on
// the surface do not count.
TEST(Landmark_fields, of_distances)
{
  const Mesh mesh = Canonical_pose_test::icosphere<Mesh>(2, 1.);
  const CP::Landmark_fields_3 expected
    = CP::farthest_point_landmarks(Straight_distances{mesh}, 9, *vertices(mesh).begin());
  const CP::Landmark_fields_3 found = CP::landmark_fields(expected.distances);
  EXPECT_EQ(found.landmarks, expected.landmarks);
  EXPECT_EQ(found.distances, expected.distances);
  EXPECT_EQ(found.covering_radius, expected.covering_radius);

  Eigen::MatrixXd distances = expected.distances;
  distances.row(7).setConstant(std::numeric_limits<double>::infinity());
  EXPECT_LE(CP::landmark_fields(distances).covering_radius, expected.covering_radius);
  distances(3, 2) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW_WITH(CP::landmark_fields(distances), std::invalid_argument, "row 3 and column 2");
  distances(3, 2) = -1;
  EXPECT_THROW_WITH(CP::landmark_fields(distances), std::invalid_argument, "row 3 and column 2");
  distances.col(2).setOnes();
  EXPECT_THROW_WITH(CP::landmark_fields(distances), std::invalid_argument, "column 2");
  EXPECT_THROW_WITH(CP::landmark_fields(Eigen::MatrixXd(4, 0)), std::invalid_argument, "no column");
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

// On a sphere, distances along the surface increase with those through space, so the fronts should
// find landmarks like those of farthest point sampling; the distances of the fronts have errors of
// a few percent of an edge. The distance fields and the radius are those of the model, queried
// once.
TEST(Front_landmarks, cover_as_farthest_points_do)
{
  const Mesh mesh = Canonical_pose_test::icosphere<Mesh>(4, 1.);
  const Straight_distances geodesics{mesh};
  std::vector<Mesh::Vertex_index> landmarks;
  for(const std::size_t l : {1u, 25u, 80u})
  {
    landmarks.clear();
    const int batches = geodesics.number_of_batches;
    const auto fields
      = CP::front_landmarks(geodesics, l, Mesh::Vertex_index(3), std::back_inserter(landmarks));
    EXPECT_EQ(geodesics.number_of_batches, batches + 1);
    ASSERT_EQ(fields.landmarks.size(), l);
    EXPECT_EQ(landmarks.front(), Mesh::Vertex_index(3));
    EXPECT_EQ(fields.distances, geodesics.distances(landmarks));
    EXPECT_EQ(fields.covering_radius, fields.distances.rowwise().minCoeff().maxCoeff());
    EXPECT_LE(
      fields.covering_radius,
      1.1 * CP::farthest_point_landmarks(geodesics, l, Mesh::Vertex_index(3)).covering_radius);
  }
}

// Each landmark is as far from the previous ones as any vertex, in the distances of the fronts; on
// a long strip these are exact, since the straight line to each vertex stays inside and crosses the
// edges of triangles in order. Halving is then the only choice.
TEST(Front_landmarks, halve_a_strip)
{
  const Mesh mesh = Canonical_pose_test::strip<Mesh>(64, 1);
  const auto fields = CP::front_landmarks(Straight_distances{mesh}, 5, Mesh::Vertex_index(0));
  const auto x
    = [&](std::size_t i) { return mesh.point(Mesh::Vertex_index(Mesh::size_type(i))).x(); };
  ASSERT_EQ(fields.landmarks.size(), 5u);
  EXPECT_EQ(x(fields.landmarks[0]), 0.);
  EXPECT_EQ(x(fields.landmarks[1]), 64.);
  EXPECT_NEAR(x(fields.landmarks[2]), 32., 1.);
  EXPECT_NEAR(std::abs(x(fields.landmarks[3]) - 32.), 16., 1.);
  EXPECT_NEAR(std::abs(x(fields.landmarks[4]) - 32.), 16., 1.);
}

// A model may show points that are not those of the mesh.
TEST(Front_landmarks, run_on_the_points_of_the_distances)
{
  struct Distances_between_points : Straight_distances
  {
    CP::Point_matrix points() const { return others; }
    CP::Point_matrix others;
  };
  const Mesh mesh = Canonical_pose_test::strip<Mesh>(64, 1);
  Distances_between_points geodesics{{mesh}, CP::point_matrix(mesh)};
  geodesics.others.col(0) = geodesics.others.col(0).array().square() / 64;
  const auto fields = CP::front_landmarks(geodesics, 3, Mesh::Vertex_index(0));
  ASSERT_EQ(fields.landmarks.size(), 3u);
  EXPECT_NEAR(geodesics.others(static_cast<Eigen::Index>(fields.landmarks[2]), 0), 32., 1.);
}

TEST(Front_landmarks, more_than_there_are_vertices)
{
  const Mesh mesh = Canonical_pose_test::icosphere<Mesh>(0, 1.);
  const auto fields = CP::front_landmarks(Straight_distances{mesh}, 80, Mesh::Vertex_index(0));
  EXPECT_EQ(std::set<std::size_t>(fields.landmarks.begin(), fields.landmarks.end()).size(), 12u);
  EXPECT_EQ(fields.distances.cols(), 12);
  EXPECT_EQ(fields.covering_radius, 0.);
  EXPECT_THROW(CP::front_landmarks(Straight_distances{mesh}, 0, Mesh::Vertex_index(0)),
               CGAL::Precondition_exception);
}

// Unreached vertices are farthest: each component has a landmark, and so has each isolated vertex.
TEST(Front_landmarks, reach_every_component)
{
  Mesh mesh = Canonical_pose_test::icosphere<Mesh>(2, 1.);
  const auto lonely = mesh.add_vertex(Kernel::Point_3(9, 9, 9));
  CGAL::copy_face_graph(Canonical_pose_test::icosphere<Mesh>(1, 0.01), mesh);
  std::vector<Mesh::Vertex_index> landmarks;
  const auto fields = CP::front_landmarks(CP::Heat_geodesics_3<Mesh>(mesh), 3,
                                          Mesh::Vertex_index(5), std::back_inserter(landmarks));
  EXPECT_EQ(landmarks, (std::vector<Mesh::Vertex_index>{Mesh::Vertex_index(5), lonely,
                                                        Mesh::Vertex_index(lonely.idx() + 1)}));
  EXPECT_TRUE(std::isfinite(fields.covering_radius));
}

// A rigid motion is undone up to rounding, a reflection only if requested; the size never changes.
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

// Additional points in one corner of a square move the mean of the vertices, but not the centroid
// of the surface, which is in the middle; the corner lifted by a tenth is then the farthest.
TEST(Extremal_point, is_farthest_from_the_centroid_of_area)
{
  CP::Point_matrix points(6, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1.1, 0, 1, 1, 0, 1, 1, 0;
  const std::vector<std::array<std::size_t, 3>> triangles = {{0, 1, 2}, {0, 2, 3}};
  EXPECT_EQ(CP::extremal_point(points, triangles), 3u);
  const Mesh mesh = CP::make_triangle_mesh<Mesh>(points, triangles);
  EXPECT_EQ(CP::extremal_vertex(mesh, mesh.points()), Mesh::Vertex_index(3));
}

// Both numbers are pseudoscalars: a reflection only changes the sign, and a rigid motion has no
// effect. For the input itself, the volume ratio is 1; the corner pulled out of the box makes it
// chiral.
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
  const double chirality = handedness(points).chirality;
  EXPECT_GT(std::abs(chirality), 1e-3);
  const auto expect_numbers = [&](const CP::Point_matrix& target, const double sign) {
    EXPECT_NEAR(handedness(target).volume_ratio, sign, 1e-12);
    EXPECT_NEAR(handedness(target).chirality, sign * chirality, 1e-12);
  };
  expect_numbers(points, 1);
  expect_numbers(points * Eigen::Vector3d(1, 1, -1).asDiagonal(), -1);
  expect_numbers(-points, -1);
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2.5, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  expect_numbers((points * rotation).rowwise() + Eigen::RowVector3d(5, -6, 7), 1);
  // flat: inside and outside cannot be distinguished
  const CP::Target_handedness_3 flat = handedness(points * Eigen::Vector3d(1, 1, 0).asDiagonal());
  EXPECT_EQ(flat.volume_ratio, 0);
  EXPECT_EQ(flat.chirality, 0);
}

} // namespace test_landmarks
