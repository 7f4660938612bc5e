/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `ShapeDescriptor_3` describes how a shape becomes a vector, such that similar shapes have
similar vectors.

The values should not depend on rigid motions, scale, the order of vertices and faces, and the
triangulation. Models are copy constructible; for `Descriptor_index_3`, also default constructible,
unless a descriptor is given.

\cgalHasModel `CGAL::Canonical_pose_3::Heat_kernel_quantiles_3`
\cgalHasModel `CGAL::Canonical_pose_3::Shape_dna_3`
\cgalHasModel `CGAL::Canonical_pose_3::Shape_distribution_d2_3`
\cgalHasModel `CGAL::Canonical_pose_3::View_descriptor_3`

\sa `CGAL::Canonical_pose_3::shape_descriptor()`
\sa `CGAL::Canonical_pose_3::Descriptor_index_3`
*/
class ShapeDescriptor_3
{
public:
  /// \name Operations
  /// @{

  /// returns the name, under which values are stored.
  std::string name() const;

  /// returns the version, which changes with the values: values of different versions cannot be
  /// compared.
  int version() const;

  /// returns the number of values.
  std::size_t size() const;

  /// describes a shape.
  /// \param points \f$ n \times 3 \f$, positions.
  /// \param polygons sequences of rows of `points`.
  Eigen::VectorXd operator()(const CGAL::Canonical_pose_3::Point_matrix& points,
                             const CGAL::Canonical_pose_3::Face_list& polygons) const;

  /// returns the shape distances of a shape to others.
  /// \param query the values of a shape.
  /// \param others the values of other shapes, a column each.
  Eigen::VectorXd distances(const Eigen::VectorXd& query,
                            const Eigen::Ref<const Eigen::MatrixXd>& others) const;

  /// @}
};
