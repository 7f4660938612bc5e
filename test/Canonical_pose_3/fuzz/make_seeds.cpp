// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Writes the initial inputs of a fuzzer: make_seeds file|mesh|complex|components|options
// DIRECTORY.

#include "formats/Mesh_file.h"
#include "formats/readers.h"
#include "shapes.h"

#include <CGAL/IO/io.h>

#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

using namespace Canonical_pose_test;
using namespace Canonical_pose_tool;

namespace {

void write_files(const std::filesystem::path& directory)
{
  Mesh_file surface, solid;
  const Triangle_soup tetrahedron
    = boundary({{{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}}, {{{0, 1, 2, 3}}}});
  const Tetrahedral_soup box = tetrahedral_box(1, 1, 1);
  surface.points = tetrahedron.points;
  surface.faces = tetrahedron.triangles;
  solid.is_tetrahedral = true;
  solid.points = box.points;
  solid.cells = box.cells;
  solid.point_references.resize(box.points.size());
  solid.cell_references.resize(box.cells.size());
  for(char format = 0; format < (is_gltf_available() ? 6 : 5); ++format)
    for(const bool is_binary : {false, true})
    {
      std::ofstream out(directory / (std::to_string(format) + (is_binary ? "b" : "a")));
      out.put(format);
      if(is_binary)
        CGAL::IO::set_binary_mode(out);
      const bool is_solid = Format(format) == Format::MEDIT;
      write_mesh(out, Format(format), is_solid ? solid : surface);
    }
}

// The shape, the number of changes, and the changes, as read by Mutated_soup.
void write_meshes(const std::filesystem::path& directory)
{
  for(int shape = 0; shape < 8; ++shape)
    for(int changes = 0; changes < 4; ++changes)
    {
      std::ofstream out(directory / (std::to_string(shape) + '-' + std::to_string(changes)));
      out.put(char(shape)).put(char(changes));
      for(int i = 0; i < 40; ++i)
        out.put(char(changes * (7 * i + 3 * shape)));
    }
}

} // namespace

int main(int argc, char* argv[])
{
  if(argc != 3)
  {
    std::cerr << "usage: make_seeds file|mesh|complex|components|options DIRECTORY\n";
    return EXIT_FAILURE;
  }
  if(argv[1] == std::string("file"))
    write_files(argv[2]);
  else
    write_meshes(argv[2]); // the first byte of the others is a shape, too, or an option
  return EXIT_SUCCESS;
}
