/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `MdsKernel` describes how multidimensional scaling turns distances into similarities.

The target builder applies a model to the distances between landmarks, centers the matrix if the
model asks for it, and takes the leading eigenvectors. A kernel ought to decrease with the distance,
and its centered matrix ought to have at least three positive eigenvalues; where there are fewer, the
target is flat. Its scale is of no importance: the target is brought back to the unit of the
distances afterwards.

Models are copy constructible. A model that is default constructible may be left out in the
constructor of the builder.

\cgalHasModel `CGAL::Canonical_pose_3::Squared_distance_kernel`
\cgalHasModel `CGAL::Canonical_pose_3::Gaussian_kernel`
\cgalHasModel `CGAL::Canonical_pose_3::Mds_kernel`

\sa `CGAL::Canonical_pose_3::Landmark_mds_target_builder_3`
*/
class MdsKernel
{
public:
  /// \name Operations
  /// @{

  /// returns the similarity of two points.
  /// \param relative_distance their distance divided by the largest one of all, a number between 0
  /// and 1.
  double operator()(double relative_distance) const;

  /// returns whether the matrix of similarities is to be centered, which makes its rows and columns
  /// sum to 0.
  bool is_centered() const;

  /// returns the name of the kernel, for reports.
  const char* name() const;

  /// @}
};
