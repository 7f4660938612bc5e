// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SHAPE_DNA_3_H
#define CGAL_CANONICAL_POSE_3_SHAPE_DNA_3_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <cstddef>
#include <string>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief describes a shape by the eigenvalues of its Laplacian.

It contains the first 30 positive eigenvalues \f$ \lambda_k \f$ at unit area, divided by \f$ 4 \pi k \f$, to which
they tend for large \f$ k \f$ (M. Reuter et al., "Laplace-Beltrami spectra as 'Shape-DNA' of surfaces and solids",
2006). It is intrinsic, as `Heat_kernel_quantiles_3`, and a simple reference for it.

If the library was built without Spectra, components of more than 300 vertices lead to `std::runtime_error`.

\cgalModels `ShapeDescriptor_3`

\sa `shape_descriptor()`, `Descriptor_index_3`
*/
class Shape_dna_3
{
public:
  /// returns the name, under which values are stored.
  static std::string name() { return "shape-dna"; }

  /// returns the version: values of different versions cannot be compared.
  static int version() { return 1; }

  /// returns the number of values.
  static std::size_t size() { return EIGENVALUES; }

  /*!
  describes a shape.

  \param points \f$ n \times 3 \f$, positions.
  \param polygons sequences of rows of `points`.

  \throws std::invalid_argument if a coordinate is not finite, a polygon has an invalid row, or no face
          has an area.

  <em>Complexity:</em> \f$ O(n \log n) \f$; surfaces of more than 5000 vertices are simplified.
  */
  Eigen::VectorXd operator()(const Point_matrix& points, const Face_list& polygons) const;

  /// returns the shape distances of `query` to the columns of `others`: Euclidean ones.
  static Eigen::VectorXd distances(const Eigen::VectorXd& query,
                                   const Eigen::Ref<const Eigen::MatrixXd>& others)
  {
    return (others.colwise() - query).colwise().norm().transpose();
  }

private:
  static constexpr Eigen::Index EIGENVALUES = 30;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SHAPE_DNA_3_H
