// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_WRITTEN_IMAGES_H
#define CGAL_CANONICAL_POSE_3_TOOL_WRITTEN_IMAGES_H

#include "Appearance.h"
#include "Companion_files.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>
#include <string>
#include <system_error>

namespace Canonical_pose_tool {

// A name that is not read as something else.
inline std::string plain_name(std::string name)
{
  const auto is_special
    = [](const unsigned char c) { return std::iscntrl(c) || c == '#' || c == '"' || c == '\\'; };
  std::replace_if(name.begin(), name.end(), is_special, '_');
  if(!name.empty() && (name.front() == '-' || name.front() == ' '))
    name.front() = '_';
  if(!name.empty() && name.back() == ' ')
    name.back() = '_';
  return name;
}

// The images of materials beside a file: those that are no files yet are written.
class Written_images
{
public:
  explicit Written_images(Companion_files& beside)
    : m_beside(beside), m_stem(plain_name(beside.path.stem().string()))
  {}

  // What the file calls the image of a material.
  std::string name_of(const Material& material)
  {
    namespace fs = std::filesystem;
    const auto [name, is_new] = m_names.emplace(material.image, std::string());
    if(!is_new)
      return name->second;
    const fs::path folder = m_beside.path.parent_path();
    std::error_code error;
    const std::string path
      = fs::canonical(material.image_path, error).lexically_proximate(folder).generic_string();
    if(!material.image_path.empty() && !error && path == plain_name(path))
      return name->second = path;
    const std::string type = type_of_image(material.image);
    const std::string extension
      = type == "image/jpeg" ? ".jpg" : '.' + type.substr(type.find('/') + 1);
    for(int number = 0;; ++number) // another image is not replaced
    {
      name->second = numbered(number, extension);
      const std::string there = content_beside(m_beside.path.string(), name->second);
      if(there == material.image)
        break;
      if(m_beside.contents.count(name->second) == 0 && !fs::exists(folder / name->second, error))
      {
        m_beside.contents[name->second] = material.image;
        break;
      }
    }
    return name->second;
  }

  // The name of a file beside it.
  std::string numbered(const int number, const std::string& extension) const
  {
    return m_stem + '_' + std::to_string(number) + extension;
  }

  const std::string& stem() const { return m_stem; }

private:
  Companion_files& m_beside;
  const std::string m_stem;                   // of the names of files
  std::map<std::string, std::string> m_names; // by contents
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_WRITTEN_IMAGES_H
