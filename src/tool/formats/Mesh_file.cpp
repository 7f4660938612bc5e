// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Mesh_file.h"
#include "Text_cursor.h"
#include "gzip.h"
#include "readers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <ios>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

std::string lower_case(std::string text)
{
  std::transform(text.begin(), text.end(), text.begin(),
                 [](const unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

fs::path without_gz(const std::string& path)
{
  return is_compressed(path) ? fs::path(path).replace_extension() : fs::path(path);
}

std::ifstream opened(const std::string& path)
{
  errno = 0;
  std::ifstream in(path, std::ios::binary);
  if(!in)
    throw std::invalid_argument("it cannot be opened: " + std::string(std::strerror(errno)));
  return in;
}

void append_all(std::istream& in, std::string& bytes)
{
  std::vector<char> part(1 << 20);
  while(in.read(part.data(), static_cast<std::streamsize>(part.size())), in.gcount() > 0)
    bytes.append(part.data(), static_cast<std::size_t>(in.gcount()));
  if(in.bad())
    throw std::invalid_argument("it cannot be read: " + std::string(std::strerror(errno)));
}

// Whether this can be read only once: the standard input, or a pipe.
bool is_stream(const std::string& path)
{
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  return is_standard_stream(path)
         || (fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status));
}

// What was read from streams is kept, since the format is found by the content.
std::map<std::string, std::string>& streams()
{
  static std::map<std::string, std::string> bytes;
  return bytes;
}
std::mutex& mutex_of_streams()
{
  static std::mutex mutex;
  return mutex;
}

std::string bytes_of_stream(const std::string& path)
{
  const std::lock_guard<std::mutex> lock(mutex_of_streams());
  const auto known = streams().find(path);
  if(known != streams().end())
    return known->second;
  std::string bytes;
  if(is_standard_stream(path))
    append_all(std::cin, bytes);
  else
  {
    std::ifstream in = opened(path);
    append_all(in, bytes);
  }
  if(is_gzip(bytes))
    bytes = decompressed(bytes);
  return streams()[path] = bytes;
}

// Without compression.
std::string bytes_of_file(const std::string& path)
{
  std::string bytes;
  if(is_stream(path))
    bytes = bytes_of_stream(path);
  else
  {
    if(fs::is_directory(path))
      throw std::invalid_argument("it is a directory");
    std::ifstream in = opened(path);
    bytes.reserve(fs::file_size(path));
    append_all(in, bytes);
    if(is_gzip(bytes))
      bytes = decompressed(bytes);
  }
  if(bytes.find_first_not_of(" \t\r\n\x1A") == std::string::npos)
    throw std::invalid_argument("the file is empty");
  return bytes;
}

constexpr double LARGEST_COORDINATE = 1e90; // of which powers do not overflow

// A format, and how to recognize and read it.
struct Format_entry
{
  Format format;
  const char* extension;
  const char* name;
  const char* beginning; // of a file
  void (*read)(const std::string& bytes, const std::string& path, Mesh_file& mesh);
  bool is_written = true;
};

template <void (*READ)(const std::string&, Mesh_file&)>
void read_alone(const std::string& bytes, const std::string&, Mesh_file& mesh)
{
  READ(bytes, mesh);
}

constexpr std::array<Format_entry, 8> FORMATS
  = {{{Format::OFF, ".off", "OFF", "OFF", read_alone<read_off>},
      {Format::OBJ, ".obj", "OBJ", nullptr, read_alone<read_obj>},
      {Format::PLY, ".ply", "PLY", "ply", read_alone<read_ply>},
      {Format::STL, ".stl", "STL", "solid", read_alone<read_stl>},
      {Format::MEDIT, ".mesh", "MEDIT", "MeshVersionFormatted", read_alone<read_medit>},
      {Format::GLB, ".glb", "binary glTF", "glTF", read_gltf},
      {Format::GLTF, ".gltf", "glTF", "{", read_gltf, false},
      {Format::VTU, ".vtu", "VTK", "<", nullptr}}};

const Format_entry& entry_of(const Format format)
{
  return *std::find_if(FORMATS.begin(), FORMATS.end(),
                       [&](const Format_entry& entry) { return entry.format == format; });
}

// The format whose files begin like a text; null if there is none.
const Format_entry* entry_of_beginning(const std::string_view text)
{
  const auto found = std::find_if(FORMATS.begin(), FORMATS.end(), [&](const Format_entry& entry) {
    return entry.beginning && text.substr(0, std::strlen(entry.beginning)) == entry.beginning;
  });
  return found == FORMATS.end() ? nullptr : &*found;
}

// What a file is, if it begins like that, and not like its extension says.
std::string other_look(const std::string& bytes, const Format format)
{
  const std::size_t first = (std::min)(bytes.find_first_not_of(" \t\r\n"), bytes.size());
  const Format_entry* const entry = entry_of_beginning(std::string_view(bytes).substr(first));
  return !entry || entry->format == format ? ""
                                           : std::string("; its content looks like ") + entry->name;
}

// The format of a file by its beginning, if it is a file, and its format can be read.
std::optional<Format> format_by_content(const std::string& path)
{
  const std::size_t most = 4096;
  std::error_code error;
  std::uintmax_t size = 0;
  std::string bytes;
  if(!is_stream(path))
  {
    if(!fs::is_regular_file(path, error))
      return std::nullopt;
    std::ifstream in(path, std::ios::binary);
    bytes.resize(most);
    in.read(bytes.data(), static_cast<std::streamsize>(most));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    size = fs::file_size(path, error);
  }
  if(is_stream(path) || is_gzip(bytes))
  {
    bytes = bytes_of_file(path);
    size = bytes.size();
    bytes.resize((std::min)(bytes.size(), most));
  }
  const bool has_size_of_stl = is_binary_stl(bytes, size);
  if(bytes.compare(0, 3, BYTE_ORDER_MARK) == 0)
    bytes.erase(0, 3);
  Text_cursor text(bytes);
  std::string_view word = text.word();
  if(const Format_entry* const entry = entry_of_beginning(word); entry && entry->read)
    return entry->format;
  if(word.size() > 3 && word.find_first_not_of("STCN") == word.size() - 3
     && word.substr(word.size() - 3) == "OFF")
    return Format::OFF;
  if(has_size_of_stl)
    return Format::STL;
  for(; !word.empty(); text.skip_line(), word = text.word())
    if(word == "v")
      return Format::OBJ;
  return std::nullopt;
}

} // namespace

bool is_standard_stream(const std::string& path)
{
  return path == "-" || (path.compare(0, 2, "-.") == 0 && path.find('/') == std::string::npos)
         || path == "/dev/stdin" || path == "/dev/stdout";
}

void forget_streams()
{
  const std::lock_guard<std::mutex> lock(mutex_of_streams());
  streams().clear();
}

bool is_compressed(const std::string& path)
{
  return lower_case(fs::path(path).extension().string()) == ".gz";
}

std::string extension_of(const std::string& path)
{
  return lower_case(without_gz(path).extension().string());
}

std::string stem_of(const std::string& path) { return without_gz(path).stem().string(); }

Format format_of(const std::string& path, const Use use)
{
  const std::string extension = extension_of(path);
  const auto found = std::find_if(FORMATS.begin(), FORMATS.end(), [&](const Format_entry& entry) {
    return extension == entry.extension;
  });
  if(found == FORMATS.end())
  {
    if(const auto format = use == Use::READ ? format_by_content(path) : std::nullopt)
      return *format;
    std::error_code error;
    if(use == Use::READ && (is_stream(path) || fs::exists(path, error)))
      bytes_of_file(path); // unless it is empty, or a directory
    std::string message
      = (use == Use::READ && is_stream(path) ? "the content of " + name_of_input(path)
                                             : "the extension of '" + path + "'")
        + " is not one of ";
    for(const Format_entry& entry : FORMATS)
      if(use == Use::WRITE ? entry.is_written : entry.read != nullptr)
        message += std::string(&entry == FORMATS.data() ? "" : ", ") + entry.extension;
    throw std::invalid_argument(message);
  }
  if((found->format == Format::GLB || found->format == Format::GLTF) && !is_gltf_available())
    throw std::invalid_argument("'" + path + "' is glTF, but this program was built without it");
  return found->format;
}

std::string extension_of_format(const Format format) { return entry_of(format).extension; }

Mesh_file read_mesh_file(const std::string& path, const Source source)
{
  const Format format = format_of(path);
  const Format_entry& entry = entry_of(format);
  if(!entry.read)
    throw std::invalid_argument("files of " + std::string(entry.name) + " (" + entry.extension
                                + ") are written, but not read");
  std::string bytes = bytes_of_file(path);
  const bool is_text = format != Format::GLB && !(format == Format::STL && is_binary_stl(bytes));
  if(format == Format::GLTF)
    bytes.erase(bytes.find_last_not_of('\x1A') + 1);
  const bool has_byte_order_mark = is_text && remove_byte_order_mark(bytes);
  Mesh_file mesh;
  mesh.is_checked = source != Source::UNCHECKED;
  try
  {
    entry.read(bytes, path, mesh);
  }
  catch(const std::invalid_argument& error)
  {
    throw std::invalid_argument(error.what() + other_look(bytes, format));
  }
  // Words that OBJ does not have are comments.
  if(const std::string look = other_look(bytes, format); mesh.points.empty() && !look.empty())
    throw std::invalid_argument("there is no vertex" + look);
  if(source == Source::KEPT)
  {
    if(entry.read == read_gltf)
      if(std::optional<std::string> all = self_contained_glb(bytes, path))
        bytes = std::move(*all);
    mesh.source = std::make_shared<const Source_file>(
      Source_file{written_format(format), std::move(bytes), path, has_byte_order_mark});
  }
  return mesh;
}

Mesh_file read_other_mesh_file(const std::string& path, const Source source)
try
{
  return read_mesh_file(path, source);
}
catch(const std::invalid_argument& error)
{
  throw std::invalid_argument("'" + path + "': " + error.what());
}

std::vector<std::string> paths_beside(const std::string& path)
try
{
  std::error_code error;
  std::vector<std::string> result;
  if(!fs::is_regular_file(path, error))
    return result;
  const Format format = format_of(path);
  if(format == Format::OBJ || format == Format::PLY || format == Format::GLTF)
    for(File_beside& file : files_beside({format, bytes_of_file(path), path}))
      result.push_back(std::move(file.path));
  return result;
}
catch(const std::invalid_argument&)
{
  return {};
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

std::size_t vertex_index(const Mesh_file& mesh, const long long index, const std::size_t n,
                         const Element& element, const int base)
{
  const std::size_t end = mesh.is_checked ? n : NO_VERTEX;
  if(index >= base && static_cast<unsigned long long>(index - base) < end)
    return static_cast<std::size_t>(index - base);
  if(!mesh.is_checked)
    return NO_VERTEX;
  throw std::invalid_argument(element.name() + " names vertex " + std::to_string(index)
                              + (base == 0 ? "" : " (counted from 1)") + ", but there are "
                              + std::to_string(n));
}

void add_faces(const std::vector<long long>& corners, const std::vector<std::size_t>& ends,
               const int base, Mesh_file& mesh)
{
  std::vector<std::size_t> face;
  std::size_t corner = 0;
  for(Element f{"face", 0}; f.index < ends.size(); ++f.index)
  {
    face.clear();
    for(; corner < ends[f.index]; ++corner)
      face.push_back(vertex_index(mesh, corners[corner], mesh.points.size(), f, base));
    mesh.faces.push_back(face);
  }
}

void check_is_finite(const Mesh_file& mesh, const std::array<double, 3>& point,
                     const Element& element)
{
  for(const double x : point)
    if(!std::isfinite(x) ? mesh.is_checked : std::abs(x) > LARGEST_COORDINATE)
      throw std::invalid_argument(element.name()
                                  + (std::isfinite(x)
                                       ? " has a coordinate that is too large: choose another unit"
                                       : " has a coordinate that is not finite"));
}

void check_is_polygon(const long long number_of_corners, const Element& face)
{
  if(number_of_corners < 3)
    throw std::invalid_argument(face.name() + " is not a polygon: its number of corners is "
                                + std::to_string(number_of_corners));
}

} // namespace Canonical_pose_tool
