// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_REGISTRATION_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_REGISTRATION_OPTIONS_H

#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

#include <cmath>
#include <cstddef>
#include <optional>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the parameters of `Tetrahedral_arap_registrar_3`.
*/
struct Registration_options
{
  /// the range of `detail_length`.
  static constexpr double SMALLEST_DETAIL_LENGTH = 1e-6, LARGEST_DETAIL_LENGTH = 1e3;

  /// the range of all weights and of all factors of stiffness. With larger ranges, matrices would
  /// not be positive definite in double precision.
  static constexpr double SMALLEST_WEIGHT = 1e-9, LARGEST_WEIGHT = 1e9;

  /// \name Weights
  /// @{

  /// \f$ \ell \f$, as a fraction of the length scale \f$ L \f$: features smaller than \f$ \ell L
  /// \f$ keep their shape, larger ones follow the target. From \f$ 10^{-6} \f$ to \f$ 10^3 \f$.
  double detail_length = 0.1;

  /// \f$ \beta \f$, weight of the Tikhonov term that keeps an iterate close to the previous one
  /// \cgalCite{cgal:canonical-s-sdacm-15} (Equation 11). From 0 to \f$ 10^9 \f$. It slows down
  /// convergence and rarely helps.
  double tikhonov = 0;

  /// @}

  /// \name Iteration
  /// @{

  /// maximum number of iterations. Nonnegative.
  int number_of_iterations = 500;

  /// stops when \f$ |E_{k-1} - E_k| \le \f$ `energy_tolerance`
  /// \f$ \cdot \max(E_{k-1}, 10^{-15}) \f$ and the condition of `move_tolerance` holds; the lower
  /// bound, dimensionless like \f$ E \f$, accounts for energies that are 0 up to rounding. With
  /// acceleration, this must hold in two consecutive iterations. Nonnegative.
  double energy_tolerance = 1e-5;

  /// stops when no surface vertex moves by more than `move_tolerance` \f$ \cdot L \f$ in an
  /// iteration without acceleration and the condition of `energy_tolerance` holds. Nonnegative.
  double move_tolerance = 5e-4;

  /// number of previous steps that correct a step by limited-memory BFGS
  /// \cgalCite{cgal:canonical-lbk-qnm-17}, which roughly halves the iterations; 0 for none. There
  /// is no correction with fairing or a Tikhonov term. Nonnegative.
  int acceleration_window = 5;

  /// @}

  /// \name Fairing
  /// @{

  /// number of fairing passes (Taubin \cgalCite{cgal:canonical-t-spafsd-95}: one step of \f$
  /// \lambda \f$ and one of \f$ \mu \f$, equal weights over the edges of the boundary of the body)
  /// of the copy from which the rotations are computed from the second iteration on
  /// \cgalCite{cgal:canonical-s-sdacm-15} (Section 6.2). 0 for none; with fairing, the energy may
  /// increase.
  int fairing_passes = 0;

  /// \f$ \lambda \f$ of the fairing. From \f$ -1 \f$ to 1.
  double fairing_lambda = 0.5;

  /// \f$ \mu \f$ of the fairing. From \f$ -1 \f$ to 1.
  double fairing_mu = -0.53;

  /// @}

  /// \name Inverted cells
  /// @{

  /// whether the result must not have inverted or flat cells, that is, cells whose orientation
  /// differs from that at rest, where none is flat. Such cells are untangled after the iteration,
  /// with their surroundings, by foldover-free maps \cgalCite{cgal:canonical-gkkprs-ffm-21}; then
  /// the energy is decreased with a barrier that no cell crosses. This takes at most about the time
  /// of 400 iterations; if that is not enough to minimize the energy, the registration has not
  /// converged. If there are no such cells, this option has no effect. By default, it is set unless
  /// there is fairing, as with the paper's weights.
  std::optional<bool> injective;

  /// @}

  /// returns `injective`, or its default.
  bool is_injective() const { return injective.value_or(fairing_passes == 0); }

  /*!
  sets the weights in the form of the paper \cgalCite{cgal:canonical-s-sdacm-15} (Equation 13), to
  be used with matching weights \f$ m_i = 1/n \f$.

  \param alpha \f$ \alpha \f$, in the inverse unit of length of the mesh (the paper states no unit;
         it used 100).
  \param beta \f$ \beta \f$ (the paper used 10).
  \param n number of surface vertices.
  \param volume rest volume.
  \param length_scale \f$ L \f$.
  */
  void set_paper_weights(const double alpha, const double beta, const std::size_t n,
                         const double volume, const double length_scale)
  {
    detail_length = std::sqrt(alpha * volume / static_cast<double>(n)) / length_scale;
    tikhonov = beta;
  }

  /// \throws std::invalid_argument stating the first value that is out of range.
  void check() const
  {
    internal::require_in_range("detail_length", detail_length, SMALLEST_DETAIL_LENGTH,
                               LARGEST_DETAIL_LENGTH);
    internal::require_in_range("tikhonov", tikhonov, 0, LARGEST_WEIGHT);
    internal::require_nonnegative("number_of_iterations", number_of_iterations);
    internal::require_nonnegative("energy_tolerance", energy_tolerance);
    internal::require_nonnegative("move_tolerance", move_tolerance);
    internal::require_nonnegative("acceleration_window", acceleration_window);
    internal::require_nonnegative("fairing_passes", fairing_passes);
    internal::require_in_range("fairing_lambda", fairing_lambda, -1, 1);
    internal::require_in_range("fairing_mu", fairing_mu, -1, 1);
  }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_REGISTRATION_OPTIONS_H
