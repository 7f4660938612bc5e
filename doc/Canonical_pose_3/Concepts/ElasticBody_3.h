/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `ElasticBody_3` describes what a registration deforms: tetrahedra at rest, and how a
surface is embedded in them.

Each of the \f$ n \f$ surface vertices is a combination of the \f$ N \f$ body vertices, a row of the
matrix \f$ B \f$ that is called the *embedding* here. When the body vertices move to the rows of
\f$ v \f$, the surface moves to \f$ Bv \f$. Body and surface may share their vertices (identity
rows), the body may have further ones inside, or the surface may be embedded in tetrahedra that know
nothing of its triangles.

The registrar keeps references to what these functions return: it must stay where it is, and
unchanged, as long as the registrar lives.

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

  /// returns the cells, four different rows of `points()` each, in either orientation. No cell is
  /// without volume. Cells need not fit together: they may overlap, and a face may belong to any
  /// number of them (to two at most where fairing is requested).
  const std::vector<std::array<int, 4>>& cells() const;

  /// returns the weights of the cells, positive numbers with sum 1; usually the shares in the rest
  /// volume.
  const Eigen::VectorXd& cell_weights() const;

  /// returns the rest volume, in the cubed unit of the points.
  double volume() const;

  /// returns \f$ B \f$, \f$ n \times N \f$. The entries of a row sum to 1. Each connected component
  /// of the cells carries a surface vertex, that is, a row with an entry other than 0 at one of its
  /// vertices.
  const Eigen::SparseMatrix<double>& embedding() const;

  /// @}
};
