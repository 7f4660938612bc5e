// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_OPTIONS_H

#include <CGAL/Canonical_pose_3/Constraints_3.h>
#include <CGAL/Canonical_pose_3/Elastic_body_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Limb_direction_3.h>
#include <CGAL/Canonical_pose_3/Linear_solver.h>
#include <CGAL/Canonical_pose_3/Mds_kernel.h>
#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/Unfolding.h>
#include <CGAL/Canonical_pose_3/internal/support/require_option.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds what `canonical_pose_3()` computes on the way to the pose. It is part of the `Result`
and can be passed to another call as `Options::given`.

Rows correspond to the vertices in the order of `vertices(tmesh)`; for a tetrahedral complex, to
those of its boundary in the order of `extract_boundary()`. Vertices that are not on the surface of
a posed component (isolated ones, those of a cavity, or of another component) have infinite
distances, and their target is their pose. If several components are posed, there are no distances.
*/
struct Intermediate_results
{
  /// landmarks and distances to them; returned if `Options::return_landmark_fields` is set. If a
  /// vertex is split because the surface is not manifold there, the smallest distance of its copies
  /// counts. On a refined surface (`Surface_component_3::added`), the landmarks that were used are in
  /// general not vertices of the input: these distances are measured from others.
  std::optional<Landmark_fields_3> landmark_fields;

  /// \f$ n \times 3 \f$, the target in its final position in the frame of the input, also for
  /// `Method_options::Frame::CANONICAL`. A given target is neither aligned nor reflected.
  std::optional<Point_matrix> target;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the weights in the notation of the paper, see
`Registration_options::set_paper_weights()`.
*/
struct Paper_weights
{
  /// \f$ \alpha \f$, in the inverse of the mesh's unit of length. Positive, and such that the detail
  /// length that it leads to is in the range of `Registration_options::detail_length`.
  double alpha = 100;
  /// \f$ \beta \f$, from 0 to \f$ 10^9 \f$.
  double beta = 10;
};

/// \ingroup PkgCanonicalPose3Ref
/// computes landmarks and the distances to them on a connected surface, an oriented 2-manifold,
/// possibly with boundary. The arguments are its points, its triangles as triples of rows, the
/// number of landmarks (possibly larger than that of the points), the first landmark, and `landmarks`:
/// if these are not empty, the distances to them are required (other ones lead to `std::logic_error`).
/// Returns finite distances with one row per point. The surface is usually the coarse one, see
/// `Method_options::number_of_coarse_vertices`, and in each round it is in another pose.
using Landmark_fields_function = std::function<Landmark_fields_3(
  const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles,
  std::size_t number_of_landmarks, std::size_t first_landmark,
  const std::vector<std::size_t>& landmarks)>;

/// \ingroup PkgCanonicalPose3Ref
/// creates the body of a connected surface, an oriented 2-manifold, possibly with boundary. The
/// arguments are its points, its triangles as triples of rows, and distances. The surface vertices
/// of the body are the points.
using Body_function = std::function<Elastic_body_3(
  const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles,
  const Landmark_fields_3& fields)>;

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of `canonical_pose_3()` that do not refer to vertices of the input.

Distances, kernel, body and solver are selected by enumerations, or provided by the user as
functions or models of concepts.
*/
struct Method_options
{
  /// model of `GeodesicDistances_3`: `Heat_geodesics_3` or `Wavefront_geodesics_3`.
  enum class Geodesics { HEAT, WAVEFRONT };

  /// model of `MdsKernel` for the target.
  enum class Kernel { CLASSICAL, GAUSSIAN, UNCENTERED_GAUSSIAN };

  /// elastic body of a surface. `AUTOMATIC` is the lattice, see `Lattice_body_3`; the others
  /// require a surface without defects.
  enum class Body { AUTOMATIC, LATTICE, TETGEN, MESH_3 };

  /// how to handle several connected components of a surface (connected by edges) or a complex
  /// (connected by common faces).
  ///
  /// - `AUTOMATIC`: one component is posed; eyes, hair, clothes and the like follow it, see below.
  ///   If others remain, they are refused, stating their number.
  /// - `REFUSE`: several components are refused, stating their number, apart from pieces and fragments.
  /// - `LARGEST`: the largest component is posed, all others follow it, or keep their place.
  /// - `EACH`: all are posed. Their bodies share the cells of a single one by area (with many faces,
  ///   a body has more). What would get less than 2.3 % has no body: it follows the nearest one if it
  ///   is small, or keeps its place.
  ///
  /// With `AUTOMATIC`, a component follows the largest one (open ones count half) if its area is at
  /// most 5 % of that (small), or 25 % if it touches what moves with it; if a third of its area is in
  /// contact with the largest, within 5 % of its diameter; if half of it lies inside; or if it wraps a third
  /// of the largest, like a dress. But a figure under the dome of a sky, in a room, or on the ground, does
  /// not follow these: a component with more than 5 % of the diameter of the largest one, or a tenth of its
  /// triangles (and at least 200), is a shape of its own if
  /// - the largest one lies in a plane, and it does not, or
  /// - it has more than 5 % of the diameter and four times the triangles of the largest one, and less than a third
  ///   of its area is in contact, or
  /// - it is inside, half of its area is farther from the surface than 30 % of its diameter, unlike that
  ///   of an eye, and it has more than 5 % of the area, or more than 5 % of the diameter and no fewer
  ///   triangles, or floats, nowhere nearer to the surface than 15 % of the diameter of the largest one.
  ///
  /// Nor does anything follow because of contact if what does so has three times the area of the
  /// largest one in total, as in a soup of triangles: there is no main one.
  ///
  /// With `AUTOMATIC` and `LARGEST`, what is in contact or inside almost entirely, or large, and not
  /// tiny, is deformed with the body; the rest moves rigidly. With all values, pieces without area,
  /// and small fragments that are connected to another component by a vertex, follow (those of a
  /// complex are part of its body), and what moves rigidly, but is farther away than a quarter of the
  /// diameter of the largest one, keeps its place. See `Registration_summary::followers`.
  enum class Components { AUTOMATIC, REFUSE, LARGEST, EACH };

  /// how to handle handles of a surface that look like false contacts of its parts: keep them, or cut
  /// them, see `cut_contacts()`. The latter requires the lattice, or a body of `make_body`.
  enum class Contacts { KEEP, CUT };

  /// position of the result.
  /// - `AUTOMATIC`: that of `INPUT` for the canonical pose, that of `BODY` for another `Stance`, or with
  ///   `Vertex_options::limb_directions`.
  /// - `INPUT`: as near as possible to the input.
  /// - `CANONICAL`: in the `canonical_frame()` of the pose, with the areas of the input as weights, so that poses
  ///   of several shapes can be compared or shown without alignment.
  /// - `BODY`: upright, see `Skeleton_3::frame`. Only for shapes that are recognized, see `Stance`.
  enum class Frame { AUTOMATIC, INPUT, CANONICAL, BODY };

  /// which pose is computed.
  /// - `CANONICAL`: the canonical pose.
  /// - `T`, `A`, `VITRUVIAN`: a person with straight limbs: the arms level, or 45 degrees downward, and the legs
  ///   parallel, or apart for `VITRUVIAN`; feet point to the front.
  /// - `STAND`: an animal with its four legs straight downward, neck and tail at rest, and the head level.
  ///
  /// `Vertex_options::limb_directions` leads to other ones.
  ///
  /// The canonical pose tells what the limbs are: a head, two arms and two legs, or four legs. Then trunk and
  /// limbs, as long as in the input, are moved to their directions, which is the target of another registration, with all
  /// details. The head looks to the front, and the neck of a person is upright. Parts that then pass through each other are
  /// named by warnings. Other shapes are refused, stating what was found.
  enum class Stance { CANONICAL, T, A, VITRUVIAN, STAND };

  /// whether the target is made symmetric where the surface has a clear symmetry, see `symmetric_target()`: poses of one
  /// shape in several postures then differ less.
  enum class Symmetry { AUTOMATIC, NONE };

  /// how the target is computed: by multidimensional scaling of geodesic distances, see `mds_target()`, or by
  /// unfolding, without distances, see `unfolded_target()`.
  enum class Target_mode { MDS, UNFOLDING };

  /// linear solver. `AUTOMATIC` is CHOLMOD if the package was configured with it, otherwise Eigen.
  enum class Solver { AUTOMATIC, EIGEN, CHOLMOD };

  /// the least value of `lattice_spacing` but 0. How many cubes there may be depends on the shape.
  static constexpr double SMALLEST_LATTICE_SPACING = internal::SMALLEST_LATTICE_SPACING;

  /// \name Distances and landmarks
  /// @{

  /// the method for geodesic distances.
  Geodesics geodesics = Geodesics::HEAT;

  /// if set, computes the distances instead, for target, body and \f$ L \f$: the way to supply your
  /// own, for example those of `Exact_geodesics_3`, see `landmark_fields_function()`.
  Landmark_fields_function landmark_fields_function;

  /// if set, computes the distances for the target alone, in the unit of the mesh. Only for distances
  /// that are not geodesic, such as those of `Biharmonic_distances_3`: body and \f$ L \f$ are still
  /// based on the distances above.
  Landmark_fields_function target_fields_function;

  /// approximate number of vertices of the coarse surface on which distances are computed, see
  /// `coarse_surface()`; 0 for distances on the surface itself. At least four times the number of
  /// landmarks is used.
  std::size_t number_of_coarse_vertices = 5000;

  /// number of landmarks, at least 1. If it exceeds the number \f$ n \f$ of vertices, \f$ n \f$ is
  /// used, or 80 if vertices are added because there are too few of them. The number used must be at most 4096 and at most \f$ 2^{29} / n \f$.
  std::size_t number_of_landmarks = 80;

  /// if 0, the first landmark is `extremal_point()`; otherwise it is drawn with this seed. Nothing
  /// else is random.
  unsigned int random_seed = 0;

  /// @}

  /// \name Target
  /// @{

  /// the kernel.
  Kernel kernel = Kernel::CLASSICAL;

  /// if set, a model of `MdsKernel` that replaces `kernel`.
  std::optional<Mds_kernel> mds_kernel;

  /// how the target is computed.
  Target_mode target_mode = Target_mode::MDS;

  /// the parameter of the unfolding.
  Unfolding unfolding;

  /// maximum number of rounds before the final registration. In a round, the body is registered
  /// with half the detail length, and distances are measured again on this pose, where limbs are
  /// straight and distances depend less on the posture; they lead to the `refined_target()`. The
  /// default is 3; for a given target or one on a line, with `paper_weights`, with the uncentered
  /// kernel, and when unfolding, it is 0. Nonnegative.
  std::optional<int> number_of_rounds;

  /// the symmetry of the target, which needs rounds.
  Symmetry symmetry = Symmetry::AUTOMATIC;

  /// whether to choose the mirror image of the target that would be chosen otherwise, see
  /// `align_handedness()`.
  bool takes_mirror_image = false;

  /// @}

  /// \name Input and components
  /// @{

  /// whether to count self-intersections for the summary, which takes a quarter to a third of the time without it.
  /// They are no obstacle, but for bodies of TetGen and Mesh_3, which search them in any case.
  bool searches_self_intersections = false;

  /// @}

  /// \name Elastic body
  /// @{

  /// the body of a surface; a complex is its own body.
  Body body = Body::AUTOMATIC;

  /// if set, creates the body of a surface instead.
  Body_function make_body;

  /// spacing of the lattice as a fraction of \f$ L \f$, from `SMALLEST_LATTICE_SPACING` to 1, where
  /// a cube is as large as the shape; if 0, it is chosen based on the thickness of the shape.
  double lattice_spacing = 0;

  /// @}

  /// \name Input and components
  /// @{

  /// the components of a surface or a complex.
  Components components = Components::AUTOMATIC;

  /// the false contacts of a surface.
  Contacts contacts = Contacts::KEEP;

  /// @}

  /// \name Result
  /// @{

  /// which pose is computed.
  Stance stance = Stance::CANONICAL;

  /// the position of the pose and the followers. Targets, whether given or returned, and constraints
  /// refer to the frame of the input in any case; `Result::motion` leads from there to the pose.
  Frame frame = Frame::AUTOMATIC;

  /// @}

  /// \name Registration
  /// @{

  /// the options of the registration.
  Registration_options registration;

  /// if set, these replace the detail length, the Tikhonov weight and the matching weights, and, as
  /// in the paper, rotations are computed from the pose after one pass of fairing (or more, if
  /// `registration` requests more).
  std::optional<Paper_weights> paper_weights;

  /// if the volume of the pose exceeds this multiple of the rest volume, the target is scaled down
  /// and the registration is repeated: geodesics run around compact bodies, so their targets are
  /// too large. Positive. The default is 1.15; for given targets and with `paper_weights`, it is
  /// unlimited.
  std::optional<double> volume_ratio_limit;

  /// @}

  /// \name Solver, threads and progress
  /// @{

  /// the linear solver.
  Solver solver = Solver::AUTOMATIC;

  /// if set, replaces `solver`.
  std::optional<Linear_solver> linear_solver;

  /// maximum number of threads of the call; 0 for no limit. The result does not depend on it.
  int number_of_threads = 0;

  /// if set, a model of `RegistrationVisitor_3` that observes the registration and may stop it. If
  /// several components are posed, it observes them one after the other, the smallest first, each
  /// from iteration 1; stopping one continues with the next. (Without it, and without other functions
  /// and models of the user, they are posed in parallel.)
  Registration_visitor visitor;

  /// @}

  /// \name Result
  /// @{

  /// whether the result contains the landmarks and the distances to them.
  bool return_landmark_fields = false;

  /// @}
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of `canonical_pose_3()` that refer to vertices of the input.
*/
struct Vertex_options
{
  /// \name Weights and stiffness
  /// @{

  /// factors of the matching weights, 0 or from \f$ 10^{-100} \f$ to \f$ 10^{100} \f$, which are
  /// shares of the area and are normalized to the sum 1 afterwards: one per vertex in the order of
  /// `vertices(tmesh)` or of the vertices of the complex, or none; see `property_values()`. A
  /// vertex with factor 0 has no target and follows the others.
  Eigen::VectorXd matching_weights;

  /// factors of the weights of the cells, from \f$ 10^{-9} \f$ to \f$ 10^9 \f$, or none: one per
  /// vertex of a surface, transferred to the cells by `cell_stiffness()`, or one per cell of a
  /// complex. A uniform factor \f$ c \f$ has the same effect as multiplying the detail length by
  /// \f$ \sqrt c \f$.
  Eigen::VectorXd stiffness;

  /// @}

  /// \name Constraints
  /// @{

  /// the constraints.
  Constraints_3 constraints;

  /// @}

  /// \name Stance
  /// @{

  /// where limbs go; each may occur once. The other limbs go where the `Method_options::stance` has them; if it is
  /// `CANONICAL`, they keep their canonical pose relative to the trunk, which becomes straight in any case. Feet of straight
  /// legs point to the front, and turn with legs that are moved to the front or to the back. What is said by the name of
  /// a limb holds for all components with a pose, which must have this limb; what is said by a vertex, for its
  /// component. If there are neither directions nor a stance for a component, it takes its canonical pose.
  std::vector<Limb_direction_3> limb_directions;

  /// @}

  /// \name Followers and given results
  /// @{

  /// \f$ m \times 3 \f$, points near the surface, such as markers or the vertices of a finer
  /// version of it. Each of them follows the nearest component, see `Body_deformer_3`. Their pose
  /// is `Result::pose_of_followers`.
  Point_matrix followers;

  /// distances and target to be used instead of computing them, if present. The `Result` of an
  /// earlier call for the same input can be assigned to it. Distances can be given for a single
  /// component only.
  Intermediate_results given;

  /// @}
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of `canonical_pose_3()`.
*/
struct Options : Method_options, Vertex_options
{};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of a component of a surface, for the steps of `canonical_pose_3()`. The
vertices to which the inherited members refer are its own instead of those of the input, which is
why it is not the same type as `Options`.

\sa `Prepared_surface_3`
*/
struct Component_options : Method_options, Vertex_options
{};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_OPTIONS_H
