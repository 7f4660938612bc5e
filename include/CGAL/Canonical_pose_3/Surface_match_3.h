// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SURFACE_MATCH_3_H
#define CGAL_CANONICAL_POSE_3_SURFACE_MATCH_3_H

#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief holds where each vertex of a surface is on another one: the result of `match_surfaces()`.
*/
struct Surface_match_3
{
  /// is a point of a face: a combination of three of its corners.
  struct Location
  {
    std::size_t face;                    ///< the face of the other surface.
    std::array<std::size_t, 3> vertices; ///< three vertices of the face.
    std::array<double, 3> weights;       ///< barycentric coordinates: nonnegative, with the sum 1.
  };

  /// where each vertex of the first surface is on the second one.
  std::vector<Location> locations;

  /// where each vertex of the second surface is on the first one.
  std::vector<Location> locations_of_other;

  /// for each vertex of the first surface, the distance between it and the point to which it returns, in the
  /// pose of unit radius: small where the matches in both directions agree.
  Eigen::VectorXd round_trips;

  /// the mean of `round_trips`, without isolated vertices and components that are not compared.
  double mean_round_trip = 0;

  /// the functional map: the coefficients of the eigenfunctions of the second surface in those of the first one.
  Eigen::MatrixXd functional_map;

  /// the size of the first surface, relative to that of the second one: the root of the ratio of their areas.
  double scale = 1;

  /// the mean distance between nearest points of the two poses, of unit radius, after their rotation toward each
  /// other, of the components that are compared.
  double mean_distance = 0;

  /// the sum of the changes of lengths of edges of the first surface, relative to the sum of their lengths, after both surfaces
  /// have been scaled to the same area, of the components that are compared. If it is several times `mean_distance`, parts
  /// of one surface may be missing, and others be matched with them.
  double edge_strain = 0;

  /// whether no other rotation leads to nearly as good a match; otherwise, front and back may be confused.
  bool is_rotation_certain = true;

  /// the share of the area of the first surface that is compared: of the largest component and those near it that are not
  /// small. The other ones have no influence, and are matched with whatever is nearest.
  double compared_share = 1;

  /// the same for the second surface.
  double compared_share_of_other = 1;

  /// interpolates values of the second surface, one row per vertex, at the vertices of the first one.
  /// \pre there is a row for each vertex of the second surface.
  template <class Matrix>
  Matrix interpolated(const Matrix& values) const
  {
    return interpolated(locations, values);
  }

  /// interpolates values of the first surface, one row per vertex, at the vertices of the second one.
  /// \pre there is a row for each vertex of the first surface.
  template <class Matrix>
  Matrix interpolated_at_other(const Matrix& values) const
  {
    return interpolated(locations_of_other, values);
  }

private:
  template <class Matrix>
  static Matrix interpolated(const std::vector<Location>& locations, const Matrix& values)
  {
    Matrix result(static_cast<Eigen::Index>(locations.size()), values.cols());
    for(std::size_t v = 0; v < locations.size(); ++v)
    {
      const auto& [face, vertices, weights] = locations[v];
      auto row = result.row(static_cast<Eigen::Index>(v));
      row = weights[0] * values.row(static_cast<Eigen::Index>(vertices[0]));
      for(std::size_t k = 1; k < 3; ++k)
        row += weights[k] * values.row(static_cast<Eigen::Index>(vertices[k]));
    }
    return result;
  }
};

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SURFACE_MATCH_3_H
