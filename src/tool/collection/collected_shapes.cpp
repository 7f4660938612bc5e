// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Which surfaces a collection has, and whether they have changed.

#include "collection/collected_shapes.h"
#include "formats/Mesh_file.h"

#include <boost/crc.hpp>

#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

// The surfaces in a folder and its folders. Links are followed, but no folder is visited twice.
void add_folder(const fs::path& folder, std::set<fs::path>& visited, std::set<std::string>& paths)
{
  if(!visited.insert(fs::canonical(folder)).second)
    return;
  for(const fs::directory_entry& entry : fs::directory_iterator(folder))
  {
    std::error_code error;
    if(fs::is_directory(entry.path(), error))
      add_folder(entry.path(), visited, paths);
    else if(is_of_surfaces(extension_of(entry.path().string())))
      paths.insert(entry.path().string());
  }
}

void add_list(const std::string& list, std::set<std::string>& paths)
try
{
  for(const std::string& line : read_lines(list))
    if(!line.empty())
      paths.insert(normal_path(line));
}
catch(const std::invalid_argument& error)
{
  throw std::invalid_argument("the list '" + list + "' cannot be read: " + error.what());
}

} // namespace

bool is_of_surfaces(const std::string& extension)
{
  static const std::set<std::string> known = {".off", ".obj", ".ply", ".stl", ".glb", ".gltf"};
  return known.count(extension) > 0;
}

std::string normal_path(const std::string& path)
{
  return fs::absolute(path).lexically_normal().string();
}

std::vector<std::string> shapes_of(const std::vector<std::string>& inputs)
{
  std::set<std::string> paths;
  std::set<fs::path> visited;
  for(const std::string& input : inputs)
  {
    std::error_code error;
    const std::size_t number_before = paths.size();
    if(input.front() == '@')
      add_list(input.substr(1), paths);
    else if(fs::is_directory(input, error))
      add_folder(normal_path(input), visited, paths);
    else if(fs::exists(input, error))
      paths.insert(normal_path(input));
    else
      throw std::invalid_argument("'" + input + "' does not exist");
    if(paths.size() == number_before && inputs.size() == 1)
      throw std::invalid_argument("there is no shape in '" + input + "'");
  }
  return {paths.begin(), paths.end()};
}

std::string checksum_of(const std::string& path)
{
  boost::crc_optimal<64, 0x42F0E1EBA9EA3693ULL, ~0ULL, ~0ULL, true, true> crc;
  std::uintmax_t size = 0;
  const auto add = [&](const std::string& file) {
    std::ifstream in(file, std::ios::binary);
    std::array<char, 1 << 16> part;
    while(in && in.read(part.data(), part.size()).gcount() > 0)
    {
      crc.process_bytes(part.data(), static_cast<std::size_t>(in.gcount()));
      size += static_cast<std::uintmax_t>(in.gcount());
    }
    return in.eof();
  };
  if(!add(path) && size == 0)
    return {};
  if(extension_of(path) == ".gltf")
    for(const std::string& file : paths_beside(path))
      add(file);
  std::array<char, 64> text;
  std::snprintf(text.data(), text.size(), "%ju-%016jx", size,
                static_cast<std::uintmax_t>(crc.checksum()));
  return text.data();
}

} // namespace Canonical_pose_tool
