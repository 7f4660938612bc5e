// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Gltf_numbers.h"
#include "Mesh_instance.h"
#include "Skinned_vertices.h"
#include "Vertex_rotations.h"
#include "load_gltf.h"
#include "readers.h"

#include <nlohmann/json.hpp>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numeric>
#include <ostream>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

using Json = nlohmann::ordered_json;

// The bytes of an accessor: `size` of them at `begin`, at `begin` plus the stride, and so on before `end`.
struct Byte_pattern
{
  Byte_pattern(const tinygltf::Model& model, const tinygltf::Accessor& a)
  {
    if(a.bufferView < 0 || static_cast<std::size_t>(a.bufferView) >= model.bufferViews.size())
      return;
    const tinygltf::BufferView& view = model.bufferViews[static_cast<std::size_t>(a.bufferView)];
    const int stride_of_view = a.ByteStride(view);
    if(stride_of_view <= 0 || a.count == 0)
      return;
    begin = view.byteOffset + a.byteOffset;
    stride = static_cast<std::size_t>(stride_of_view);
    size = static_cast<std::size_t>(
      tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(a.componentType))
      * tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(a.type)));
    end = begin + (a.count - 1) * stride + size;
  }

  // Whether they have bytes in common; interleaved attributes have not.
  bool overlaps(const Byte_pattern& other) const
  {
    if(end <= other.begin || other.end <= begin)
      return false;
    if(stride != other.stride)
      return true;
    const std::size_t after = (other.begin % stride + stride - begin % stride) % stride;
    return after < size || after + other.size > stride;
  }

  std::size_t begin = 0, end = 0, stride = 0, size = 0;
};

// Accessors into which numbers are written: those of the file, in its buffer, if they are in single precision, not yet
// taken, and no others have the same bytes; otherwise new ones, after it.
class Changed_accessors
{
public:
  Changed_accessors(const tinygltf::Model& model, Json& json, std::string& buffer)
    : m_model(model), m_json(json), m_buffer(buffer)
  {
    for(const tinygltf::Accessor& a : model.accessors)
      m_patterns.emplace_back(model, a);
  }

  // Writes `count` tuples, of which `tuple(i)` are the first three numbers; others are as in the accessor. Returns the index
  // of the accessor.
  template <class Function>
  std::size_t write(const int accessor, const int components, const std::string& name,
                    const Function& tuple)
  {
    const Gltf_numbers numbers(m_model, accessor, components, name);
    const tinygltf::Accessor& a = m_model.accessors[static_cast<std::size_t>(accessor)];
    const tinygltf::BufferView& view = m_model.bufferViews[static_cast<std::size_t>(a.bufferView)];
    auto index = static_cast<std::size_t>(accessor);
    std::size_t begin = view.byteOffset + a.byteOffset,
                stride = static_cast<std::size_t>(a.ByteStride(view));
    if(a.componentType != TINYGLTF_COMPONENT_TYPE_FLOAT || !m_taken.insert(accessor).second
       || has_common_bytes(accessor))
    {
      stride = static_cast<std::size_t>(components) * sizeof(float);
      std::tie(index, begin) = add_accessor({{"componentType", TINYGLTF_COMPONENT_TYPE_FLOAT},
                                             {"count", numbers.count()},
                                             {"type", components == 3 ? "VEC3" : "VEC4"}},
                                            numbers.count() * stride, TINYGLTF_TARGET_ARRAY_BUFFER);
    }
    Eigen::Vector3f low = Eigen::Vector3f::Constant((std::numeric_limits<float>::max)()),
                    high = -low;
    for(std::size_t i = 0; i < numbers.count(); ++i)
    {
      const Eigen::Vector3f p
        = tuple(i, Eigen::Vector3d(numbers(i, 0), numbers(i, 1), numbers(i, 2)))
            .template cast<float>();
      if(!p.allFinite())
        throw std::invalid_argument(
          "the surface is too large for glTF, which has single precision");
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
      char* const bytes = m_buffer.data() + begin + i * stride;
      std::memcpy(bytes, p.data(), 3 * sizeof(float));
      if(components == 4)
      {
        const auto last = static_cast<float>(numbers(i, 3));
        std::memcpy(bytes + 3 * sizeof(float), &last, sizeof(last));
      }
    }
    Json& changed = m_json["accessors"][index];
    changed.erase("min");
    changed.erase("max");
    if(name == "POSITION")
    {
      changed["min"] = {low[0], low[1], low[2]};
      changed["max"] = {high[0], high[1], high[2]};
    }
    return index;
  }

  // Writes the triangles of a primitive, turned over. Returns the index of the accessor.
  std::size_t write_turned_over(const tinygltf::Primitive& primitive, const std::size_t count)
  {
    std::vector<std::uint32_t> corners(count);
    std::iota(corners.begin(), corners.end(), 0u);
    if(primitive.indices >= 0)
    {
      const Gltf_numbers numbers(m_model, primitive.indices, 1, "the indices");
      corners.resize(numbers.count());
      for(std::size_t i = 0; i < corners.size(); ++i)
        corners[i] = static_cast<std::uint32_t>(numbers(i, 0));
    }
    for(std::size_t i = 0; i + 2 < corners.size(); i += 3)
      std::swap(corners[i + 1], corners[i + 2]);
    const auto [index, begin]
      = add_accessor({{"componentType", TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT},
                      {"count", corners.size()},
                      {"type", "SCALAR"}},
                     corners.size() * sizeof(std::uint32_t), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    std::memcpy(m_buffer.data() + begin, corners.data(), corners.size() * sizeof(std::uint32_t));
    return index;
  }

private:
  // Adds an accessor after the buffer. Returns its index, and where its bytes begin.
  std::pair<std::size_t, std::size_t> add_accessor(Json accessor, const std::size_t size,
                                                   const int target)
  {
    const std::size_t begin = (m_buffer.size() + 3) / 4 * 4;
    m_buffer.resize(begin + size);
    Json& views = m_json["bufferViews"];
    views.push_back(
      {{"buffer", 0}, {"byteOffset", begin}, {"byteLength", size}, {"target", target}});
    accessor["bufferView"] = views.size() - 1;
    Json& accessors = m_json["accessors"];
    accessors.push_back(std::move(accessor));
    return {accessors.size() - 1, begin};
  }

  bool has_common_bytes(const int accessor) const
  {
    const auto index = static_cast<std::size_t>(accessor);
    for(std::size_t other = 0; other < m_patterns.size(); ++other)
      if(other != index && m_patterns[index].overlaps(m_patterns[other]))
        return true;
    return false;
  }

  const tinygltf::Model& m_model;
  Json& m_json;
  std::string& m_buffer;
  std::vector<Byte_pattern> m_patterns; // of the accessors
  std::set<int> m_taken;
};

// Those of the vertices of a mesh that was read from the model, in the space of the scene.
std::vector<Eigen::Vector3d> normals_of(const tinygltf::Model& model)
{
  std::vector<Eigen::Vector3d> result;
  for(const Mesh_instance& instance : mesh_instances(model))
  {
    std::set<std::pair<int, int>> known;
    for(const tinygltf::Primitive& primitive : model.meshes[instance.mesh].primitives)
    {
      if(!known.insert(accessors_of_vertices(instance, primitive)).second)
        continue;
      const std::size_t first = result.size();
      const std::size_t count
        = Gltf_numbers(model, primitive.attributes.at("POSITION"), 3, "POSITION").count();
      result.resize(first + count, Eigen::Vector3d::Zero());
      const auto found = primitive.attributes.find("NORMAL");
      if(found == primitive.attributes.end())
        continue;
      const Gltf_numbers normals(model, found->second, 3, "NORMAL");
      const Skinned_vertices transformations(model, instance, primitive, count);
      for(std::size_t i = 0; i < count; ++i)
        result[first + i] = transformations(i).linear().inverse().transpose()
                            * Eigen::Vector3d(normals(i, 0), normals(i, 1), normals(i, 2));
    }
  }
  return result;
}

// Changes the primitives of a mesh that a node shows, whose first vertex is `first`; adds the number of its vertices to that.
void change_instance(const tinygltf::Model& model, const Mesh_instance& instance, Json& mesh,
                     const Points& points, const Vertex_rotations& rotations, std::size_t& first,
                     Changed_accessors& changed)
{
  const Eigen::Affine3d from_scene = instance.transformation.inverse();
  std::map<std::pair<int, int>, std::size_t> first_of_vertices;
  std::map<std::pair<std::pair<int, int>, int>, std::size_t>
    new_accessors; // by vertices and the attribute
  const auto& primitives = model.meshes[instance.mesh].primitives;
  for(std::size_t p = 0; p < primitives.size(); ++p)
  {
    const auto& attributes = primitives[p].attributes;
    const int positions = attributes.at("POSITION");
    const std::size_t count = model.accessors[static_cast<std::size_t>(positions)].count;
    const auto vertices = accessors_of_vertices(instance, primitives[p]);
    const auto [found, is_new] = first_of_vertices.emplace(vertices, first);
    if(is_new)
      first += count;
    const std::size_t begin = found->second;
    const Skinned_vertices transformations(model, instance, primitives[p], count);
    for(const std::string name : {"POSITION", "NORMAL", "TANGENT"})
    {
      const auto attribute = attributes.find(name);
      if(attribute == attributes.end())
        continue;
      const auto [accessor, is_unknown]
        = new_accessors.emplace(std::make_pair(vertices, attribute->second), 0);
      const auto of_directions = [&](const Eigen::Affine3d& transformation) -> Eigen::Matrix3d {
        if(name == "NORMAL")
          return transformation.linear().inverse().transpose();
        return transformation.linear();
      };
      const Eigen::Matrix3d back = of_directions(instance.transformation).inverse();
      if(is_unknown)
        accessor->second = changed.write(
          attribute->second, name == "TANGENT" ? 4 : 3, name,
          [&](const std::size_t i, const Eigen::Vector3d& before) -> Eigen::Vector3d {
            if(name == "POSITION")
              return from_scene * vector_of(points[begin + i]);
            const Eigen::Vector3d direction = of_directions(transformations(i)) * before;
            return (back * rotations(begin + i, direction)).normalized();
          });
      mesh["primitives"][p]["attributes"][name] = accessor->second;
    }
    if(transformations.is_mirrored() != (instance.transformation.linear().determinant() < 0))
      mesh["primitives"][p]["indices"] = changed.write_turned_over(primitives[p], count);
    if(!instance.joints.empty())
    {
      Json kept = Json::object();
      for(const auto& attribute : mesh["primitives"][p]["attributes"].items())
        if(attribute.key().compare(0, 7, "JOINTS_") != 0
           && attribute.key().compare(0, 8, "WEIGHTS_") != 0)
          kept[attribute.key()] = attribute.value();
      mesh["primitives"][p]["attributes"] = kept;
    }
  }
}

} // namespace

bool is_rewritable_glb(const Mesh_file& mesh)
try
{
  const tinygltf::Model model = load_gltf(mesh.source->bytes, "");
  if(model.buffers.size() != 1 || !model.buffers[0].uri.empty())
    return false;
  for(const Mesh_instance& instance : mesh_instances(model))
  {
    if(std::abs(instance.transformation.linear().determinant())
       < (std::numeric_limits<double>::min)())
      return false;
    for(const tinygltf::Primitive& primitive : model.meshes[instance.mesh].primitives)
    {
      const std::size_t count
        = Gltf_numbers(model, primitive.attributes.at("POSITION"), 3, "POSITION").count();
      for(const char* const name : {"NORMAL", "TANGENT"})
        if(const auto found = primitive.attributes.find(name);
           found != primitive.attributes.end()
           && Gltf_numbers(model, found->second, std::strcmp(name, "NORMAL") == 0 ? 3 : 4, name)
                  .count()
                != count)
          return false;
      if(primitive.attributes.count("_VERTEX") > 0 || primitive.mode != TINYGLTF_MODE_TRIANGLES)
        return false;
    }
  }
  return true;
}
catch(const std::invalid_argument&) // of external buffers, or attributes that are not read
{
  return false;
}

void rewrite_glb(std::ostream& out, const Mesh_file& mesh, const Points& points)
{
  const std::string& bytes = mesh.source->bytes;
  const tinygltf::Model model = load_gltf(bytes, "");
  const Glb_chunks chunks = chunks_of_glb(bytes);
  Json json = Json::parse(chunks.json);
  std::string buffer(chunks.buffer);
  for(Json& changed : json["meshes"])
  {
    changed.erase("weights");
    for(Json& primitive : changed["primitives"])
      primitive.erase("targets");
  }
  json.erase("animations");
  json.erase("skins");
  if(json.contains("nodes"))
    for(Json& node : json["nodes"])
      node.erase("skin");

  const Vertex_rotations rotations(mesh, points, normals_of(model));
  Changed_accessors changed(model, json, buffer);
  const Json meshes = json["meshes"];
  std::set<std::size_t> shown;
  std::size_t first = 0;
  for(const Mesh_instance& instance : mesh_instances(model))
  {
    std::size_t index = instance.mesh;
    if(!shown.insert(index).second) // by an earlier node, which has other positions now
    {
      index = json["meshes"].size();
      json["meshes"].push_back(meshes[instance.mesh]);
      json["nodes"][*instance.node]["mesh"] = index;
    }
    change_instance(model, instance, json["meshes"][index], points, rotations, first, changed);
  }
  buffer.resize((buffer.size() + 3) / 4 * 4);
  json["buffers"][0]["byteLength"] = buffer.size();

  out << glb_of(json.dump(), buffer, chunks.rest);
}

} // namespace Canonical_pose_tool
