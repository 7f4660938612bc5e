// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_MATCH_COARSE_MATCH_H
#define CANONICAL_POSE_3_ENGINE_MATCH_COARSE_MATCH_H

#include "Matchable_data.h"

#include <CGAL/Canonical_pose_3/Match_options.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The match of two coarse surfaces: which vertex of the other one is nearest, in the product of mapped eigenfunctions, reliefs,
// normals and positions, each in units of its residual.
class Coarse_match
{
public:
  using Indices = std::vector<std::size_t>;

  // `rotation` brings the pose of `a` near that of `b`. Landmarks are coarse vertices.
  Coarse_match(const Matchable_data& a, const Matchable_data& b, const Eigen::Matrix3d& rotation,
               const Match_options& options, Indices landmarks_of_a, Indices landmarks_of_b);

  // Compares by more and more functions, up to `most`; goes on where it ended before.
  void refine(Eigen::Index most);

  // Registers the pose to the other one.
  void deform();

  // How bad the match is: what it changes about the lengths of edges, functions, reliefs and positions; much more if it turns
  // most triangles inside out.
  double cost() const;

  const Eigen::MatrixXd& functional_map() const { return m_map; }

  // Of the pose, near the other one.
  const Point_matrix& position() const { return m_position; }

private:
  struct Features;

  double strain() const;
  double mean_distance() const;
  bool preserves_orientation() const;
  Eigen::Index number_of_functions() const;
  bool is_counted(const std::array<std::size_t, 3>& triangle) const;
  void update(Eigen::Index count, bool moves, std::size_t number);
  template <class Function>
  void for_each_pair(const Function& function) const;
  Point_matrix targets() const;
  Features features_of_a(Eigen::Index count, bool moves);
  Features features_of_b(Eigen::Index count) const;
  void set_weights_of_details(const Point_matrix& normals, double factor_of_normals);
  Features features(const Matchable_data& shape, const Function_matrix& functions,
                    const Point_matrix& normals, const Point_matrix& positions) const;
  double squared_distance(std::size_t i, std::size_t j) const;

  const Matchable_data &m_a, &m_b;
  const Match_options& m_options;
  const Eigen::Matrix3d m_rotation;
  const Point_matrix m_rest;
  Point_matrix m_position;
  const Point_matrix m_normals_of_b;
  const Indices m_landmarks_of_a, m_landmarks_of_b;
  Indices m_forward, m_backward;          // partners
  Indices m_samples_of_a, m_samples_of_b; // those that have partners by the last comparison
  Eigen::MatrixXd m_map;
  Eigen::RowVectorXd m_weights, m_weights_of_reliefs; // m_weights: of the functions
  double m_weight_of_positions = 0, m_weight_of_normals = 0;
  Eigen::Index m_count = 0; // of the functions so far
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_MATCH_COARSE_MATCH_H
