// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shown_surface.h"
#include "Vertex_rotations.h"
#include "readers.h"
#include "rewriters.h"

#include <algorithm>
#include <array>
#include <ostream>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

void rewrite_medit(std::ostream& out, const std::string& bytes, const Points& points)
{
  Text_cursor text(bytes);
  Text_copy copy(out, bytes);
  while(text.word() != "Vertices")
    ;
  text.word(); // their number
  for(const std::array<double, 3>& point : points)
  {
    for(const double x : point)
      copy.replace(text.word(), x);
    text.word(); // the reference
  }
  copy.finish();
}

} // namespace

std::vector<std::string> attributes_of_file(const Mesh_file& mesh)
{
  if(!mesh.source)
    return {};
  switch(mesh.source->format)
  {
  case Format::OFF:
    return attributes_of_off(mesh.source->bytes);
  case Format::OBJ:
    return attributes_of_obj(mesh.source->bytes);
  case Format::PLY:
    return attributes_of_ply(mesh.source->bytes);
  case Format::STL:
    return has_rest_of_stl(mesh.source->bytes)
             ? std::vector<std::string>{"what follows the last face"}
             : std::vector<std::string>();
  case Format::MEDIT: // the rest of the file is kept
    return mesh.source->bytes.find("Normals") == std::string::npos
             ? std::vector<std::string>()
             : std::vector<std::string>{"turned normals"};
  case Format::GLB:
  case Format::GLTF:
    return attributes_of_gltf(mesh);
  default:
    return {};
  }
}

bool is_rewritable(const Mesh_file& mesh, const Format format)
{
  if(!mesh.source || mesh.source->format != format)
    return false;
  switch(format)
  {
  case Format::OFF:
  case Format::OBJ:
  case Format::STL:
  case Format::MEDIT:
    return true;
  case Format::PLY:
    return holds_positions(mesh.source->bytes);
  case Format::GLB:
    return is_rewritable_glb(mesh);
  default:
    return false;
  }
}

std::vector<std::string> losses(const Mesh_file& mesh, const Format format, const bool is_rewritten,
                                const bool has_files_beside)
{
  std::vector<std::string> names = attributes_of_file(mesh);
  const std::set<std::string> always
    = {"animations", "images that are not beside it", "morph targets", "skins", "turned normals"};
  const bool has_materials
    = format == Format::GLB || (format == Format::OBJ && has_files_beside)
      || (format == Format::PLY && has_files_beside && mesh.appearance.has_images());
  const auto is_kept = [&](const std::string& name) {
    if(is_rewritten)
      return always.count(name) == 0;
    const Appearance& appearance = mesh.appearance;
    const bool has_textures
      = format == Format::GLB || format == Format::PLY || format == Format::OBJ;
    const bool has_colors = has_textures || format == Format::OFF;
    if(name == "normals")
      return format == Format::GLB || format == Format::OBJ
               ? !appearance.normals.empty()
               : has_colors && !normals_of_vertices(mesh).empty();
    if(name == "colors")
      return has_colors && !appearance.vertex_colors.empty();
    if(name == "texture coordinates")
      return has_textures && !appearance.texture_coordinates.empty();
    return name == "materials" && has_materials && appearance.has_materials();
  };
  names.erase(std::remove_if(names.begin(), names.end(), is_kept), names.end());
  if(!is_rewritten && format == Format::OBJ && !mesh.appearance.vertex_opacities.empty())
    names.push_back("the opacity of colors");
  const auto is_colored = [](const Material& m) { return m.color != Material().color; };
  if(!is_rewritten && has_materials && format == Format::PLY
     && mesh.appearance.has_material(is_colored))
    names.push_back("colors of materials");
  if(!is_rewritten && has_materials && format != Format::GLB && mesh.appearance.has_other_maps())
    names.push_back("maps of materials other than colors");
  if(!is_rewritten && has_materials)
    names.insert(names.end(), mesh.appearance.missing.begin(), mesh.appearance.missing.end());
  std::vector<std::string> result; // each name once
  for(std::string& name : names)
    if(std::find(result.begin(), result.end(), name) == result.end())
      result.push_back(std::move(name));
  return result;
}

void rewrite_mesh(std::ostream& out, const Mesh_file& mesh, const Points& points,
                  const std::vector<Vertex_values>& values, Companion_files* const beside)
{
  if(beside)
    copy_files_beside(mesh, *beside);
  const std::string& bytes = mesh.source->bytes;
  if(mesh.source->has_byte_order_mark && mesh.source->format != Format::GLB)
    out << BYTE_ORDER_MARK;
  switch(mesh.source->format)
  {
  case Format::OFF:
    return rewrite_off(out, bytes, mesh, points);
  case Format::OBJ:
    return rewrite_obj(out, bytes, mesh, points);
  case Format::MEDIT:
    return rewrite_medit(out, bytes, points);
  case Format::PLY:
    return rewrite_ply(out, mesh, points, values);
  case Format::GLB:
    return rewrite_glb(out, mesh, points);
  default:
    return rewrite_stl(out, bytes, mesh, points);
  }
}

} // namespace Canonical_pose_tool
