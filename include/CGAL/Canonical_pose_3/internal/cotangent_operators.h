// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_INTERNAL_COTANGENT_OPERATORS_H
#define CGAL_CANONICAL_POSE_3_INTERNAL_COTANGENT_OPERATORS_H

#include <CGAL/Canonical_pose_3/internal/Intrinsic_triangulation.h>

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

// n: number of vertices, f: number of faces of an intrinsic triangulation.

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Lumped mass: n positive numbers, a third of the area of the faces around a vertex; they sum to
// the area. 0 at a vertex without face.
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
// opposite to the edges between i and j: not positive inside an intrinsic Delaunay triangulation.
// Integrated, not pointwise: u'Lu is the Dirichlet energy, the integral of |grad u|^2.
// All diagonal entries are stored, also those that are 0.
inline Eigen::SparseMatrix<double> cotangent_laplacian(const Intrinsic_triangulation& triangulation)
{
  const auto n = static_cast<Eigen::Index>(triangulation.number_of_vertices());
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(static_cast<std::size_t>(2 * triangulation.number_of_halfedges() + n));
  Eigen::VectorXd diagonal = Eigen::VectorXd::Zero(n);
  for(int h = 0; h < triangulation.number_of_halfedges(); ++h)
  {
    const int i = triangulation.origin(h), j = triangulation.target(h);
    if(!triangulation.is_edge_representative(h) || i == j)
      continue; // an edge from a vertex to itself sees no difference
    const double weight = 0.5 * triangulation.cotangent_sum(h);
    entries.emplace_back(i, j, -weight);
    entries.emplace_back(j, i, -weight);
    diagonal[i] += weight;
    diagonal[j] += weight;
  }
  for(Eigen::Index i = 0; i < n; ++i)
    entries.emplace_back(static_cast<int>(i), static_cast<int>(i), diagonal[i]);
  Eigen::SparseMatrix<double> laplacian(n, n);
  laplacian.setFromTriplets(entries.begin(), entries.end());
  return laplacian;
}

// Gradient and divergence, face by face in the plane of the face: its first corner at the origin,
// its first side along the first axis.
class Gradient_field
{
public:
  Gradient_field() = default;

  explicit Gradient_field(const Intrinsic_triangulation& triangulation)
  {
    m_faces.reserve(static_cast<std::size_t>(triangulation.number_of_faces()));
    for(int h = 0; h < triangulation.number_of_halfedges(); h += 3)
    {
      const auto [x, y] = triangulation.apex(h);
      m_faces.push_back(
        {{triangulation.origin(h), triangulation.origin(h + 1), triangulation.origin(h + 2)},
         triangulation.length(h),
         x,
         y});
    }
  }

  // Gradient of the linear function with values `values` (n numbers) at the corners of face `f`.
  Eigen::Vector2d gradient(std::size_t f, const Eigen::Ref<const Eigen::VectorXd>& values) const
  {
    const Face& face = m_faces[f];
    const double along = (values[face.corners[1]] - values[face.corners[0]]) / face.base;
    return {along, ((values[face.corners[2]] - values[face.corners[0]]) - along * face.x) / face.y};
  }

  // Adds to `result` (n numbers) the integral of the gradients of the hat functions times `field`,
  // over face `f`. Summed over the faces with the gradients of u as field it is Lu, L the cotangent
  // Laplacian; it is minus the integrated divergence, and sums to 0 over each component.
  void add_divergence(std::size_t f, const Eigen::Vector2d& field,
                      Eigen::Ref<Eigen::VectorXd> result) const
  {
    const Face& face = m_faces[f];
    const double second = 0.5 * (face.y * field[0] - face.x * field[1]);
    const double third = 0.5 * face.base * field[1];
    result[face.corners[0]] -= second + third;
    result[face.corners[1]] += second;
    result[face.corners[2]] += third;
  }

  // Turns values of u (n numbers) into the right-hand side L phi = b of the function phi whose
  // gradient is closest to -grad u / |grad u| (faces with constant u pull nowhere).
  Eigen::VectorXd divergence_of_unit_descent(const Eigen::Ref<const Eigen::VectorXd>& u) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Zero(u.size());
    for(std::size_t f = 0; f < m_faces.size(); ++f)
    {
      Eigen::Vector2d descent = -gradient(f, u);
      // far from the source the squares of the gradients underflow, the gradients do not
      const double largest = (std::max)(std::abs(descent[0]), std::abs(descent[1]));
      if(!(largest > 0))
        continue;
      descent /= largest;
      add_divergence(f, descent / std::sqrt(descent.squaredNorm()), result);
    }
    return result;
  }

private:
  struct Face
  {
    std::array<int, 3> corners;
    double base, x, y; // corners at (0,0), (base,0), (x,y)
  };
  std::vector<Face> m_faces;
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_INTERNAL_COTANGENT_OPERATORS_H
