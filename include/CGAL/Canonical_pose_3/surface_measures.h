// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_SURFACE_MEASURES_H
#define CGAL_CANONICAL_POSE_3_SURFACE_MEASURES_H

#include <CGAL/Canonical_pose_3/Face_list.h>
#include <CGAL/Canonical_pose_3/internal/surface/check_soup.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/internal/surface/twice_area.h>
#include <CGAL/Canonical_pose_3/internal/support/Buckets.h>
#include <CGAL/Canonical_pose_3/internal/support/for_each_block.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the share of each vertex in the area of a surface, one third of the area of its
triangles. The sum is 1.

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.

\throws std::invalid_argument if the area is zero or overflows, or a triangle has an invalid row.
*/
inline Eigen::VectorXd vertex_area_shares(const Point_matrix& points,
                                          const std::vector<std::array<std::size_t, 3>>& triangles)
{
  internal::check_elements(triangles, static_cast<std::size_t>(points.rows()));
  const double unit = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0;
  Eigen::VectorXd thirds(static_cast<Eigen::Index>(triangles.size()));
  internal::for_each_block(
    triangles.size(), [&](std::size_t, const std::size_t first, const std::size_t last) {
      for(std::size_t i = first; i < last; ++i)
      {
        const auto& t = triangles[i];
        const Eigen::Vector3d e = (points.row(t[1]) - points.row(t[0])) / unit;
        const Eigen::Vector3d f = (points.row(t[2]) - points.row(t[0])) / unit;
        thirds[static_cast<Eigen::Index>(i)] = e.cross(f).norm() / 6;
      }
    });
  Eigen::VectorXd area = Eigen::VectorXd::Zero(points.rows());
  for(std::size_t i = 0; i < triangles.size(); ++i)
    for(const std::size_t v : triangles[i])
      area[static_cast<Eigen::Index>(v)] += thirds[static_cast<Eigen::Index>(i)];
  const double sum = area.sum();
  if(!(sum > 0) || !std::isfinite(sum))
    throw std::invalid_argument("the surface has no area");
  return area / sum;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the share of each vertex in the area of a triangle mesh.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`; instead of them, a
       point map.
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Eigen::VectorXd vertex_area_shares(const TriangleMesh& tmesh,
                                   const NamedParameters& np = parameters::default_values())
{
  return vertex_area_shares(internal::points_of_parameters(tmesh, np),
                            internal::index_triangles(tmesh));
}

namespace internal {

// For each vertex, the larger vertices with which it forms pairs of corners of elements (triangles,
// tetrahedra): as often as there are such pairs, in order.
template <std::size_t N>
Buckets<Face_list::Index> larger_ends(const std::size_t number_of_vertices,
                                      const std::vector<std::array<std::size_t, N>>& elements)
{
  return Buckets<Face_list::Index>::sorted(
    number_of_vertices, elements.size(), [&](const std::size_t t, const auto& put) {
      for(std::size_t i = 1; i < N; ++i)
        for(std::size_t j = 0; j < i; ++j)
          put((std::min)(elements[t][i], elements[t][j]),
              static_cast<Face_list::Index>((std::max)(elements[t][i], elements[t][j])));
    });
}

// Calls f(v, w) for each pair, once, with v in [first, last).
template <class Function>
void for_each_edge(const Buckets<Face_list::Index>& larger_ends, const std::size_t first,
                   const std::size_t last, const Function& f)
{
  for(std::size_t v = first; v < last; ++v)
  {
    const auto ends = larger_ends[v];
    for(auto w = ends.begin(); w != ends.end(); ++w)
      if(w == ends.begin() || *w != *(w - 1))
        f(static_cast<Eigen::Index>(v), static_cast<Eigen::Index>(*w));
  }
}

} // namespace internal

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns the median of \f$ |\log(l'/l)| \f$ over the edges, where \f$ l \f$ and \f$ l' \f$ are
the lengths of an edge at rest and in the pose. Edges of length 0 at rest are ignored.

\param rest \f$ n \times 3 \f$, positions at rest.
\param pose \f$ n \times 3 \f$, positions in the pose.
\param triangles triples of rows.

\pre The numbers of rows agree.

\throws std::invalid_argument if a triangle has an invalid row.
*/
inline double median_edge_strain(const Point_matrix& rest, const Point_matrix& pose,
                                 const std::vector<std::array<std::size_t, 3>>& triangles)
{
  CGAL_precondition(rest.rows() == pose.rows());
  internal::check_elements(triangles, static_cast<std::size_t>(rest.rows()));
  const std::size_t n = static_cast<std::size_t>(rest.rows());
  const auto ends = internal::larger_ends(n, triangles);
  std::vector<std::vector<double>> blocks(internal::number_of_blocks(n));
  internal::for_each_block(
    n, [&](const std::size_t block, const std::size_t first, const std::size_t last) {
      internal::for_each_edge(ends, first, last, [&](const Eigen::Index v, const Eigen::Index w) {
        const double length = (rest.row(v) - rest.row(w)).norm();
        if(length > 0)
          blocks[block].push_back(std::abs(std::log((pose.row(v) - pose.row(w)).norm() / length)));
      });
    });
  std::vector<double> strains;
  for(const std::vector<double>& block : blocks)
    strains.insert(strains.end(), block.begin(), block.end());
  if(strains.empty())
    return 0;
  const auto middle = strains.begin() + static_cast<std::ptrdiff_t>(strains.size() / 2);
  std::nth_element(strains.begin(), middle, strains.end());
  return *middle;
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns for each vertex the mean of \f$ |\log(l'/l)| \f$ over its edges, where \f$ l \f$ and
\f$ l' \f$ are the lengths of an edge at rest and in the pose.

Edges of length 0 at rest or in the pose are ignored; the value of a vertex without other edges
is 0.

\tparam N 3 for triangles, 4 for tetrahedra

\param rest \f$ n \times 3 \f$, positions at rest.
\param pose \f$ n \times 3 \f$, positions in the pose.
\param elements `N` rows each.

\pre The numbers of rows agree.

\throws std::invalid_argument if an element has an invalid row.

\sa `median_edge_strain()`
*/
template <std::size_t N>
Eigen::VectorXd vertex_strains(const Point_matrix& rest, const Point_matrix& pose,
                               const std::vector<std::array<std::size_t, N>>& elements)
{
  CGAL_precondition(rest.rows() == pose.rows());
  internal::check_elements(elements, static_cast<std::size_t>(rest.rows()),
                           N == 3 ? "triangle" : "tetrahedron");
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(rest.rows());
  Eigen::VectorXd number = Eigen::VectorXd::Zero(rest.rows());
  const std::size_t n = static_cast<std::size_t>(rest.rows());
  const auto ends = internal::larger_ends(n, elements);
  std::vector<std::vector<double>> blocks(internal::number_of_blocks(n)); // negative: none
  internal::for_each_block(
    n, [&](const std::size_t block, const std::size_t first, const std::size_t last) {
      internal::for_each_edge(ends, first, last, [&](const Eigen::Index v, const Eigen::Index w) {
        const double at_rest = (rest.row(v) - rest.row(w)).stableNorm();
        const double in_pose = (pose.row(v) - pose.row(w)).stableNorm();
        const bool has_strain = at_rest > 0 && in_pose > 0;
        blocks[block].push_back(has_strain ? std::abs(std::log(in_pose / at_rest)) : -1);
      });
    });
  for(std::size_t block = 0; block < blocks.size(); ++block)
  {
    auto strain = blocks[block].begin();
    internal::for_each_edge(ends, block * internal::block_size,
                            (std::min)(n, (block + 1) * internal::block_size),
                            [&](const Eigen::Index v, const Eigen::Index w) {
                              if(*strain >= 0)
                                for(const Eigen::Index end : {v, w})
                                {
                                  sum[end] += *strain;
                                  ++number[end];
                                }
                              ++strain;
                            });
  }
  return sum.cwiseQuotient(number.cwiseMax(1));
}

/*!
\ingroup PkgCanonicalPose3Ref

\brief returns a unit normal per vertex of a surface, the direction of the sum of the area vectors of
its triangles. It is 0 where there is none, for instance at vertices without triangles.

\param points \f$ n \times 3 \f$, positions.
\param triangles triples of rows of `points`.

\throws std::invalid_argument if a triangle has an invalid row.
*/
inline Point_matrix vertex_normals(const Point_matrix& points,
                                   const std::vector<std::array<std::size_t, 3>>& triangles)
{
  internal::check_elements(triangles, static_cast<std::size_t>(points.rows()));
  const double unit = points.size() > 0 ? points.cwiseAbs().maxCoeff() : 0;
  Point_matrix normals = Point_matrix::Zero(points.rows(), 3);
  for(const auto& t : triangles)
  {
    const Eigen::RowVector3d e = (points.row(t[1]) - points.row(t[0])) / unit;
    const Eigen::RowVector3d f = (points.row(t[2]) - points.row(t[0])) / unit;
    const Eigen::RowVector3d area = e.cross(f);
    if(area.allFinite())
      for(const std::size_t v : t)
        normals.row(static_cast<Eigen::Index>(v)) += area;
  }
  for(Eigen::Index v = 0; v < normals.rows(); ++v)
    normals.row(v).stableNormalize();
  return normals;
}

} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_SURFACE_MEASURES_H
