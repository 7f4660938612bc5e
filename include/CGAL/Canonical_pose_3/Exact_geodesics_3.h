// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EXACT_GEODESICS_3_H
#define CGAL_CANONICAL_POSE_3_EXACT_GEODESICS_3_H

#include <CGAL/Canonical_pose_3/Mesh_distances_3.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Distance_solver.h>

#include <CGAL/Default.h>
#include <CGAL/boost/graph/properties.h>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Exact_geodesics_3` computes the lengths of shortest paths on the surface of a
triangle mesh, with `CGAL::Surface_mesh_shortest_path`.

The paths are exact, and their lengths are correct up to rounding; they are symmetric and a metric.
This class serves as reference for `Heat_geodesics_3`, and takes hundreds of times as long per
source: \f$ O(n^2 \log n) \f$ in the worst case, also for the distances from the nearest of several
sources. If CGAL fails to find the paths, queries throw `std::runtime_error`.

<em>Thin faces.</em> If faces with a height below about 1/100 of their length form regular rows, as
in a stretched grid, the search may miss the shortest path to a vertex. If the path through one of
its neighbors is shorter than the path found, its length is returned. On such grids and tubes, down
to heights of 1e-14, no distance was too large by more than 3.2e-7 times the largest one. Thinner
faces, whose shape is dominated by rounding errors, are refused.

The mesh is copied, with points of `Exact_predicates_inexact_constructions_kernel` scaled by a power
of two; any kernel and any unit can be used.

\tparam TriangleMesh, VertexPointMap, Traits see `Mesh_distances_3`, which has the queries

\cgalModels `GeodesicDistances_3`

\sa `CGAL::Canonical_pose_3::Heat_geodesics_3`
*/
template <class TriangleMesh, class VertexPointMap = Default, class Traits = Default>
class Exact_geodesics_3 : public Mesh_distances_3<TriangleMesh, VertexPointMap, Traits>
{
  using Base = Mesh_distances_3<TriangleMesh, VertexPointMap, Traits>;

public:
  using typename Base::Geom_traits;
  using typename Base::Vertex_point_map;

  /// \name Construction
  /// @{

  /*!
  copies the mesh, with the points of its internal property map `vertex_point`.
  */
  explicit Exact_geodesics_3(const TriangleMesh& tmesh)
    : Exact_geodesics_3(tmesh, get(vertex_point, tmesh))
  {}

  /*!
  copies the mesh.

  \param tmesh the mesh, not a temporary. It must outlive this object and keep its vertices. Its
         points are only read by the constructor: moving them later has no effect.
  \param vertex_point_map the point of each vertex, in any unit
  \param traits reads the coordinates of the points

  \throws std::invalid_argument if the mesh has no face, or a face that is not a triangle or has no
          area, or whose height is less than 1e-14 times its longest edge, or whose edges are
          shorter than 1e-14 times the connected component or 1e-60 times the largest coordinate, or
          a vertex with a non-finite coordinate. The message states the index of the face or vertex.

  <em>Complexity:</em> linear.
  */
  Exact_geodesics_3(const TriangleMesh& tmesh, Vertex_point_map vertex_point_map,
                    const Geom_traits& traits = Geom_traits())
    : Base(tmesh, vertex_point_map, traits, internal::make_exact_solver)
  {}

  /// \cond SKIP_IN_MANUAL
  explicit Exact_geodesics_3(const TriangleMesh&&) = delete;
  Exact_geodesics_3(const TriangleMesh&&, Vertex_point_map, const Geom_traits& = Geom_traits())
    = delete;
  /// \endcond

  /// @}
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_EXACT_GEODESICS_3_H
