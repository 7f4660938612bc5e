// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_PYTHON_SOLVERS_H
#define CGAL_CANONICAL_POSE_3_PYTHON_SOLVERS_H

#include "arrays.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Result.h>

#include <Eigen/Core>

#include <cstddef>
#include <memory>
#include <vector>

namespace Canonical_pose_python {

using CGAL::Canonical_pose_3::Options;
using CGAL::Canonical_pose_3::Result;

// The target of the first round, as the pose of a result.
Result first_target(const Mesh_file& surface, const Options& options);

// See CGAL::Canonical_pose_3::Heat_geodesics_3; for any polygons, which are repaired.
class Heat_solver
{
public:
  Heat_solver(const Mesh_file& surface, double time_step_factor);
  ~Heat_solver();

  std::size_t number_of_vertices() const;
  // One column per source.
  Eigen::MatrixXd distances(const std::vector<std::size_t>& sources) const;
  Eigen::VectorXd distance_to_nearest(const std::vector<std::size_t>& sources) const;

private:
  struct Data;
  std::unique_ptr<const Data> m_data;
};

// See CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3; with the body of a surface.
class Registrar
{
public:
  Registrar(const Mesh_file& surface, const Options& options);
  ~Registrar();

  const Point_matrix& target() const;
  const Point_matrix& body_points() const;
  const std::vector<std::array<int, 4>>& body_cells() const;
  void set_detail_length(double detail_length);

  // Starts at the positions of the body that the registration before ended with, if requested.
  Result registered_to(const Point_matrix& target, bool is_warm,
                       const CGAL::Canonical_pose_3::Registration_visitor& visitor);

private:
  struct Data;
  std::unique_ptr<Data> m_data;
};

} // namespace Canonical_pose_python

#endif // CGAL_CANONICAL_POSE_3_PYTHON_SOLVERS_H
