// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gltf_numbers.h"
#include "Skinned_vertices.h"
#include "load_gltf.h"
#include "readers.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

using tinygltf::Model;
using tinygltf::Primitive;

void check_extensions(const Model& model)
{
  for(const std::string& name : model.extensionsRequired)
    if(name != "KHR_mesh_quantization" && name.compare(0, 14, "KHR_materials_") != 0
       && name.compare(0, 12, "KHR_texture_") != 0 && name.compare(0, 11, "KHR_lights_") != 0)
      throw std::invalid_argument("the extension " + Text_cursor::shown(name)
                                  + " is required, but not supported");
}

void check_primitive(const Primitive& primitive)
{
  static const std::array<const char*, 7> modes
    = {"points",    "lines",           "line loops",   "line strips",
       "triangles", "triangle strips", "triangle fans"};
  if(primitive.mode < 0 || static_cast<std::size_t>(primitive.mode) >= modes.size())
    throw std::invalid_argument("the primitive has the unknown mode "
                                + std::to_string(primitive.mode));
  if(primitive.mode != TINYGLTF_MODE_TRIANGLES)
    throw std::invalid_argument(std::string("the primitive consists of ")
                                + modes[static_cast<std::size_t>(primitive.mode)]
                                + ", but triangles are needed");
  for(const auto& extension : primitive.extensions)
    if(extension.first.find("compression") != std::string::npos)
      throw std::invalid_argument("the primitive is compressed by "
                                  + Text_cursor::shown(extension.first)
                                  + ", which is not supported");
}

void read_points(const Gltf_numbers& numbers, const Skinned_vertices& transformations,
                 Mesh_file& mesh)
{
  for(std::size_t i = 0; i < numbers.count(); ++i)
  {
    const Eigen::Vector3d p
      = transformations(i) * Eigen::Vector3d(numbers(i, 0), numbers(i, 1), numbers(i, 2));
    mesh.points.push_back({p[0], p[1], p[2]});
    check_is_finite(mesh.points.back(), Element{"vertex", mesh.points.size() - 1});
  }
}

// The vertices of the mesh that belong to primitives with the same positions.
struct Vertices
{
  std::size_t first, count;
  bool is_mirrored;
};

void read_triangles(const Model& model, const Primitive& primitive, const Vertices& vertices,
                    Mesh_file& mesh)
{
  const auto [first, count, is_mirrored] = vertices;
  std::vector<std::size_t> corners(count);
  std::iota(corners.begin(), corners.end(), std::size_t(0));
  if(primitive.indices != -1)
  {
    const Gltf_numbers numbers(model, primitive.indices, 1, "the indices");
    if(!numbers.are_indices())
      throw std::invalid_argument("the indices are not unsigned integers");
    corners.resize(numbers.count());
    for(std::size_t i = 0; i < corners.size(); ++i)
      corners[i] = vertex_index(static_cast<long long>(numbers(i, 0)), count,
                                Element{"face", mesh.faces.size() + i / 3});
  }
  if(corners.size() % 3 != 0)
    throw std::invalid_argument("the number of corners, " + std::to_string(corners.size())
                                + ", is no multiple of 3");
  for(std::size_t i = 0; i < corners.size(); i += 3)
  {
    if(is_mirrored)
      std::swap(corners[i + 1], corners[i + 2]);
    mesh.faces.push_back({first + corners[i], first + corners[i + 1], first + corners[i + 2]});
  }
}

// Primitives often share their vertices, and differ in material.
void read_instance(const Model& model, const Mesh_instance& instance, Mesh_file& mesh)
{
  std::map<std::pair<int, int>, Vertices> vertices; // of accessors
  for(const Primitive& primitive : model.meshes[instance.mesh].primitives)
  {
    check_primitive(primitive);
    const auto position = primitive.attributes.find("POSITION");
    if(position == primitive.attributes.end())
      throw std::invalid_argument("the primitive has no attribute POSITION");
    const auto accessors = accessors_of_vertices(instance, primitive);
    auto found = vertices.find(accessors);
    if(found == vertices.end())
    {
      const Gltf_numbers numbers(model, position->second, 3, "POSITION");
      const Skinned_vertices transformations(model, instance, primitive, numbers.count());
      const Vertices added = {mesh.points.size(), numbers.count(), transformations.is_mirrored()};
      read_points(numbers, transformations, mesh);
      found = vertices.emplace(accessors, added).first;
    }
    read_triangles(model, primitive, found->second, mesh);
  }
}

// Merges vertices with the same number of _VERTEX, which are copies of one vertex, and sorts them by
// it.
void merge_copies(const Model& model, const Primitive& primitive, Mesh_file& mesh)
{
  const auto found = primitive.attributes.find("_VERTEX");
  if(found == primitive.attributes.end())
    return;
  const Gltf_numbers numbers(model, found->second, 1, "_VERTEX");
  if(numbers.count() != mesh.points.size())
    throw std::invalid_argument("there are " + std::to_string(numbers.count())
                                + " numbers _VERTEX, but " + std::to_string(mesh.points.size())
                                + " vertices");
  std::vector<std::size_t> order(mesh.points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  for(std::size_t v = 0; v < order.size(); ++v)
    if(const double number = numbers(v, 0); !(number >= 0) || number != std::floor(number))
      throw std::invalid_argument("_VERTEX of vertex " + std::to_string(v)
                                  + " is not the index of a vertex");
  std::stable_sort(order.begin(), order.end(), [&](const std::size_t v, const std::size_t w) {
    return numbers(v, 0) < numbers(w, 0);
  });
  std::vector<std::array<double, 3>> points;
  std::vector<std::size_t> merged(order.size());
  for(std::size_t i = 0; i < order.size(); ++i)
  {
    const std::array<double, 3>& point = mesh.points[order[i]];
    if(i == 0 || numbers(order[i - 1], 0) != numbers(order[i], 0))
      points.push_back(point);
    else if(point != points.back())
      throw std::invalid_argument("vertices " + std::to_string(order[i - 1]) + " and "
                                  + std::to_string(order[i])
                                  + " have the same number _VERTEX, but different positions");
    merged[order[i]] = points.size() - 1;
  }
  mesh.points.swap(points);
  Face_list faces;
  for(const Face_list::Face face : mesh.faces)
    faces.push_back({merged[face[0]], merged[face[1]], merged[face[2]]});
  mesh.faces = std::move(faces);
}

} // namespace

bool is_gltf_available() { return true; }

void read_gltf(const std::string& bytes, const std::string& path, Mesh_file& mesh)
{
  const Model model = load_gltf(bytes, path);
  check_positions(bytes);
  check_extensions(model);
  const std::vector<Mesh_instance> shown = mesh_instances(model);
  for(const Mesh_instance& instance : shown)
    read_instance(model, instance, mesh);
  if(shown.size() == 1 && model.meshes[shown[0].mesh].primitives.size() == 1)
    merge_copies(model, model.meshes[shown[0].mesh].primitives[0], mesh);
}

} // namespace Canonical_pose_tool
