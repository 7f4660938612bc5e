// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// OBJ, with an MTL file and images beside it.

#include "Companion_files.h"
#include "Mesh_file.h"
#include "Shortest_numbers.h"
#include "Written_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <ostream>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

// Writes values once each. Returns their numbers, from 1, in the order in which they were written.
template <class Value, class Write>
std::map<Value, std::size_t> write_values(const std::vector<Value>& values, const Write& write)
{
  std::map<Value, std::size_t> numbers;
  for(const Value& value : values)
    if(numbers.emplace(value, numbers.size() + 1).second)
      write(value);
  return numbers;
}

// Makes the MTL file of a surface, and the images beside it that are not files yet.
class Material_library
{
public:
  Material_library(Companion_files& beside, const Appearance& appearance)
    : m_beside(beside), m_appearance(appearance), m_images(beside),
      m_used(appearance.material_of_face.begin(), appearance.material_of_face.end())
  {
    std::set<std::string> names;
    for(const std::size_t m : m_used)
      m_names[m] = name_of(m, names);
  }

  const std::string& material(const std::size_t number) const { return m_names.at(number); }

  // Returns the name of the file.
  std::string write()
  {
    std::ostringstream text;
    use_shortest_numbers(text);
    for(const std::size_t m : m_used)
      write(text, m);
    // One of an output before may be replaced, but none of those that inputs name.
    std::string name = m_images.stem() + ".mtl";
    for(int number = 0; is_read(m_beside.path.parent_path() / name); ++number)
      name = m_images.numbered(number, ".mtl");
    m_beside.contents[name] = text.str();
    return name;
  }

private:
  void write(std::ostream& text, const std::size_t number)
  {
    const Material& material = m_appearance.materials[number];
    text << "newmtl " << m_names.at(number) << "\nKd " << material.color[0] << ' '
         << material.color[1] << ' ' << material.color[2] << "\nd " << material.color[3] << '\n';
    // With a texture, black would be read as white.
    if(material.image.empty() || m_appearance.texture_coordinates.empty() || material.is_black())
      return;
    const std::string image = m_images.name_of(material);
    text << "map_Kd " << image << '\n';
    if(material.alpha_mode != "OPAQUE" && type_of_image(material.image) != "image/jpeg")
      text << "map_d " << image << '\n';
  }

  // Its own, without blanks, unless another one has it.
  std::string name_of(const std::size_t number, std::set<std::string>& names) const
  {
    std::string name = plain_name(m_appearance.materials[number].name);
    std::replace(name.begin(), name.end(), ' ', '_');
    if(name.empty())
      name = "material_" + std::to_string(number);
    while(!names.insert(name).second)
      name += '_' + std::to_string(number);
    return name;
  }

  bool is_read(const fs::path& path) const
  {
    std::error_code error;
    return std::any_of(m_beside.kept.begin(), m_beside.kept.end(),
                       [&](const std::string& file) { return fs::equivalent(file, path, error); });
  }

  Companion_files& m_beside;
  const Appearance& m_appearance;
  Written_images m_images;
  const std::set<std::size_t> m_used;
  std::map<std::size_t, std::string> m_names;
};

} // namespace

void write_obj(std::ostream& out, const Mesh_file& mesh, Companion_files* const beside)
{
  const Appearance& appearance = mesh.appearance;
  std::optional<Material_library> materials;
  if(beside && appearance.has_materials())
    out << "mtllib " << materials.emplace(*beside, appearance).write() << '\n';
  for(std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    out << 'v';
    write_numbers(out, mesh.points[v]);
    if(!appearance.vertex_colors.empty())
      for(const unsigned char c : appearance.vertex_colors[v])
        out << ' ' << std::round(1e4 * c / 255.) / 1e4;
    out << '\n';
  }
  const auto coordinates
    = write_values(appearance.texture_coordinates, [&](const std::array<float, 2>& value) {
        out << "vt " << value[0] << ' ' << 1 - value[1] << '\n';
      });
  const auto normals = write_values(appearance.normals, [&](const std::array<float, 3>& value) {
    out << "vn";
    write_numbers(out, value);
    out << '\n';
  });
  std::size_t corner = 0;
  for(std::size_t f = 0; f < mesh.faces.size(); ++f)
  {
    if(materials
       && (f == 0 || appearance.material_of_face[f] != appearance.material_of_face[f - 1]))
      out << "usemtl " << materials->material(appearance.material_of_face[f]) << '\n';
    out << 'f';
    for(const std::size_t v : mesh.faces[f])
    {
      out << ' ' << v + 1;
      if(!coordinates.empty() || !normals.empty())
        out << '/';
      if(!coordinates.empty())
        out << coordinates.at(appearance.texture_coordinates[corner]);
      if(!normals.empty())
        out << '/' << normals.at(appearance.normals[corner]);
      ++corner;
    }
    out << '\n';
  }
}

} // namespace Canonical_pose_tool
