// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command page.

#include "Output_files.h"
#include "command_options.h"
#include "commands.h"
#include "page_text.h"
#include "formats/Mesh_file.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

namespace {

std::string contents_of(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  std::string contents{std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
  if(!file)
    throw std::runtime_error("'" + path + "' cannot be read");
  return contents;
}

// The bytes of a scene that the page can show.
std::string scene_of(const std::string& path)
{
  if(format_of(path) != Format::GLB)
    throw std::invalid_argument("'" + path + "' is not a .glb file");
  read_other_mesh_file(path);
  return contents_of(path);
}

void write_base64(std::ostream& out, std::string bytes)
{
  using namespace boost::archive::iterators;
  using Digits = base64_from_binary<transform_width<std::string::const_iterator, 6, 8>>;
  const std::size_t padding = (3 - bytes.size() % 3) % 3;
  const std::size_t digits = (8 * bytes.size() + 5) / 6;
  bytes.append(padding, '\0'); // transform_width reads whole groups
  std::copy_n(Digits(bytes.cbegin()), digits, std::ostreambuf_iterator<char>(out));
  out << std::string(padding, '=');
}

std::string escaped(const std::string& text)
{
  std::string result;
  for(const char c : text)
    result += c == '&' ? "&amp;" : c == '"' ? "&quot;" : c == '<' ? "&lt;" : std::string(1, c);
  return result;
}

void add_page_options(Command_options& o)
{
  o.app.add_option("SCENE", o.arguments.inputs, "scenes, or other surfaces (.glb)")->required();
  add_path(o, "-o,--output", o.arguments.output, "the page (.html)")->required();
}

int run_page(Arguments& arguments)
{
  check_extension(arguments.output, ".html");
  Output_files files({arguments.output});
  std::vector<std::string> scenes;
  for(const std::string& path : arguments.inputs)
    scenes.push_back(scene_of(path));
  files.write(arguments.output, [&](std::ostream& out) {
    out << PAGE_HEAD;
    for(std::size_t i = 0; i < scenes.size(); ++i)
    {
      out << "<script type=\"model/gltf-binary;base64\" class=\"scene\" data-name=\""
          << escaped(std::filesystem::path(arguments.inputs[i]).stem().string()) << "\">";
      write_base64(out, scenes[i]);
      out << "</script>\n";
    }
    out << PAGE_TAIL;
  });
  files.commit();
  return EXIT_SUCCESS;
}

} // namespace

const Command PAGE_COMMAND = {"page",
                              "makes a web page that shows scenes (.glb)",
                              {"page man.glb -o man.html", "page *.glb -o gallery.html"},
                              add_page_options,
                              run_page};

} // namespace Canonical_pose_tool
