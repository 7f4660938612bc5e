// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_PAPER_SHAPES_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_PAPER_SHAPES_H

#include <CGAL/Canonical_pose_3/pose_steps.h>

#include "../../examples/Canonical_pose_3/Articulated_figure.h"

#include "formats/Cgal_types.h" // of the tool
#include "formats/Mesh_file.h"

#include <cstddef>
#include <fstream>
#include <stdexcept>
#include <string>
#include <utility>

namespace Canonical_pose_benchmark {

using Canonical_pose_tool::Mesh_file;
using CGAL::Canonical_pose_3::Point_matrix;

inline std::string stem_of(const std::string& file)
{
  const std::string name = file.substr(file.find_last_of('/') + 1);
  return name.substr(0, name.find_last_of('.'));
}

inline Point_matrix points_of_file(const Mesh_file& mesh)
{
  return Canonical_pose_tool::matrix_of(Canonical_pose_tool::points_of(mesh));
}

/// The largest component of a mesh, with its options.
inline CGAL::Canonical_pose_3::Prepared_surface_3
prepared_surface(const Mesh_file& mesh,
                 CGAL::Canonical_pose_3::Options options = CGAL::Canonical_pose_3::Options())
{
  options.components = CGAL::Canonical_pose_3::Options::Components::LARGEST;
  return CGAL::Canonical_pose_3::prepare_surface(points_of_file(mesh), mesh.faces, options);
}

inline Mesh_file mesh_of_figure(const Canonical_pose_examples::Articulated_figure& figure,
                                const Canonical_pose_examples::Joint_angles& angles)
{
  Mesh_file mesh;
  mesh.points = figure.points(angles);
  mesh.faces = figure.triangles();
  return mesh;
}

/// Writes the mesh with other points to `prefix` + `name` + ".off"; nothing if the prefix is empty.
inline void write_picture_mesh(const std::string& prefix, const std::string& name,
                               const Mesh_file& mesh, const Point_matrix& points)
{
  if(prefix.empty())
    return;
  std::ofstream out(prefix + name + ".off");
  Canonical_pose_tool::write_mesh(out, Canonical_pose_tool::Format::OFF,
                                  Canonical_pose_tool::with_points(mesh, points));
  if(!out.flush())
    throw std::runtime_error("cannot write " + prefix + name + ".off");
}

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_PAPER_SHAPES_H
