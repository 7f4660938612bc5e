/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `TetrahedralComplexTraits_3` describes how to read a tetrahedral complex, whatever data
structure holds it. All functions are static; nothing is ever written to the complex.

A model is a specialization of `CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3` for the type
`Complex` of the complex:

\code{.cpp}
template <>
struct CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3<My_complex> { ... };
\endcode

The class template is specialized already for the complexes of the packages Mesh_3 and
Tetrahedral_remeshing, for `CGAL::Canonical_pose_3::Indexed_tetrahedra_3`, and for selections of the
cells of any of these, `CGAL::Canonical_pose_3::Labeled_cells_3`.

\cgalHasModel `CGAL::Canonical_pose_3::Tetrahedral_complex_traits_3`

\sa `CGAL::Canonical_pose_3::complex_body()`
\sa `CGAL::Canonical_pose_3::extract_boundary()`
*/
class TetrahedralComplexTraits_3
{
public:
  /// \name Types
  /// @{

  /// The vertices: copyable and comparable for equality, with a specialization of `std::hash`.
  typedef unspecified_type Vertex_descriptor;

  /// The points, of a kernel or of a model of `CanonicalPoseTraits_3`.
  typedef unspecified_type Point_3;

  /// @}

  /// \name Operations
  /// @{

  /// returns a range of the vertices, each once and in the same order at every call: the
  /// \f$ i \f$-th one is row \f$ i \f$ of all matrices. For a canonical pose each of them must
  /// belong to a cell.
  static unspecified_type vertices(const Complex& complex);

  /// returns a range of the cells, in the same order at every call. For a cell `c` the four
  /// expressions `c[0]` to `c[3]` are its vertices, in either orientation.
  static unspecified_type cells(const Complex& complex);

  /// returns the point of `v`.
  static Point_3 point(const Complex& complex, Vertex_descriptor v);

  /// @}

  /// \name Labels
  /// @{

  /// returns a range of labels, one per cell in the order of `cells(complex)`; their type is copyable and
  /// comparable for equality. Optional: only `CGAL::Canonical_pose_3::Labeled_cells_3` asks for it.
  static unspecified_type labels(const Complex& complex);

  /// @}
};
