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
  /// whether to continue. If it returns `false`, the iteration stops, and the result is the current
  /// pose. This is the best one so far, as the energy does not increase without fairing. Exceptions
  /// propagate to the caller of the registration, whose arguments are then unchanged.
  bool operator()(const CGAL::Canonical_pose_3::Registration_progress& progress);

  /// @}
};
