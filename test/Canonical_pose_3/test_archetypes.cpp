// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

// Archetypes: classes with only the requirements of their concepts, run on data.

#include <CGAL/Canonical_pose_3/Landmark_mds_target_builder_3.h>
#include <CGAL/Canonical_pose_3/Tetrahedral_arap_registrar_3.h>

#include <gtest/gtest.h>

#include "matchers.h"
#include "shapes.h"

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <vector>

namespace CP = CGAL::Canonical_pose_3;
using Canonical_pose_test::uniform_weights;
using CP::Point_matrix;

namespace {

// A model of ElasticBody_3 whose surface is inside the cells: B has four entries per row.
class Hanging_body
{
public:
  Hanging_body()
  {
    const auto soup = Canonical_pose_test::tetrahedral_bent_bar(12, 2, 2, 0.);
    m_points = Canonical_pose_test::to_matrix(soup.points);
    for(const auto& c : soup.cells)
      m_cells.push_back({int(c[0]), int(c[1]), int(c[2]), int(c[3])});
    m_weights
      = Eigen::VectorXd::Constant(Eigen::Index(m_cells.size()), 1. / double(m_cells.size()));
    std::vector<Eigen::Triplet<double>> entries;
    for(std::size_t t = 0; t < m_cells.size(); ++t)
      for(int k = 0; k < 4; ++k)
        entries.emplace_back(int(t), m_cells[t][std::size_t(k)], 0.1 * (k + 1));
    m_embedding.resize(Eigen::Index(m_cells.size()), m_points.rows());
    m_embedding.setFromTriplets(entries.begin(), entries.end());
  }
  const Point_matrix& points() const { return m_points; }
  const std::vector<std::array<int, 4>>& cells() const { return m_cells; }
  const Eigen::VectorXd& cell_weights() const { return m_weights; }
  double volume() const { return 8.; }
  const Eigen::SparseMatrix<double>& embedding() const { return m_embedding; }

private:
  Point_matrix m_points;
  std::vector<std::array<int, 4>> m_cells;
  Eigen::VectorXd m_weights;
  Eigen::SparseMatrix<double> m_embedding;
};

// A model of RegistrationConstraint_3 that pulls a vertex to a point: kappa |x_v - c|^2.
struct Handle
{
  std::size_t matrix_revision() const { return revision; }
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    matrix.emplace_back(vertex, vertex, stiffness);
  }
  void add_to_right_hand_side(const Point_matrix&, Point_matrix& right_hand_side)
  {
    right_hand_side.row(vertex) += stiffness * position;
  }
  double energy(const Point_matrix& points) const
  {
    return stiffness * (points.row(vertex) - position).squaredNorm();
  }

  int vertex;
  Eigen::RowVector3d position;
  double stiffness;
  std::size_t revision = 0;
};

// A model of MdsKernel: -r^2/2 plus a constant, which centering removes.
struct Shifted_kernel
{
  double operator()(const double relative_distance) const
  {
    return 3 - 0.5 * relative_distance * relative_distance;
  }
  bool is_centered() const { return true; }
  const char* name() const { return "shifted"; }
};

// Inverted cells remain, so that the result is a minimum.
CP::Registration_options to_the_end()
{
  CP::Registration_options options;
  options.injective = false;
  options.number_of_iterations = 5000;
  options.energy_tolerance = 1e-14;
  options.move_tolerance = 1e-10;
  return options;
}

} // namespace

// Rows of B sum to 1, so a rigid motion of the body also moves the surface: a rigid target is
// reached with energy 0 although no body vertex has its own target.
TEST(Archetypes, body_on_which_the_surface_hangs)
{
  const Hanging_body body;
  const Point_matrix surface = body.embedding() * body.points();
  CP::Tetrahedral_arap_registrar_3<Hanging_body> registrar(body, uniform_weights(surface), 8.,
                                                           to_the_end());
  const Eigen::Matrix3d rotation
    = Eigen::AngleAxisd(2., Eigen::Vector3d(1, 1, 0).normalized()).toRotationMatrix();
  const Point_matrix target = surface * rotation.transpose();
  registrar.set_target(target);
  Point_matrix pose;
  const CP::Registration_summary summary = registrar.register_to_target(pose);
  EXPECT_TRUE(summary.converged());
  EXPECT_LT(summary.energy, 1e-12);
  EXPECT_LT((registrar.surface_points(pose) - target).norm(), 1e-4);
  EXPECT_LT((pose - body.points() * rotation.transpose()).norm(), 1e-4);
  EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
}

// A handle of huge stiffness is satisfied; if target and handle are shifted by the same vector, so
// is the entire body.
TEST(Archetypes, constraint)
{
  const Hanging_body body;
  const Point_matrix surface = body.embedding() * body.points();
  CP::Tetrahedral_arap_registrar_3<Hanging_body> registrar(body, uniform_weights(surface), 8.,
                                                           to_the_end());
  Handle handle = {0, surface.row(0) + Eigen::RowVector3d(0, 0, 2), 1e6};
  registrar.add_constraint(handle);
  registrar.set_target(surface);
  Point_matrix pose;
  const CP::Registration_summary summary = registrar.register_to_target(pose);
  EXPECT_LT((registrar.surface_points(pose).row(0) - handle.position).norm(), 1e-4);
  EXPECT_TRUE(Canonical_pose_test::never_rises(summary.energy_history));
  EXPECT_NEAR(summary.energy,
              summary.energy_match + summary.energy_arap + summary.energy_constraints, 1e-15);

  const Eigen::RowVector3d shift(1, 2, 3);
  handle.position += shift;
  registrar.set_target(surface.rowwise() + shift);
  Point_matrix shifted;
  registrar.register_to_target(shifted);
  EXPECT_LT(((shifted.rowwise() - shift) - pose).norm(), 1e-6);

  // A different stiffness changes the matrix and its revision. The surface returns to its target,
  // except for 2e-5 due to the handle at distance 2.
  handle.stiffness = 1e-6;
  ++handle.revision;
  Point_matrix loose;
  registrar.register_to_target(loose);
  const Point_matrix moved = registrar.surface_points(loose).rowwise() - shift;
  EXPECT_LT((moved - surface).rowwise().norm().maxCoeff(), 4e-5);
  EXPECT_NEAR((moved.row(0) + shift - handle.position).norm(), 2, 4e-5);
}

// Centering removes constants: the target is that of classical scaling.
TEST(Archetypes, mds_kernel)
{
  const Point_matrix points = Canonical_pose_test::to_matrix(
    Canonical_pose_test::tetrahedral_box(3, 4, 5, {{1., 2., 4.}}).points);
  CP::Landmark_fields_3 fields;
  fields.distances.resize(points.rows(), 20);
  for(Eigen::Index j = 0; j < 20; ++j)
  {
    fields.landmarks.push_back(std::size_t(6 * j));
    fields.distances.col(j) = (points.rowwise() - points.row(6 * j)).rowwise().norm();
  }
  CP::Landmark_mds_target_builder_3<Shifted_kernel> shifted;
  CP::Landmark_mds_target_builder_3<> classical;
  shifted.build(fields);
  classical.build(fields);
  EXPECT_LT((shifted.targets() - classical.targets()).norm(), 1e-9);
}
