// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CANONICAL_POSE_3_ENGINE_WAVEFRONT_VIRTUAL_SOURCE_H
#define CANONICAL_POSE_3_ENGINE_WAVEFRONT_VIRTUAL_SOURCE_H

#include <algorithm>
#include <cmath>

namespace CGAL {
namespace Canonical_pose_3 {
namespace internal {

// A source as seen from a face: the position of the true source, or of the vertex at which the path
// bent last, when the faces on the path are unfolded into the plane, and the length of the path up
// to there. Also whether this vertex is flat, so that no shortest path bends there.
struct Virtual_source
{
  double x, y, base;
  bool is_flat;

  double distance(double px, double py) const
  {
    const double dx = px - x, dy = py - y;
    return base + std::sqrt(dx * dx + dy * dy);
  }

  // Where the segment to a point above the x axis crosses it; the source is not above the axis.
  double crossing(double px, double py) const { return x + (px - x) * (y / (y - py)); }
};

// A side of a face in the frame of another: its start, its unit direction and its length.
struct Unfolded_side
{
  double x, y, direction_x, direction_y, length;

  // the source in the frame in which this side runs from (0,0) to (length,0)
  Virtual_source in_frame(const Virtual_source& source) const
  {
    const double dx = source.x - x, dy = source.y - y;
    // rounding must not move a source above the side that it lights
    return {direction_x * dx + direction_y * dy,
            (std::min)(direction_x * dy - direction_y * dx, 0.), source.base, source.is_flat};
  }

  // the position along this side, within [0,length], where the ray from the source through (t,0)
  // arrives
  double arrival(const Virtual_source& source, double t) const
  {
    const double rx = t - source.x, ry = -source.y;
    const double at = ((t - x) * ry + y * rx) / (direction_x * ry - direction_y * rx);
    // a ray parallel to the side does not arrive: for any choice, distances are lengths of paths
    return at >= 0 ? (std::min)(at, length) : at < 0 ? 0. : length;
  }
};

} // namespace internal
} // namespace Canonical_pose_3
} // namespace CGAL

#endif // CANONICAL_POSE_3_ENGINE_WAVEFRONT_VIRTUAL_SOURCE_H
