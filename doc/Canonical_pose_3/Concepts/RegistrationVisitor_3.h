/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `RegistrationVisitor_3` describes a function object that monitors a registration and may
stop it.

Visitors are copied. A visitor that stores data for later use should hold a reference to it, or be
passed as `std::ref(visitor)`.

\cgalRefines `CopyConstructible`

\cgalHasModel `CGAL::Canonical_pose_3::Registration_visitor`, and any lambda expression with this
signature

\sa `CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3::register_to_target()`
\sa `CGAL::Canonical_pose_3::Options::visitor`
*/
class RegistrationVisitor_3
{
public:
  /// \name Operations
  /// @{

  /// is called once after each iteration, in the thread that runs the registration, and returns
  /// whether to continue. If it returns `false`, the iteration stops, and the result is the best pose
  /// so far.
  ///
  /// In `CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3`, this is the iterate with the least
  /// energy; without fairing, the last one, since the energy does not increase. In
  /// `CGAL::canonical_pose_3()`, it is that with the least energy with respect to the target of the
  /// result, the last one, and with the detail length of the options, also in a round, whose own
  /// energies are for half of it. So as long as the target is the same, the result of canceling
  /// later never has a higher energy. A new round or a scaled target starts anew: energies for different
  /// targets cannot be compared; those of later rounds are better targets, but farther from the
  /// surface. At the end, inverted cells are untangled, if requested, which may increase the energy.
  ///
  /// No iteration follows the one after which `false` was returned.
  ///
  /// Exceptions propagate unchanged to the caller of the registration, whose arguments are then
  /// also unchanged.
  bool operator()(const CGAL::Canonical_pose_3::Registration_progress& progress);

  /// @}
};
