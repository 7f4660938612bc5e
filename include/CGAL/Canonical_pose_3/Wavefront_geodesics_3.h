// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_WAVEFRONT_GEODESICS_3_H
#define CGAL_CANONICAL_POSE_3_WAVEFRONT_GEODESICS_3_H

#include <CGAL/Canonical_pose_3/Mesh_distances_3.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Distance_solver.h>

#include <CGAL/Default.h>
#include <CGAL/boost/graph/properties.h>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Wavefront_geodesics_3` computes geodesic distances on a triangle mesh by
propagating a wave over the faces, each of which is unfolded into the plane of the previous one.

Instead of the windows of exact methods, it keeps virtual sources, like
\cgalCite{cgal:canonical-tbk-gdcvsp-21}, but a bounded number of them per edge: up to three at a
time, each for a part of the edge, and only if they yield the shortest paths to one of four points
of the edge. If a corner is in the way, the path bends there.

A query takes \f$ O(n \log n) \f$ in practice, also for the distances from the nearest of several
sources, with 250 bytes of temporary memory per vertex and thread. Nothing is factored, and no matrix is stored: for one source, it takes less time than
`Heat_geodesics_3`, including the constructor, and a quarter of the memory. For more than two to
four sources on the same mesh, the heat method is faster.

<em>Accuracy.</em> The distance is the length of a path on the surface, hence up to rounding never
less than that of the shortest path. There is one exception: in flat regions with holes, a source
that sees both endpoints of an edge is assumed to see the entire edge, even if a hole smaller than
the edge is in the way; in experiments with holes at random positions, distances were at most 0.4
percent too short. The distance is too long if the path found bends at a corner that the shortest
path passes at some distance. On meshes of animals and people, the mean error was 0.006 to 0.017
percent and the largest 1.2 percent; on a coarse torus of 600 vertices, the mean was 0.2 percent. In
convex planar regions, and on developable surfaces rolled up from them, distances are exact up to
rounding. They are not exactly symmetric.

<em>Triangulation.</em> The wave runs on the intrinsic Delaunay triangulation of the same surface
\cgalCite{cgal:canonical-fsbs-aicid-07}, so long thin faces do no harm. Nearly degenerate faces are
mollified by adding a tiny number, at most 1e-10 times the mean edge length, to the lengths of all
edges of their component \cgalCite{cgal:canonical-sc-lntm-20}; distances are then too large by this
amount per edge.

<em>Units and determinism.</em> Any unit can be used. Multiplying all coordinates by a power of two
multiplies all distances by it, bit by bit. Distances depend neither on the number of threads, nor
on the other sources of a batch, nor on the type of the mesh if vertices and faces are in the same
order.

\tparam TriangleMesh, VertexPointMap, Traits see `Mesh_distances_3`, which has the queries

\cgalModels `GeodesicDistances_3`

\sa `CGAL::Canonical_pose_3::Heat_geodesics_3`
\sa `CGAL::Canonical_pose_3::Exact_geodesics_3`
\sa `CGAL::Canonical_pose_3::farthest_point_landmarks()`
*/
template <class TriangleMesh, class VertexPointMap = Default, class Traits = Default>
class Wavefront_geodesics_3 : public Mesh_distances_3<TriangleMesh, VertexPointMap, Traits>
{
  using Base = Mesh_distances_3<TriangleMesh, VertexPointMap, Traits>;

public:
  using typename Base::Geom_traits;
  using typename Base::Vertex_point_map;

  /// \name Construction
  /// @{

  /*!
  computes the intrinsic Delaunay triangulation, with the points of the internal property map
  `vertex_point` of the mesh.
  */
  explicit Wavefront_geodesics_3(const TriangleMesh& tmesh)
    : Wavefront_geodesics_3(tmesh, get(vertex_point, tmesh))
  {}

  /*!
  computes the intrinsic Delaunay triangulation.

  \param tmesh the mesh, not a temporary. It must outlive this object and keep its vertices. Its
         points are only read by the constructor: moving them later has no effect.
  \param vertex_point_map the point of each vertex, in any unit
  \param traits reads the coordinates of the points

  \throws std::invalid_argument if the mesh has no face, or no face with an area, or a face that is
         not a triangle, or a vertex with a non-finite coordinate. The message states the index of
         the face or vertex.

  <em>Complexity:</em> linear in practice; about 250 bytes per vertex are stored.
  */
  Wavefront_geodesics_3(const TriangleMesh& tmesh, Vertex_point_map vertex_point_map,
                        const Geom_traits& traits = Geom_traits())
    : Base(tmesh, vertex_point_map, traits, internal::make_wavefront_solver)
  {}

  /// \cond SKIP_IN_MANUAL
  explicit Wavefront_geodesics_3(const TriangleMesh&&) = delete;
  Wavefront_geodesics_3(const TriangleMesh&&, Vertex_point_map, const Geom_traits& = Geom_traits())
    = delete;
  /// \endcond

  /// @}
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_WAVEFRONT_GEODESICS_3_H
