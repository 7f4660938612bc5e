// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Assumptions of other tests about the articulated figures: in each pose they are the boundary of a
// solid; the poses differ much in space and little along the surface. Topology, number of vertices
// and the absence of self-intersections are exact. The shapes are symmetric, but their meshes only
// up to the length of an edge. Measured at 10 000 vertices:
//
// | | person | animal |
// |---|---|---|
// | mean rms between the poses, radii of gyration | 0.44 | 0.33 |
// | mean edge strain | 0.043 | 0.052 |
// | its median in each pair, at most | 0.008 | 0.010 |
// | smallest angle of the rest pose, degrees | 31 | 29 |

#include "../../examples/Canonical_pose_3/Articulated_animal.h"
#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/distance.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Polyhedron_3.h>
#include <CGAL/boost/graph/helpers.h>

#include <gtest/gtest.h>

#include "matchers.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <numeric>

namespace test_figure {

using Canonical_pose_examples::Articulated_animal;
using Canonical_pose_examples::Articulated_figure;
using Canonical_pose_examples::Landmark;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Canonical_pose_test::Point_matrix;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

template <class Shape>
const Shape& figure()
{
  static const Shape instance(3500);
  return instance;
}

template <class Shape>
class Articulated_shapes : public testing::Test
{};

using Shapes = testing::Types<Articulated_figure, Articulated_animal>;
TYPED_TEST_SUITE(Articulated_shapes, Shapes);

/// Sorted |log| of the ratios of edge lengths; each edge twice.
template <class Triangles>
std::vector<double> edge_strains(const Triangles& triangles, const Point_matrix& p,
                                 const Point_matrix& q)
{
  std::vector<double> strains;
  for(const auto& t : triangles)
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Eigen::Index a = Eigen::Index(t[i]), b = Eigen::Index(t[(i + 1) % 3]);
      strains.push_back(
        std::abs(std::log((p.row(a) - p.row(b)).norm() / (q.row(a) - q.row(b)).norm())));
    }
  std::sort(strains.begin(), strains.end());
  return strains;
}

TYPED_TEST(Articulated_shapes, AreTheBoundaryOfABodyInEachPose)
{
  auto poses = TypeParam::named_poses();
  poses.push_back({"rest", {}});
  for(const auto& pose : poses)
  {
    const Mesh mesh = figure<TypeParam>().template make_mesh<Mesh>(pose.angles);
    EXPECT_TRUE(CGAL::is_closed(mesh)) << pose.name;
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh)) << pose.name;
    EXPECT_EQ(num_vertices(mesh) + num_faces(mesh), num_edges(mesh) + 2) << pose.name;
    EXPECT_TRUE(CGAL::Polygon_mesh_processing::is_outward_oriented(mesh)) << pose.name;
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh)) << pose.name;
  }
}

TYPED_TEST(Articulated_shapes, AreSymmetricIfTheirAnglesAre)
{
  for(const auto& angles : {typename TypeParam::Joint_angles(), TypeParam::named_poses()[0].angles})
  {
    std::vector<Kernel::Point_3> mirrored;
    for(const auto& p : figure<TypeParam>().points(angles))
      mirrored.push_back(Kernel::Point_3(-p[0], p[1], p[2]));
    const Mesh mesh = figure<TypeParam>().template make_mesh<Mesh>(angles);
    EXPECT_LT(CGAL::Polygon_mesh_processing::max_distance_to_triangle_mesh<CGAL::Sequential_tag>(
                mirrored, mesh),
              0.025); // an edge: it may cut off the tip of a finger
  }
}

TYPED_TEST(Articulated_shapes, DifferInSpaceButHardlyAlongTheSurface)
{
  std::vector<Point_matrix> poses;
  for(const auto& pose : TypeParam::named_poses())
    poses.push_back(Canonical_pose_test::to_matrix(figure<TypeParam>().points(pose.angles)));
  const double rms = Canonical_pose_test::mean_pairwise_rms(poses);
  double mean_strain = 0;
  int pairs = 0;
  for(std::size_t i = 0; i < poses.size(); ++i)
    for(std::size_t j = 0; j < i; ++j, ++pairs)
    {
      const auto strains = edge_strains(figure<TypeParam>().triangles(), poses[i], poses[j]);
      EXPECT_LT(strains[strains.size() / 2], 0.02);
      mean_strain += std::accumulate(strains.begin(), strains.end(), 0.) / double(strains.size());
    }
  std::cout << "mean rms " << rms << " radii of gyration, mean edge strain " << mean_strain / pairs
            << '\n';
  EXPECT_GT(rms, 0.3);
  EXPECT_LT(rms, 0.55);
  EXPECT_LT(mean_strain / pairs, 0.06);
}

TYPED_TEST(Articulated_shapes, HaveWellShapedTrianglesInTheRestPose)
{
  const auto points = figure<TypeParam>().points();
  for(const auto& t : figure<TypeParam>().triangles())
    for(std::size_t i = 0; i < 3; ++i)
    {
      auto corner = [&](std::size_t k) { return Eigen::Vector3d(points[t[(i + k) % 3]].data()); };
      const Eigen::Vector3d u = corner(1) - corner(0), v = corner(2) - corner(0);
      EXPECT_GT(std::atan2(u.cross(v).norm(), u.dot(v)), 0.26); // 15 degrees
    }
}

TYPED_TEST(Articulated_shapes, AreTheSameEachTime)
{
  const TypeParam again(3500);
  EXPECT_EQ(figure<TypeParam>().triangles(), again.triangles());
  for(const auto& pose : TypeParam::named_poses())
    EXPECT_EQ(figure<TypeParam>().points(pose.angles), again.points(pose.angles));
}

TYPED_TEST(Articulated_shapes, HaveTheRequestedNumberOfVerticesAtAnySize)
{
  for(std::size_t n : {std::size_t(2000), std::size_t(20001)})
  {
    const TypeParam sized(n);
    EXPECT_EQ(sized.points().size(), n);
    EXPECT_EQ(sized.triangles().size(), 2 * n - 4); // a sphere
  }
  EXPECT_THROW(TypeParam(10), std::invalid_argument);
}

TEST(Articulated_figure, MakesTheSamePolyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const auto& person = figure<Articulated_figure>();
  const Articulated_figure::Points points = person.points();
  const auto polyhedron = person.make_mesh<Polyhedron>();
  ASSERT_EQ(polyhedron.size_of_facets(), person.triangles().size());
  std::size_t i = 0;
  for(auto v = polyhedron.vertices_begin(); v != polyhedron.vertices_end(); ++v, ++i)
    ASSERT_EQ(v->point(), Kernel::Point_3(points[i][0], points[i][1], points[i][2]));
}

TEST(Articulated_figure, LandmarksAreTheTipsOfTheBody)
{
  const auto& person = figure<Articulated_figure>();
  const Articulated_figure::Points points = person.points();
  auto at = [&](Landmark tip) { return points[person.landmark(tip)]; };
  EXPECT_NEAR(at(Landmark::LEFT_HAND)[0], 0.92, 0.02);
  EXPECT_NEAR(at(Landmark::RIGHT_HAND)[0], -0.92, 0.02);
  EXPECT_GT(at(Landmark::LEFT_FOOT)[2], 0.17);
  EXPECT_LT(at(Landmark::RIGHT_FOOT)[0], -0.1);
  EXPECT_NEAR(at(Landmark::HEAD)[1], 1.79, 0.02);
}

} // namespace test_figure
