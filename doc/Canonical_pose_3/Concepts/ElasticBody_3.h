/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `ElasticBody_3` describes what a registration deforms: tetrahedra at rest, and the
embedding of a surface in them.

Each of the \f$ n \f$ surface vertices is a combination of the \f$ N \f$ body vertices, given by a
row of the matrix \f$ B \f$, the *embedding*. If the body vertices move to the rows of
\f$ v \f$, the surface moves to \f$ Bv \f$. Body and surface may share their vertices (rows of the
identity matrix), the body may have additional vertices inside, or the surface may be embedded in
tetrahedra that are independent of its triangles.

The registrar keeps references to the values returned by these functions: they must not be moved or
modified during the lifetime of the registrar. Models need not be copyable; those that
`CGAL::Canonical_pose_3::Elastic_body_3` is constructed from are move constructible.

\cgalHasModel `CGAL::Canonical_pose_3::Lattice_body_3`
\cgalHasModel `CGAL::Canonical_pose_3::Conforming_body_3`
\cgalHasModel `CGAL::Canonical_pose_3::Embedded_body_3`
\cgalHasModel `CGAL::Canonical_pose_3::Elastic_body_3`

\sa `CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3`
*/
class ElasticBody_3
{
public:
  /// \name Operations
  /// @{

  /// returns the rest positions of the body vertices, \f$ N \times 3 \f$, all of them finite.
  const CGAL::Canonical_pose_3::Point_matrix& points() const;

  /// returns the cells, each with four different rows of `points()`, in either orientation. Each
  /// cell has a nonzero volume. Cells need not form a mesh: they may overlap, and a face may belong
  /// to any number of them (at most two if fairing is requested).
  const std::vector<std::array<int, 4>>& cells() const;

  /// returns the weights of the cells, positive numbers that sum to 1; usually the shares of the
  /// rest volume.
  const Eigen::VectorXd& cell_weights() const;

  /// returns the rest volume, in the unit of the points cubed.
  double volume() const;

  /// returns \f$ B \f$, \f$ n \times N \f$. The entries of a row sum to 1. Each connected component
  /// of the cells contains a surface vertex, that is, some row has a nonzero entry at one of its
  /// vertices.
  const Eigen::SparseMatrix<double>& embedding() const;

  /// @}
};
