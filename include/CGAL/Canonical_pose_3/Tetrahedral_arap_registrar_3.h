// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TETRAHEDRAL_ARAP_REGISTRAR_3_H
#define CGAL_CANONICAL_POSE_3_TETRAHEDRAL_ARAP_REGISTRAR_3_H

#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Registration_summary.h>
#include <CGAL/Canonical_pose_3/internal/body/Body_view.h>
#include <CGAL/Canonical_pose_3/internal/energy/default_rotation_routines.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/registration/Arap_registration.h>
#include <CGAL/Canonical_pose_3/internal/registration/Registration_constraint_base.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>

#include <Eigen/Core>

#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief pulls an elastic body towards a target of its surface while it keeps the details.

It minimizes
\f[ E(v) = \sum_i m_i |(Bv)_i - \hat v_i|^2 / L^2 + \ell^2 \sum_t w_t \|F_t - R_t\|^2
           + E_{constraints} / L^2 \f]
by local and global steps in turn \cgalCite{cgal:canonical-sa-asap-07},
\cgalCite{cgal:canonical-s-sdacm-15} (Equations 4 to 13). Here \f$ v \f$ are the body vertices,
\f$ Bv \f$ the surface, \f$ \hat v \f$ the target, \f$ m \f$ the matching weights and \f$ w \f$ the
cell weights (each with sum 1), \f$ F_t \f$ is the deformation gradient of cell \f$ t \f$ and
\f$ R_t \f$ the rotation closest to it, always of determinant 1. The global step has the matrix
\f[ A = \ell^2 L^2 \sum_t w_t G_t^t G_t + (1 + \beta) B^t M B + A_{constraints}, \f]
which is factored once; where constraints on few vertices are added, changed or removed afterwards,
the old factor stays in use with a low-rank update. The steps of earlier iterations correct those that
it gives, by limited-memory BFGS \cgalCite{cgal:canonical-lbk-qnm-17}; where the corrected step does
not lower the energy as it should, the plain one is taken. All lengths are divided by \f$ L \f$, hence neither
units nor resolution matter. Without fairing the energy never rises. Iterations stop by the
inequalities of `Registration_options`.

\tparam ElasticBody a model of `ElasticBody_3`
\tparam ClosestRotationTraits a model of CGAL's `DeformationClosestRotationTraits_3`. By default the
        rotations are found in closed form, for eight cells at once, with 12 digits; by a singular
        value decomposition where the form is ill-conditioned.
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
  /*!
  constructs a registrar, without target. Body and weights are measured and checked here, the matrix
  is factored by `factor()` or at first need.

  \param body the body, not a temporary one; it must outlive the registrar.
  \param matching_weights \f$ n \f$ non-negative weights of the surface vertices; divided by their
         sum. Vertices of weight 0 have no target.
  \param length_scale \f$ L \f$, usually the largest geodesic distance. Positive.
  \param options the knobs.
  \param stiffness positive factors of the cell weights \f$ w \f$, one per cell, or none. A factor
         \f$ c \f$ everywhere is the same as a detail length \f$ \sqrt c \f$ times as large.

  \pre `matching_weights.size() == body.embedding().rows()`

  \throws std::invalid_argument if a weight, a factor or an option is out of its bounds, or a connected
         component of the body carries no surface vertex of positive weight (the matrix would be
         singular); the message names the element.

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

  /// adds a constraint, not a temporary one, which must outlive the registrar or be removed before it ends. What it asks for
  /// may change between calls of `register_to_target()`. What does not change its matrix costs nothing;
  /// what does costs a solve per element concerned, or a factorization if there are more than 32.
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

  /// removes a constraint; costs as much as a change of its matrix.
  /// \pre `constraint` was added and not removed since.
  template <class Constraint>
  void remove_constraint(const Constraint& constraint)
  {
    m_registration->remove_constraint(&constraint);
  }

  /// sets the target \f$ \hat v \f$ (\f$ n \times 3 \f$); no factorization is needed.
  /// \pre The number of rows is that of the surface vertices.
  /// \throws std::invalid_argument if a coordinate is not finite.
  void set_target(const Point_matrix& target) { m_registration->set_target(target); }

  /// factors the matrix, or updates its factor, unless that has been done for the present constraints.
  /// \throws std::runtime_error if the matrix is not positive definite to working precision.
  void factor() { m_registration->factor(); }

  /*!
  runs the iteration.

  \param body_points \f$ N \times 3 \f$. If it has no row the iteration starts at the target: a body
         vertex that is a surface vertex starts where its target is, all others where the system
         without rotations puts them. Otherwise it starts from these positions (warm start). On
         return the result, unless the summary says that it is not usable; then it is left as it
         was, and so it is when something is thrown.
  \param visitor a model of `RegistrationVisitor_3` that is called after each iteration and may
         stop it, or none.

  \returns the outcome; energies per iteration, inverted cells and volume included.

  \pre `set_target()` was called, and `body_points` has no row or as many as the body.

  \throws std::runtime_error see `factor()`; and whatever the visitor throws.

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

  /// changes the cap on the number of iterations; no factorization is needed. Not negative.
  void set_number_of_iterations(const int number_of_iterations)
  {
    m_registration->set_number_of_iterations(number_of_iterations);
  }

  /// changes `Registration_options::detail_length`. The next registration factors its matrix anew; what was made of
  /// the body stays.
  /// \throws std::invalid_argument if it is not positive and finite.
  void set_detail_length(const double detail_length)
  {
    m_registration->set_detail_length(detail_length);
  }

  /// returns the options.
  const Registration_options& options() const { return m_registration->options(); }

private:
  std::unique_ptr<internal::Arap_registration> m_registration;
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TETRAHEDRAL_ARAP_REGISTRAR_3_H
