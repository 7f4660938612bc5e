// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_OPTIONS_H
#define CGAL_CANONICAL_POSE_3_OPTIONS_H

#include <CGAL/Canonical_pose_3/Constraints_3.h>
#include <CGAL/Canonical_pose_3/Elastic_body_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Linear_solver.h>
#include <CGAL/Canonical_pose_3/Mds_kernel.h>
#include <CGAL/Canonical_pose_3/Registration_options.h>
#include <CGAL/Canonical_pose_3/Registration_progress.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds what `canonical_pose_3()` computes on the way to the pose: it is part of the `Result`, and can be
given to another call by `Options::given`.

Rows are the vertices in the order of `vertices(tmesh)`; for a tetrahedral complex those of its boundary, in the
order of `extract_boundary()`. Vertices that are on no surface of their own (those of no face, of a cavity, or
of another component) have infinite distances, and their pose as target. With a pose for each of several
components, there are no distances.
*/
struct Intermediate_results
{
  /// landmarks and distances to them; returned where `Options::return_landmark_fields` requests it. Where several
  /// copies of a vertex were needed, since the surface is not manifold there, the nearest counts.
  std::optional<Landmark_fields_3> landmark_fields;

  /// \f$ n \times 3 \f$, the target in its final position. One that is given is neither aligned nor
  /// reflected.
  std::optional<Point_matrix> target;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the weights as the paper prints them, see `Registration_options::set_paper_weights()`.
*/
struct Paper_weights
{
  double alpha = 100; ///< \f$ \alpha \f$, in the inverse of the mesh's unit of length.
  double beta = 10;   ///< \f$ \beta \f$.
};

/// \ingroup PkgCanonicalPose3Ref
/// computes landmarks and the distances to them on a connected surface, an oriented 2-manifold perhaps with boundary.
/// It is called with its points, triples of rows of these, the number of landmarks (larger, perhaps, than that of the
/// points), and the first landmark, and returns finite distances with a row per point.
using Landmark_fields_function = std::function<Landmark_fields_3(
  const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles,
  std::size_t number_of_landmarks, std::size_t first_landmark)>;

/// \ingroup PkgCanonicalPose3Ref
/// makes a body of a connected surface, an oriented 2-manifold perhaps with boundary, of its points, triples of rows of
/// these, and distances. The surface vertices of the body are the points.
using Body_function = std::function<Elastic_body_3(
  const Point_matrix& points, const std::vector<std::array<std::size_t, 3>>& triangles,
  const Landmark_fields_3& fields)>;

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of `canonical_pose_3()` that do not refer to vertices of the input.

Distances, kernel, body and solver are selected by enumerations, or provided by the user as functions or models of
concepts.
*/
struct Method_options
{
  /// model of `GeodesicDistances_3` to measure with: `Heat_geodesics_3`, `Wavefront_geodesics_3`.
  enum class Geodesics { HEAT, WAVEFRONT };

  /// model of `MdsKernel` of the target.
  enum class Kernel { CLASSICAL, GAUSSIAN, UNCENTERED_GAUSSIAN };

  /// elastic body of a surface: `AUTOMATIC` is the lattice, see `Lattice_body_3`; the others need a
  /// surface without defect.
  enum class Body { AUTOMATIC, LATTICE, TETGEN, MESH_3 };

  /// what to do with several connected components, of a surface (by edges) or of the cells of a complex (by
  /// common faces): refuse them; pose the largest one, to which the others stay attached; or pose each on its own.
  enum class Components { REFUSE, LARGEST, EACH };

  /// linear solver: `AUTOMATIC` is CHOLMOD where the package was configured with it, else Eigen.
  enum class Solver { AUTOMATIC, EIGEN, CHOLMOD };

  /// the distances.
  Geodesics geodesics = Geodesics::HEAT;

  /// if set, computes the distances instead, for example with `Exact_geodesics_3`; see `landmark_fields_function()`.
  Landmark_fields_function landmark_fields_function;

  /// if set, computes the distances for the target, in the unit of the mesh, while the body and the length
  /// \f$ L \f$ are still based on the distances above.
  Landmark_fields_function target_fields_function;

  /// number of landmarks, at least 1. Of those that a surface of \f$ n \f$ vertices can have, \f$ n \f$, at
  /// most 4096, and at most \f$ 2^{29} / n \f$.
  std::size_t number_of_landmarks = 80;

  /// 0: the first landmark is `extremal_point()`; otherwise it is drawn with this seed. Nothing
  /// else is random.
  unsigned int random_seed = 0;

  /// the kernel.
  Kernel kernel = Kernel::CLASSICAL;

  /// if set, a model of `MdsKernel` that replaces `kernel`.
  std::optional<Mds_kernel> mds_kernel;

  /// the body of a surface; a complex is its own body.
  Body body = Body::AUTOMATIC;

  /// if set, creates the body of a surface instead.
  Body_function make_body;

  /// spacing of the lattice as a fraction of \f$ L \f$; 0: chosen from the thickness of the shape.
  double lattice_spacing = 0;

  /// components of a surface or a complex.
  Components components = Components::REFUSE;

  /// the options of the registration.
  Registration_options registration;

  /// if set, these replace detail length, Tikhonov weight and matching weights, and rotations are
  /// computed from the pose after one pass of fairing (or as many as `registration` says, if more),
  /// as the paper does.
  std::optional<Paper_weights> paper_weights;

  /// if the volume of the pose exceeds this multiple of the rest volume, the target is scaled down and the
  /// registration is repeated: geodesics run around compact bodies, so their targets are too large. Positive. By
  /// default 1.15, but unlimited for given targets and with `paper_weights`.
  std::optional<double> volume_ratio_limit;

  /// the linear solver.
  Solver solver = Solver::AUTOMATIC;

  /// if set, replaces `solver`.
  std::optional<Linear_solver> linear_solver;

  /// upper bound on the number of threads; 0 for none. The result does not depend on it.
  int number_of_threads = 0;

  /// a model of `RegistrationVisitor_3` that watches the registration and may stop it, or none. With
  /// a pose for each of several components it watches one after the other, the smallest first, each
  /// from iteration 1; to stop one is to begin with the next.
  Registration_visitor visitor;

  /// whether the result is to hold the landmarks and the distances to them.
  bool return_landmark_fields = false;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of `canonical_pose_3()` that refer to vertices of the input.
*/
struct Vertex_options
{
  /// nonnegative factors of the matching weights (shares in the area, which have the sum 1 again
  /// afterwards), one per vertex in the order of `vertices(tmesh)` or of the vertices of the complex,
  /// or none; see `property_values()`. A vertex of factor 0 has no target and follows the others.
  Eigen::VectorXd matching_weights;

  /// positive factors of the weights of the cells, or none: one per vertex of a surface, from where
  /// `cell_stiffness()` brings them to the cells, but one per cell of a complex. A factor \f$ c \f$
  /// everywhere is the same as a detail length \f$ \sqrt c \f$ times as large.
  Eigen::VectorXd stiffness;

  /// the constraints.
  Constraints_3 constraints;

  /// \f$ m \times 3 \f$, points near the surface, such as markers or the vertices of a finer version of
  /// it, that are to follow it, each the component that is nearest to it; see `Body_deformer_3`. Their pose is
  /// `Result::pose_of_followers`.
  Point_matrix followers;

  /// distances and target to use instead of computing them, as far as they are there. The `Result` of an earlier
  /// call for the same input can be assigned to it. Distances can be given for a single component only.
  Intermediate_results given;
};

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds the options of `canonical_pose_3()`.
*/
struct Options : Method_options, Vertex_options
{};

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_OPTIONS_H
