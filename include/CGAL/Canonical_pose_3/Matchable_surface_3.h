// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_MATCHABLE_SURFACE_3_H
#define CGAL_CANONICAL_POSE_3_MATCHABLE_SURFACE_3_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <cstddef>
#include <memory>

namespace CGAL {
namespace Canonical_pose_3 {

namespace internal {
struct Matchable_data;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds what `match_surfaces()` needs of a surface: its pose, a coarse copy, and eigenfunctions of its
Laplacian. Copies share it.

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
