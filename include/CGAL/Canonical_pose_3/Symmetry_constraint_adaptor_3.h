// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SYMMETRY_CONSTRAINT_ADAPTOR_3_H
#define CGAL_CANONICAL_POSE_3_SYMMETRY_CONSTRAINT_ADAPTOR_3_H

#include <CGAL/Canonical_pose_3/Constraint_list_3.h>
#include <CGAL/Canonical_pose_3/internal/support/weighted_product.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/assertions.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is a pair of vertices of the surface that become mirror images of each other.
*/
struct Symmetric_pair_3
{
  std::size_t p = 0;    ///< row of the first vertex.
  std::size_t q = 0;    ///< row of the second vertex; if equal to `p`, it is on the plane.
  double stiffness = 1; ///< \f$ \kappa \f$, dimensionless. Positive.
};

namespace internal {

template <>
struct Constraint_element_traits<Symmetric_pair_3> : Vertex_pair_traits
{
  static constexpr const char* name = "symmetric pair";

  static std::string defect(const Symmetric_pair_3&) { return std::string(); }
};

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief makes pairs of vertices mirror images of each other with respect to one common plane during a
registration.

The plane is not prescribed. If \f$ S(x) \f$ is the mirror image of \f$ x \f$ with respect to a
plane, the energy is
\f[ e = \min_S \frac{1}{2} \sum_s \kappa_s |p_s - S(q_s)|^2 . \f]
For the unit normal \f$ \nu \f$ and the offset \f$ c \f$ of the plane, and with \f$ d_s = p_s - q_s
\f$ and \f$ m_s = \frac{1}{2} (p_s + q_s) \f$,
\f[ |p_s - S(q_s)|^2 = |d_s|^2 - (\nu \cdot d_s)^2 + 4\, (\nu \cdot m_s - c)^2 . \f]
Hence the best plane passes through the weighted mean \f$ \bar m \f$ of the midpoints, and its normal
is an eigenvector for the smallest eigenvalue of
\f[ \sum_s \kappa_s \left( 4\, (m_s - \bar m)(m_s - \bar m)^t - d_s d_s^t \right) . \f]

The nearest points to \f$ p \f$ and \f$ q \f$ that are mirror images of each other are \f$ p' =
\frac{1}{2} (p + S(q)) \f$ and \f$ q' = S(p') \f$, and \f$ |p - S(q)|^2 = 2\, |p - p'|^2 + 2\, |q -
q'|^2 \f$. Each iteration replaces the square by the latter, with the plane, \f$ p' \f$ and
\f$ q' \f$ from before the iteration, similar to \cgalCite{cgal:canonical-lbok-fsmss-13}. This is an
upper bound of the energy, which thus never increases, and its matrix does not depend on the plane.

A single pair is always symmetric with respect to the plane halfway between its vertices.

\cgalModels `RegistrationConstraint_3`

\sa `Tetrahedral_arap_registrar_3::add_constraint()`
*/
class Symmetry_constraint_adaptor_3 : public Constraint_list_3<Symmetric_pair_3>
{
public:
  using Constraint_list_3<Symmetric_pair_3>::Constraint_list_3;

  /// returns a plane that minimizes the sum at `points` (\f$ n \times 3 \f$).
  /// \pre There is a pair.
  Eigen::Hyperplane<double, 3> plane(const Point_matrix& points) const
  {
    CGAL_precondition(!elements().empty());
    Point_matrix middles(static_cast<Eigen::Index>(elements().size()), 3);
    Point_matrix differences(middles.rows(), 3);
    Eigen::VectorXd stiffness(middles.rows());
    for(Eigen::Index i = 0; i < middles.rows(); ++i)
    {
      const Symmetric_pair_3& s = element(static_cast<std::size_t>(i));
      CGAL_precondition((std::max)(s.p, s.q) < static_cast<std::size_t>(points.rows()));
      middles.row(i) = (points.row(s.p) + points.row(s.q)) / 2;
      differences.row(i) = points.row(s.p) - points.row(s.q);
      stiffness[i] = s.stiffness;
    }
    stiffness /= stiffness.sum();
    const Eigen::RowVector3d center = stiffness.transpose() * middles;
    middles.rowwise() -= center;
    // the eigenvectors do not depend on the unit, but squares could overflow
    const double unit
      = (std::max)(middles.cwiseAbs().maxCoeff(), differences.cwiseAbs().maxCoeff());
    if(!(unit > 0))
      return Eigen::Hyperplane<double, 3>(Eigen::Vector3d::UnitX(), center.transpose());
    middles /= unit;
    differences /= unit;
    const Eigen::Matrix3d matrix
      = 4 * internal::weighted_product(middles, stiffness, middles)
        - internal::weighted_product(differences, stiffness, differences);
    return Eigen::Hyperplane<double, 3>(
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvectors().col(0),
      center.transpose());
  }

  /// \name Requirements of `RegistrationConstraint_3`
  /// @{

  /// appends \f$ \kappa_s \f$ to the diagonal, for \f$ p_s \f$ and for \f$ q_s \f$.
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const
  {
    for(const Symmetric_pair_3& s : elements())
      for(const std::size_t v : {s.p, s.q})
        matrix.emplace_back(static_cast<int>(v), static_cast<int>(v), s.stiffness);
  }

  /// adds \f$ \kappa_s p'_s \f$ to row \f$ p_s \f$ and \f$ \kappa_s q'_s \f$ to row \f$ q_s \f$.
  void add_to_right_hand_side(const Point_matrix& points, Point_matrix& right_hand_side) const
  {
    for_each_misfit(points, [&](const Symmetric_pair_3& s, const Eigen::RowVector3d& misfit,
                                const Eigen::RowVector3d& mirrored_misfit) {
      right_hand_side.row(s.p) += s.stiffness * (points.row(s.p) - misfit / 2);
      right_hand_side.row(s.q) += s.stiffness * (points.row(s.q) + mirrored_misfit / 2);
    });
  }

  /// returns the energy at `points`, in the squared unit of the mesh.
  double energy(const Point_matrix& points) const
  {
    double sum = 0;
    for_each_misfit(
      points, [&](const Symmetric_pair_3& s, const Eigen::RowVector3d& misfit,
                  const Eigen::RowVector3d&) { sum += s.stiffness / 2 * misfit.squaredNorm(); });
    return sum;
  }

  /// @}

private:
  // Calls f(s, d, mirror image of the vector d) with d = p - S(q) for each pair.
  template <class Function>
  void for_each_misfit(const Point_matrix& points, const Function& f) const
  {
    if(elements().empty())
      return;
    const Eigen::Hyperplane<double, 3> mirror = plane(points);
    const Eigen::RowVector3d normal = mirror.normal().transpose();
    for(const Symmetric_pair_3& s : elements())
    {
      const Eigen::RowVector3d p = points.row(s.p), q = points.row(s.q);
      const double height = mirror.signedDistance(q.transpose());
      const Eigen::RowVector3d misfit = p - q + 2 * height * normal;
      f(s, misfit, misfit - 2 * misfit.dot(normal) * normal);
    }
  }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SYMMETRY_CONSTRAINT_ADAPTOR_3_H
