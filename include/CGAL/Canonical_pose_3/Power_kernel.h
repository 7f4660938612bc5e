// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_POWER_KERNEL_H
#define CGAL_CANONICAL_POSE_3_POWER_KERNEL_H

#include <CGAL/Canonical_pose_3/internal/support/require_option.h>

#include <cmath>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief is the kernel of multidimensional scaling with powers of the distances,
\f$ k(r) = -r^p/2 \f$.

The exponent 2 is that of `Squared_distance_kernel`. The smaller it is, the less the target is
dominated by the largest distances.

\cgalModels `MdsKernel`
*/
class Power_kernel
{
public:
  /// constructs the kernel.
  /// \throws std::invalid_argument unless `exponent` is from 0.001 to 100.
  explicit Power_kernel(const double exponent = 1.5) : m_exponent(exponent)
  {
    internal::require_in_range("exponent", exponent, 1e-3, 100);
  }

  /// returns the exponent \f$ p \f$.
  double exponent() const { return m_exponent; }

  /// returns \f$ -r^p/2 \f$ for the relative distance \f$ r = g/L \f$.
  double operator()(const double relative_distance) const
  {
    return -0.5 * std::pow(relative_distance, m_exponent);
  }

  /// returns `true`.
  bool is_centered() const { return true; }

  /// returns `"power"`.
  const char* name() const { return "power"; }

private:
  double m_exponent;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_POWER_KERNEL_H
