// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_WAVEFRONT_GEODESICS_3_H
#define CGAL_CANONICAL_POSE_3_WAVEFRONT_GEODESICS_3_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/wavefront/Wavefront_solver.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <type_traits>
#include <vector>

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

Nothing is factored, and no matrix is stored: for one source, it takes less time than
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

\tparam TriangleMesh a model of `FaceListGraph`, oriented and 2-manifold, with or without boundary,
        with any number of connected components and isolated vertices
\tparam VertexPointMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `Traits::Point_3` as
        value type.<br> <b>%Default:</b> `boost::property_map<TriangleMesh,
        CGAL::vertex_point_t>::%const_type`
\tparam Traits a model of `CanonicalPoseTraits_3`.<br> <b>%Default:</b> the kernel of the points of
        `VertexPointMap`

\cgalModels `GeodesicDistances_3`

\sa `CGAL::Canonical_pose_3::Heat_geodesics_3`
\sa `CGAL::Canonical_pose_3::Exact_geodesics_3`
\sa `CGAL::Canonical_pose_3::farthest_point_landmarks()`
*/
template <class TriangleMesh, class VertexPointMap = Default, class Traits = Default>
class Wavefront_geodesics_3
{
  using Default_point_map = typename boost::property_map<TriangleMesh, vertex_point_t>::const_type;
  using Point_map = typename Default::Get<VertexPointMap, Default_point_map>::type;
  using Geometry =
    typename Default::Lazy_get<Traits, internal::Lazy_kernel_of_point_map<Point_map>>::type;
  using Row_map = internal::Vertex_number_map<TriangleMesh>;

public:
  /// \name Types
  /// @{

  /// the mesh type
  using Triangle_mesh = TriangleMesh;

  /// the vertex type
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// the property map of its points
  using Vertex_point_map = Point_map;

  /// the traits
  using Geom_traits = Geometry;

  /// @}

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
  Wavefront_geodesics_3(const TriangleMesh& tmesh, Point_map vertex_point_map,
                        const Geometry& traits = Geometry())
    : m_tmesh(&tmesh), m_rows(internal::number_vertices(tmesh)),
      m_points(point_matrix(tmesh, vertex_point_map, traits)),
      m_solver(internal::face_corners(tmesh, m_rows), m_points)
  {}

  /// \cond SKIP_IN_MANUAL
  explicit Wavefront_geodesics_3(const TriangleMesh&&) = delete;
  Wavefront_geodesics_3(const TriangleMesh&&, Point_map, const Geometry& = Geometry()) = delete;
  /// \endcond

  Wavefront_geodesics_3(const Wavefront_geodesics_3&) = delete;
  Wavefront_geodesics_3& operator=(const Wavefront_geodesics_3&) = delete;
  /// moves; the source may only be assigned to or destroyed afterwards.
  Wavefront_geodesics_3(Wavefront_geodesics_3&&) = default;
  /// moves, see above.
  Wavefront_geodesics_3& operator=(Wavefront_geodesics_3&&) = default;

  /// @}

  /// \name Queries
  /// All queries may be called from several threads at once.
  /// @{

  /// returns the mesh.
  const TriangleMesh& triangle_mesh() const { return *m_tmesh; }

  /// returns the points that the distances were computed with, one row per vertex.
  const Point_matrix& points() const { return m_points; }

  /*!
  returns the index of `v` in the range `vertices(tmesh)`, its row in the results.
  \pre `v` is a vertex of the mesh.
  */
  std::size_t index(vertex_descriptor v) const
  {
    CGAL_precondition(v != boost::graph_traits<TriangleMesh>::null_vertex());
    return get(m_rows, v);
  }

  /*!
  returns the distances from `source` to all vertices.

  \returns one number per vertex, in the unit of the points: 0 at `source`, positive or 0 elsewhere,
           `+infinity` at vertices of other connected components; never NaN
  \pre `source` is a vertex of the mesh.

  <em>Complexity:</em> \f$ O(n \log n) \f$ in practice, with 250 bytes of temporary memory per
  vertex.
  */
  Eigen::VectorXd distances(vertex_descriptor source) const
  {
    return m_solver.distances({static_cast<int>(index(source))});
  }

  /*!
  returns the distances from each of `sources` to all vertices; in parallel, if
  the library was built with TBB.

  \tparam VertexRange a range of vertex descriptors
  \param sources the sources, possibly with repetitions
  \returns one row per vertex and one column per source; each column is bitwise equal to
         `distances(source)`
  \pre All of `sources` are vertices of the mesh.

  <em>Complexity:</em> the time of a single query per source, and the memory of one per thread.
  */
  template <class VertexRange,
            std::enable_if_t<!std::is_convertible<VertexRange, vertex_descriptor>::value, int> = 0>
  Eigen::MatrixXd distances(const VertexRange& sources) const
  {
    return m_solver.distances(rows(sources));
  }

  /*!
  returns the distances from all vertices to the nearest of `sources`, in the time of a single
  query.

  \tparam VertexRange a range of vertex descriptors
  \param sources the sources, possibly with repetitions
  \returns one number per vertex, like `distances(source)`: 0 at all sources, `+infinity` at
         vertices that are not connected to any source; up to approximation errors, the row-wise
         minimum of `distances(sources)`
  \pre All of `sources` are vertices of the mesh.
  */
  template <class VertexRange>
  Eigen::VectorXd distance_to_nearest(const VertexRange& sources) const
  {
    return m_solver.distance_to_nearest(rows(sources));
  }

  /*!
  writes the distances from `source` to all vertices to a property map.

  \tparam VertexDistanceMap a model of `WritablePropertyMap` with `vertex_descriptor` as key type
          and a value type to which `double` converts
  \pre `source` is a vertex of the mesh.
  */
  template <class VertexDistanceMap>
  void distances(vertex_descriptor source, VertexDistanceMap vertex_distance_map) const
  {
    const Eigen::VectorXd values = distances(source);
    for(vertex_descriptor v : vertices(*m_tmesh))
      put(vertex_distance_map, v, values[static_cast<Eigen::Index>(index(v))]);
  }

  /// @}

private:
  template <class VertexRange>
  std::vector<int> rows(const VertexRange& sources) const
  {
    std::vector<int> result;
    for(vertex_descriptor v : sources)
      result.push_back(static_cast<int>(index(v)));
    return result;
  }

  const TriangleMesh* m_tmesh;
  Row_map m_rows;
  Point_matrix m_points;
  internal::Wavefront_solver m_solver;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_WAVEFRONT_GEODESICS_3_H
