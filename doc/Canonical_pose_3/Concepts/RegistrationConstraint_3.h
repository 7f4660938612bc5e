/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `RegistrationConstraint_3` describes an additional energy term of the surface vertices,
which the registrar weighs against the target and the details.

A constraint has an energy \f$ e(x) \f$ of the \f$ n \times 3 \f$ positions \f$ x \f$ of the surface
vertices. In the global step that starts from positions \f$ \tilde x \f$, the energy is replaced by
a quadratic form
\f[ q(x) = \mathrm{tr}(x^t C x) - 2\, \mathrm{tr}(x^t D(\tilde x)) + \mathrm{const}, \f]
with a symmetric positive semidefinite matrix \f$ C \f$ that does not depend on the positions. If
\f$ q \ge e \f$ everywhere, with equality at \f$ \tilde x \f$, then the energy of the registration
never increases.

Positions are in the unit of the mesh, the energy is in its square, and \f$ C \f$ is dimensionless.
The registrar divides energies by \f$ L^2 \f$. Row \f$ i \f$ corresponds to surface vertex \f$ i \f$
of the body; the registrar transfers \f$ C \f$ and \f$ D \f$ to the body vertices.

Models need not be copyable; those that `CGAL::Canonical_pose_3::Registration_constraint_3` is
constructed from are move constructible.

\cgalHasModel `CGAL::Canonical_pose_3::Spring_constraint_adaptor_3`
\cgalHasModel `CGAL::Canonical_pose_3::Direction_constraint_adaptor_3`
\cgalHasModel `CGAL::Canonical_pose_3::Handle_constraint_adaptor_3`
\cgalHasModel `CGAL::Canonical_pose_3::Symmetry_constraint_adaptor_3`

\sa `CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3`
*/
class RegistrationConstraint_3
{
public:
  /// \name Operations
  /// @{

  /// returns a number that changes whenever \f$ C \f$ does. If it has changed at the beginning of a
  /// registration, the registrar updates its factor if \f$ C \f$ has changed in few rows, and
  /// refactors the matrix otherwise. Changes of \f$ D \f$ alone, for instance of a length, should
  /// not change the number.
  std::size_t matrix_revision() const;

  /// appends the entries of both triangles of \f$ C \f$. Duplicate entries are summed.
  void add_to_matrix(std::vector<Eigen::Triplet<double>>& matrix) const;

  /// adds \f$ D(\tilde x) \f$ to `right_hand_side`. It is called once per iteration.
  /// \param points \f$ \tilde x \f$, \f$ n \times 3 \f$.
  /// \param right_hand_side \f$ n \times 3 \f$.
  void add_to_right_hand_side(const CGAL::Canonical_pose_3::Point_matrix& points,
                              CGAL::Canonical_pose_3::Point_matrix& right_hand_side);

  /// returns \f$ e(x) \f$.
  /// \param points \f$ x \f$, \f$ n \times 3 \f$.
  double energy(const CGAL::Canonical_pose_3::Point_matrix& points) const;

  /// @}
};
