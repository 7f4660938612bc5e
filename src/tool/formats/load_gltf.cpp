// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "load_gltf.h"
#include "Text_cursor.h"
#include "readers.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

const std::size_t HEADER = 12, CHUNK_HEADER = 8; // bytes
const std::string_view MAGIC = "glTF";

std::uint32_t number_at(const std::string& bytes, const std::size_t position)
{
  std::uint32_t number = 0;
  for(std::size_t k = 4; k-- > 0;)
    number = number << 8 | static_cast<unsigned char>(bytes[position + k]);
  return number;
}

// Returns the JSON of a binary file whose lengths are consistent.
std::string_view json_of_glb(const std::string& bytes)
{
  const std::string truncated = "the file is truncated: ";
  if(bytes.size() < HEADER + CHUNK_HEADER)
    throw std::invalid_argument(truncated + "it ends in the header");
  if(const std::uint32_t version = number_at(bytes, 4); version != 2)
    throw std::invalid_argument("this is version " + std::to_string(version)
                                + " of glTF, but version 2 is needed");
  const std::size_t length = number_at(bytes, 8);
  if(bytes.size() < length)
    throw std::invalid_argument(truncated + "it has " + std::to_string(bytes.size()) + " of "
                                + std::to_string(length) + " bytes");
  if(bytes.size() > length)
    throw std::invalid_argument("the file goes on for " + std::to_string(bytes.size() - length)
                                + " bytes after the last one announced");
  std::size_t position = HEADER;
  for(int chunk = 0; position < length; ++chunk)
  {
    if(length - position < CHUNK_HEADER
       || length - position - CHUNK_HEADER < number_at(bytes, position))
      throw std::invalid_argument("chunk " + std::to_string(chunk) + " is longer than the file");
    position += CHUNK_HEADER + number_at(bytes, position);
  }
  if(bytes.compare(HEADER + 4, 4, "JSON") != 0)
    throw std::invalid_argument("the first chunk is not JSON");
  return std::string_view(bytes).substr(HEADER + CHUNK_HEADER, number_at(bytes, HEADER));
}

bool is_glb(const std::string& bytes) { return bytes.compare(0, MAGIC.size(), MAGIC) == 0; }

// That of a text or binary file.
std::string_view json_of(const std::string& bytes)
{
  return is_glb(bytes) ? json_of_glb(bytes) : bytes;
}

// tinygltf descends into what is nested by recursion.
void check_is_flat(const std::string_view json)
{
  const int deepest = 64;
  int depth = 0;
  bool is_string = false;
  for(std::size_t i = 0; i < json.size(); ++i)
    if(is_string && json[i] == '\\')
      ++i;
    else if(json[i] == '"')
      is_string = !is_string;
    else if(!is_string && (json[i] == '{' || json[i] == '['))
    {
      if(++depth > deepest)
        throw std::invalid_argument("the JSON is nested more than " + std::to_string(deepest)
                                    + " levels deep");
    }
    else if(!is_string && (json[i] == '}' || json[i] == ']'))
      --depth;
}

// The files of external buffers, in the directory of the glTF file or below.
class Files_beside
{
public:
  explicit Files_beside(const std::string& path) : m_directory(fs::path(path).parent_path()) {}

  bool is_beside(const std::string& name)
  {
    const fs::path path(name);
    const bool is_elsewhere = path.is_absolute() || name.find(':') != std::string::npos
                              || std::find(path.begin(), path.end(), "..") != path.end();
    if(is_elsewhere && m_defect.empty()) // tinygltf tries several paths
      m_defect = "a buffer is in " + Text_cursor::shown(name) + ", which is not beside this file";
    return !is_elsewhere;
  }

  bool exists(const std::string& name)
  {
    std::error_code error;
    return is_beside(name) && fs::is_regular_file(m_directory / name, error);
  }

  bool read(const std::string& name, std::vector<unsigned char>& bytes)
  {
    std::ifstream in(m_directory / name, std::ios::binary);
    bytes.assign(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    return !in.bad();
  }

  const std::string& defect() const { return m_defect; }

private:
  fs::path m_directory;
  std::string m_defect;
};

std::string uri_of(const nlohmann::ordered_json& image)
{
  return image.is_object() ? image.value("uri", std::string()) : std::string();
}

// Whether this leads to a file, rather than being empty or data.
bool is_file(const std::string& uri) { return !uri.empty() && uri.compare(0, 5, "data:") != 0; }

// Newer versions also ask for the size of a file.
template <class Callbacks>
auto add_size(Callbacks& callbacks, int) -> decltype(callbacks.GetFileSizeInBytes, void())
{
  callbacks.GetFileSizeInBytes
    = [](std::size_t* size, std::string*, const std::string& name, void* files) {
        std::vector<unsigned char> bytes;
        const bool is_read = static_cast<Files_beside*>(files)->read(name, bytes);
        *size = bytes.size();
        return is_read;
      };
}

template <class Callbacks>
void add_size(Callbacks&, long)
{}

tinygltf::FsCallbacks callbacks(Files_beside& files)
{
  tinygltf::FsCallbacks result{};
  result.FileExists
    = [](const std::string& name, void* f) { return static_cast<Files_beside*>(f)->exists(name); };
  result.ExpandFilePath = [](const std::string& name, void*) { return name; };
  result.ReadWholeFile
    = [](std::vector<unsigned char>* bytes, std::string*, const std::string& name, void* f) {
        return static_cast<Files_beside*>(f)->read(name, *bytes);
      };
  result.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&,
                             void*) { return false; };
  add_size(result, 0);
  result.user_data = &files;
  return result;
}

// The beginning of what tinygltf says, in one line.
std::string shortened(std::string text)
{
  const std::size_t most = 200;
  text = text.substr(0, most);
  std::replace_if(
    text.begin(), text.end(), [](const char c) { return c < ' ' || c > '~'; }, ' ');
  return text.substr(0, text.find_last_not_of(' ') + 1);
}

} // namespace

tinygltf::Model load_gltf(const std::string& bytes, const std::string& path)
{
  if(bytes.size() > std::numeric_limits<std::uint32_t>::max())
    throw std::invalid_argument("the file has more than 4 GB");
  check_is_flat(json_of(bytes));
  const bool is_binary = is_glb(bytes);
  Files_beside files(path);
  tinygltf::TinyGLTF loader;
  loader.SetFsCallbacks(callbacks(files));
  loader.SetImageLoader([](tinygltf::Image*, int, std::string*, std::string*, int, int,
                           const unsigned char*, int, void*) { return true; },
                        nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const unsigned int size = static_cast<unsigned int>(bytes.size());
  bool is_loaded = false;
  try
  {
    is_loaded
      = is_binary ? loader.LoadBinaryFromMemory(
          &model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()), size)
                  : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, "");
  }
  catch(const std::bad_alloc&)
  {
    throw;
  }
  catch(const std::exception& exception) // for instance of an empty buffer
  {
    error = exception.what();
  }
  if(!is_loaded)
    throw std::invalid_argument(
      !files.defect().empty() ? files.defect() : "this is not valid glTF: " + shortened(error));
  return model;
}

void check_model(const std::string& bytes, const tinygltf::Model& model)
{
  const std::string_view json = json_of(bytes);
  const auto parsed = nlohmann::json::parse(json.begin(), json.end(), nullptr, false);
  for(const char* const list : {"accessors", "bufferViews"})
    if(const auto found = parsed.find(list); found != parsed.end() && found->is_array())
      for(std::size_t i = 0; i < found->size(); ++i)
        for(const char* const name : {"byteOffset", "byteLength", "byteStride", "count"})
          if(const auto& element = (*found)[i]; element.is_object() && element.contains(name)
                                                && element[name].is_number()
                                                && element[name].get<double>() < 0)
            throw std::invalid_argument(std::string(name) + " of element " + std::to_string(i)
                                        + " of " + list + " is negative");
  for(std::size_t i = 0; i < model.meshes.size(); ++i)
    if(const auto path
       = nlohmann::json::json_pointer("/meshes/" + std::to_string(i) + "/primitives");
       !parsed.contains(path) || parsed[path].size() != model.meshes[i].primitives.size())
      throw std::invalid_argument("a primitive of mesh " + std::to_string(i) + " is not valid");
}

std::vector<std::string> files_of_gltf(const std::string& bytes)
{
  const auto json = nlohmann::ordered_json::parse(json_of(bytes), nullptr, false);
  std::vector<std::string> result;
  for(const char* const list : {"buffers", "images"})
    if(const auto found = json.find(list); found != json.end())
      for(const auto& entry : *found)
        if(entry.is_object() && entry.contains("uri") && entry["uri"].is_string())
          result.push_back(decoded_uri(entry["uri"].get<std::string>()));
  return result;
}

std::optional<std::string> self_contained_glb(const std::string& bytes, const std::string& path)
try
{
  auto json = nlohmann::ordered_json::parse(json_of(bytes));
  const auto has_files = [&](const char* const list) {
    const auto found = json.find(list);
    return found != json.end() && std::any_of(found->begin(), found->end(), [](const auto& entry) {
             return is_file(uri_of(entry));
           });
  };
  if(is_glb(bytes) && json.value("buffers", nlohmann::ordered_json::array()).size() == 1
     && !json["buffers"][0].contains("uri") && !has_files("images"))
    return std::nullopt;
  const tinygltf::Model model = load_gltf(bytes, path);
  std::string all;
  const auto append = [&](const auto& part) {
    all.resize((all.size() + 3) / 4 * 4);
    const std::size_t begin = all.size();
    all.append(part.begin(), part.end());
    return begin;
  };
  std::vector<std::size_t> begins;
  for(const tinygltf::Buffer& buffer : model.buffers)
    begins.push_back(append(buffer.data));
  for(auto& view : json["bufferViews"])
    if(const std::size_t buffer = view.value("buffer", std::size_t(0)); buffer < begins.size())
    {
      view["byteOffset"] = begins[buffer] + view.value("byteOffset", std::size_t(0));
      view["buffer"] = 0;
    }
  Files_beside files(path);
  if(json.contains("images"))
    for(auto& image : json["images"])
    {
      const std::string uri = uri_of(image), name = decoded_uri(uri);
      std::vector<unsigned char> content;
      std::string type_of_uri;
      if(is_file(uri)
           ? !files.exists(name) || !files.read(name, content)
           : uri.empty() || !tinygltf::DecodeDataURI(&content, type_of_uri, uri, 0, false))
        continue;
      const std::string type = type_of_image(std::string(content.begin(), content.end()));
      if(type.empty())
        continue;
      json["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", append(content)}, {"byteLength", content.size()}});
      image.erase("uri");
      image["mimeType"] = type;
      image["bufferView"] = json["bufferViews"].size() - 1;
    }
  all.resize((all.size() + 3) / 4 * 4);
  json["buffers"] = {{{"byteLength", all.size()}}};
  return glb_of(json.dump(), all);
}
catch(const nlohmann::json::exception& error) // of what tinygltf does not look at
{
  throw std::invalid_argument("this is not valid glTF: " + shortened(error.what()));
}

std::string glb_of(const std::string& json, const std::string_view buffer,
                   const std::string_view rest)
{
  const auto bytes_of = [](const std::size_t number) {
    const auto value = static_cast<std::uint32_t>(number);
    return std::string(reinterpret_cast<const char*>(&value), sizeof(value));
  };
  constexpr std::size_t headers = HEADER + 2 * CHUNK_HEADER;
  std::string text = json;
  text.resize((text.size() + 3) / 4 * 4, ' ');
  std::string result(MAGIC);
  result.append(bytes_of(2))
    .append(bytes_of(headers + text.size() + buffer.size() + rest.size()))
    .append(bytes_of(text.size()))
    .append("JSON")
    .append(text)
    .append(bytes_of(buffer.size()))
    .append("BIN\0", 4)
    .append(buffer)
    .append(rest);
  return result;
}

Glb_chunks chunks_of_glb(const std::string& bytes)
{
  std::size_t position = HEADER;
  const auto next_chunk = [&] {
    const std::string_view chunk
      = std::string_view(bytes).substr(position + CHUNK_HEADER, number_at(bytes, position));
    position += CHUNK_HEADER + chunk.size();
    return chunk;
  };
  Glb_chunks result;
  result.json = next_chunk();
  if(position < bytes.size())
    result.buffer = next_chunk();
  result.rest = std::string_view(bytes).substr(position);
  return result;
}

} // namespace Canonical_pose_tool
