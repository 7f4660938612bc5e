/*!
\ingroup PkgCanonicalPose3Concepts
\cgalConcept

The concept `MdsKernel` describes how multidimensional scaling turns distances into similarities.

The target builder applies a kernel to the distances between landmarks, centers the matrix if the
kernel requests it, and computes the leading eigenvectors. A kernel should decrease with the
distance, and its centered matrix should have at least three positive eigenvalues; otherwise, the
target is flat. The scale of the kernel does not matter, since the target is scaled to the unit of
the distances afterwards.

Models are copy constructible. If a model is default constructible, it may be omitted in the
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
  /// \param relative_distance their distance divided by the largest distance, a number between 0
  /// and 1.
  double operator()(double relative_distance) const;

  /// returns whether the matrix of similarities is to be centered, such that its rows and columns
  /// sum to 0.
  bool is_centered() const;

  /// returns the name of the kernel, for reports.
  const char* name() const;

  /// @}
};
