// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_GAUSSIAN_KERNEL_H
#define CGAL_CANONICAL_POSE_3_GAUSSIAN_KERNEL_H

#include <cmath>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is the Gaussian affinity \f$ k(g) = \exp(-g^2 / 2\sigma^2) \f$ with \f$ \sigma = L/2 \f$,
where \f$ L \f$ is the largest distance \cgalCite{cgal:canonical-s-sdacm-15}, Section 5.

If centered (the default), this is kernel principal component analysis. The affinity as printed in
the paper is not centered; its first eigenvector is then nearly constant, so the first coordinate
measures how central a point is, and the target curls up. This form is provided for reproducibility
only.

\cgalModels `MdsKernel`
*/
class Gaussian_kernel
{
public:
  /// constructs the kernel; `centered` determines whether its Gram matrix is centered.
  explicit Gaussian_kernel(const bool centered = true) : m_centered(centered) {}

  /// returns \f$ \exp(-2 r^2) \f$ for the relative distance \f$ r = g/L \f$.
  double operator()(const double relative_distance) const
  {
    return std::exp(-2 * relative_distance * relative_distance);
  }

  /// returns whether the Gram matrix is centered.
  bool is_centered() const { return m_centered; }

  /// returns `"gaussian"` or `"gaussian-uncentred"`.
  const char* name() const { return m_centered ? "gaussian" : "gaussian-uncentred"; }

private:
  bool m_centered;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_GAUSSIAN_KERNEL_H
