// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_WITH_GEODESICS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_WITH_GEODESICS_H

#include <CGAL/Canonical_pose_3/Heat_geodesics_3.h>
#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/Wavefront_geodesics_3.h>
#include <CGAL/Canonical_pose_3/internal/linear_algebra/Factor_base.h>
#include <CGAL/Canonical_pose_3/internal/surface/Indexed_mesh.h>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Calls a function with the requested model of GeodesicDistances_3, and returns its result.
// `time_step_factor`: of the heat method.
template <class Function>
auto with_geodesics(const Indexed_mesh& mesh, const Method_options& options,
                    const Factor_maker factor_maker, const double time_step_factor,
                    const Function& f)
{
  if(options.geodesics == Options::Geodesics::WAVEFRONT)
    return f(Wavefront_geodesics_3<Indexed_mesh>(mesh));
  return f(Heat_geodesics_3<Indexed_mesh>(mesh, get(vertex_point, mesh), {}, factor_maker,
                                          time_step_factor));
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_WITH_GEODESICS_H
