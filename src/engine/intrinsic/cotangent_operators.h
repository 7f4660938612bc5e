// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_INTRINSIC_COTANGENT_OPERATORS_H
#define CANONICAL_POSE_3_ENGINE_INTRINSIC_COTANGENT_OPERATORS_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

// n: number of vertices, f: number of faces of an intrinsic triangulation.

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Lumped mass: n positive numbers, a third of the area of the faces around a vertex; they sum to
// the area. 0 at an isolated vertex.
inline Eigen::VectorXd lumped_mass(const Intrinsic_triangulation& triangulation)
{
  Eigen::VectorXd mass
    = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(triangulation.number_of_vertices()));
  for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
    mass[triangulation.origin(h)] += triangulation.twice_area(h / 3) / 6;
  return mass;
}

// Cotangent Laplacian: n x n, sparse, full symmetric, positive SEMIdefinite (the sign of -Delta);
// constants on a component are its kernel. Entry (i,j) is minus half the sum of the cotangents
// opposite to the edges between i and j: nonpositive in the interior of an intrinsic Delaunay
// triangulation. Integrated, not pointwise: u'Lu is the Dirichlet energy, the integral of
// |grad u|^2. All diagonal entries are stored, including zeros.
inline Eigen::SparseMatrix<double> cotangent_laplacian(const Intrinsic_triangulation& triangulation)
{
  const std::size_t n = triangulation.number_of_vertices();
  const auto is_taken = [&](int h) { // loops contribute nothing
    return triangulation.is_edge_representative(h)
           && triangulation.origin(h) != triangulation.target(h);
  };
  std::vector<double> weights(static_cast<std::size_t>(triangulation.number_of_halfedges()), 0.);
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(n));
  for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
    if(is_taken(h))
    {
      const double weight = 0.5 * triangulation.cotangent_sum(h);
      weights[static_cast<std::size_t>(h)] = weight;
      diagonal[triangulation.origin(h)] += weight;
      diagonal[triangulation.target(h)] += weight;
    }
  using Entry = std::pair<int, double>; // row and value
  Buckets<Entry> columns(n, [&](const auto& put) {
    for(std::size_t i = 0; i < n; ++i)
      put(i, Entry(static_cast<int>(i), diagonal[static_cast<Eigen::Index>(i)]));
    for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
      if(is_taken(h))
      {
        const int i = triangulation.origin(h), j = triangulation.target(h);
        put(static_cast<std::size_t>(i), Entry(j, -weights[static_cast<std::size_t>(h)]));
        put(static_cast<std::size_t>(j), Entry(i, -weights[static_cast<std::size_t>(h)]));
      }
  });

  Eigen::SparseMatrix<double> laplacian(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(n));
  laplacian.reserve(static_cast<Eigen::Index>(columns.values().size()));
  for(std::size_t i = 0; i < n; ++i)
  {
    const auto column = static_cast<Eigen::Index>(i);
    const auto first = columns[i].begin(), last = columns[i].end();
    std::sort(first, last);
    laplacian.startVec(column);
    double* value = nullptr;
    for(auto it = first; it != last; ++it)
      if(it != first && it->first == (it - 1)->first) // two edges with the same endpoints
        *value += it->second;
      else
        *(value = &laplacian.insertBack(it->first, column)) = it->second;
  }
  laplacian.finalize();
  return laplacian;
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_INTRINSIC_COTANGENT_OPERATORS_H
