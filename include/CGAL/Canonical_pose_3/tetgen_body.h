// Copyright (c) 2026 The Canonical_pose_3 authors.
//
// This file belongs to Canonical_pose_3, an extension package for CGAL, not part of the CGAL
// distribution.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Author(s) : The Canonical_pose_3 authors

#ifndef CGAL_CANONICAL_POSE_3_TETGEN_BODY_H
#define CGAL_CANONICAL_POSE_3_TETGEN_BODY_H

#ifndef CGAL_CANONICAL_POSE_3_USE_TETGEN
#error "tetgen_body.h needs TetGen: link the CMake target Canonical_pose_3::tetgen"
#endif

#include <CGAL/Canonical_pose_3/Conforming_body_3.h>
#include <CGAL/Canonical_pose_3/diagnose.h>
#include <CGAL/Canonical_pose_3/internal/support/configuration.h>
#include <CGAL/Canonical_pose_3/internal/support/points_of_parameters.h>
#include <CGAL/Canonical_pose_3/internal/support/state_of_the_process.h>

#ifndef TETLIBRARY
#define TETLIBRARY
#endif
#include <tetgen.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace CGAL {
namespace Canonical_pose_3 {
inline namespace CGAL_CANONICAL_POSE_3_CONFIGURATION {
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

// Precondition: the surface is clean (TetGen may terminate the process otherwise).
inline Conforming_body_3 tetgen_body_of_clean_surface(const Point_matrix& points,
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

/*!
\ingroup PkgCanonicalPose3Ref

\brief fills a clean closed surface with tetrahedra, using TetGen
\cgalCite{cgal:canonical-s-tdbqtmg-15}, without new vertices on the surface.

The surface is examined first, since TetGen terminates the process on many defects. TetGen is
licensed under the AGPL, which applies to programs that include this header (target
`Canonical_pose_3::tetgen`).

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of \ref bgl_namedparameters "Named Parameters"

\param tmesh the mesh.
\param np `vertex_point_map` and `geom_traits`, as for `CGAL::canonical_pose_3()`; instead of them, a
       point map.

\throws std::invalid_argument if `diagnose()` finds a defect; the message states the defect and an
       element.
\throws std::runtime_error if TetGen fails.

<em>Complexity:</em> that of `diagnose()` and of TetGen, close to linear in practice (0.3 s for 26
000 vertices).

\sa `Conforming_body_3`
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
Conforming_body_3 tetgen_body(const TriangleMesh& tmesh,
                              const NamedParameters& np = parameters::default_values())
{
  const Point_matrix points = internal::points_of_parameters(tmesh, np);
  const auto triangles = internal::index_triangles(tmesh);
  const Diagnosis_3 diagnosis = diagnose(points, triangles);
  if(!diagnosis.is_clean())
    throw std::invalid_argument(diagnosis.first_defect);
  return internal::tetgen_body_of_clean_surface(points, triangles);
}

} // namespace CGAL_CANONICAL_POSE_3_CONFIGURATION
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CGAL_CANONICAL_POSE_3_TETGEN_BODY_H
