// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/canonical_pose_3.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <gtest/gtest.h>

#include "Articulated_figure.h"
#include "matchers.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace test_invariance {

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_examples::Articulated_figure;
using Canonical_pose_test::radius_of_gyration;
using CP::Point_matrix;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Permutation = std::vector<std::size_t>; // old row of each new row

const Eigen::Matrix3d rotation
  = Eigen::AngleAxisd(2.2, Eigen::Vector3d(1, 3, -2).normalized()).toRotationMatrix();
const Eigen::RowVector3d translation(3, -1, 2);

Point_matrix moved(const Point_matrix& points)
{
  return (points * rotation.transpose()).rowwise() + translation;
}

Point_matrix permuted(const Point_matrix& points, const Permutation& old_row)
{
  Point_matrix result(points.rows(), 3);
  for(std::size_t i = 0; i < old_row.size(); ++i)
    result.row(Eigen::Index(i)) = points.row(Eigen::Index(old_row[i]));
  return result;
}

Permutation shuffled(const std::size_t n)
{
  Permutation result(n);
  std::iota(result.begin(), result.end(), std::size_t(0));
  std::shuffle(result.begin(), result.end(), std::mt19937(5));
  return result;
}

// Renames the indices of faces or cells.
template <class Simplices>
Simplices renamed(Simplices simplices, const Permutation& old_row)
{
  Permutation new_row(old_row.size());
  for(std::size_t i = 0; i < old_row.size(); ++i)
    new_row[old_row[i]] = i;
  for(auto& simplex : simplices)
    for(std::size_t& v : simplex)
      v = new_row[v];
  return simplices;
}

std::vector<Kernel::Point_3> to_points(const Point_matrix& points)
{
  std::vector<Kernel::Point_3> result;
  for(Eigen::Index i = 0; i < points.rows(); ++i)
    result.emplace_back(points(i, 0), points(i, 1), points(i, 2));
  return result;
}

Point_matrix surface_pose(const Point_matrix& points,
                          const std::vector<CP::internal::Index_triangle>& triangles)
{
  Mesh mesh = CP::internal::indexed_mesh(points, triangles);
  const auto summary = CGAL::canonical_pose_3(mesh, mesh.points()).summary;
  EXPECT_TRUE(summary.converged());
  return CP::point_matrix(mesh);
}

struct Complex_case
{
  CP::Indexed_tetrahedra_3<Kernel::Point_3> complex;
  CP::Intermediate_results results;
};

// Without rounds, since the distances are given, and at a minimum, which inverted cells are part of.
Point_matrix complex_pose(Complex_case c)
{
  std::vector<Kernel::Point_3> pose(c.complex.points.size());
  CP::Options options;
  options.number_of_rounds = 0;
  options.registration.injective = false;
  options.given = c.results;
  options.registration.energy_tolerance = 1e-12;
  options.registration.move_tolerance = 1e-9;
  options.registration.number_of_iterations = 3000;
  EXPECT_TRUE(
    CGAL::canonical_pose_3(c.complex, CGAL::make_property_map(pose), options).summary.converged());
  return Canonical_pose_test::to_matrix(pose);
}

// If body and distances are given, a moved or relabeled complex differs from the original one only
// by rounding: the minimum is isolated, and moves with the input. It is approached far beyond the
// default tolerances here.
TEST(Invariance, given_body_and_landmarks)
{
  const auto soup = Canonical_pose_test::tetrahedral_bent_bar(16, 3, 2, 2.5, {{8., 1.5, 1.}});
  const Point_matrix points = Canonical_pose_test::to_matrix(soup.points);
  Complex_case input;
  input.complex = {to_points(points), soup.cells};
  std::vector<Kernel::Point_3> unused(soup.points.size());
  CP::Options options;
  options.return_landmark_fields = true;
  input.results.landmark_fields
    = CGAL::canonical_pose_3(input.complex, CGAL::make_property_map(unused), options)
        .landmark_fields;
  const Point_matrix pose = complex_pose(input);
  const double bound = 1e-6 * radius_of_gyration(pose);

  Complex_case motion = input;
  motion.complex.points = to_points(moved(points));
  EXPECT_LT((complex_pose(motion) - moved(pose)).rowwise().norm().maxCoeff(), bound);

  // The rows of the distances are the boundary vertices of the complex, in its order.
  std::vector<std::size_t> origin;
  Canonical_pose_test::boundary(soup, &origin);
  const Permutation old_row = shuffled(soup.points.size());
  Complex_case relabeled = input;
  relabeled.complex = {to_points(permuted(points, old_row)), renamed(soup.cells, old_row)};
  CP::Landmark_fields_3& fields = *relabeled.results.landmark_fields;
  Eigen::Index row = 0;
  Permutation new_row(origin.size());
  for(const std::size_t v : old_row)
  {
    const auto found = std::lower_bound(origin.begin(), origin.end(), v);
    if(found == origin.end() || *found != v)
      continue;
    new_row[std::size_t(found - origin.begin())] = std::size_t(row);
    fields.distances.row(row++)
      = input.results.landmark_fields->distances.row(found - origin.begin());
  }
  for(std::size_t& landmark : fields.landmarks)
    landmark = new_row[landmark];
  EXPECT_LT((complex_pose(relabeled) - permuted(pose, old_row)).rowwise().norm().maxCoeff(), bound);
}

// If the surface is given, there are choices (landmarks, tetrahedra) that ties and rounding may
// change, but not by more than this.
TEST(Invariance, whole_pipeline)
{
  const Articulated_figure figure(4000);
  const Point_matrix points = Canonical_pose_test::to_matrix(
    figure.points(Articulated_figure::named_poses().back().angles));
  const auto& triangles = figure.triangles();
  const Point_matrix pose = surface_pose(points, triangles);
  const double size = radius_of_gyration(pose);
  const auto rms = [](const Point_matrix& difference) {
    return std::sqrt(difference.rowwise().squaredNorm().mean());
  };

  EXPECT_LT(rms(surface_pose(moved(points), triangles) - moved(pose)), 1e-3 * size);
  const Permutation old_row = shuffled(std::size_t(points.rows()));
  EXPECT_LT(rms(surface_pose(permuted(points, old_row), renamed(triangles, old_row))
                - permuted(pose, old_row)),
            6e-3 * size);

  // All lengths are divided by powers of two or by other lengths, so they scale exactly.
  EXPECT_LT(rms(surface_pose(64 * points, triangles) / 64 - pose), 1e-12 * size);
  EXPECT_LT(rms(surface_pose(points / 1024, triangles) * 1024 - pose), 1e-12 * size);
  EXPECT_LT(rms(surface_pose(1e6 * points, triangles) / 1e6 - pose), 1e-3 * size);
  EXPECT_LT(rms(surface_pose(1e-6 * points, triangles) * 1e6 - pose), 1e-3 * size);
}

} // namespace test_invariance
