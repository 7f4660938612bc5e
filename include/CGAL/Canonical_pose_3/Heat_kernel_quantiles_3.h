// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_HEAT_KERNEL_QUANTILES_3_H
#define CGAL_CANONICAL_POSE_3_HEAT_KERNEL_QUANTILES_3_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief describes a shape by how much heat remains at its points.

The heat kernel signature \f$ h(x,t) = \sum_k e^{-\lambda_k t} \phi_k(x)^2 \f$ (J. Sun et al., "A concise and provably
informative multi-scale signature based on heat diffusion", 2009), of the first 100 eigenvalues and
eigenfunctions of the Laplacian at unit area, is computed at 16 times. The descriptor contains ten
quantiles, by area, of \f$ \log(1 + h) \f$ for each of them. It is intrinsic: it depends on the
shape only by its lengths, so all poses of a shape have nearly the same values, and no pose is needed.

The eigenvalues are divided by \f$ \exp(\frac34(m - 5)) \f$, where \f$ m \f$ is the mean of the logarithms of the first
15 of them, which makes up for differences in area between similar shapes.

If the library was built without Spectra, components of more than 396 vertices lead to `std::runtime_error`.

\cgalModels `ShapeDescriptor_3`

\sa `shape_descriptor()`, `Descriptor_index_3`
*/
class Heat_kernel_quantiles_3
{
public:
  /// returns the name, under which values are stored.
  static std::string name() { return "heat-kernel-quantiles"; }

  /// returns the version: values of different versions cannot be compared.
  static int version() { return 1; }

  /// returns the number of values.
  static std::size_t size() { return TIMES * QUANTILES; }

  /*!
  describes a shape.

  \param points \f$ n \times 3 \f$, positions.
  \param polygons sequences of rows of `points`.

  \throws std::invalid_argument if a coordinate is not finite, a polygon has an invalid row, or no face
          has an area.

  <em>Complexity:</em> \f$ O(n \log n) \f$; surfaces of more than 5000 vertices are simplified.
  */
  Eigen::VectorXd operator()(const Point_matrix& points, const Face_list& polygons) const;

  /// returns the shape distances of `query` to the columns of `others`: sums of absolute differences.
  static Eigen::VectorXd distances(const Eigen::VectorXd& query,
                                   const Eigen::Ref<const Eigen::MatrixXd>& others)
  {
    return (others.colwise() - query).cwiseAbs().colwise().sum().transpose();
  }

private:
  static constexpr Eigen::Index TIMES = 16, QUANTILES = 10;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_HEAT_KERNEL_QUANTILES_3_H
