/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `GeodesicDistances_3` describes an oracle for distances on a surface: constructed once
for a mesh, it returns the distances from any vertex to all vertices. Distances may be measured
along the surface, exactly or approximately, or be any other function that is nonnegative, and 0 at
the source.

In all results, row `i` corresponds to the `i`-th vertex of the range `vertices(tmesh)` of the mesh.
Distances are in the unit of the points. They are `+infinity` between vertices that are not
connected, and never NaN. Models need not be copyable.

\cgalHasModel `CGAL::Canonical_pose_3::Heat_geodesics_3`
\cgalHasModel `CGAL::Canonical_pose_3::Wavefront_geodesics_3`
\cgalHasModel `CGAL::Canonical_pose_3::Exact_geodesics_3`
\cgalHasModel `CGAL::Canonical_pose_3::Biharmonic_distances_3`

\sa `CGAL::Canonical_pose_3::farthest_point_landmarks()`
\sa `CGAL::Canonical_pose_3::front_landmarks()`
*/
class GeodesicDistances_3
{
public:
  /// \name Types
  /// @{

  /// The mesh, a model of `VertexListGraph`.
  using Triangle_mesh = unspecified_type;

  /// The vertex type, `boost::graph_traits<Triangle_mesh>::%vertex_descriptor`.
  using vertex_descriptor = unspecified_type;

  /// @}

  /// \name Operations
  /// @{

  /// returns the mesh.
  const Triangle_mesh& triangle_mesh() const;

  /// returns the index of `v` in the range `vertices(triangle_mesh())`.
  /// \pre `v` is a vertex of the mesh.
  std::size_t index(vertex_descriptor v) const;

  /// returns the distances from `source` to all vertices: one number per vertex, 0 at `source`.
  /// \pre `source` is a vertex of the mesh.
  Eigen::VectorXd distances(vertex_descriptor source) const;

  /// returns the distances from each of `sources` to all vertices: one row per vertex, one column
  /// per source, each bitwise equal to `distances(source)`.
  /// \tparam VertexRange a range of vertex descriptors
  /// \pre All of `sources` are vertices of the mesh.
  template <class VertexRange>
  Eigen::MatrixXd distances(const VertexRange& sources) const;

  /// writes the distances from `source` to all vertices to a property map.
  /// \tparam VertexDistanceMap a model of `WritablePropertyMap` with `vertex_descriptor` as key
  ///         type and a value type to which `double` converts
  /// \pre `source` is a vertex of the mesh.
  template <class VertexDistanceMap>
  void distances(vertex_descriptor source, VertexDistanceMap vertex_distance_map) const;

  /// @}
};
