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
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

// The names of files in a file: a name of MTL may be those of several files, with blanks between them.
std::vector<std::string> names_of_files(const Format format, const std::string& bytes,
                                        const std::string& path)
{
  if(format == Format::PLY)
    return names_of_textures(bytes, path);
  if(format == Format::GLTF)
    return files_of_gltf(bytes);
  std::vector<std::string> result;
  if(format != Format::OBJ)
    return result;
  Text_cursor text(bytes);
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(word == "mtllib")
      result.push_back(rest_of_line(text));
  return result;
}

// Those of such a name, beside the file at `path`. Those that are not there have no path.
std::vector<File_beside> files_of_names(const std::string& name, const std::string& path)
{
  if(std::string found = path_beside(path, name); !found.empty())
    return {{name, std::move(found)}};
  std::vector<File_beside> result;
  Text_cursor names(name);
  for(std::string_view word = names.word(); !word.empty(); word = names.word())
    result.push_back({std::string(word), path_beside(path, std::string(word))});
  return result;
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
  return content_beside(path.string(), path.filename().string()) == content_of(file.path);
}

} // namespace

std::vector<File_beside> files_beside(const Source_file& source)
{
  std::vector<File_beside> result;
  const std::string& path = source.path;
  if(is_standard_stream(path))
    return result;
  const auto add = [&](const File_beside& file) {
    const auto is_same = [&](const File_beside& other) { return other.path == file.path; };
    if(!file.path.empty() && std::none_of(result.begin(), result.end(), is_same))
      result.push_back(file);
  };
  for(const std::string& name : names_of_files(source.format, source.bytes, path))
    if(source.format != Format::OBJ)
      add({name, path_beside(path, name)});
    else
    {
      std::string materials;
      for(const File_beside& file : files_of_names(name, path))
      {
        add(file);
        materials += content_of(file.path) + '\n';
      }
      for(const std::string& image : images_of_mtl(materials))
        add({image, path_beside(path, image)});
    }
  return result;
}

std::vector<File_beside> files_beside(const Mesh_file& mesh)
{
  return mesh.source ? files_beside(*mesh.source) : std::vector<File_beside>();
}

std::vector<std::string> names_not_beside(const Mesh_file& mesh, const std::string& path)
{
  if(!mesh.source || !is_standard_stream(mesh.source->path))
    return {};
  std::vector<std::string> result;
  for(std::string& name : names_of_files(mesh.source->format, mesh.source->bytes, path))
  {
    const std::vector<File_beside> files = files_of_names(name, path);
    if(std::any_of(files.begin(), files.end(),
                   [](const File_beside& file) { return file.path.empty(); }))
      result.push_back(std::move(name));
  }
  return result;
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
      beside.contents[name] = content_of(file.path);
}

} // namespace Canonical_pose_tool
