// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MATCHABLE_SURFACE_3_H
#define CGAL_CANONICAL_POSE_3_MATCHABLE_SURFACE_3_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <CGAL/Named_function_parameters.h>

#include <cstddef>
#include <memory>
#include <type_traits>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {
struct Matchable_data;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds what `match_surfaces()` needs of a surface: its pose, a coarse copy, its relief, and eigenfunctions of its
Laplacian. Copies share it. The first match that registers the pose adds its body.

\sa `match_surfaces()`
*/
class Matchable_surface_3
{
public:
  /// the largest number of eigenfunctions, with the constant one.
  static constexpr std::size_t NUMBER_OF_FUNCTIONS = 100;

  /*!
  prepares a surface.

  \param points \f$ n \times 3 \f$, positions.
  \param polygons sequences of rows of `points`.
  \param pose \f$ n \times 3 \f$, the canonical pose, in any frame.

  \throws std::invalid_argument if the pose has another number of rows, a coordinate is not finite, a polygon has an
          invalid row, or no face has an area.
  \throws std::runtime_error if the library was built without Spectra.

  <em>Complexity:</em> \f$ O(n \log n) \f$; eigenfunctions are those of a coarse copy of at most 4000 vertices.
  */
  Matchable_surface_3(const Point_matrix& points, const Face_list& polygons,
                      const Point_matrix& pose);

  /*!
  prepares a polygon mesh. Its vertices and faces are counted in the order of its ranges.

  \tparam PolygonMesh a model of `FaceListGraph`
  \tparam PosePointMap a model of `ReadablePropertyMap` with the vertex descriptor as key type, and the same
          value type as the point map
  \tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

  \param mesh the mesh.
  \param pose the pose of each vertex, as `CGAL::canonical_pose_3()` writes it.
  \param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`.
  */
  template <class PolygonMesh, class PosePointMap,
            class NamedParameters = parameters::Default_named_parameters,
            std::enable_if_t<!std::is_convertible<PolygonMesh, Point_matrix>::value, int> = 0>
  Matchable_surface_3(const PolygonMesh& mesh, PosePointMap pose,
                      const NamedParameters& np = parameters::default_values())
    : Matchable_surface_3(internal::points_of_parameters(mesh, np), internal::index_polygons(mesh),
                          internal::points_of_parameters(mesh, np.vertex_point_map(pose)))
  {}

  /// returns the number of vertices.
  std::size_t number_of_vertices() const;

  /// \cond SKIP_IN_MANUAL
  const internal::Matchable_data& data() const { return *m_data; }
  /// \endcond

private:
  std::shared_ptr<const internal::Matchable_data> m_data;
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_MATCHABLE_SURFACE_3_H
