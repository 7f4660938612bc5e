// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MESH_DISTANCES_3_H
#define CGAL_CANONICAL_POSE_3_MESH_DISTANCES_3_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Distance_solver.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/properties.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <memory>
#include <type_traits>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Mesh_distances_3` is the base of the classes that compute distances on a surface,
`Heat_geodesics_3`, `Wavefront_geodesics_3`, `Exact_geodesics_3` and `Biharmonic_distances_3`: it has
their queries.

All queries can be called from several threads at the same time.

\tparam TriangleMesh a model of `FaceListGraph`, oriented and 2-manifold, with or without boundary,
        with any number of connected components and isolated vertices
\tparam VertexPointMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `Traits::Point_3` as
        value type.<br> <b>%Default:</b> `boost::property_map<TriangleMesh,
        CGAL::vertex_point_t>::%const_type`
\tparam Traits a model of `CanonicalPoseTraits_3`.<br> <b>%Default:</b> the kernel of the points of
        `VertexPointMap`

\cgalModels `GeodesicDistances_3`
*/
template <class TriangleMesh, class VertexPointMap = Default, class Traits = Default>
class Mesh_distances_3
{
  using Default_point_map = typename boost::property_map<TriangleMesh, vertex_point_t>::const_type;
  using Point_map = typename Default::Get<VertexPointMap, Default_point_map>::type;

public:
  /// \name Types
  /// @{

  /// the mesh
  using Triangle_mesh = TriangleMesh;

  /// its vertices
  using vertex_descriptor = typename boost::graph_traits<TriangleMesh>::vertex_descriptor;

  /// the property map of its points
  using Vertex_point_map = Point_map;

  /// the traits
  using Geom_traits =
    typename Default::Lazy_get<Traits, internal::Lazy_kernel_of_point_map<Point_map>>::type;

  /// @}

  /// \name Queries
  /// @{

  /// returns the mesh.
  const TriangleMesh& triangle_mesh() const { return *m_tmesh; }

  /// returns the points that the distances are computed with, one row per vertex.
  const Point_matrix& points() const { return m_points; }

  /*!
  returns the row of `v` in the results: its index in the range `vertices(tmesh)`.
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
  */
  Eigen::VectorXd distances(vertex_descriptor source) const
  {
    return m_solver->distance_to_nearest({static_cast<Eigen::Index>(index(source))});
  }

  /*!
  returns the distances from each of `sources` to all vertices, independently of the other sources;
  in parallel if the library was built with TBB.

  \tparam VertexRange a range of vertex descriptors
  \param sources the sources, which may repeat
  \returns one row per vertex and one column per source, bit for bit as `distances(source)`
  \pre All of `sources` are vertices of the mesh.
  */
  template <class VertexRange,
            std::enable_if_t<!std::is_convertible<VertexRange, vertex_descriptor>::value, int> = 0>
  Eigen::MatrixXd distances(const VertexRange& sources) const
  {
    return m_solver->distances(rows(sources));
  }

  /*!
  returns the distances from the nearest of `sources` to all vertices: up to the error of the
  distances, the smallest of those from each of them.

  \tparam VertexRange a range of vertex descriptors
  \param sources the sources, which may repeat
  \returns one number per vertex, as `distances()` does; `+infinity` everywhere if there is no source
  \pre All of `sources` are vertices of the mesh.
  */
  template <class VertexRange>
  Eigen::VectorXd distance_to_nearest(const VertexRange& sources) const
  {
    return m_solver->distance_to_nearest(rows(sources));
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

  Mesh_distances_3(const Mesh_distances_3&) = delete;
  Mesh_distances_3& operator=(const Mesh_distances_3&) = delete;
  /// moves; the source may only be assigned to or destroyed afterwards.
  Mesh_distances_3(Mesh_distances_3&&) = default;
  /// moves, see above.
  Mesh_distances_3& operator=(Mesh_distances_3&&) = default;

protected:
  /// \cond SKIP_IN_MANUAL
  // `make_solver(corners, points)` returns a `std::unique_ptr` to a `Distance_solver`.
  template <class MakeSolver>
  Mesh_distances_3(const TriangleMesh& tmesh, const Point_map& vertex_point_map,
                   const Geom_traits& traits, const MakeSolver& make_solver)
    : m_tmesh(&tmesh), m_rows(internal::number_vertices(tmesh)),
      m_points(point_matrix(tmesh, vertex_point_map, traits)),
      m_solver(make_solver(internal::face_corners(tmesh, m_rows), m_points))
  {}

  ~Mesh_distances_3() = default;

  const internal::Distance_solver& solver() const { return *m_solver; }
  /// \endcond

private:
  template <class VertexRange>
  std::vector<Eigen::Index> rows(const VertexRange& sources) const
  {
    std::vector<Eigen::Index> result;
    for(vertex_descriptor v : sources)
      result.push_back(static_cast<Eigen::Index>(index(v)));
    return result;
  }

  const TriangleMesh* m_tmesh;
  internal::Vertex_number_map<TriangleMesh> m_rows;
  Point_matrix m_points;
  std::unique_ptr<internal::Distance_solver> m_solver;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MESH_DISTANCES_3_H
