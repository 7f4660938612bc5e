// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_POSE_STEPS_H
#define CGAL_CANONICAL_POSE_3_POSE_STEPS_H

#include <CGAL/Canonical_pose_3/Coarse_surface_3.h>
#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/Intrinsic_symmetry_3.h>
#include <CGAL/Canonical_pose_3/Landmark_fields_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Prepared_surface_3.h>
#include <CGAL/Canonical_pose_3/Result.h>
#include <CGAL/Canonical_pose_3/Surface_body_3.h>
#include <CGAL/Canonical_pose_3/Surface_component_3.h>
#include <CGAL/Canonical_pose_3/Target_3.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/body_of_surface.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/linked_bodies.h>
#include <CGAL/Canonical_pose_3/internal/pipeline/options_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief examines and repairs a polygon soup, splits it into components, and assigns the options to
them: the first step of `canonical_pose_3()`.

Where triangles are too large to measure distances at their vertices alone, vertices are added, see
`Surface_component_3::added`; values given at the other ones are interpolated. On planar components,
the distances are those of wavefronts, which are exact there.

\param points \f$ n \times 3 \f$, positions.
\param polygons sequences of rows of `points`.
\param options the options, which refer to the vertices of the input.

\throws std::invalid_argument under the same conditions as `canonical_pose_3()`.

<em>Complexity:</em> \f$ O(n \log n) \f$.
*/
Prepared_surface_3 prepare_surface(const Point_matrix& points, const Face_list& polygons,
                                   const Options& options = Options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief examines and repairs a polygon mesh, splits it into components, and assigns the options to
them.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh.
\param options the options, which refer to the vertices of the mesh.
\param np `vertex_point_map` and `geom_traits`, as for `canonical_pose_3()`
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Prepared_surface_3 prepare_surface(const TriangleMesh& tmesh, const Options& options = Options(),
                                   const NamedParameters& np = parameters::default_values())
{
  return prepare_surface(internal::points_of_parameters(tmesh, np), internal::index_polygons(tmesh),
                         options);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief does the same with the default options.
*/
template <class TriangleMesh, class T, class Tag, class Base>
Prepared_surface_3 prepare_surface(const TriangleMesh& tmesh,
                                   const Named_function_parameters<T, Tag, Base>& np)
{
  return prepare_surface(tmesh, Options(), np);
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief simplifies a surface, since geodesic distances do not require all vertices: the second step of
`canonical_pose_3()`, after `prepare_surface()`.

\param surface the surface.
\param options `number_of_coarse_vertices` and `number_of_landmarks` are used; the landmarks of
       `given.landmark_fields` remain vertices.
*/
Coarse_surface_3 coarse_surface(const Surface_component_3& surface,
                                const Component_options& options = Component_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief chooses landmarks on a surface and computes the geodesic distances to them.

\param surface the surface.
\param options `geodesics`, `landmark_fields_function`, `number_of_landmarks`, `random_seed`, the
       solver and `number_of_threads` are used.

\throws std::invalid_argument if the distances require faces with an area and a face has none, or
        the function in the options returns invalid distances.
*/
Landmark_fields_3 landmark_fields(const Surface_component_3& surface,
                                  const Method_options& options = Method_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief chooses landmarks on a coarse surface and computes the geodesic distances to them, or returns the
given ones for its vertices: the third step of `canonical_pose_3()`, after `coarse_surface()`.

\param coarse the coarse surface.
\param options as above, and `given.landmark_fields`.

\throws std::invalid_argument as above, or if a landmark of the given distances is not a vertex of
        the coarse surface.

\sa `mds_target()`
*/
Landmark_fields_3 landmark_fields(const Coarse_surface_3& coarse,
                                  const Component_options& options = Component_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief computes the geodesic distances to given landmarks on a surface.

\param surface the surface.
\param landmarks vertices of the surface.
\param options `geodesics`, `landmark_fields_function`, the solver and `number_of_threads` are used.

\throws std::invalid_argument if there is no landmark, a landmark is not a vertex of the surface, the
        distances require faces with an area and a face has none, or
        the function in the options returns invalid distances.
*/
Landmark_fields_3 landmark_fields(const Surface_component_3& surface,
                                  const std::vector<std::size_t>& landmarks,
                                  const Method_options& options = Method_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief computes the target of a surface by landmark multidimensional scaling, mirrors it if its
handedness requires it, and aligns it with the surface; or returns the given target: the fourth step of
`canonical_pose_3()`.

\param surface the surface.
\param coarse its coarse surface, from which the target is interpolated.
\param fields distances, one row per vertex of the coarse surface.
\param options `kernel`, `mds_kernel` and `given.target` are used.

\pre The numbers of rows agree; the given target, if any, has one row per vertex of the surface.

\throws std::invalid_argument see `Landmark_mds_target_builder_3::build()`.

\sa `Landmark_mds_target_builder_3`
\sa `target_handedness()`
\sa `align_target()`
*/
Target_3 mds_target(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                    const Landmark_fields_3& fields,
                    const Component_options& options = Component_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief computes a target from geodesic distances that were measured on a pose of the surface, starting from
this pose, and aligns it with the surface.

In the pose, limbs are straight, so the shortest paths do not depend on how they were bent. The
distances are scaled such that the area of the pose becomes that of the surface: otherwise, the
stretch of one pose would be passed on to the next one.

\param surface the surface.
\param coarse its coarse surface.
\param fields distances on `coarse.posed(pose)`.
\param pose one row per vertex of the surface.
\param options `number_of_threads` is used.

\pre The numbers of rows agree.

\sa `Smacof_target_builder_3`
*/
Target_3 refined_target(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                        const Landmark_fields_3& fields, const Point_matrix& pose,
                        const Method_options& options = Method_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief extrapolates geodesic distances from those of the input beyond those of a pose, in which limbs are
nearly, but not entirely straight.

Let \f$ g \f$ be the distances on the input, multiplied by the square root of the area of the pose
divided by that of the input, and \f$ d \f$ those on the pose. The result is
\f$ d_{ij} + f (c_{ij} - r_i - s_j + m) \f$, where \f$ c = d - g \f$, \f$ r_i \f$ is the mean of
\f$ c \f$ over the landmarks, \f$ s_j \f$ its mean over the vertices, by their areas, and
\f$ m \f$ that of the \f$ r_i \f$. So the change of distances that is common to a vertex or to a
landmark is not extrapolated: it belongs to the stretch around it, not to limbs that straighten.
Results are at least 0, and 0 at the landmarks.

\param coarse the coarse surface.
\param fields distances on `coarse.surface`.
\param fields_of_pose distances on `coarse.posed(pose)`.
\param pose one row per vertex of the surface.
\param factor \f$ f \f$.

\pre Both have the same landmarks, and the numbers of rows agree.
\pre `factor` is finite and at least 0.

<em>Complexity:</em> linear in the number of distances.

\sa `refined_target()`
*/
Landmark_fields_3 extrapolated_fields(const Coarse_surface_3& coarse,
                                      const Landmark_fields_3& fields,
                                      const Landmark_fields_3& fields_of_pose,
                                      const Point_matrix& pose, double factor);

/*!
\ingroup PkgCanonicalPose3Ref

\brief finds the symmetry of a surface, such as that of left and right, if it is clear.

The symmetry is an orthogonal map of the embedding by up to ten eigenvectors of multidimensional scaling (M. Ovsjanikov,
J. Sun and L. Guibas, "Global intrinsic symmetries of shapes", 2008), fitted from rotations and reflections of the pose. It is
clear if distances in the embedding change by at most 6.5 percent, and if it is far from the identity.

\param coarse the coarse surface.
\param fields distances on the coarse surface, in a canonical pose if possible.
\param pose one row per vertex of the surface: a pose or a target.

\pre The numbers of rows agree.

<em>Complexity:</em> quadratic in the number of vertices of the coarse surface.
*/
std::optional<Intrinsic_symmetry_3> intrinsic_symmetry(const Coarse_surface_3& coarse,
                                                       const Landmark_fields_3& fields,
                                                       const Point_matrix& pose);

/*!
\ingroup PkgCanonicalPose3Ref

\brief makes a target symmetric: the mean of it and of its image, next to which it is moved by a rotation or a reflection.

A target that is symmetric already, up to a third of the length of an edge, remains as it is.

\param coarse the coarse surface.
\param symmetry the symmetry.
\param target one row per vertex of the surface.

\pre The numbers of rows agree.

<em>Complexity:</em> linear.

\sa `refined_target()`
*/
Point_matrix symmetric_target(const Coarse_surface_3& coarse, const Intrinsic_symmetry_3& symmetry,
                              const Point_matrix& target);

inline namespace CGAL_CANONICAL_POSE_3_BODIES {

/*!
\ingroup PkgCanonicalPose3Ref

\brief creates the body of a surface: the fifth step of `canonical_pose_3()`.

\param surface the surface.
\param coarse its coarse surface.
\param fields distances, one row per vertex of the coarse surface.
\param options `body`, `make_body`, `lattice_spacing` and `stiffness` are used.

\pre The numbers of rows agree.

\throws std::invalid_argument if the function in the options returns a body of another surface.
\throws std::runtime_error if the mesher fails, or the program was built without support for the
        requested body.

\sa `Lattice_body_3`
*/
inline Surface_body_3 surface_body(const Surface_component_3& surface,
                                   const Coarse_surface_3& coarse, const Landmark_fields_3& fields,
                                   const Component_options& options = Component_options())
{
  return internal::body_of_surface(surface, coarse, fields, options, internal::linked_bodies());
}

} // namespace CGAL_CANONICAL_POSE_3_BODIES

/*!
\ingroup PkgCanonicalPose3Ref

\brief computes a target without geodesic distances, by unfolding the body of the surface, see `Unfolding`:
replaces `mds_target()` if `Method_options::target_mode` is `UNFOLDING`.

The body is unfolded strongly, so that hardly any bend is left, which also inflates it; the registration
to the target then restores the details. The target is scaled such that its area is that of the surface,
and aligned with the surface. It has the handedness of the surface.

\param surface the surface.
\param body its body.
\param options `unfolding`, `registration.number_of_iterations`, the solver and `number_of_threads` are
       used. The weight of the unfolding refers to the default detail length, 0.1.

\throws std::invalid_argument if the weight is out of range, or the body is not connected.
\throws std::runtime_error if the solver fails.

\sa `Tetrahedral_arap_registrar_3::set_unfolding()`
*/
Target_3 unfolded_target(const Surface_component_3& surface, const Surface_body_3& body,
                         const Method_options& options = Method_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief registers the body of a surface to its target, then to refined targets: the sixth step of
`canonical_pose_3()`, before `joined_result()`.

In each round, the body is registered with half the detail length and larger tolerances, and
distances are measured on this pose, from the same landmarks; the next registration is to the
`refined_target()`, starting at the pose, the last one with all details. If the body loses more than
half of its volume in a round, it is registered with three times the detail length instead. Rounds
end early if the target hardly changes, or changes by more than 1.1 times as much as in the round
before: then it drifts. If the target changes by less than three quarters as much in the last round
as in the one before, its distances are extrapolated (`extrapolated_fields()`). If distances show a clear
symmetry of the shape, such as that of left and right, the last target is the `symmetric_target()`, unless it is in a plane (`Method_options::symmetry`).
Given distances serve the first target only; the landmarks are theirs in all rounds.

The handedness is determined after the rounds. If the target is inside out, or its chirality is less
than \f$ -0.1 v^2 \f$, where \f$ v \f$ is the volume ratio (see `Target_handedness_3`), the rounds
are repeated from the mirrored first target. It is chosen if it is not inside out after them and, if
the other one is not inside out either, its stress is at most 1.2 times that of the other one.

\param surface the surface.
\param coarse its coarse surface.
\param fields distances on the coarse surface, one row per vertex.
\param target the first target.
\param body the body.
\param options `number_of_rounds` and the options of `landmark_fields()`, `registration`,
       `paper_weights`, `volume_ratio_limit`, `matching_weights`, `constraints`, `followers`, the
       solver, `number_of_threads` and `visitor` are used.

\returns the pose of the surface vertices of the body, the pose of the followers, the target, and
         the summary.

\pre The numbers of rows agree.

\throws std::invalid_argument if a weight or an option is out of range.
\throws std::runtime_error if the solver fails.

\sa `Tetrahedral_arap_registrar_3`
*/
Result registered_pose(const Surface_component_3& surface, const Coarse_surface_3& coarse,
                       const Landmark_fields_3& fields, const Target_3& target,
                       const Surface_body_3& body,
                       const Component_options& options = Component_options());

/*!
\ingroup PkgCanonicalPose3Ref

\brief transfers the poses of the components to the vertices of the input: the last step of
`canonical_pose_3()`.

Other components, and isolated vertices, move with the nearest component that has a
pose.

\param surface the surface.
\param results the result of `registered_pose()` for each component.

\pre `results.size() == surface.components.size()`
*/
Result joined_result(const Prepared_surface_3& surface, const std::vector<Result>& results);

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_POSE_STEPS_H
