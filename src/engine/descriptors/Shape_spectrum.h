// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_DESCRIPTORS_SHAPE_SPECTRUM_H
#define CANONICAL_POSE_3_ENGINE_DESCRIPTORS_SHAPE_SPECTRUM_H

#include "../intrinsic/Component_spectra.h"

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Repaired_surface_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Delaunay_surface.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/repair_surface.h>

#include <Eigen/Core>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

inline Coarse_surface_3 coarse_copy(const Repaired_surface_3& repaired,
                                    const std::size_t number_of_vertices)
{
  Surface_component_3 all;
  all.points = repaired.points;
  all.triangles = repaired.triangles;
  all.face_of_triangle = repaired.face_of_triangle;
  all.origins = all.body_origins = repaired.origins;
  return coarse_surface(all, number_of_vertices);
}

// The smallest eigenvalues of the Laplacian of a shape, which may have several components, in the
// unit in which its area is 1. Shapes with many vertices are simplified.
class Shape_spectrum
{
public:
  // `polygons`: rows of `points`. `count`: at most as many positive eigenvalues.
  Shape_spectrum(const Point_matrix& points, const Face_list& polygons, const Eigen::Index count)
    : Shape_spectrum(coarse_copy(repair_surface(points, polygons), COARSE_VERTICES).surface, count)
  {}

  Shape_spectrum(const Surface_component_3& surface, const Eigen::Index count)
    : Shape_spectrum(Component_spectra(delaunay_surface(surface), count, make_default_factor),
                     count)
  {}

  const Eigen::VectorXd& mass() const { return m_mass; }               // sums to 1
  const Eigen::VectorXd& eigenvalues() const { return m_eigenvalues; } // positive, ascending
  // A column each, orthonormal with respect to the mass. Those of the eigenvalue 0, which are
  // constant on a component, are replaced by the sum of their squares.
  const Eigen::MatrixXd& eigenfunctions() const { return m_eigenfunctions; }
  const Eigen::VectorXd& squared_constants() const { return m_squared_constants; }

private:
  static constexpr std::size_t COARSE_VERTICES = 5000;

  static Delaunay_surface delaunay_surface(const Surface_component_3& surface)
  {
    const Indexed_mesh mesh = indexed_mesh(surface.points, surface.triangles);
    return Delaunay_surface(face_corners(mesh, get(vertex_index, mesh)), surface.points);
  }

  Shape_spectrum(const Component_spectra& spectra, const Eigen::Index count)
    : m_mass(spectra.mass()), m_squared_constants(Eigen::VectorXd::Zero(m_mass.size()))
  {
    const double area = m_mass.sum();
    m_mass /= area;
    std::vector<std::pair<double, std::pair<std::size_t, Eigen::Index>>> all;
    for(std::size_t c = 0; c < spectra.components().size(); ++c)
    {
      const auto& [vertices, spectrum] = spectra.components()[c];
      for(Eigen::Index k = 0; k < spectrum.eigenvalues().size(); ++k)
        all.push_back({spectrum.eigenvalues()[k], {c, k}});
      double share = 0;
      for(const Eigen::Index v : vertices)
        share += m_mass[v];
      for(const Eigen::Index v : vertices)
        m_squared_constants[v] = 1 / share;
    }
    std::sort(all.begin(), all.end());
    all.resize((std::min)(all.size(), static_cast<std::size_t>(count)));
    const auto n = static_cast<Eigen::Index>(all.size());
    m_eigenvalues.resize(n);
    m_eigenfunctions = Eigen::MatrixXd::Zero(m_mass.size(), n);
    for(Eigen::Index i = 0; i < n; ++i)
    {
      const auto& [value, place] = all[static_cast<std::size_t>(i)];
      const auto& [vertices, spectrum] = spectra.components()[place.first];
      m_eigenvalues[i] = value * area;
      for(std::size_t v = 0; v < vertices.size(); ++v)
        m_eigenfunctions(vertices[v], i)
          = std::sqrt(area) * spectrum.eigenfunctions()(static_cast<Eigen::Index>(v), place.second);
    }
  }

  Eigen::VectorXd m_mass, m_eigenvalues, m_squared_constants;
  Eigen::MatrixXd m_eigenfunctions;
};

} // namespace internal

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_DESCRIPTORS_SHAPE_SPECTRUM_H
