// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Component_spectra.h"

#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Distance_solver.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Maps vertex i to the vector (phi_k(i) / lambda_k)_k, component by component.
class Biharmonic_embedding final : public Distance_solver
{
public:
  Biharmonic_embedding(const Delaunay_surface& surface, const std::size_t number_of_eigenfunctions,
                       const Factor_maker factor_maker)
    : m_component(surface.components().of_vertices()), m_exponent(surface.exponent())
  {
    const auto count
      = static_cast<Eigen::Index>((std::min)(number_of_eigenfunctions, m_component.size()));
    const Component_spectra spectra(surface, count, factor_maker);
    const Eigen::Index n = spectra.mass().size();
    m_vectors.setZero(n, (std::min)(count, n));
    for(const auto& [vertices, spectrum] : spectra.components())
      for(std::size_t i = 0; i < vertices.size(); ++i)
        m_vectors.row(vertices[i]).head(spectrum.eigenvalues().size())
          = spectrum.eigenfunctions()
              .row(static_cast<Eigen::Index>(i))
              .cwiseQuotient(spectrum.eigenvalues().transpose());
  }

  Eigen::MatrixXd distances(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::MatrixXd result(m_vectors.rows(), static_cast<Eigen::Index>(sources.size()));
    for_each_block(
      m_component.size(), [&](std::size_t, const std::size_t begin, const std::size_t end) {
        for(std::size_t k = 0; k < sources.size(); ++k)
          for(auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i)
            result(i, static_cast<Eigen::Index>(k)) = distance(i, sources[k]);
      });
    return result;
  }

  Eigen::VectorXd distance_to_nearest(const std::vector<Eigen::Index>& sources) const override
  {
    Eigen::VectorXd result
      = Eigen::VectorXd::Constant(m_vectors.rows(), (std::numeric_limits<double>::infinity)());
    for(const Eigen::Index source : sources)
      result = result.cwiseMin(distances({source}).col(0));
    return result;
  }

private:
  double distance(const Eigen::Index i, const Eigen::Index j) const
  {
    return component(i) != component(j)
             ? (std::numeric_limits<double>::infinity)()
             : std::ldexp((m_vectors.row(i) - m_vectors.row(j)).norm(), m_exponent);
  }

  int component(const Eigen::Index i) const { return m_component[static_cast<std::size_t>(i)]; }

  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> m_vectors;
  std::vector<int> m_component; // of each vertex
  int m_exponent;               // distances are multiplied by 2 to this power
};

std::unique_ptr<Distance_solver> make_biharmonic_solver(const Face_corners& corners,
                                                        const Point_matrix& points,
                                                        const std::size_t number_of_eigenfunctions,
                                                        const Factor_maker factor_maker)
{
  if(number_of_eigenfunctions == 0)
    throw std::invalid_argument("the number of eigenfunctions is 0");
  return std::make_unique<Biharmonic_embedding>(Delaunay_surface(corners, points),
                                                number_of_eigenfunctions, factor_maker);
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
