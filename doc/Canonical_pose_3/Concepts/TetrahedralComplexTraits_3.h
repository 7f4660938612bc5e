/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `TetrahedralComplexTraits_3` describes how to read a tetrahedral complex from an
arbitrary data structure. All functions are static; the complex is never modified.

A model is a specialization of `CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3` for the type
`Complex` of the complex:

\code{.cpp}
template <>
struct CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3<My_complex> { ... };
\endcode

Specializations are provided for the complexes of the packages Mesh_3 and Tetrahedral_remeshing, for
`CGAL::Canonical_pose_3::Indexed_tetrahedra_3`, and for selections of the cells of any of these,
`CGAL::Canonical_pose_3::Labeled_cells_3`.

\cgalHasModel `CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3`

\sa `CGAL::Canonical_pose_3::complex_body()`
\sa `CGAL::Canonical_pose_3::extract_boundary()`
*/
class TetrahedralComplexTraits_3
{
public:
  /// \name Types
  /// @{

  /// The vertex type: copyable and comparable for equality, with a specialization of `std::hash`.
  using Vertex_descriptor = unspecified_type;

  /// The point type of a model of `CanonicalPoseTraits_3`, for instance of a kernel.
  using Point_3 = unspecified_type;

  /// @}

  /// \name Operations
  /// @{

  /// returns a range of the vertices, each once and in the same order at every call: the
  /// \f$ i \f$-th vertex corresponds to row \f$ i \f$ of all matrices. For a canonical pose, each
  /// vertex must belong to a cell.
  static unspecified_type vertices(const Complex& complex);

  /// returns a range of the cells, in the same order at every call. For a cell `c` the four
  /// expressions `c[0]` to `c[3]` are its vertices, in either orientation.
  static unspecified_type cells(const Complex& complex);

  /// returns the point of `v`.
  static Point_3 point(const Complex& complex, Vertex_descriptor v);

  /// @}

  /// \name Labels
  /// @{

  /// returns a range of labels, one per cell in the order of `cells(complex)`; their type is
  /// copyable and comparable for equality. Optional: required only by
  /// `CGAL::Canonical_pose_3::Labeled_cells_3`.
  static unspecified_type labels(const Complex& complex);

  /// @}
};
