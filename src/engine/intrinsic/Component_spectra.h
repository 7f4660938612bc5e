// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_INTRINSIC_COMPONENT_SPECTRA_H
#define CANONICAL_POSE_3_ENGINE_INTRINSIC_COMPONENT_SPECTRA_H

#include "cotangent_operators.h"
#include "../linear_algebra/Laplace_spectrum.h"

#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// The eigenvalues and eigenfunctions of each connected component of a surface.
class Component_spectra
{
public:
  struct Component
  {
    std::vector<Eigen::Index> vertices;
    Laplace_spectrum spectrum; // of these
  };

  // `count`: of eigenvalues, per component. Components of one vertex are ignored.
  Component_spectra(const Delaunay_surface& surface, const Eigen::Index count,
                    const Factor_maker factor_maker)
    : m_mass(lumped_mass(surface.triangulation()))
  {
    const Eigen::SparseMatrix<double> laplacian = cotangent_laplacian(surface.triangulation());
    const std::vector<int>& component = surface.components().of_vertices();
    std::vector<std::vector<Eigen::Index>> rows(
      static_cast<std::size_t>(surface.components().size()));
    std::vector<int> place_in_component;
    for(std::size_t i = 0; i < component.size(); ++i)
    {
      auto& own = rows[static_cast<std::size_t>(component[i])];
      place_in_component.push_back(static_cast<int>(own.size()));
      own.push_back(static_cast<Eigen::Index>(i));
    }
    for(const std::vector<Eigen::Index>& own : rows)
      if(own.size() > 1)
        m_components.push_back(
          {own,
           {block(laplacian, own, place_in_component), entries(m_mass, own), count, factor_maker}});
  }

  const Eigen::VectorXd& mass() const { return m_mass; } // of all vertices
  const std::vector<Component>& components() const { return m_components; }

private:
  static Eigen::VectorXd entries(const Eigen::VectorXd& all, const std::vector<Eigen::Index>& rows)
  {
    Eigen::VectorXd result(static_cast<Eigen::Index>(rows.size()));
    for(std::size_t i = 0; i < rows.size(); ++i)
      result[static_cast<Eigen::Index>(i)] = all[rows[i]];
    return result;
  }

  static Eigen::SparseMatrix<double> block(const Eigen::SparseMatrix<double>& matrix,
                                           const std::vector<Eigen::Index>& rows,
                                           const std::vector<int>& place_in_component)
  {
    const auto n = static_cast<Eigen::Index>(rows.size());
    std::vector<Eigen::Triplet<double>> triplets;
    for(std::size_t i = 0; i < rows.size(); ++i)
      for(Eigen::SparseMatrix<double>::InnerIterator it(matrix, rows[i]); it; ++it)
        triplets.emplace_back(place_in_component[static_cast<std::size_t>(it.row())],
                              static_cast<int>(i), it.value());
    Eigen::SparseMatrix<double> result(n, n);
    result.setFromTriplets(triplets.begin(), triplets.end());
    return result;
  }

  Eigen::VectorXd m_mass;
  std::vector<Component> m_components;
};

} // namespace internal

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_INTRINSIC_COMPONENT_SPECTRA_H
