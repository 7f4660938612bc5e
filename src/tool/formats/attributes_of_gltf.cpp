// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// What a glTF file has beside positions and faces.

#include "Mesh_file.h"
#include "load_gltf.h"
#include "readers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

using Json = nlohmann::ordered_json;

// Empty for what is read with positions, or belongs to a skin.
std::string name_of_attribute(const std::string& attribute)
{
  const auto begins_with
    = [&](const std::string& text) { return attribute.compare(0, text.size(), text) == 0; };
  if(attribute == "POSITION" || attribute == "_VERTEX" || begins_with("JOINTS_")
     || begins_with("WEIGHTS_"))
    return {};
  return attribute == "NORMAL"      ? "normals"
         : attribute == "COLOR_0"   ? "colors"
         : begins_with("TEXCOORD_") ? "texture coordinates"
                                    : "the attribute " + attribute;
}

bool has_extras(const Json& json)
{
  return (json.is_object() && json.contains("extras"))
         || std::any_of(json.begin(), json.end(),
                        [](const Json& part) { return part.is_structured() && has_extras(part); });
}

// Those are carried, or named with their materials.
bool is_of_materials(const std::string& extension)
{
  return extension == "KHR_mesh_quantization" || extension == "KHR_texture_transform"
         || (extension.compare(0, 14, "KHR_materials_") == 0
             && extension != "KHR_materials_variants");
}

} // namespace

std::vector<std::string> attributes_of_gltf(const Mesh_file& mesh)
try
{
  const Json json = Json::parse(chunks_of_glb(mesh.source->bytes).json);
  std::vector<std::string> result;
  const auto add_if = [&](const bool is_there, const std::string& name) {
    if(is_there)
      result.push_back(name);
  };
  const auto has_any = [&](const char* const list, const char* const key) {
    const Json entries = json.value(list, Json::array());
    return std::any_of(entries.begin(), entries.end(),
                       [&](const Json& entry) { return entry.contains(key); });
  };
  for(const Json& shape : json.value("meshes", Json::array()))
    for(const Json& primitive : shape.value("primitives", Json::array()))
    {
      const Json attributes = primitive.value("attributes", Json::object());
      for(const auto& attribute : attributes.items())
        add_if(true, name_of_attribute(attribute.key()));
      add_if(attributes.contains("TEXCOORD_0") && attributes.contains("TEXCOORD_1"),
             "other sets of texture coordinates");
      add_if(primitive.contains("material"), "materials");
      add_if(primitive.contains("targets"), "morph targets");
    }
  for(const char* const name : {"skins", "animations", "cameras"})
    add_if(!json.value(name, Json::array()).empty(), name);
  add_if(json.value("nodes", Json::array()).size() > 1, "nodes");
  add_if(json.value("scenes", Json::array()).size() > 1, "other scenes");
  add_if(has_any("nodes", "name") || has_any("meshes", "name"), "names of nodes and meshes");
  add_if(json.value("asset", Json::object()).contains("copyright"), "the copyright");
  add_if(has_extras(json), "extras");
  for(const Json& extension : json.value("extensionsUsed", Json::array()))
    add_if(!is_of_materials(extension), "the extension " + extension.get<std::string>());
  const Json images = json.value("images", Json::array());
  add_if(std::any_of(images.begin(), images.end(),
                     [](const Json& image) {
                       const std::string uri = image.value("uri", std::string());
                       return !uri.empty() && uri.compare(0, 5, "data:") != 0;
                     }),
         "images that are not beside it");
  result.erase(std::remove(result.begin(), result.end(), std::string()), result.end());
  return result;
}
catch(const Json::exception&) // what is not as it should be was not read
{
  return {};
}

} // namespace Canonical_pose_tool
