// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shape_spectrum.h"

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Heat_kernel_quantiles_3.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {
namespace heat_kernel {

// Divides by a power of the scale of the first eigenvalues.
inline Eigen::ArrayXd normalized(const Eigen::VectorXd& eigenvalues)
{
  constexpr double exponent = .75, usual_mean = 5;
  constexpr Eigen::Index most_used = 15;
  const Eigen::Index used = (std::min)(most_used, eigenvalues.size());
  if(used == 0)
    return eigenvalues;
  const double mean = eigenvalues.head(used).array().log().mean();
  return eigenvalues.array() / std::exp(exponent * (mean - usual_mean));
}

inline double time_of(const Eigen::Index i, const Eigen::Index number_of_times)
{
  const double first = 4 * std::log(10.) / 2000, last = 4 * std::log(10.) / 12;
  return first * std::pow(last / first, static_cast<double>(i) / (number_of_times - 1));
}

// The quantiles .05, .15 ... of values with weights that sum to 1.
inline Eigen::VectorXd quantiles(const Eigen::VectorXd& values, const Eigen::VectorXd& weights,
                                 const Eigen::Index number)
{
  std::vector<Eigen::Index> order(static_cast<std::size_t>(values.size()));
  std::iota(order.begin(), order.end(), Eigen::Index(0));
  std::sort(order.begin(), order.end(), [&](const Eigen::Index a, const Eigen::Index b) {
    return values[a] != values[b] ? values[a] < values[b] : a < b;
  });
  Eigen::VectorXd result(number);
  double sum = 0;
  Eigen::Index next = 0;
  for(const Eigen::Index v : order)
  {
    sum += weights[v];
    while(next < number && sum >= (static_cast<double>(next) + .5) / static_cast<double>(number))
      result[next++] = values[v];
  }
  for(; next < number; ++next) // rounding errors of the sum
    result[next] = values[order.back()];
  return result;
}

} // namespace heat_kernel
} // namespace internal

Eigen::VectorXd Heat_kernel_quantiles_3::operator()(const Point_matrix& points,
                                                    const Face_list& polygons) const
{
  constexpr Eigen::Index number_of_eigenfunctions = 100;
  const internal::Shape_spectrum spectrum(points, polygons, number_of_eigenfunctions - 1);
  const Eigen::ArrayXd eigenvalues = internal::heat_kernel::normalized(spectrum.eigenvalues());
  const Eigen::MatrixXd squares = spectrum.eigenfunctions().cwiseAbs2();
  Eigen::VectorXd result(TIMES * QUANTILES);
  for(Eigen::Index i = 0; i < TIMES; ++i)
  {
    const Eigen::VectorXd heat
      = spectrum.squared_constants()
        + squares * (-internal::heat_kernel::time_of(i, TIMES) * eigenvalues).exp().matrix();
    result.segment(i * QUANTILES, QUANTILES)
      = internal::heat_kernel::quantiles(heat.array().log1p().matrix(), spectrum.mass(), QUANTILES);
  }
  return result;
}

} // namespace Canonical_pose_3
} // namespace CGAL
