// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_DESCRIPTORS_ZERNIKE_BASIS_H
#define CANONICAL_POSE_3_ENGINE_DESCRIPTORS_ZERNIKE_BASIS_H

#include <CGAL/number_utils.h>

#include <Eigen/Core>

#include <cmath>
#include <complex>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The Zernike polynomials of order 0 to 14 on an image, whose inscribed disk they are defined on, up
// to complex conjugates: 64 of them. The absolute value of the product of an image with one of them
// does not change when the image is rotated or mirrored. (M. Teague, "Image analysis via the general
// theory of moments", 1980.)
class Zernike_basis
{
public:
  static constexpr Eigen::Index SIZE = 64;

  // `width`: of the images, in pixels.
  explicit Zernike_basis(const Eigen::Index width)
    : m_real(Eigen::MatrixXd::Zero(SIZE, width * width)),
      m_imaginary(Eigen::MatrixXd::Zero(SIZE, width * width))
  {
    for(Eigen::Index y = 0; y < width; ++y)
      for(Eigen::Index x = 0; x < width; ++x)
        evaluate(center(x, width), center(y, width), width, y * width + x);
  }

  // The position of a pixel, between -1 and 1.
  static double center(const Eigen::Index pixel, const Eigen::Index width)
  {
    return (2. * static_cast<double>(pixel) + 1) / static_cast<double>(width) - 1;
  }

  // `images`: a column each, row by row. Returns a column each.
  Eigen::MatrixXd magnitudes(const Eigen::MatrixXd& images) const
  {
    return ((m_real * images).array().square() + (m_imaginary * images).array().square()).sqrt();
  }

private:
  static constexpr int ORDER = 14;

  void evaluate(const double x, const double y, const Eigen::Index width, const Eigen::Index pixel)
  {
    const double radius = std::hypot(x, y), angle = std::atan2(y, x);
    if(radius > 1)
      return;
    const double area = 4 / static_cast<double>(width * width);
    Eigen::Index row = 0;
    for(int n = 0; n <= ORDER; ++n)
      for(int m = n % 2; m <= n; m += 2, ++row)
      {
        const std::complex<double> value
          = (n + 1) / CGAL_PI * area * std::polar(radial(n, m, radius), -m * angle);
        m_real(row, pixel) = value.real();
        m_imaginary(row, pixel) = value.imag();
      }
  }

  static double radial(const int n, const int m, const double radius)
  {
    double result = 0;
    for(int s = 0; s <= (n - m) / 2; ++s)
    {
      const double term = std::tgamma(n - s + 1.)
                          / (std::tgamma(s + 1.) * std::tgamma((n + m) / 2 - s + 1.)
                             * std::tgamma((n - m) / 2 - s + 1.));
      result += (s % 2 == 0 ? term : -term) * std::pow(radius, n - 2 * s);
    }
    return result;
  }

  Eigen::MatrixXd m_real, m_imaginary; // a row per polynomial, a column per pixel
};

} // namespace internal

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_DESCRIPTORS_ZERNIKE_BASIS_H
