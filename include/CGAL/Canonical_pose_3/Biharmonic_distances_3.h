// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BIHARMONIC_DISTANCES_3_H
#define CGAL_CANONICAL_POSE_3_BIHARMONIC_DISTANCES_3_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Biharmonic_embedding.h>
#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
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

\brief The class `Biharmonic_distances_3` computes biharmonic distances on a triangle mesh
\cgalCite{cgal:canonical-lrf-bd-10}.

Let \f$ \lambda_k \f$ and \f$ \varphi_k \f$ be the positive eigenvalues and the orthonormal
eigenfunctions of the Laplacian of the surface. The distance between \f$ x \f$ and \f$ y \f$ is the
square root of \f$ \sum_k (\varphi_k(x) - \varphi_k(y))^2 / \lambda_k^2 \f$. It has the unit of
length, is a metric, and is smooth; it depends on all paths between two points, not only on the
shortest. It is not a geodesic distance: it grows more slowly, and differs by a factor that depends
on the shape.

It is sensitive to false contacts, too. If a hand and a leg of the articulated figure are joined by
a bridge one face wide, in five poses, distances change by 9 to 17 percent (root mean square), and
geodesic distances by 10 to 16 percent.

The sum is truncated after `number_of_eigenfunctions` terms; the truncation error of the squared
distance is about \f$ A / (8 \pi^2 k) \f$ for the area \f$ A \f$ and \f$ k \f$ terms. The Laplacian
is that of the intrinsic Delaunay triangulation, see `Heat_geodesics_3`.

<em>Units and determinism.</em> As for `Heat_geodesics_3`.

If the library was built without Spectra, components of more than 300 vertices, and of more than four
per eigenfunction, lead to `std::runtime_error`.

\tparam TriangleMesh a model of `FaceListGraph`, oriented and 2-manifold, with or without boundary,
        with any number of connected components and isolated vertices
\tparam VertexPointMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `Traits::Point_3` as
        value type.<br> <b>%Default:</b> `boost::property_map<TriangleMesh,
        CGAL::vertex_point_t>::%const_type`
\tparam Traits a model of `CanonicalPoseTraits_3`.<br> <b>%Default:</b> the kernel of the points of
        `VertexPointMap`
\tparam FactorTraits a model of `SparseLinearAlgebraWithBlockFactorTraits_d`.<br>
        <b>%Default:</b> `Default_factor_traits_d`

\cgalModels `GeodesicDistances_3`

\sa `CGAL::Canonical_pose_3::Heat_geodesics_3`
*/
template <class TriangleMesh, class VertexPointMap = Default, class Traits = Default,
          class FactorTraits = Default>
class Biharmonic_distances_3
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
  Biharmonic_distances_3(const TriangleMesh& tmesh, Point_map vertex_point_map,
                         const std::size_t number_of_eigenfunctions = 100,
                         const Geometry& traits = Geometry())
    : m_tmesh(&tmesh), m_rows(internal::number_vertices(tmesh)),
      m_points(point_matrix(tmesh, vertex_point_map, traits)),
      m_embedding(internal::biharmonic_embedding(internal::face_corners(tmesh, m_rows), m_points,
                                                 number_of_eigenfunctions,
                                                 internal::make_factor<FactorTraits>))
  {}

  /// \cond SKIP_IN_MANUAL
  explicit Biharmonic_distances_3(const TriangleMesh&&, std::size_t = 100) = delete;
  Biharmonic_distances_3(const TriangleMesh&&, Point_map, std::size_t = 100,
                         const Geometry& = Geometry())
    = delete;
  /// \endcond

  Biharmonic_distances_3(const Biharmonic_distances_3&) = delete;
  Biharmonic_distances_3& operator=(const Biharmonic_distances_3&) = delete;
  /// moves; the source may only be assigned to or destroyed afterwards.
  Biharmonic_distances_3(Biharmonic_distances_3&&) = default;
  /// moves, see above.
  Biharmonic_distances_3& operator=(Biharmonic_distances_3&&) = default;

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

  <em>Complexity:</em> \f$ O(n k) \f$.
  */
  Eigen::VectorXd distances(vertex_descriptor source) const
  {
    return m_embedding.distances(index(source));
  }

  /*!
  returns the distances from each of `sources` to all vertices.

  \tparam VertexRange a range of vertex descriptors
  \param sources the sources, possibly with repetitions
  \returns one row per vertex and one column per source; each column is bitwise equal to
         `distances(source)`
  \pre All of `sources` are vertices of the mesh.

  <em>Complexity:</em> \f$ O(n k) \f$ per source.
  */
  template <class VertexRange,
            std::enable_if_t<!std::is_convertible<VertexRange, vertex_descriptor>::value, int> = 0>
  Eigen::MatrixXd distances(const VertexRange& sources) const
  {
    const std::vector<vertex_descriptor> all(sources.begin(), sources.end());
    Eigen::MatrixXd result(m_points.rows(), static_cast<Eigen::Index>(all.size()));
    for(std::size_t k = 0; k < all.size(); ++k)
      result.col(static_cast<Eigen::Index>(k)) = distances(all[k]);
    return result;
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
  const TriangleMesh* m_tmesh;
  Row_map m_rows;
  Point_matrix m_points;
  internal::Biharmonic_embedding m_embedding;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_BIHARMONIC_DISTANCES_3_H
