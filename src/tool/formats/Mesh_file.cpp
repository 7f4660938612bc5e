// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_file.h"
#include "Text_cursor.h"
#include "readers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

std::string bytes_of_file(const std::string& path)
{
  if(std::filesystem::is_directory(path))
    throw std::invalid_argument("it is a directory");
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if(!in)
    throw std::invalid_argument("it cannot be opened: " + std::string(std::strerror(errno)));
  std::string bytes;
  std::vector<char> part(1 << 20); // pipes have no size
  while(in.read(part.data(), static_cast<std::streamsize>(part.size())), in.gcount() > 0)
    bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
  if(in.bad())
    throw std::invalid_argument("it cannot be read: " + std::string(std::strerror(errno)));
  if(bytes.find_first_not_of(" \t\r\n") == std::string::npos)
    throw std::invalid_argument("the file is empty");
  return bytes;
}

} // namespace

Format format_of(const std::string& path)
{
  static const std::map<std::string, Format> formats
    = {{".off", Format::OFF},   {".obj", Format::OBJ},    {".ply", Format::PLY},
       {".stl", Format::STL},   {".mesh", Format::MEDIT}, {".glb", Format::GLB},
       {".gltf", Format::GLTF}, {".vtu", Format::VTU}};
  std::string extension = std::filesystem::path(path).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const auto found = formats.find(extension);
  if(found == formats.end())
    throw std::invalid_argument(
      "the extension of '" + path
      + "' is not one of .off, .obj, .ply, .stl, .mesh, .glb, .gltf, .vtu");
  if((found->second == Format::GLB || found->second == Format::GLTF) && !is_gltf_available())
    throw std::invalid_argument("'" + path + "' is glTF, but this program was built without it");
  return found->second;
}

Mesh_file read_mesh_file(const std::string& path)
{
  const Format format = format_of(path);
  if(format == Format::VTU)
    throw std::invalid_argument("files of VTK (.vtu) are written, but not read");
  std::string bytes = bytes_of_file(path);
  if(format != Format::GLB && !(format == Format::STL && is_binary_stl(bytes)))
    remove_byte_order_mark(bytes);
  Mesh_file mesh;
  switch(format)
  {
  case Format::OFF:
    read_off(bytes, mesh);
    break;
  case Format::OBJ:
    read_obj(bytes, mesh);
    break;
  case Format::PLY:
    read_ply(bytes, mesh);
    break;
  case Format::STL:
    read_stl(bytes, mesh);
    break;
  case Format::MEDIT:
    read_medit(bytes, mesh);
    break;
  case Format::GLB:
  case Format::GLTF:
    read_gltf(bytes, path, mesh);
    break;
  case Format::VTU: // refused above
    break;
  }
  return mesh;
}

Mesh_file read_other_mesh_file(const std::string& path)
try
{
  return read_mesh_file(path);
}
catch(const std::invalid_argument& error)
{
  throw std::invalid_argument("'" + path + "': " + error.what());
}

std::vector<std::string> read_lines(const std::string& path)
{
  std::string bytes = bytes_of_file(path);
  remove_byte_order_mark(bytes);
  std::vector<std::string> lines;
  for(Text_cursor text(bytes); text.position() != text.end(); text.next_line())
  {
    const char* const begin = text.position();
    text.skip_line();
    lines.emplace_back(begin, text.position());
    if(!lines.back().empty() && lines.back().back() == '\r')
      lines.back().pop_back();
  }
  return lines;
}

std::vector<double> read_numbers(const std::string& path)
try
{
  std::string bytes = bytes_of_file(path);
  remove_byte_order_mark(bytes);
  std::vector<double> numbers;
  Text_cursor text(bytes);
  for(std::string_view word = text.word(); !word.empty(); word = text.word())
    numbers.push_back(text.number(word, Element{"number", numbers.size()}));
  if(numbers.empty())
    throw std::invalid_argument("there are no numbers");
  return numbers;
}
catch(const std::invalid_argument& error)
{
  throw std::invalid_argument("'" + path + "': " + error.what());
}

std::size_t vertex_index(const long long index, const std::size_t n, const Element& element,
                         const int base)
{
  if(index < base || static_cast<unsigned long long>(index - base) >= n)
    throw std::invalid_argument(element.name() + " names vertex " + std::to_string(index)
                                + (base == 0 ? "" : " (counted from 1)") + ", but there are "
                                + std::to_string(n));
  return static_cast<std::size_t>(index - base);
}

void check_is_finite(const std::array<double, 3>& point, const Element& element)
{
  for(const double x : point)
    if(!std::isfinite(x))
      throw std::invalid_argument(element.name() + " has a coordinate that is not finite");
}

void check_is_polygon(const long long number_of_corners, const Element& face)
{
  if(number_of_corners < 3)
    throw std::invalid_argument(face.name() + " is not a polygon: its number of corners is "
                                + std::to_string(number_of_corners));
}

} // namespace Canonical_pose_tool
