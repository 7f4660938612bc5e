/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `SparseLinearAlgebraWithBlockFactorTraits_d` describes a direct solver for sparse
symmetric positive definite systems that factors a matrix once and solves for many right-hand sides,
one or a block at a time.

It refines CGAL's concept in three ways: it supports blocks, it reports matrices that are not
positive definite, and its results depend neither on the number of threads nor, for each column, on
the other columns.

Models are default constructible. They need not be copyable.

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
  using NT = unspecified_type;

  /// The vector type; `CGAL::Eigen_vector<double>` for the models of this package.
  using Vector = unspecified_type;

  /// The matrix type, constructible from an `Eigen::SparseMatrix<double>` that holds either the
  /// full symmetric matrix or its lower triangle.
  using Matrix = unspecified_type;

  /// @}

  /// \name Operations
  /// @{

  /// factors `A`, reading its lower triangle, and sets `D` to 1.
  /// \returns `false`, without printing or throwing, if `A` is not numerically positive definite
  /// \throws std::runtime_error if `A` cannot be factored for another reason: memory runs out, or the
  ///         factor is too large for the indices of the solver. It is passed on to the user.
  bool factor(const Matrix& A, NT& D);

  /// solves \f$ A x = b \f$ with the last matrix passed to `factor()`. It may be called from
  /// several threads at once.
  /// \returns `false` if the solution is not finite
  /// \pre The last call to `factor()` returned `true`.
  bool linear_solver(const Vector& b, Vector& x) const;

  /// solves \f$ A X = B \f$ with the last matrix passed to `factor()`; each column of `B` is a
  /// right-hand side, and `X` is resized to the size of `B`. The bytes of a column of `X` do not
  /// depend on the other columns or their number. It may be called from several threads at once.
  /// \returns `false` if the solution is not finite
  /// \pre The last call to `factor()` returned `true`.
  bool linear_solver(const Eigen::Ref<const Eigen::MatrixXd>& B, Eigen::MatrixXd& X) const;

  /// returns the name of the solver, for reports.
  static const char* name();

  /// @}
};
