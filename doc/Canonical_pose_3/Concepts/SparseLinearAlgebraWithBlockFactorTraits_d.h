/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `SparseLinearAlgebraWithBlockFactorTraits_d` describes a direct solver for sparse
symmetric positive definite systems that is factored once and asked for many right-hand sides, one
or a block at a time.

It refines CGAL's concept in three ways: it takes blocks, it says no to a matrix that is not
positive definite, and its results do not depend on the number of threads, nor a column on the
others.

\cgalRefines `SparseLinearAlgebraWithFactorTraits_d`

\cgalHasModel `CGAL::Canonical_pose_3::Cholmod_factor_traits_d`
\cgalHasModel `CGAL::Canonical_pose_3::Eigen_factor_traits_d`

\sa `CGAL::Canonical_pose_3::Default_factor_traits_d`
*/
class SparseLinearAlgebraWithBlockFactorTraits_d
{
public:
  /// \name Types
  /// @{

  /// The number type, `double`.
  typedef unspecified_type NT;

  /// The vector type; `CGAL::Eigen_vector<double>` for the models of this package.
  typedef unspecified_type Vector;

  /// The matrix type, which is constructible from an `Eigen::SparseMatrix<double>`, either full
  /// symmetric or lower triangular.
  typedef unspecified_type Matrix;

  /// @}

  /// \name Operations
  /// @{

  /// factors `A`, reading its lower triangle, and sets `D` to 1.
  /// \returns `false`, without printing or throwing, if `A` is not numerically positive definite
  bool factor(const Matrix& A, NT& D);

  /// solves \f$ A x = b \f$ with the last matrix given to `factor()`. It may be called from several
  /// threads at once.
  /// \returns `false` if the solution is not finite
  /// \pre The last call to `factor()` returned `true`.
  bool linear_solver(const Vector& b, Vector& x) const;

  /// solves \f$ A X = B \f$ with the last matrix given to `factor()`; a column of `B` is a
  /// right-hand side, and `X` is resized to the size of `B`. A column of `X` has the same bytes
  /// whatever the other columns are, and however many. It may be called from several threads at
  /// once.
  /// \returns `false` if the solution is not finite
  /// \pre The last call to `factor()` returned `true`.
  bool linear_solver(const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::MatrixXd& X) const;

  /// returns the name of the solver, for reports.
  static const char* name();

  /// @}
};
