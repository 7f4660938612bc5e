// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_EXACT_GEODESICS_3_H
#define CGAL_CANONICAL_POSE_3_EXACT_GEODESICS_3_H

#include <CGAL/Canonical_pose_3/internal/intrinsic/Intrinsic_triangulation.h>
#include <CGAL/Canonical_pose_3/internal/surface/Face_defect.h>
#include <CGAL/Canonical_pose_3/internal/wavefront/check_unfoldable.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/assertions.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/boost/graph/properties.h>
#include <CGAL/exceptions.h>

#include <Eigen/Core>

#include <boost/graph/graph_traits.hpp>
#include <boost/property_map/function_property_map.hpp>
#include <boost/property_map/property_map.hpp>

#include <cmath>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <queue>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Calls f, which calls CGAL's shortest paths. Converts exceptions of their assertions, if enabled.
template <class Function>
void find_shortest_paths(const Function& f)
{
  try
  {
    f();
  }
  catch(const Failure_exception& failure)
  {
    throw std::runtime_error("exact distances could not be computed: CGAL's shortest paths failed ("
                             + failure.expression() + ")");
  }
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief The class `Exact_geodesics_3` computes the lengths of shortest paths on the surface of a
triangle mesh, with `CGAL::Surface_mesh_shortest_path`.

The paths are exact, and their lengths are correct up to rounding; they are symmetric and a metric.
This class serves as reference for `Heat_geodesics_3`, and takes hundreds of times as long per
source.

<em>Thin faces.</em> If faces with a height below about 1/100 of their length form regular rows, as
in a stretched grid, the search may miss the shortest path to a vertex. If the path through one of
its neighbors is shorter than the path found, its length is returned. On such grids and tubes, down
to heights of 1e-14, no distance was too large by more than 3.2e-7 times the largest one. Thinner
faces, whose shape is dominated by rounding errors, are refused.

The mesh is copied, with points of `Exact_predicates_inexact_constructions_kernel` scaled by a power
of two; any kernel and any unit can be used.

\tparam TriangleMesh a model of `FaceListGraph` and `HalfedgeListGraph` with dynamic properties,
        as required by `CGAL::copy_face_graph()`, oriented and 2-manifold, with or without boundary,
        with any number of connected components and isolated vertices
\tparam VertexPointMap a model of `ReadablePropertyMap` with
        `boost::graph_traits<TriangleMesh>::%vertex_descriptor` as key type and `Traits::Point_3` as
        value type.<br> <b>%Default:</b> `boost::property_map<TriangleMesh,
        CGAL::vertex_point_t>::%const_type`
\tparam Traits a model of `CanonicalPoseTraits_3`.<br> <b>%Default:</b> the kernel of the points of
        `VertexPointMap`

\cgalModels `GeodesicDistances_3`

\sa `CGAL::Canonical_pose_3::Heat_geodesics_3`
*/
template <class TriangleMesh, class VertexPointMap = Default, class Traits = Default>
class Exact_geodesics_3
{
  using Default_point_map = typename boost::property_map<TriangleMesh, vertex_point_t>::const_type;
  using Point_map = typename Default::Get<VertexPointMap, Default_point_map>::type;
  using Geometry =
    typename Default::Lazy_get<Traits, internal::Lazy_kernel_of_point_map<Point_map>>::type;
  using Row_map = internal::Vertex_number_map<TriangleMesh>;

  using Kernel = Exact_predicates_inexact_constructions_kernel;
  using Copy = Surface_mesh<Kernel::Point_3>;
  using Copied_vertex = Copy::Vertex_index;
  using Shortest_path = Surface_mesh_shortest_path<Surface_mesh_shortest_path_traits<Kernel, Copy>>;

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
  Exact_geodesics_3(const TriangleMesh& tmesh, Point_map vertex_point_map,
                    const Geometry& traits = Geometry())
    : m_tmesh(&tmesh), m_rows(internal::number_vertices(tmesh)),
      m_points(point_matrix(tmesh, vertex_point_map, traits))
  {
    const internal::Face_corners corners = internal::face_corners(tmesh, m_rows);
    Point_matrix matrix = m_points;
    constexpr double far = 1e3; // by the size: there, the difference of two points is exact
    if(matrix.rows() > 0)
    {
      const Eigen::RowVector3d first = matrix.row(0);
      if(first.norm() > far * (matrix.rowwise() - first).rowwise().norm().maxCoeff())
        matrix.rowwise() -= first;
    }
    m_exponent = internal::normalize(matrix);
    std::vector<Kernel::Point_3> points;
    for(Eigen::Index i = 0; i < matrix.rows(); ++i)
      points.emplace_back(matrix(i, 0), matrix(i, 1), matrix(i, 2));
    check_faces(corners, points);
    internal::check_unfoldable(corners, matrix);
    copy(points);
  }

  /// \cond SKIP_IN_MANUAL
  explicit Exact_geodesics_3(const TriangleMesh&&) = delete;
  Exact_geodesics_3(const TriangleMesh&&, Point_map, const Geometry& = Geometry()) = delete;
  /// \endcond

  Exact_geodesics_3(const Exact_geodesics_3&) = delete;
  Exact_geodesics_3& operator=(const Exact_geodesics_3&) = delete;
  /// moves; the source may only be assigned to or destroyed afterwards.
  Exact_geodesics_3(Exact_geodesics_3&&) = default;
  /// moves, see above.
  Exact_geodesics_3& operator=(Exact_geodesics_3&&) = default;

  /// @}

  /// \name Queries
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

  <em>Complexity:</em> \f$ O(n^2 \log n) \f$ in the worst case for \f$ n \f$ vertices.
  */
  Eigen::VectorXd distances(vertex_descriptor source) const
  {
    return distance_to_nearest(std::vector<vertex_descriptor>(1, source));
  }

  /*!
  returns the distances from each of `sources` to all vertices.

  \tparam VertexRange a range of vertex descriptors
  \param sources the sources, possibly with repetitions
  \returns one row per vertex and one column per source; each column is bitwise equal to
         `distances(source)`
  \pre All of `sources` are vertices of the mesh.
  */
  template <class VertexRange,
            std::enable_if_t<!std::is_convertible<VertexRange, vertex_descriptor>::value, int> = 0>
  Eigen::MatrixXd distances(const VertexRange& sources) const
  {
    const std::vector<vertex_descriptor> all(sources.begin(), sources.end());
    Eigen::MatrixXd result(static_cast<Eigen::Index>(m_copied.size()),
                           static_cast<Eigen::Index>(all.size()));
    for(std::size_t k = 0; k < all.size(); ++k)
      result.col(static_cast<Eigen::Index>(k)) = distances(all[k]);
    return result;
  }

  /*!
  returns the lengths of the shortest paths from the nearest of `sources` to all vertices.

  \tparam VertexRange a range of vertex descriptors
  \param sources the sources, possibly with repetitions
  \returns one number per vertex, like `distances()`; `+infinity` everywhere if there is no source
  \pre All of `sources` are vertices of the mesh.

  \throws std::runtime_error if \cgal fails to find the paths

  <em>Complexity:</em> \f$ O(n^2 \log n) \f$ in the worst case, for all sources together.
  */
  template <class VertexRange>
  Eigen::VectorXd distance_to_nearest(const VertexRange& sources) const
  {
    Eigen::VectorXd result = Eigen::VectorXd::Constant(static_cast<Eigen::Index>(m_copied.size()),
                                                       (std::numeric_limits<double>::infinity)());
    std::vector<Copied_vertex> copied_sources;
    for(vertex_descriptor source : sources)
    {
      const auto row = static_cast<Eigen::Index>(index(source));
      if(result[row] != 0 && !is_isolated(row))
        copied_sources.push_back(copied(row));
      result[row] = 0;
    }
    if(!copied_sources.empty())
    {
      internal::find_shortest_paths([&] { find_distances(copied_sources, result); });
      go_by_neighbors(result);
    }
    return result.unaryExpr([this](const double d) { return std::ldexp(d, m_exponent); });
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
  using Way = std::pair<double, Copied_vertex>;

  // The unfolding divides by the heights of the faces.
  static void check_faces(const internal::Face_corners& corners,
                          const std::vector<Kernel::Point_3>& points)
  {
    if(corners.origins.empty())
      throw std::invalid_argument("the mesh is empty: it has no face");
    const auto point
      = [&](std::size_t h) { return points[static_cast<std::size_t>(corners.origins[h])]; };
    for(std::size_t h = 0; h < corners.origins.size(); h += 3)
      if(collinear(point(h), point(h + 1), point(h + 2)))
        throw internal::Face_defect(h / 3, "is degenerate");
  }

  // Writes the distances found, in the unit of the copy.
  void find_distances(const std::vector<Copied_vertex>& sources, Eigen::VectorXd& distances) const
  {
    Shortest_path paths(m_copy);
    for(const Copied_vertex source : sources)
      paths.add_source_point(source);
    for(Eigen::Index i = 0; i < distances.size(); ++i)
      if(distances[i] != 0 && !is_isolated(i))
      {
        const double distance = paths.shortest_distance_to_source_points(copied(i)).first;
        if(distance >= 0) // negative: not reached
          distances[i] = distance;
      }
  }

  // Replaces distances that exceed those through a neighbor by more than rounding errors.
  void go_by_neighbors(Eigen::VectorXd& distances) const
  {
    std::vector<Eigen::Index> row_of(m_copy.num_vertices());
    for(Eigen::Index i = 0; i < distances.size(); ++i)
      if(!is_isolated(i))
        row_of[copied(i)] = i;
    std::priority_queue<Way, std::vector<Way>, std::greater<Way>> shortened;
    const auto go_on = [&](const Copied_vertex v) {
      for(const auto h : m_copy.halfedges_around_target(m_copy.halfedge(v)))
      {
        const Copied_vertex neighbor = m_copy.source(h);
        const double way = distances[row_of[v]] + length(h);
        double& distance = distances[row_of[neighbor]];
        if(way < (1 - MOST_ROUNDING) * distance)
        {
          distance = way;
          shortened.emplace(way, neighbor);
        }
      }
    };
    for(const Copied_vertex v : m_copy.vertices())
      if(!m_copy.is_isolated(v))
        go_on(v);
    while(!shortened.empty())
    {
      const auto [way, v] = shortened.top();
      shortened.pop();
      if(way == distances[row_of[v]])
        go_on(v);
    }
  }

  double length(const Copy::Halfedge_index h) const
  {
    return std::sqrt(
      squared_distance(m_copy.point(m_copy.source(h)), m_copy.point(m_copy.target(h))));
  }

  void copy(const std::vector<Kernel::Point_3>& points)
  {
    const auto point = [&](vertex_descriptor v) { return points[index(v)]; };
    std::vector<std::pair<vertex_descriptor, Copied_vertex>> pairs;
    copy_face_graph(
      *m_tmesh, m_copy,
      parameters::vertex_point_map(boost::make_function_property_map<vertex_descriptor>(point))
        .vertex_to_vertex_output_iterator(std::back_inserter(pairs)));
    m_copied.resize(points.size());
    for(const auto& pair : pairs)
      m_copied[index(pair.first)] = pair.second;
  }

  Copied_vertex copied(Eigen::Index row) const { return m_copied[static_cast<std::size_t>(row)]; }

  bool is_isolated(Eigen::Index row) const
  {
    return copied(row) == Copy::null_vertex() || m_copy.is_isolated(copied(row));
  }

  static constexpr double MOST_ROUNDING = 1e-12;

  const TriangleMesh* m_tmesh;
  Row_map m_rows;
  Point_matrix m_points;
  int m_exponent = 0; // distances are multiplied by 2 to this power
  Copy m_copy;
  std::vector<Copied_vertex> m_copied; // of each row
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_EXACT_GEODESICS_3_H
