// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "../support/state_of_the_process.h"

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/internal/surface/index_faces.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>
#include <CGAL/Canonical_pose_3/tetgen_body.h>

#ifndef TETLIBRARY
#define TETLIBRARY
#endif
#include <tetgen.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// `points` are scaled by a power of two to about unit size, as TetGen has absolute tolerances.
inline void fill_tetgen_input(const Point_matrix& points,
                              const std::vector<Index_triangle>& triangles, const double unit,
                              tetgenio& in)
{
  in.firstnumber = 0;
  in.numberofpoints = static_cast<int>(points.rows());
  in.pointlist = new REAL[3 * static_cast<std::size_t>(points.rows())];
  for(Eigen::Index i = 0; i < points.rows(); ++i)
    for(Eigen::Index k = 0; k < 3; ++k)
      in.pointlist[3 * i + k] = points(i, k) / unit;
  in.numberoffacets = static_cast<int>(triangles.size());
  in.facetlist = new tetgenio::facet[triangles.size()];
  for(std::size_t f = 0; f < triangles.size(); ++f)
  {
    tetgenio::facet& facet = in.facetlist[f];
    tetgenio::init(&facet);
    facet.numberofpolygons = 1;
    facet.polygonlist = new tetgenio::polygon[1];
    tetgenio::init(facet.polygonlist);
    facet.polygonlist->numberofvertices = 3;
    facet.polygonlist->vertexlist = new int[3];
    std::copy(triangles[f].begin(), triangles[f].end(), facet.polygonlist->vertexlist);
  }
}

Conforming_body_3 tetgen_body_of_clean_surface(const Point_matrix& points,
                                               const std::vector<Index_triangle>& triangles)
{
  const double unit = std::exp2(std::ilogb(points.cwiseAbs().maxCoeff()));
  tetgenio in, out;
  fill_tetgen_input(points, triangles, unit, in);
  try
  {
    // p: the given facets, Y: without a new vertex on them, Q: quiet
    char switches[] = "pYQ";
    const std::lock_guard<std::mutex> lock(mutex_of_random_numbers());
    tetrahedralize(switches, &in, &out);
  }
  catch(const int code)
  {
    throw std::runtime_error(
      code == 1 ? std::string("TetGen ran out of memory")
                : "TetGen could not fill the surface (its code: " + std::to_string(code) + ")");
  }
  if(out.numberofpoints < points.rows() || out.numberoftetrahedra == 0)
    throw std::runtime_error("TetGen returned no tetrahedra for the surface");

  Point_matrix body_points(out.numberofpoints, 3);
  body_points.topRows(points.rows()) = points;
  for(Eigen::Index i = points.rows(); i < body_points.rows(); ++i)
    for(Eigen::Index k = 0; k < 3; ++k)
      body_points(i, k) = unit * out.pointlist[3 * i + k];
  std::vector<std::array<int, 4>> cells(static_cast<std::size_t>(out.numberoftetrahedra));
  for(std::size_t t = 0; t < cells.size(); ++t)
    for(std::size_t k = 0; k < 4; ++k)
      cells[t][k] = out.tetrahedronlist[4 * t + k];
  return Conforming_body_3(std::move(body_points), std::move(cells),
                           static_cast<std::size_t>(points.rows()));
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL
