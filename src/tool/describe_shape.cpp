// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "describe_shape.h"
#include "command_options.h"
#include "compute_pose.h"
#include "formats/Cgal_types.h"

#include <CGAL/Canonical_pose_3/call_with_threads.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>

namespace Canonical_pose_tool {

namespace {

void take_pose(const Mesh_file& input, const Arguments& arguments, Shape_description& shape)
{
  if(!arguments.pose.empty())
  {
    shape.pose = matrix_of(points_of(read_other_mesh_file(arguments.pose)));
    if(shape.pose.rows() != shape.points.rows())
      throw std::invalid_argument("the pose has " + std::to_string(shape.pose.rows())
                                  + " vertices, but the surface has "
                                  + std::to_string(shape.points.rows()));
    return;
  }
  Result result = compute_pose(input, watched_options(arguments));
  shape.pose = std::move(result.pose);
  shape.summary = std::move(result.summary);
}

} // namespace

Shape_description describe_shape(const Mesh_file& input, const std::vector<Descriptor>& chosen,
                                 const Arguments& arguments, const bool needs_pose)
{
  check_is_surface(input);
  arguments.say("computing the pose");
  Shape_description shape;
  shape.points = matrix_of(points_of(input));
  if(needs_pose
     || std::any_of(chosen.begin(), chosen.end(), [](const Descriptor& d) { return d.needs_pose; }))
    take_pose(input, arguments, shape);
  CGAL::Canonical_pose_3::call_with_threads(arguments.options.number_of_threads, [&] {
    for(const Descriptor& d : chosen)
    {
      arguments.say("computing " + d.name);
      shape.descriptors.push_back(
        {d.name, d.version, d.values(d.needs_pose ? shape.pose : shape.points, input.faces)});
    }
  });
  arguments.say("");
  return shape;
}

} // namespace Canonical_pose_tool
