// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Materials of OBJ, and files beside a file.

#include "Appearance.h"
#include "Text_cursor.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

bool has_content(const fs::path& path)
{
  std::error_code error;
  return fs::is_regular_file(path, error)
         && std::ifstream(path, std::ios::binary).peek() != std::ifstream::traits_type::eof();
}

bool looks_like_number(const std::string_view word)
{
  return !word.empty() && word.find_first_not_of("+-.0123456789eE") == std::string_view::npos;
}

std::string small_letters(std::string_view word)
{
  std::string result(word);
  for(char& c : result)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

// Whether an image follows.
bool is_map_of_mtl(const std::string& keyword)
{
  static const std::set<std::string> others = {"bump", "decal", "disp", "norm", "refl"};
  return keyword.compare(0, 4, "map_") == 0 || others.count(keyword) > 0;
}

// Reads what follows map_Kd: options, then the name of a file, which may have blanks. Returns also whether there are
// options which are not read.
std::pair<std::string, bool> read_image_name(Text_cursor& text, Material& material)
{
  bool has_others = false;
  for(;;)
  {
    const Text_cursor begin = text;
    const std::string option(text.word_on_line());
    if(option.empty() || option[0] != '-')
    {
      text = begin;
      return {rest_of_line(text), has_others};
    }
    has_others = has_others || (option != "-s" && option != "-o");
    std::vector<double> numbers;
    for(Text_cursor next = text; looks_like_number(next.word_on_line()); text = next)
      numbers.push_back(text.number_or(Text_cursor(text).word_on_line(), 0));
    if(numbers.empty()) // on, off, or the name of a channel
      text.word_on_line();
    for(std::size_t k = 0; k < 2 && k < numbers.size(); ++k)
      if(std::isfinite(numbers[k]))
      {
        if(option == "-s")
          material.scale[k] = numbers[k];
        else if(option == "-o")
          material.offset[k] = numbers[k];
      }
  }
}

// Returns whether they are numbers up to 1, or bytes.
bool read_color(Text_cursor& text, Material& material)
{
  std::array<double, 3> color;
  double others = -1; // that of the first one if these are not given
  for(double& x : color)
  {
    x = text.number_or(text.word_on_line(), others);
    if(!(x >= 0))
      return false; // another notation
    others = color[0];
  }
  const double most = *std::max_element(color.begin(), color.end()), bytes = 255;
  for(std::size_t k = 0; k < 3; ++k)
    material.color[k] = (std::min)(most > 2 ? color[k] / bytes : color[k], 1.);
  return most <= 1 || (most > 2 && most <= bytes);
}

} // namespace

std::string rest_of_line(Text_cursor& text)
{
  const std::string_view first = text.word_on_line();
  if(first.empty())
    return {};
  text.skip_line();
  std::string result(first.data(), text.position());
  for(const char* const comment : {" #", "\t#"})
    result.erase((std::min)(result.find(comment), result.size()));
  result.erase(result.find_last_not_of(" \t\r") + 1);
  if(result.size() > 1 && result.front() == '"' && result.back() == '"')
    result = result.substr(1, result.size() - 2);
  return result;
}

std::string path_beside(const std::string& path, std::string name)
{
  if(path.empty() || name.empty())
    return {};
  std::replace(name.begin(), name.end(), '\\', '/');
  std::error_code error;
  const fs::path target = fs::canonical(path, error); // empty if there is no file yet
  for(const fs::path& file : {fs::path(path), target.empty() ? fs::path(path) : target})
    for(const fs::path& other : {fs::path(name), fs::path(name).filename()})
      if(const fs::path found = file.parent_path() / other; has_content(found))
        return found.string();
  return {};
}

std::string content_of(const std::string& path)
{
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

std::string content_beside(const std::string& path, const std::string& name)
{
  return content_of(path_beside(path, name));
}

void load_image_beside(const std::string& path, const std::string& name, Appearance& appearance,
                       Material& material)
{
  material.image_path = path_beside(path, name);
  material.image = content_of(material.image_path);
  if(!type_of_image(material.image).empty())
    return;
  material.image.clear();
  appearance.missing.insert(name.empty() ? "a texture without a name"
                                         : "the texture " + Text_cursor::shown(name));
}

bool load_mtl(const std::string& path, const std::string& name, Appearance& appearance,
              std::map<std::string, std::size_t>& indices)
{
  std::string bytes = content_beside(path, name);
  if(bytes.empty())
    return false;
  try
  {
    remove_byte_order_mark(bytes);
  }
  catch(const std::invalid_argument&)
  {
    appearance.missing.insert("the materials in " + Text_cursor::shown(name)
                              + " (encoded in UTF-16)");
    return true;
  }
  Text_cursor text(bytes);
  Material unnamed;
  Material* material = &unnamed;
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
  {
    const std::string keyword = small_letters(word);
    if(keyword == "newmtl")
    {
      const std::string material_name = rest_of_line(text);
      indices.emplace(material_name, appearance.materials.size());
      material = &appearance.materials.emplace_back();
      material->name = material_name;
    }
    else if(keyword == "kd")
    {
      if(!read_color(text, *material))
        appearance.missing.insert(OTHER_PROPERTIES);
    }
    else if(keyword == "d") // Tr means opacity in some programs, and the opposite in others
    {
      word = text.word_on_line();
      const double opacity = text.number_or(word == "-halo" ? text.word_on_line() : word, 1);
      if(opacity > 0 && opacity < 1)
      {
        material->color[3] = opacity;
        material->alpha_mode = "BLEND";
      }
    }
    else if(keyword == "map_kd")
    {
      const auto [image, has_options] = read_image_name(text, *material);
      load_image_beside(path, image, appearance, *material);
      if(has_options)
        appearance.missing.insert(OTHER_PROPERTIES);
    }
    else if(keyword == "map_d") // the opacity of the same image
    {
      Material ignored;
      if(material->image.empty()
         || content_beside(path, read_image_name(text, ignored).first) != material->image)
        appearance.missing.insert(OTHER_MAPS);
      else if(type_of_image(material->image) != "image/jpeg")
        material->alpha_mode = "BLEND";
    }
    else
      appearance.missing.insert(is_map_of_mtl(keyword) ? OTHER_MAPS : OTHER_PROPERTIES);
  }
  // Some programs write black for the color of what has a texture.
  for(Material& other : appearance.materials)
    if(!other.image.empty() && other.is_black())
      std::fill(other.color.begin(), other.color.begin() + 3, 1.);
  return true;
}

std::vector<std::string> images_of_mtl(const std::string& bytes)
{
  std::vector<std::string> result;
  Text_cursor text(bytes);
  Material ignored;
  for(std::string_view word = text.word(); !word.empty(); text.skip_line(), word = text.word())
    if(is_map_of_mtl(small_letters(word)))
      result.push_back(read_image_name(text, ignored).first);
  return result;
}

std::string type_of_image(const std::string& bytes)
{
  const auto has = [&](const std::size_t begin, const std::string_view magic) {
    return bytes.compare((std::min)(begin, bytes.size()), magic.size(), magic) == 0;
  };
  return has(0, "\x89PNG")                            ? "image/png"
         : has(0, "\xFF\xD8\xFF")                     ? "image/jpeg"
         : has(0, "RIFF") && has(8, "WEBP")           ? "image/webp"
         : has(0, std::string_view("\xABKTX 20\xBB")) ? "image/ktx2"
                                                      : "";
}

} // namespace Canonical_pose_tool
