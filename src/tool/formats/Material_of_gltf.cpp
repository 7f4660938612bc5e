// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Material_of_gltf.h"
#include "Text_cursor.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <set>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

// Of a list of the model; null if there is none.
template <class Entry>
const Entry* entry(const std::vector<Entry>& list, const int i)
{
  return i >= 0 && static_cast<std::size_t>(i) < list.size() ? &list[static_cast<std::size_t>(i)]
                                                             : nullptr;
}

double between_0_and_1(const double x) { return (std::min)((std::max)(x, 0.), 1.); }

Sampler sampler_of(const tinygltf::Sampler& sampler)
{
  // Others are the default, or not numbers of glTF.
  const auto known = [](const int value, const std::initializer_list<int>& values) {
    return std::find(values.begin(), values.end(), value) == values.end() ? -1 : value;
  };
  const auto mag_filters = {TINYGLTF_TEXTURE_FILTER_NEAREST, TINYGLTF_TEXTURE_FILTER_LINEAR};
  const auto mipmap_filters = {
    TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST, TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST,
    TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR, TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR};
  const auto wraps = {TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE, TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT};
  return {
    known(sampler.magFilter, mag_filters),
    (std::max)(known(sampler.minFilter, mag_filters), known(sampler.minFilter, mipmap_filters)),
    known(sampler.wrapS, wraps), known(sampler.wrapT, wraps)};
}

// The image of a texture, if it is one within the file.
Material_map map_of(const tinygltf::Model& model, const int number_of_texture)
{
  Material_map result;
  const auto* const texture = entry(model.textures, number_of_texture);
  if(const auto* const sampler = texture ? entry(model.samplers, texture->sampler) : nullptr)
    result.sampler = sampler_of(*sampler);
  const auto* const image = texture ? entry(model.images, texture->source) : nullptr;
  const auto* const view = image ? entry(model.bufferViews, image->bufferView) : nullptr;
  const auto* const buffer = view ? entry(model.buffers, view->buffer) : nullptr;
  if(!buffer || view->byteOffset > buffer->data.size()
     || view->byteLength > buffer->data.size() - view->byteOffset)
    return result;
  const auto begin = buffer->data.begin() + static_cast<std::ptrdiff_t>(view->byteOffset);
  result.image.assign(begin, begin + static_cast<std::ptrdiff_t>(view->byteLength));
  if(type_of_image(result.image).empty())
    result.image.clear();
  return result;
}

template <class Info>
Texture_transform transform_of_image(const Info& info)
{
  Texture_transform result;
  result.set = info.texCoord;
  const auto found = info.extensions.find("KHR_texture_transform");
  if(found == info.extensions.end())
    return result;
  const tinygltf::Value& transform = found->second;
  const auto read_pair = [&](const char* const name, std::array<double, 2>& pair) {
    const tinygltf::Value& values = transform.Get(name);
    for(std::size_t k = 0; k < 2 && values.IsArray() && values.ArrayLen() == 2; ++k)
      if(values.Get(k).IsNumber())
        pair[k] = values.Get(k).GetNumberAsDouble();
  };
  read_pair("offset", result.offset);
  read_pair("scale", result.scale);
  if(transform.Get("rotation").IsNumber())
    result.rotation = transform.Get("rotation").GetNumberAsDouble();
  if(transform.Get("texCoord").IsNumber())
    result.set = transform.Get("texCoord").GetNumberAsInt();
  return result;
}

} // namespace

Texture_transform transform_of(const tinygltf::Material& material)
{
  const tinygltf::PbrMetallicRoughness& base = material.pbrMetallicRoughness;
  return base.baseColorTexture.index >= 0 ? transform_of_image(base.baseColorTexture)
         : base.metallicRoughnessTexture.index >= 0
           ? transform_of_image(base.metallicRoughnessTexture)
         : material.normalTexture.index >= 0    ? transform_of_image(material.normalTexture)
         : material.occlusionTexture.index >= 0 ? transform_of_image(material.occlusionTexture)
                                                : transform_of_image(material.emissiveTexture);
}

Material material_of(const tinygltf::Model& model, const tinygltf::Material& material,
                     std::set<std::string>& missing)
{
  Material result;
  result.name = material.name;
  const tinygltf::PbrMetallicRoughness& base = material.pbrMetallicRoughness;
  for(std::size_t k = 0; k < 4 && k < base.baseColorFactor.size(); ++k)
    result.color[k] = between_0_and_1(base.baseColorFactor[k]);
  for(std::size_t k = 0; k < 3 && k < material.emissiveFactor.size(); ++k)
    result.emission[k] = between_0_and_1(material.emissiveFactor[k]);
  result.metallic = between_0_and_1(base.metallicFactor);
  result.roughness = between_0_and_1(base.roughnessFactor);
  result.strength_of_normals = material.normalTexture.scale;
  result.strength_of_occlusion = between_0_and_1(material.occlusionTexture.strength);
  if(material.alphaMode == "BLEND" || material.alphaMode == "MASK")
    result.alpha_mode = material.alphaMode;
  else
    result.color[3] = 1;
  result.alpha_cutoff = (std::max)(material.alphaCutoff, 0.);
  result.is_double_sided = material.doubleSided;
  const Material_map map_of_color = map_of(model, base.baseColorTexture.index);
  result.image = map_of_color.image;
  result.sampler = map_of_color.sampler;

  const auto read = [&](const auto& info, const std::string& name) {
    if(info.index < 0)
      return Material_map();
    if(transform_of_image(info) == transform_of(material))
      return map_of(model, info.index);
    missing.insert("the image of " + name + ", which has texture coordinates of its own");
    return Material_map();
  };
  result.metallic_roughness_map = read(base.metallicRoughnessTexture, "metal and roughness");
  result.normal_map = read(material.normalTexture, "normals");
  result.occlusion_map = read(material.occlusionTexture, "occlusion");
  result.emission_map = read(material.emissiveTexture, "emission");
  for(const auto& extension : material.extensions)
    missing.insert("the extension " + Text_cursor::shown(extension.first) + " of materials");
  return result;
}

} // namespace Canonical_pose_tool
