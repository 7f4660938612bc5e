// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shown_surface.h"
#include "Vertex_rotations.h"
#include "readers.h"
#include "rewriters.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
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

std::vector<std::string> attributes_of_medit(const Mesh_file& mesh)
{
  static const std::set<std::string_view> others
    = {"MeshVersionFormatted", "Dimension", "Vertices", "Tetrahedra", "End"};
  std::vector<std::string> result;
  const auto has_labels = [](const std::vector<long long>& labels) {
    return std::any_of(labels.begin(), labels.end(), [](const long long x) { return x != 0; });
  };
  if(has_labels(mesh.point_references) || has_labels(mesh.cell_references))
    result.push_back("labels");
  Text_cursor text(mesh.source->bytes);
  for(std::string_view word = text.word(); !word.empty(); word = text.word())
    if(std::isalpha(static_cast<unsigned char>(word[0])) && others.count(word) == 0)
    {
      const std::string name = "the section " + std::string(word);
      if(text.word() != "0") // elements
        result.push_back(name);
      text.skip_line();
    }
  if(has_comments(mesh.source->bytes))
    result.push_back(COMMENTS);
  return result;
}

bool has_isolated_vertices(const Mesh_file& mesh)
{
  std::vector<bool> has_face(mesh.points.size(), false);
  for(const Face_list::Face face : mesh.faces)
    for(const std::size_t v : face)
      has_face[v] = true;
  return std::find(has_face.begin(), has_face.end(), false) != has_face.end();
}

} // namespace

bool has_comments(const std::string& bytes)
{
  const auto begins_word = [&](const std::size_t i) {
    return i == 0 || std::isspace(static_cast<unsigned char>(bytes[i - 1]));
  };
  std::size_t i = bytes.find('#');
  while(i != std::string::npos && !begins_word(i))
    i = bytes.find('#', i + 1);
  return i != std::string::npos;
}

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
    return attributes_of_stl(mesh);
  case Format::MEDIT:
    return attributes_of_medit(mesh);
  case Format::GLB:
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
  case Format::PLY:
    return true;
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
  if(is_rewritten && format == Format::PLY)
    names = integers_of_ply(mesh.source->bytes);
  if(is_rewritten && std::count(names.begin(), names.end(), "the section Normals") > 0)
    names.push_back("turned normals");
  const std::set<std::string> always = {"animations",      "images that are not beside it",
                                        "integer normals", "integer positions",
                                        "morph targets",   "skins",
                                        "turned normals"};
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
    if(name == "labels")
      return format == Format::VTU || format == Format::MEDIT;
    return name == "materials" && has_materials && appearance.has_materials();
  };
  names.erase(std::remove_if(names.begin(), names.end(), is_kept), names.end());
  if(!is_rewritten && format == Format::OBJ && !mesh.appearance.vertex_opacities.empty())
    names.push_back(OPACITY_OF_COLORS);
  const auto is_colored = [](const Material& m) { return m.color != Material().color; };
  if(!is_rewritten && has_materials && format == Format::PLY
     && mesh.appearance.has_material(is_colored))
    names.push_back("colors of materials");
  const auto has_name = [](const Material& m) { return !m.name.empty(); };
  if(!is_rewritten && has_materials && format == Format::PLY
     && mesh.appearance.has_material(has_name))
    names.push_back("names of materials");
  if(!is_rewritten && has_materials && format != Format::GLB && mesh.appearance.has_other_maps())
    names.push_back(OTHER_MAPS);
  if(!is_rewritten && has_materials && format != Format::GLB
     && mesh.appearance.has_material([](const Material& m) { return m.has_numbers_of_gltf(); }))
    names.push_back(OTHER_PROPERTIES);
  if(!is_rewritten && has_materials)
    names.insert(names.end(), mesh.appearance.missing.begin(), mesh.appearance.missing.end());
  const auto is_polygon = [](const Face_list::Face face) { return face.size() > 3; };
  if(!is_rewritten && format == Format::GLB
     && std::any_of(mesh.faces.begin(), mesh.faces.end(), is_polygon))
    names.push_back("polygons");
  if(!is_rewritten && format == Format::STL && !mesh.is_tetrahedral && has_isolated_vertices(mesh))
    names.push_back("isolated vertices");
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
