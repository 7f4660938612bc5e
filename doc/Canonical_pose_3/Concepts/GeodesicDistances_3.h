/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `GeodesicDistances_3` describes an oracle for distances on a surface: built once for a
mesh, it answers how far all vertices are from any vertex. It may measure them along the surface,
exactly or not, or be anything else that is 0 at the source and not negative.

In all results, row `i` is the `i`-th vertex of the range `vertices(tmesh)` of the mesh. Distances
are in the unit of the points. Between vertices that are not connected they are `+infinity`; they
are never NaN.

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
  typedef unspecified_type Triangle_mesh;

  /// Its vertices, `boost::graph_traits<Triangle_mesh>::%vertex_descriptor`.
  typedef unspecified_type vertex_descriptor;

  /// @}

  /// \name Operations
  /// @{

  /// returns the mesh.
  const Triangle_mesh& triangle_mesh() const;

  /// returns the row of `v`, its number in the range `vertices(triangle_mesh())`.
  /// \pre `v` is a vertex of the mesh.
  std::size_t index(vertex_descriptor v) const;

  /// returns the distances from `source` to all vertices: one number per vertex, 0 at `source`.
  /// \pre `source` is a vertex of the mesh.
  Eigen::VectorXd distances(vertex_descriptor source) const;

  /// returns the distances from each of `sources`, taken alone, to all vertices: one row per
  /// vertex, one column per source, equal to `distances(source)` to the last bit.
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
