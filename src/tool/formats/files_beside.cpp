// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Companion_files.h"
#include "Mesh_file.h"
#include "Ply_header.h"
#include "Text_cursor.h"
#include "readers.h"

#include <algorithm>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

// Adds a file that exists. Returns its content.
std::string add_file(const std::string& name, const std::string& path,
                     std::vector<File_beside>& files)
{
  File_beside file{name, {}, {}};
  file.content = content_beside(path, name, &file.path);
  const auto is_same = [&](const File_beside& other) { return other.path == file.path; };
  if(!file.content.empty() && std::none_of(files.begin(), files.end(), is_same))
    files.push_back(file);
  return file.content;
}

// Its name in the same folder as that of the mesh; empty if it is elsewhere.
std::string name_in_folder(const Mesh_file& mesh, const File_beside& file)
{
  std::error_code error;
  const fs::path path(file.path);
  return fs::equivalent(fs::absolute(path).parent_path(),
                        fs::absolute(mesh.source->path).parent_path(), error)
           ? path.filename().string()
           : std::string();
}

bool is_there(const fs::path& path, const File_beside& file)
{
  return content_beside(path.string(), path.filename().string()) == file.content;
}

} // namespace

std::vector<File_beside> files_beside(const Source_file& source)
{
  std::vector<File_beside> result;
  const std::string& path = source.path;
  if(is_standard_stream(path))
    return result;
  if(source.format == Format::PLY)
    for(const std::string& name : names_of_textures(source.bytes, path))
      add_file(name, path, result);
  if(source.format == Format::GLTF)
    for(const std::string& name : files_of_gltf(source.bytes))
      add_file(name, path, result);
  if(source.format != Format::OBJ)
    return result;
  Text_cursor text(source.bytes);
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(word == "mtllib")
    {
      const std::string name = rest_of_line(text);
      std::string materials = add_file(name, path, result);
      if(materials.empty()) // or several names, with blanks between them
        for(Text_cursor names(name); !(word = names.word()).empty();)
          materials += add_file(std::string(word), path, result) + '\n';
      for(const std::string& image : images_of_mtl(materials))
        add_file(image, path, result);
    }
  return result;
}

std::vector<File_beside> files_beside(const Mesh_file& mesh)
{
  return mesh.source ? files_beside(*mesh.source) : std::vector<File_beside>();
}

std::vector<std::string> names_not_beside(const Mesh_file& mesh, const std::string& path)
{
  std::vector<std::string> names;
  if(!mesh.source || !is_standard_stream(mesh.source->path))
    return names;
  const std::string& bytes = mesh.source->bytes;
  if(mesh.source->format == Format::PLY)
    names = names_of_textures(bytes, path);
  Text_cursor text(bytes);
  if(mesh.source->format == Format::OBJ)
    for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
      if(word == "mtllib")
        names.push_back(rest_of_line(text));
  const auto is_there = [&](const std::string& name) {
    if(!content_beside(path, name).empty())
      return true;
    Text_cursor words(name); // or several names
    std::string_view word = words.word();
    while(!word.empty() && !content_beside(path, std::string(word)).empty())
      word = words.word();
    return word.empty();
  };
  names.erase(std::remove_if(names.begin(), names.end(), is_there), names.end());
  return names;
}

bool is_copied(const Mesh_file& mesh, const File_beside& file, const std::string& path)
{
  const std::string name = name_in_folder(mesh, file);
  std::error_code error;
  const fs::path copy = fs::path(path).parent_path() / name;
  return !name.empty()
         && (is_there(copy, file) || (has_files_beside(path) && !fs::exists(copy, error)));
}

bool is_another_there(const Mesh_file& mesh, const File_beside& file, const std::string& path)
{
  const std::string name = name_in_folder(mesh, file);
  std::error_code error;
  const fs::path copy = fs::path(path).parent_path() / name;
  return !name.empty() && fs::exists(copy, error) && !is_there(copy, file);
}

void copy_files_beside(const Mesh_file& mesh, Companion_files& beside)
{
  for(const File_beside& file : files_beside(mesh))
    if(const std::string name = name_in_folder(mesh, file);
       is_copied(mesh, file, beside.path.string())
       && !is_there(beside.path.parent_path() / name, file))
      beside.contents[name] = file.content;
}

} // namespace Canonical_pose_tool
