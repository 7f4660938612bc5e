// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shortest_numbers.h"
#include "Shown_surface.h"
#include "Written_images.h"

#include <array>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

void announce_color(std::ostream& out)
{
  out << "property uchar red\nproperty uchar green\nproperty uchar blue\n";
}

void write_color(std::ostream& out, const Color& color)
{
  for(const unsigned char c : color)
    out << ' ' << static_cast<int>(c);
}

// Colors that show results come before those of the surface itself.
const std::vector<Color>& colors_of(const Shown_surface& surface)
{
  return surface.vertex_colors.empty() ? surface.mesh.appearance.vertex_colors
                                       : surface.vertex_colors;
}

bool has_opacities(const Shown_surface& surface)
{
  return surface.vertex_colors.empty() && !surface.mesh.appearance.vertex_opacities.empty();
}

// The images of a surface, as MeshLab has them: names, and the number of each face, -1 for those without.
struct Textures
{
  std::vector<std::string> names;
  std::vector<int> number_of_face; // empty if all have the first one

  Textures(const Shown_surface& surface, Companion_files* const beside)
  {
    const Appearance& appearance = surface.mesh.appearance;
    if(!beside || !surface.vertex_colors.empty() || !surface.part_of_face.empty()
       || !appearance.has_images())
      return;
    Written_images images(*beside);
    std::map<std::string, int> numbers;
    bool has_others = false;
    for(const std::size_t m : appearance.material_of_face)
    {
      const Material& material = appearance.materials[m];
      int number = -1;
      if(!material.image.empty())
      {
        const std::string name = images.name_of(material);
        const auto [known, is_new] = numbers.emplace(name, static_cast<int>(names.size()));
        if(is_new)
          names.push_back(name);
        number = known->second;
      }
      number_of_face.push_back(number);
      has_others = has_others || number != 0;
    }
    if(!has_others)
      number_of_face.clear();
  }
};

void write_header(std::ostream& out, const Shown_surface& surface, const bool has_normals,
                  const Textures& textures)
{
  out << "ply\nformat ascii 1.0\n";
  for(const std::string& name : textures.names)
    out << "comment TextureFile " << name << '\n';
  out << "element vertex " << surface.mesh.points.size()
      << "\nproperty double x\nproperty double y\nproperty double z\n";
  if(has_normals)
    out << "property float nx\nproperty float ny\nproperty float nz\n";
  if(!colors_of(surface).empty())
    announce_color(out);
  if(has_opacities(surface))
    out << "property uchar alpha\n";
  for(const Vertex_values& values : surface.values)
    out << "property double " << values.name << '\n';
  out << "element face " << surface.mesh.faces.size()
      << "\nproperty list uchar int vertex_indices\n";
  if(!surface.part_of_face.empty())
  {
    announce_color(out);
    out << "property int part\n";
  }
  if(!surface.mesh.appearance.texture_coordinates.empty())
    out << "property list uchar float texcoord\n";
  if(!textures.number_of_face.empty())
    out << "property int texnumber\n";
  out << "end_header\n";
}

} // namespace

void write_ply(std::ostream& out, const Shown_surface& surface, Companion_files* const beside)
{
  const Mesh_file& mesh = surface.mesh;
  check_format_holds(Format::PLY, mesh);
  use_shortest_numbers(out);
  const std::vector<Color>& colors = colors_of(surface);
  const std::vector<std::array<float, 3>> normals = normals_of_vertices(mesh);
  const Textures textures(surface, beside);
  write_header(out, surface, !normals.empty(), textures);
  const auto& coordinates = mesh.appearance.texture_coordinates;
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    const std::array<double, 3>& p = mesh.points[v];
    out << p[0] << ' ' << p[1] << ' ' << p[2];
    if(!normals.empty())
      for(const float x : normals[v])
        out << ' ' << x;
    if(!colors.empty())
      write_color(out, colors[v]);
    if(has_opacities(surface))
      out << ' ' << static_cast<int>(mesh.appearance.vertex_opacities[v]);
    for(const Vertex_values& values : surface.values)
      out << ' ' << values.values[static_cast<Eigen::Index>(v)];
    out << '\n';
  }
  std::size_t corner = 0;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    out << mesh.faces[f].size();
    for(const std::size_t v : mesh.faces[f])
      out << ' ' << v;
    if(!surface.part_of_face.empty())
    {
      write_color(out, color_of_part(surface.part_of_face[f]));
      out << ' ' << surface.part_of_face[f];
    }
    if(!coordinates.empty())
    {
      out << ' ' << 2 * mesh.faces[f].size();
      for(std::size_t k = 0; k < mesh.faces[f].size(); ++k, ++corner)
        out << ' ' << coordinates[corner][0] << ' ' << 1 - coordinates[corner][1];
    }
    if(!textures.number_of_face.empty())
      out << ' ' << textures.number_of_face[f];
    out << '\n';
  }
}

} // namespace Canonical_pose_tool
