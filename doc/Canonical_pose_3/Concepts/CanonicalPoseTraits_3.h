/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `CanonicalPoseTraits_3` describes how the package reads and writes points. All
computations use `double`; a model defines the point type and how to convert points from and to
three coordinates.

Models are default constructible and copy constructible.

\cgalHasModel All models of the concept `Kernel`, for instance
`CGAL::Exact_predicates_inexact_constructions_kernel`,
`CGAL::Exact_predicates_exact_constructions_kernel` and `CGAL::Simple_cartesian<float>`

\sa `CGAL::Canonical_pose_3::point_matrix()`
*/
class CanonicalPoseTraits_3
{
public:
  /// \name Types
  /// @{

  /// The type of a coordinate: `CGAL::to_double()` accepts it, and it is constructible from a
  /// `double`.
  using FT = unspecified_type;

  /// The point type, copyable.
  using Point_3 = unspecified_type;

  /// Functor with `FT operator()(const Point_3& p) const`, returning the first Cartesian coordinate
  /// of `p`. The return type may be any type that converts to `FT`, such as `const FT&`.
  using Compute_x_3 = unspecified_type;

  /// The same for the second coordinate.
  using Compute_y_3 = unspecified_type;

  /// The same for the third coordinate.
  using Compute_z_3 = unspecified_type;

  /// Functor with `Point_3 operator()(const FT& x, const FT& y, const FT& z) const`, returning the
  /// point with these Cartesian coordinates.
  using Construct_point_3 = unspecified_type;

  /// @}

  /// \name Operations
  /// @{

  /// returns the functor.
  Compute_x_3 compute_x_3_object() const;

  /// returns the functor.
  Compute_y_3 compute_y_3_object() const;

  /// returns the functor.
  Compute_z_3 compute_z_3_object() const;

  /// returns the functor.
  Construct_point_3 construct_point_3_object() const;

  /// @}
};
