// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BIHARMONIC_DISTANCES_3_H
#define CGAL_CANONICAL_POSE_3_BIHARMONIC_DISTANCES_3_H

#include <CGAL/Canonical_pose_3/Mesh_distances_3.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Distance_solver.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>
#include <CGAL/boost/graph/properties.h>

#include <cstddef>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Biharmonic_distances_3` computes biharmonic distances on a triangle mesh
\cgalCite{cgal:canonical-lrf-bd-10}.

Let \f$ \lambda_k \f$ and \f$ \varphi_k \f$ be the positive eigenvalues and the orthonormal
eigenfunctions of the Laplacian of the surface. The distance between \f$ x \f$ and \f$ y \f$ is the
square root of \f$ \sum_k (\varphi_k(x) - \varphi_k(y))^2 / \lambda_k^2 \f$. It has the unit of
length, is a metric, and is smooth; it depends on all paths between two points, not only on the
shortest. It is not a geodesic distance: it grows more slowly, and differs by a factor that depends
on the shape.

It is also sensitive to false contacts. If a hand and a leg of the articulated figure are joined by
a bridge one face wide, in five poses, distances change by 9 to 17 percent (root mean square), and
geodesic distances by 10 to 16 percent.

The sum is truncated after `number_of_eigenfunctions` terms; the truncation error of the squared
distance is about \f$ A / (8 \pi^2 k) \f$ for the area \f$ A \f$ and \f$ k \f$ terms. The Laplacian
is that of the intrinsic Delaunay triangulation, see `Heat_geodesics_3`. A query takes \f$ O(nk) \f$.

<em>Units and determinism.</em> As for `Heat_geodesics_3`.

If the library was built without Spectra, components of more than 300 vertices, and of more than four
per eigenfunction, lead to `std::runtime_error`.

\tparam TriangleMesh, VertexPointMap, Traits see `Mesh_distances_3`, which has the queries
\tparam FactorTraits a model of `SparseLinearAlgebraWithBlockFactorTraits_d`.<br>
        <b>%Default:</b> `Default_factor_traits_d`

\cgalModels `GeodesicDistances_3`

\sa `CGAL::Canonical_pose_3::Heat_geodesics_3`
*/
template <class TriangleMesh, class VertexPointMap = Default, class Traits = Default,
          class FactorTraits = Default>
class Biharmonic_distances_3 : public Mesh_distances_3<TriangleMesh, VertexPointMap, Traits>
{
  using Base = Mesh_distances_3<TriangleMesh, VertexPointMap, Traits>;

public:
  using typename Base::Geom_traits;
  using typename Base::Vertex_point_map;

  /// \name Construction
  /// @{

  /*!
  computes the eigenfunctions, with the points of the internal property map `vertex_point` of the
  mesh.
  */
  explicit Biharmonic_distances_3(const TriangleMesh& tmesh,
                                  const std::size_t number_of_eigenfunctions = 100)
    : Biharmonic_distances_3(tmesh, get(vertex_point, tmesh), number_of_eigenfunctions)
  {}

  /*!
  computes the eigenfunctions of each connected component.

  \param tmesh the mesh, not a temporary. It must outlive this object and keep its vertices. Its
         points are only read by the constructor: moving them later has no effect.
  \param vertex_point_map the point of each vertex, in any unit
  \param number_of_eigenfunctions per component; at most the number of its vertices
  \param traits reads the coordinates of the points

  \throws std::invalid_argument if the mesh has no face, or no face with an area, or a face that is
         not a triangle, or a vertex with a non-finite coordinate, or the number is 0. The message
         states the index of the face or vertex.
  \throws std::runtime_error if the Laplacian cannot be factored (out of memory), or the eigensolver
         fails

  <em>Complexity:</em> for \f$ n \f$ vertices and \f$ k \f$ eigenfunctions, one factorization,
  \f$ O(k) \f$ solves and \f$ O(n k^2) \f$ operations; memory \f$ O(n (k + \log n)) \f$.
  */
  Biharmonic_distances_3(const TriangleMesh& tmesh, Vertex_point_map vertex_point_map,
                         const std::size_t number_of_eigenfunctions = 100,
                         const Geom_traits& traits = Geom_traits())
    : Base(tmesh, vertex_point_map, traits,
           [&](const internal::Face_corners& corners, const Point_matrix& points) {
             return internal::make_biharmonic_solver(corners, points, number_of_eigenfunctions,
                                                     internal::make_factor<FactorTraits>);
           })
  {}

  /// \cond SKIP_IN_MANUAL
  explicit Biharmonic_distances_3(const TriangleMesh&&, std::size_t = 100) = delete;
  Biharmonic_distances_3(const TriangleMesh&&, Vertex_point_map, std::size_t = 100,
                         const Geom_traits& = Geom_traits())
    = delete;
  /// \endcond

  /// @}
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_BIHARMONIC_DISTANCES_3_H
