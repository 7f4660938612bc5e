// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SMACOF_TARGET_BUILDER_3_H
#define CGAL_CANONICAL_POSE_3_SMACOF_TARGET_BUILDER_3_H

#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>

#include <Eigen/Core>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief embeds points in 3D by minimizing the stress of their distances to a few landmarks, starting
from given positions.

Multidimensional scaling by eigenvectors (`Landmark_mds_target_builder_3`) has no choice of weights,
and finds the embedding up to a reflection. Here, the positions \f$ z_i \f$ of the landmarks
decrease the weighted stress \f$ \sum_{i<j} w_{ij} (|z_i - z_j| - g_{ij})^2 \f$ from a start by
majorization (SMACOF, \cgalCite{cgal:canonical-l-acda-77}), so a start near the embedding decides
which of the two mirror images, and which arrangement of limbs, is found. Then, each point minimizes
\f$ \sum_j c_j (|x - z_j| - d_j)^2 \f$ for its distances \f$ d_j \f$ to the landmarks
(Levenberg-Marquardt), starting from its given position plus the displacement of the landmarks near
it.

The weights are \f$ w_{ij} = a_i a_j \max(g_{ij}/L, 0.02)^q \f$ and \f$ c_j = a_j \max(d_j/L,
0.02)^q \f$, where \f$ L \f$ is the largest distance, \f$ a_j \f$ is the share of the points nearest
to landmark \f$ j \f$ in the sum of all point weights (at least \f$ 10^{-4} \f$), and \f$ q \f$ is
the <em>weight exponent</em>. With a <em>robust scale</em> \f$ \sigma > 0 \f$, each weight is also
multiplied by \f$ (1 + r^2 / \sigma^2)^{-2} \f$ (Geman-McClure) for the residual \f$ r \f$ as a
fraction of \f$ L \f$, so that a few wrong distances hardly matter.

Nothing here depends on a surface: distances can come from anywhere.

\sa `Landmark_mds_target_builder_3`
*/
class Smacof_target_builder_3
{
public:
  /// constructs a builder; `robust_scale` is 0 for weights that do not depend on residuals.
  /// \throws std::invalid_argument unless `weight_exponent` is from \f$ -5 \f$ to 5, and
  ///         `robust_scale` is 0 or from 0.001 to 1000.
  explicit Smacof_target_builder_3(double weight_exponent = 1, double robust_scale = 0);

  /*!
  embeds the points whose distances to the landmarks are given.

  \param fields the distances.
  \param start \f$ n \times 3 \f$, the position from which each point starts, in the unit of the
         distances.
  \param weights \f$ n \f$ nonnegative weights of the points, for instance `vertex_area_shares()`.

  \pre `start` and `weights` have one row per row of the distances, `start` is finite, and the sum
       of the weights is positive.

  \throws std::invalid_argument under the same conditions as
          `Landmark_mds_target_builder_3::build()`.

  <em>Complexity:</em> \f$ O(nl) \f$ for \f$ n \f$ points and \f$ l \f$ landmarks, \f$ O(l^3) \f$
  once (with robust weights, per iteration), and \f$ O(l^2) \f$ per iteration.
  */
  void build(const Landmark_fields_3& fields, const Point_matrix& start,
             const Eigen::VectorXd& weights);

  /// \name Results
  /// These functions refer to the last call of `build()`.
  /// @{

  /// returns the \f$ n \times 3 \f$ matrix of embedded points, in the unit of the distances. A
  /// landmark is embedded like the other points, near its row of `landmark_targets()`.
  const Point_matrix& targets() const { return m_targets; }

  /// returns the \f$ l \times 3 \f$ matrix of embedded landmarks.
  const Point_matrix& landmark_targets() const { return m_landmark_targets; }

  /// returns \f$ \sqrt{\sum w (|z_i - z_j| - g)^2 / \sum w g^2} \f$ over all pairs of landmarks; 0
  /// if all distances are 0.
  double stress() const { return m_stress; }

  /// returns \f$ \sqrt{\sum c (|x - z_j| - d)^2 / \sum c d^2} \f$ for each point.
  const Eigen::VectorXd& point_stress() const { return m_point_stress; }

  /// returns the number of iterations for the landmarks.
  int iterations() const { return m_iterations; }

  /// returns the largest distance, \f$ L \f$.
  double length_scale() const { return m_length_scale; }

  /// @}

private:
  double m_weight_exponent, m_robust_scale;
  Point_matrix m_targets, m_landmark_targets;
  Eigen::VectorXd m_point_stress;
  double m_stress = 0;
  double m_length_scale = 0;
  int m_iterations = 0;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SMACOF_TARGET_BUILDER_3_H
