// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Component_spectra.h"

#include <CGAL/Canonical_pose_3/internal/intrinsic/Biharmonic_embedding.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

Eigen::VectorXd Biharmonic_embedding::distances(const std::size_t source) const
{
  Eigen::VectorXd result(vectors.rows());
  for_each_block(component.size(),
                 [&](std::size_t, const std::size_t begin, const std::size_t end) {
                   for(std::size_t i = begin; i < end; ++i)
                     result[static_cast<Eigen::Index>(i)]
                       = component[i] != component[source]
                           ? (std::numeric_limits<double>::infinity)()
                           : std::ldexp((vectors.row(static_cast<Eigen::Index>(i))
                                         - vectors.row(static_cast<Eigen::Index>(source)))
                                          .norm(),
                                        exponent);
                 });
  return result;
}

Biharmonic_embedding biharmonic_embedding(const Face_corners& corners, const Point_matrix& points,
                                          const std::size_t number_of_eigenfunctions,
                                          const Factor_maker factor_maker)
{
  if(number_of_eigenfunctions == 0)
    throw std::invalid_argument("the number of eigenfunctions is 0");
  const Delaunay_surface surface(corners, points);
  Biharmonic_embedding result;
  result.exponent = surface.exponent();
  result.component = surface.components().of_vertices();
  const auto count
    = static_cast<Eigen::Index>((std::min)(number_of_eigenfunctions, result.component.size()));
  const Component_spectra spectra(surface, count, factor_maker);
  const Eigen::Index n = spectra.mass().size();
  result.vectors.setZero(n, (std::min)(count, n));
  for(const auto& [vertices, spectrum] : spectra.components())
    for(std::size_t i = 0; i < vertices.size(); ++i)
      result.vectors.row(vertices[i]).head(spectrum.eigenvalues().size())
        = spectrum.eigenfunctions()
            .row(static_cast<Eigen::Index>(i))
            .cwiseQuotient(spectrum.eigenvalues().transpose());
  return result;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
