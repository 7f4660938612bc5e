// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_HEAT_KERNEL_QUANTILES_3_H
#define CGAL_CANONICAL_POSE_3_HEAT_KERNEL_QUANTILES_3_H

#include <CGAL/Canonical_pose_3/internal/descriptors/Shape_spectrum.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

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

It requires the library Spectra.

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
  Eigen::VectorXd operator()(const Point_matrix& points,
                             const std::vector<std::vector<std::size_t>>& polygons) const
  {
    const internal::Shape_spectrum spectrum(points, polygons, EIGENFUNCTIONS - 1);
    const Eigen::ArrayXd eigenvalues = normalized(spectrum.eigenvalues());
    const Eigen::MatrixXd squares = spectrum.eigenfunctions().cwiseAbs2();
    Eigen::VectorXd result(TIMES * QUANTILES);
    for(Eigen::Index i = 0; i < TIMES; ++i)
    {
      const Eigen::VectorXd heat
        = spectrum.squared_constants() + squares * (-time(i) * eigenvalues).exp().matrix();
      result.segment(i * QUANTILES, QUANTILES)
        = quantiles(heat.array().log1p().matrix(), spectrum.mass());
    }
    return result;
  }

  /// returns the distances of `query` to the columns of `others`: sums of absolute differences.
  static Eigen::VectorXd distances(const Eigen::VectorXd& query,
                                   const Eigen::Ref<const Eigen::MatrixXd>& others)
  {
    return (others.colwise() - query).cwiseAbs().colwise().sum().transpose();
  }

private:
  static constexpr Eigen::Index EIGENFUNCTIONS = 100, TIMES = 16, QUANTILES = 10;

  // Divides by a power of the scale of the first eigenvalues.
  static Eigen::ArrayXd normalized(const Eigen::VectorXd& eigenvalues)
  {
    constexpr double exponent = .75, usual_mean = 5;
    constexpr Eigen::Index most_used = 15;
    const Eigen::Index used = (std::min)(most_used, eigenvalues.size());
    if(used == 0)
      return eigenvalues;
    const double mean = eigenvalues.head(used).array().log().mean();
    return eigenvalues.array() / std::exp(exponent * (mean - usual_mean));
  }

  static double time(const Eigen::Index i)
  {
    const double first = 4 * std::log(10.) / 2000, last = 4 * std::log(10.) / 12;
    return first * std::pow(last / first, static_cast<double>(i) / (TIMES - 1));
  }

  // The quantiles .05, .15 ... of values with weights that sum to 1.
  static Eigen::VectorXd quantiles(const Eigen::VectorXd& values, const Eigen::VectorXd& weights)
  {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
    std::iota(order.begin(), order.end(), Eigen::Index(0));
    std::sort(order.begin(), order.end(), [&](const Eigen::Index a, const Eigen::Index b) {
      return values[a] != values[b] ? values[a] < values[b] : a < b;
    });
    Eigen::VectorXd result(QUANTILES);
    double sum = 0;
    Eigen::Index next = 0;
    for(const Eigen::Index v : order)
    {
      sum += weights[v];
      while(next < QUANTILES && sum >= (static_cast<double>(next) + .5) / QUANTILES)
        result[next++] = values[v];
    }
    for(; next < QUANTILES; ++next) // rounding errors of the sum
      result[next] = values[order.back()];
    return result;
  }
};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_HEAT_KERNEL_QUANTILES_3_H
