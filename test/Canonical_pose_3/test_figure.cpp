// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Assumptions of other tests about the articulated figure: in each pose it is the boundary of a
// solid; the poses differ much in space and little along the surface. Measured at 10 000 vertices:
// mean rms between the poses 0.44 radii of gyration, mean edge strain 0.043, its median at most
// 0.008 in each pair, smallest angle of the rest pose 31 degrees.

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
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

namespace {

using Canonical_pose_examples::Articulated_figure;
using Canonical_pose_examples::Landmark;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Canonical_pose_test::Point_matrix;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

const Articulated_figure& figure()
{
  static const Articulated_figure instance(3500);
  return instance;
}

/// Sorted |log| of the ratios of edge lengths; each edge twice.
std::vector<double> edge_strains(const Point_matrix& p, const Point_matrix& q)
{
  std::vector<double> strains;
  for(const auto& t : figure().triangles())
    for(std::size_t i = 0; i < 3; ++i)
    {
      const Eigen::Index a = Eigen::Index(t[i]), b = Eigen::Index(t[(i + 1) % 3]);
      strains.push_back(
        std::abs(std::log((p.row(a) - p.row(b)).norm() / (q.row(a) - q.row(b)).norm())));
    }
  std::sort(strains.begin(), strains.end());
  return strains;
}

TEST(Articulated_figure, IsTheBoundaryOfABodyInEachPose)
{
  auto poses = Articulated_figure::named_poses();
  ASSERT_EQ(poses.size(), 5u);
  poses.push_back({"rest", {}});
  for(const auto& pose : poses)
  {
    const Mesh mesh = figure().make_mesh<Mesh>(pose.angles);
    EXPECT_TRUE(CGAL::is_closed(mesh)) << pose.name;
    EXPECT_TRUE(CGAL::is_valid_polygon_mesh(mesh)) << pose.name;
    EXPECT_EQ(num_vertices(mesh) + num_faces(mesh), num_edges(mesh) + 2) << pose.name;
    EXPECT_TRUE(CGAL::Polygon_mesh_processing::is_outward_oriented(mesh)) << pose.name;
    EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh)) << pose.name;
  }
}

TEST(Articulated_figure, PosesDifferInSpaceButHardlyAlongTheSurface)
{
  std::vector<Point_matrix> poses;
  for(const auto& pose : Articulated_figure::named_poses())
    poses.push_back(Canonical_pose_test::to_matrix(figure().points(pose.angles)));
  const double rms = Canonical_pose_test::mean_pairwise_rms(poses);
  double mean_strain = 0;
  int pairs = 0;
  for(std::size_t i = 0; i < poses.size(); ++i)
    for(std::size_t j = 0; j < i; ++j, ++pairs)
    {
      const std::vector<double> strains = edge_strains(poses[i], poses[j]);
      EXPECT_LT(strains[strains.size() / 2], 0.02);
      mean_strain += std::accumulate(strains.begin(), strains.end(), 0.) / double(strains.size());
    }
  std::cout << "mean rms " << rms << " radii of gyration, mean edge strain " << mean_strain / pairs
            << '\n';
  EXPECT_GT(rms, 0.35);
  EXPECT_LT(rms, 0.55);
  EXPECT_LT(mean_strain / pairs, 0.05);
}

TEST(Articulated_figure, TrianglesOfTheRestPoseAreWellShaped)
{
  const Articulated_figure::Points points = figure().points();
  for(const auto& t : figure().triangles())
    for(std::size_t i = 0; i < 3; ++i)
    {
      auto corner = [&](std::size_t k) { return Eigen::Vector3d(points[t[(i + k) % 3]].data()); };
      const Eigen::Vector3d u = corner(1) - corner(0), v = corner(2) - corner(0);
      EXPECT_GT(std::atan2(u.cross(v).norm(), u.dot(v)), 0.26); // 15 degrees
    }
}

TEST(Articulated_figure, IsTheSameEachTime)
{
  const Articulated_figure again(3500);
  EXPECT_EQ(figure().triangles(), again.triangles());
  for(const auto& pose : Articulated_figure::named_poses())
    EXPECT_EQ(figure().points(pose.angles), again.points(pose.angles));
}

TEST(Articulated_figure, HasTheWishedNumberOfVerticesAtAnySize)
{
  for(std::size_t n : {std::size_t(2000), std::size_t(20001)})
  {
    const Articulated_figure sized(n);
    EXPECT_EQ(sized.points().size(), n);
    EXPECT_EQ(sized.triangles().size(), 2 * n - 4); // a sphere
  }
  EXPECT_THROW(Articulated_figure(10), std::invalid_argument);
}

TEST(Articulated_figure, MakesTheSamePolyhedron)
{
  using Polyhedron = CGAL::Polyhedron_3<Kernel>;
  const Articulated_figure::Points points = figure().points();
  const auto polyhedron = figure().make_mesh<Polyhedron>();
  ASSERT_EQ(polyhedron.size_of_facets(), figure().triangles().size());
  std::size_t i = 0;
  for(auto v = polyhedron.vertices_begin(); v != polyhedron.vertices_end(); ++v, ++i)
    ASSERT_EQ(v->point(), Kernel::Point_3(points[i][0], points[i][1], points[i][2]));
}

TEST(Articulated_figure, LandmarksAreTheTipsOfTheBody)
{
  const Articulated_figure::Points points = figure().points();
  auto at = [&](Landmark tip) { return points[figure().landmark(tip)]; };
  EXPECT_NEAR(at(Landmark::LEFT_HAND)[0], 0.92, 0.02);
  EXPECT_NEAR(at(Landmark::RIGHT_HAND)[0], -0.92, 0.02);
  EXPECT_GT(at(Landmark::LEFT_FOOT)[2], 0.17);
  EXPECT_LT(at(Landmark::RIGHT_FOOT)[0], -0.1);
  EXPECT_NEAR(at(Landmark::HEAD)[1], 1.79, 0.02);
}

} // namespace
