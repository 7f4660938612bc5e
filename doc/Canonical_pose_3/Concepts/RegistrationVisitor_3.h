/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `RegistrationVisitor_3` describes a function object that watches a registration and may
stop it.

It is copied. A visitor that keeps something for later refers to it, or is passed as
`std::ref(visitor)`.

\cgalRefines `CopyConstructible`

\cgalHasModel `CGAL::Canonical_pose_3::Registration_visitor`, and any lambda expression of that
signature

\sa `CGAL::Canonical_pose_3::Tetrahedral_arap_registrar_3::register_to_target()`
\sa `CGAL::Canonical_pose_3::Options::visitor`
*/
class RegistrationVisitor_3
{
public:
  /// \name Operations
  /// @{

  /// is called once after each iteration, in the thread that runs the registration, and tells
  /// whether to go on. With `false` the iteration stops, and the pose that it has arrived at is the
  /// result: the best one so far, as the energy does not rise without fairing. An exception passes
  /// through to the caller of the registration, whose arguments are then as they were.
  bool operator()(const CGAL::Canonical_pose_3::Registration_progress& progress);

  /// @}
};
