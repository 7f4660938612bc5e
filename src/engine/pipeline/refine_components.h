// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_PIPELINE_REFINE_COMPONENTS_H
#define CANONICAL_POSE_3_ENGINE_PIPELINE_REFINE_COMPONENTS_H

#include "../surface/planar.h"
#include "../surface/refined_surface.h"

#include <CGAL/Canonical_pose_3/Options.h>
#include <CGAL/Canonical_pose_3/point_matrix.h>

#include <Eigen/Core>

#include <algorithm>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// Adds vertices to components that are too coarse to measure distances. Those with a small share of the
// cells get fewer, so that many of them do not cost more than a single one. In planes, wavefronts are
// exact. Given distances are completed by measured ones, corrected by what is interpolated of the
// difference between both. A template, so that landmark_fields() may be declared later.
template <class Components>
void refine(Components& components)
{
  constexpr double all
    = 0.25; // the share of cells that suffices for as many vertices as a single one
  for(auto& [surface, options] : components)
  {
    Point_matrix points = surface.points;
    normalize(points);
    if(options.geodesics == Options::Geodesics::HEAT && is_planar(surface.points, surface.triangles))
      options.geodesics = Options::Geodesics::WAVEFRONT;
    if(options.paper_weights || options.make_body || !is_coarse(points, surface.triangles))
      continue;
    surface = refined_surface(surface, (std::min)(surface.share_of_cells / all, 1.));
    options.number_of_landmarks
      = (std::min)(options.number_of_landmarks,
                   (std::max)(surface.origins.size(), Method_options().number_of_landmarks));
    if(options.given.target)
      options.given.target = with_added(surface, *options.given.target);
    if(options.given.landmark_fields)
    {
      Eigen::MatrixXd& given = options.given.landmark_fields->distances;
      const Eigen::MatrixXd distances
        = landmark_fields(surface, options.given.landmark_fields->landmarks, options).distances;
      const Eigen::MatrixXd difference = given - distances.topRows(given.rows());
      given = (distances + with_added(surface, difference)).cwiseMax(0);
    }
  }
}

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_PIPELINE_REFINE_COMPONENTS_H
