/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `CanonicalPoseTraits_3` describes how the package reads and writes points. All
computations are done with `double`; a model says what a point is and how to get from it to three
numbers and back.

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
  typedef unspecified_type FT;

  /// The point type, copyable.
  typedef unspecified_type Point_3;

  /// Functor with `FT operator()(const Point_3& p) const`, the first Cartesian coordinate of `p`. A
  /// type that converts to `FT`, such as `const FT&`, may be returned.
  typedef unspecified_type Compute_x_3;

  /// The same for the second coordinate.
  typedef unspecified_type Compute_y_3;

  /// The same for the third coordinate.
  typedef unspecified_type Compute_z_3;

  /// Functor with `Point_3 operator()(const FT& x, const FT& y, const FT& z) const`, the point with
  /// these Cartesian coordinates.
  typedef unspecified_type Construct_point_3;

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
