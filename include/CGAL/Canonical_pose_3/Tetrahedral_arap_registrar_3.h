// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TETRAHEDRAL_ARAP_REGISTRAR_3_H
#define CGAL_CANONICAL_POSE_3_TETRAHEDRAL_ARAP_REGISTRAR_3_H

#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/Unfolding.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/Registration_constraint_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>

#include <Eigen/Core>

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief pulls an elastic body toward a target of its surface while preserving details.

It minimizes
\f[ E(v) = \sum_i m_i |(Bv)_i - \hat v_i|^2 / L^2 + \ell^2 \sum_t w_t \|F_t - R_t\|^2
           + E_{constraints} / L^2 \f]
by alternating local and global steps \cgalCite{cgal:canonical-sa-asap-07},
\cgalCite{cgal:canonical-s-sdacm-15} (Equations 4 to 13). Here \f$ v \f$ are the body vertices,
\f$ Bv \f$ the surface, \f$ \hat v \f$ the target, \f$ m \f$ the matching weights and \f$ w \f$ the
cell weights (each with sum 1), \f$ F_t \f$ is the deformation gradient of cell \f$ t \f$ and
\f$ R_t \f$ the rotation closest to it, always of determinant 1. The matrix of the global step is
\f[ A = \ell^2 L^2 \sum_t w_t G_t^t G_t + (1 + \beta) B^t M B + A_{constraints}, \f]
which is factored once; if constraints on few vertices are added, modified or removed afterwards,
the factor is kept and combined with a low-rank update. The resulting steps are corrected by those
of previous iterations, using limited-memory BFGS \cgalCite{cgal:canonical-lbk-qnm-17}; if the
corrected step does not decrease the energy sufficiently, the uncorrected one is used. All lengths
are divided by \f$ L \f$, so neither units nor resolution matter. Without fairing, the energy never
increases. The stopping criterion is described in `Registration_options`.

After `set_unfolding()`, there is no target, and the first term of \f$ E \f$ is
\f[ -\mu \sum_i m_i |(Bv)_i - c| / L, \qquad c = \sum_i m_i (Bv)_i \f]
instead, which unfolds the body \cgalCite{cgal:canonical-sk-dpmun-16}. It is concave, so in a global
step it is replaced by its linearization, and \f$ (1 + \beta) B^t M B \f$ by \f$ (\beta + \ell^2 /
20) B^t M B \f$, the matrix of a term that keeps an iterate close to the previous one, like the
Tikhonov term. Without constraints on positions, it keeps the centroid.

\tparam ElasticBody a model of `ElasticBody_3`
\tparam ClosestRotationTraits a model of CGAL's `DeformationClosestRotationTraits_3`. By default,
       rotations are computed in closed form, for eight cells at once, to 12 digits; where the
       closed form is ill-conditioned, by a singular value decomposition.
\tparam FactorTraits a model of `SparseLinearAlgebraWithBlockFactorTraits_d`, by default
       `Default_factor_traits_d`

\sa `canonical_pose_3()`
\sa `Spring_constraint_adaptor_3`
\sa `Direction_constraint_adaptor_3`
\sa `Handle_constraint_adaptor_3`
\sa `Symmetry_constraint_adaptor_3`
*/
template <class ElasticBody, class ClosestRotationTraits = Default, class FactorTraits = Default>
class Tetrahedral_arap_registrar_3
{
public:
  /// the body
  using Elastic_body = ElasticBody;

  /*!
  constructs a registrar without target. Body and weights are checked; the matrix is factored by
  `factor()` or when it is first required.

  \param body the body, not a temporary. It must outlive the registrar.
  \param matching_weights \f$ n \f$ nonnegative weights of the surface vertices; they are divided by
         their sum. Vertices of weight 0 have no target.
  \param length_scale \f$ L \f$, usually the largest geodesic distance. Positive.
  \param options the parameters.
  \param stiffness positive factors of the cell weights \f$ w \f$, one per cell, or none. A constant
         factor \f$ c \f$ is equivalent to multiplying the detail length by \f$ \sqrt c \f$.

  \pre `matching_weights.size() == body.embedding().rows()`

  \throws std::invalid_argument if a weight, a factor or an option is out of range, or a connected
         component of the body has no surface vertex of positive weight (the matrix would be
         singular); the message states the element.

  <em>Complexity:</em> linear in the size of the body.
  */
  Tetrahedral_arap_registrar_3(const ElasticBody& body, const Eigen::VectorXd& matching_weights,
                               const double length_scale,
                               const Registration_options& options = Registration_options(),
                               const Eigen::VectorXd& stiffness = Eigen::VectorXd())
    : m_registration(internal::make_arap_registration(
      internal::Body_view(body), matching_weights, length_scale, options, stiffness,
      internal::rotation_routines<ClosestRotationTraits>(), internal::make_factor<FactorTraits>))
  {}

  /// \cond SKIP_IN_MANUAL
  Tetrahedral_arap_registrar_3(const ElasticBody&&, const Eigen::VectorXd&, double,
                               const Registration_options& = Registration_options(),
                               const Eigen::VectorXd& = Eigen::VectorXd())
    = delete;
  /// \endcond

  /// adds a constraint, not a temporary. It must outlive the registrar or be removed before its
  /// lifetime ends. It may change between calls of `register_to_target()`. Changes that do not
  /// affect its matrix cost nothing; others cost one solve per affected element, or a factorization
  /// if there are more than 32.
  /// \tparam Constraint a model of `RegistrationConstraint_3`
  template <class Constraint>
  void add_constraint(Constraint& constraint)
  {
    m_registration->add_constraint(
      std::make_unique<internal::Registration_constraint_model<Constraint>>(constraint));
  }

  /// \cond SKIP_IN_MANUAL
  template <class Constraint>
  void add_constraint(const Constraint&&) = delete;
  /// \endcond

  /// removes a constraint; the cost is that of changing its matrix.
  /// \pre `constraint` was added and has not been removed since.
  template <class Constraint>
  void remove_constraint(const Constraint& constraint)
  {
    m_registration->remove_constraint(&constraint);
  }

  /// sets the target \f$ \hat v \f$ (\f$ n \times 3 \f$); no factorization is required.
  /// \pre The number of rows equals the number of surface vertices.
  /// \throws std::invalid_argument if a coordinate is not finite.
  void set_target(const Point_matrix& target) { m_registration->set_target(target); }

  /// replaces the target by the repulsion of the vertices from their centroid. The first iteration
  /// starts at the rest pose if no other positions are given. Afterwards, `set_target()` replaces
  /// it; after such a change, the matrix is factored anew.
  /// \throws std::invalid_argument if the weight is out of range, or the body is not connected: then
  ///        the energy would have no lower bound.
  void set_unfolding(const Unfolding& unfolding) { m_registration->set_unfolding(unfolding); }

  /// factors the matrix or updates its factor, unless this has been done for the current
  /// constraints.
  /// \throws std::runtime_error if the matrix is not positive definite to working precision.
  void factor() { m_registration->factor(); }

  /*!
  runs the iteration.

  \param body_points \f$ N \times 3 \f$. If it has no rows, the iteration starts at the target: a
         body vertex that is a surface vertex starts at its target, all others at the solution of
         the system without rotations. Otherwise, it starts from these positions (warm start). On
         return, it holds the result. It is unchanged if the summary states that the result is not
         usable, or if an exception is thrown.
  \param visitor a model of `RegistrationVisitor_3` that is called after each iteration and may stop
         the registration, or none.

  \returns the summary, including the energies of all iterations, the number of inverted cells and
         the volume.

  \pre `set_target()` or `set_unfolding()` was called, and `body_points` has no row or as many as the body.

  \throws std::runtime_error see `factor()`. Exceptions of the visitor propagate.

  <em>Complexity:</em> per iteration one pass over the cells and one solve with the factor for three
  right-hand sides.
  */
  Registration_summary register_to_target(Point_matrix& body_points,
                                          const Registration_visitor& visitor
                                          = Registration_visitor())
  {
    return m_registration->register_to_target(body_points, visitor);
  }

  /// returns the surface vertices \f$ Bv \f$ (\f$ n \times 3 \f$) at body positions \f$ v \f$ (\f$
  /// N \times 3 \f$).
  Point_matrix surface_points(const Point_matrix& body_points) const
  {
    return m_registration->surface_points(body_points);
  }

  /// sets the maximum number of iterations, which must be nonnegative; no factorization is
  /// required.
  void set_number_of_iterations(const int number_of_iterations)
  {
    m_registration->set_number_of_iterations(number_of_iterations);
  }

  /// sets `Registration_options::detail_length`. The next registration refactors the matrix; data
  /// computed from the body are kept.
  /// \throws std::invalid_argument if it is out of range.
  void set_detail_length(const double detail_length)
  {
    m_registration->set_detail_length(detail_length);
  }

  /// returns the options.
  const Registration_options& options() const { return m_registration->options(); }

private:
  std::unique_ptr<internal::Arap_registration> m_registration;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TETRAHEDRAL_ARAP_REGISTRAR_3_H
