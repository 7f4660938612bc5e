// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_MESH_INSTANCE_H
#define CGAL_CANONICAL_POSE_3_TOOL_MESH_INSTANCE_H

#include <tiny_gltf.h>

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

// A mesh where a node shows it.
struct Mesh_instance
{
  std::size_t mesh;
  Eigen::Affine3d transformation; // by the node and those above it
  std::optional<std::size_t> node;
  std::vector<Eigen::Affine3d> joints; // if it has a skin: from the space of the mesh to the scene
};

// What tells the vertices of the primitives of an instance apart: the accessor of their positions, and
// that of their joints, if they have a skin.
std::pair<int, int> accessors_of_vertices(const Mesh_instance& instance,
                                          const tinygltf::Primitive& primitive);

// The meshes of all nodes that the scene shows, in the order of the nodes; without scenes, of all nodes, or the only mesh
// if no node has it. Throws std::invalid_argument if there is none, or a node or the scene is wrong.
std::vector<Mesh_instance> mesh_instances(const tinygltf::Model& model);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_MESH_INSTANCE_H
