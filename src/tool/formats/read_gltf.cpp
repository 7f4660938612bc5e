// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Material_of_gltf.h"
#include "Gltf_numbers.h"
#include "Mesh_instance.h"
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
#include <optional>
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
  static const std::array<const char*, 4> modes
    = {"points", "lines", "line loops",
       "line strips"}; // before triangles, and strips and fans of them
  if(primitive.mode < 0 || primitive.mode > TINYGLTF_MODE_TRIANGLE_FAN)
    throw std::invalid_argument("the primitive has the unknown mode "
                                + std::to_string(primitive.mode));
  if(primitive.mode < TINYGLTF_MODE_TRIANGLES)
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
    check_is_finite(mesh, mesh.points.back(), Element{"vertex", mesh.points.size() - 1});
  }
}

// The vertices of the mesh that belong to primitives with the same positions.
struct Vertices
{
  std::size_t first, count;
  bool is_mirrored;
};

// The triangles of a strip or fan. Those with a vertex twice lead from one strip to another.
std::vector<std::size_t> corners_of_strip(const std::vector<std::size_t>& vertices,
                                          const bool is_fan)
{
  std::vector<std::size_t> corners;
  for(std::size_t i = 2; i < vertices.size(); ++i)
  {
    const std::size_t a = vertices[is_fan ? 0 : i - 2], b = vertices[i - 1], c = vertices[i];
    const bool is_odd = !is_fan && i % 2 == 1;
    if(a != b && b != c && c != a)
      corners.insert(corners.end(), {is_odd ? b : a, is_odd ? a : b, c});
  }
  return corners;
}

// The vertices of the triangles of a primitive, counted from 0. `face`: the index in `mesh` of the first triangle.
std::vector<std::size_t> corners_of(const Model& model, const Primitive& primitive,
                                    const std::size_t count, const bool is_mirrored,
                                    const Mesh_file& mesh, const std::size_t face)
{
  const bool is_strip = primitive.mode != TINYGLTF_MODE_TRIANGLES;
  std::vector<std::size_t> corners(count);
  std::iota(corners.begin(), corners.end(), std::size_t(0));
  if(primitive.indices != -1)
  {
    const Gltf_numbers numbers(model, primitive.indices, 1, "the indices");
    if(!numbers.are_indices())
      throw std::invalid_argument("the indices are not unsigned integers");
    corners.resize(numbers.count());
    for(std::size_t i = 0; i < corners.size(); ++i)
      corners[i] = vertex_index(
        mesh, static_cast<long long>(numbers(i, 0)), count,
        Element{"face", face + (is_strip ? (std::max)(i, std::size_t(2)) - 2 : i / 3)});
  }
  if(is_strip)
    corners = corners_of_strip(corners, primitive.mode == TINYGLTF_MODE_TRIANGLE_FAN);
  if(corners.size() % 3 != 0)
    throw std::invalid_argument("the number of corners, " + std::to_string(corners.size())
                                + ", is no multiple of 3");
  for(std::size_t i = 0; is_mirrored && i < corners.size(); i += 3)
    std::swap(corners[i + 1], corners[i + 2]);
  return corners;
}

void read_triangles(const Model& model, const Primitive& primitive, const Vertices& vertices,
                    Mesh_file& mesh)
{
  const std::vector<std::size_t> corners
    = corners_of(model, primitive, vertices.count, vertices.is_mirrored, mesh, mesh.faces.size());
  // Vertices that the primitive does not have may be those of another one.
  const auto vertex = [&](const std::size_t corner) {
    return corner < vertices.count ? vertices.first + corner : NO_VERTEX;
  };
  for(std::size_t i = 0; i < corners.size(); i += 3)
    mesh.faces.push_back({vertex(corners[i]), vertex(corners[i + 1]), vertex(corners[i + 2])});
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
  const auto vertex
    = [&](const std::size_t v) { return v < merged.size() ? merged[v] : NO_VERTEX; };
  Face_list faces;
  for(const Face_list::Face face : mesh.faces)
    faces.push_back({vertex(face[0]), vertex(face[1]), vertex(face[2])});
  mesh.faces = std::move(faces);
}

bool have_same_vertices(const std::vector<Primitive>& primitives)
{
  return !primitives.empty()
         && std::all_of(primitives.begin(), primitives.end(), [&](const Primitive& primitive) {
              return primitive.attributes == primitives[0].attributes;
            });
}

unsigned char srgb(const double linear)
{
  const double x = (std::min)((std::max)(linear, 0.), 1.);
  const double y = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
  return static_cast<unsigned char>(std::lround(255 * y));
}

// Reads the appearance of the primitives of a mesh that was read, in the same order.
class Appearance_reader
{
public:
  Appearance_reader(const Model& model, Mesh_file& mesh)
    : m_model(model), m_mesh(mesh), m_appearance(mesh.appearance)
  {
    for(const tinygltf::Material& material : model.materials)
      m_appearance.materials.push_back(material_of(model, material, m_appearance.missing));
    m_appearance.materials.emplace_back(); // of primitives without
  }

  void read(const Mesh_instance& instance, const Primitive& primitive)
  {
    const std::size_t count
      = Gltf_numbers(m_model, primitive.attributes.at("POSITION"), 3, "POSITION").count();
    const bool is_mirrored = Skinned_vertices(m_model, instance, primitive, count).is_mirrored();
    const std::vector<std::size_t> corners
      = corners_of(m_model, primitive, count, is_mirrored, m_mesh, m_face);
    const auto material = static_cast<std::size_t>(primitive.material);
    const bool has_material = primitive.material >= 0 && material < m_model.materials.size();
    m_has_materials = m_has_materials || has_material;
    read_colors(primitive, corners);
    read_normals(instance, primitive, count, corners);
    read_coordinates(primitive, corners,
                     has_material ? transform_of(m_model.materials[material])
                                  : Texture_transform());
    m_appearance.material_of_face.resize(
      m_face += corners.size() / 3, has_material ? material : m_appearance.materials.size() - 1);
  }

  // What no primitive has is removed.
  void finish()
  {
    if(!m_has_coordinates)
      m_appearance.texture_coordinates.clear();
    if(!m_has_normals)
      m_appearance.normals.clear();
    if(!m_has_materials)
    {
      m_appearance.materials.clear();
      m_appearance.material_of_face.clear();
    }
  }

private:
  // The accessor of an attribute with a tuple for each vertex; none if it is not so.
  std::optional<Gltf_numbers> numbers(const Primitive& primitive, const std::string& name,
                                      const int components,
                                      const std::vector<std::size_t>& corners) const
  try
  {
    const auto found = primitive.attributes.find(name);
    if(found == primitive.attributes.end())
      return std::nullopt;
    const Gltf_numbers result(m_model, found->second, components, name);
    const auto largest = std::max_element(corners.begin(), corners.end());
    return largest == corners.end() || *largest < result.count() ? std::optional(result)
                                                                 : std::nullopt;
  }
  catch(const std::invalid_argument&)
  {
    return std::nullopt;
  }

  bool is_opaque(const Primitive& primitive) const
  {
    const auto material = static_cast<std::size_t>(primitive.material);
    return primitive.material < 0 || material >= m_appearance.materials.size()
           || m_appearance.materials[material].alpha_mode == "OPAQUE";
  }

  void read_colors(const Primitive& primitive, const std::vector<std::size_t>& corners)
  {
    std::optional<Gltf_numbers> colors = numbers(primitive, "COLOR_0", 4, corners);
    const bool has_opacity = colors.has_value() && !is_opaque(primitive);
    if(!colors)
      colors = numbers(primitive, "COLOR_0", 3, corners);
    if(!colors)
      return;
    if(m_appearance.vertex_colors.empty())
    {
      m_appearance.vertex_colors.assign(m_mesh.points.size(), Color{255, 255, 255});
      m_appearance.vertex_opacities.assign(m_mesh.points.size(), 255);
    }
    for(std::size_t i = 0; i < corners.size(); ++i)
    {
      const std::size_t v = m_mesh.faces[m_face + i / 3][i % 3];
      for(std::size_t k = 0; k < 3; ++k)
        m_appearance.vertex_colors[v][k] = srgb((*colors)(corners[i], k));
      if(has_opacity)
        m_appearance.vertex_opacities[v] = byte_of((*colors)(corners[i], 3), 1);
    }
  }

  void read_normals(const Mesh_instance& instance, const Primitive& primitive,
                    const std::size_t count, const std::vector<std::size_t>& corners)
  {
    const auto normals = numbers(primitive, "NORMAL", 3, corners);
    m_has_normals = m_has_normals || normals;
    const Skinned_vertices transformations(m_model, instance, primitive, count);
    for(const std::size_t v : corners)
    {
      Eigen::Vector3f normal = Eigen::Vector3f::Zero();
      if(normals)
        normal = (transformations(v).linear().inverse().transpose()
                  * Eigen::Vector3d((*normals)(v, 0), (*normals)(v, 1), (*normals)(v, 2)))
                   .cast<float>();
      m_appearance.normals.push_back({normal[0], normal[1], normal[2]});
    }
  }

  void read_coordinates(const Primitive& primitive, const std::vector<std::size_t>& corners,
                        const Texture_transform& transform)
  {
    const auto coordinates
      = numbers(primitive, "TEXCOORD_" + std::to_string(transform.set), 2, corners);
    m_has_coordinates = m_has_coordinates || coordinates;
    for(const std::size_t v : corners)
      m_appearance.texture_coordinates.push_back(
        coordinates ? transform((*coordinates)(v, 0), (*coordinates)(v, 1))
                    : std::array<float, 2>{0, 0});
  }

  const Model& m_model;
  const Mesh_file& m_mesh;
  Appearance& m_appearance;
  std::size_t m_face = 0;
  bool m_has_coordinates = false, m_has_normals = false, m_has_materials = false;
};

} // namespace

bool is_gltf_available() { return true; }

void read_gltf(const std::string& bytes, const std::string& path, Mesh_file& mesh)
{
  const Model model = load_gltf(bytes, path);
  check_model(bytes, model);
  check_extensions(model);
  const std::vector<Mesh_instance> shown = mesh_instances(model);
  for(const Mesh_instance& instance : shown)
    read_instance(model, instance, mesh);
  if(shown.size() == 1 && have_same_vertices(model.meshes[shown[0].mesh].primitives))
    merge_copies(model, model.meshes[shown[0].mesh].primitives[0], mesh);
}

void load_appearance_of_gltf(Mesh_file& mesh)
{
  const Model model = load_gltf(mesh.source->bytes, "");
  Appearance_reader reader(model, mesh);
  for(const Mesh_instance& instance : mesh_instances(model))
    for(const Primitive& primitive : model.meshes[instance.mesh].primitives)
      reader.read(instance, primitive);
  reader.finish();
}

} // namespace Canonical_pose_tool
