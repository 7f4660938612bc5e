// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_GLTF_MATERIALS_H
#define CGAL_CANONICAL_POSE_3_TOOL_GLTF_MATERIALS_H

#include "Appearance.h"
#include "Gltf_builder.h"

#include <nlohmann/json.hpp>

#include <map>
#include <string>
#include <utility>

namespace Canonical_pose_tool {

// Adds materials to a model; an image is there once.
class Gltf_materials
{
public:
  explicit Gltf_materials(Gltf_builder& builder) : m_builder(builder) {}

  // Returns its index. Without texture coordinates, it has no texture.
  int add(const Material& given, const bool has_texture_coordinates)
  {
    tinygltf::Material material;
    material.doubleSided = given.is_double_sided;
    tinygltf::PbrMetallicRoughness& base = material.pbrMetallicRoughness;
    base.metallicFactor = given.metallic;
    base.roughnessFactor = given.roughness;
    base.baseColorFactor.assign(given.color.begin(), given.color.end());
    if(nlohmann::json::accept('"' + given.name + '"')) // no other encoding
      material.name = given.name;
    material.alphaMode = given.alpha_mode;
    if(given.alpha_mode == "MASK")
      material.alphaCutoff = given.alpha_cutoff;
    material.emissiveFactor.assign(given.emission.begin(), given.emission.end());
    if(has_texture_coordinates)
    {
      base.baseColorTexture.index = texture_of(given.image, given.sampler);
      base.metallicRoughnessTexture.index = texture_of(given.metallic_roughness_map);
      material.normalTexture.index = texture_of(given.normal_map);
      material.normalTexture.scale = given.strength_of_normals;
      material.occlusionTexture.index = texture_of(given.occlusion_map);
      material.occlusionTexture.strength = given.strength_of_occlusion;
      material.emissiveTexture.index = texture_of(given.emission_map);
    }
    m_builder.model().materials.push_back(material);
    return static_cast<int>(m_builder.model().materials.size()) - 1;
  }

  // Makes this the material of a primitive in the variant.
  static void add_to_variant(tinygltf::Primitive& primitive, const int material)
  {
    using tinygltf::Value;
    const Value mapping(
      Value::Object{{"material", Value(material)}, {"variants", Value(Value::Array{Value(0)})}});
    primitive.extensions[VARIANTS]
      = Value(Value::Object{{"mappings", Value(Value::Array{mapping})}});
  }

  void add_variant()
  {
    using tinygltf::Value;
    const Value name(Value::Object{{"name", Value(std::string("texture"))}});
    m_builder.model().extensions[VARIANTS]
      = Value(Value::Object{{"variants", Value(Value::Array{name})}});
    m_builder.model().extensionsUsed.push_back(VARIANTS);
  }

private:
  int texture_of(const Material_map& map) { return texture_of(map.image, map.sampler); }

  // Its index; -1 if there is no image.
  int texture_of(const std::string& content, const Sampler& sampler)
  {
    if(content.empty())
      return -1;
    const auto [image, is_new_image] = m_images.emplace(content, 0);
    if(is_new_image)
      image->second = m_builder.append_image(content, type_of_image(content));
    const auto [texture, is_new] = m_textures.emplace(std::make_pair(image->second, sampler), 0);
    if(is_new)
      texture->second = m_builder.append_texture(image->second, sampler);
    return texture->second;
  }

  static constexpr const char* VARIANTS = "KHR_materials_variants";

  Gltf_builder& m_builder;
  std::map<std::string, int> m_images;               // by their contents
  std::map<std::pair<int, Sampler>, int> m_textures; // by images
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_GLTF_MATERIALS_H
