// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_MESH_FILE_H
#define CGAL_CANONICAL_POSE_3_TOOL_MESH_FILE_H

#include "Appearance.h"

#include <CGAL/Canonical_pose_3/Face_list.h>

#include <array>
#include <cstddef>
#include <iosfwd>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

using CGAL::Canonical_pose_3::Face_list;

struct Companion_files;

enum class Format { OFF, OBJ, PLY, STL, MEDIT, GLB, GLTF, VTU };

// A file as it is, without compression; glTF is binary, and in one file.
struct Source_file
{
  Format format;
  std::string bytes;
  std::string path = {};            // beside which other files are
  bool has_byte_order_mark = false; // before these bytes
};

// The contents of a file: a surface or, if is_tetrahedral, a tetrahedral mesh. Indices start at 0.
struct Mesh_file
{
  bool is_tetrahedral = false;
  bool is_checked = true; // whether positions that are not finite, and wrong indices, are refused
  std::vector<std::array<double, 3>> points;
  Face_list faces;                                          // of a surface
  std::vector<std::array<std::size_t, 4>> cells;            // of a tetrahedral mesh
  std::vector<long long> point_references, cell_references; // MEDIT's labels
  std::shared_ptr<const Source_file> source;                // if it was kept
  Appearance appearance;                                    // if it was loaded
};

// Returns the format for the extension or, of a file to read with another one or none, by its content.
// Throws std::invalid_argument, which lists the extensions for this use, if there is none.
enum class Use { READ, WRITE };
Format format_of(const std::string& path, Use use = Use::READ);

// With its dot, in small letters.
std::string extension_of_format(Format format);

// The format in which the pose of a file is written: the same, but for glTF with buffers beside it.
inline Format written_format(const Format format)
{
  return format == Format::GLTF ? Format::GLB : format;
}

// "-", the standard input or output, also with an extension.
bool is_standard_stream(const std::string& path);

// Lets pipes be read anew. Otherwise, what was read from one is kept, as if it were a file.
void forget_streams();

// How messages name an input.
inline std::string name_of_input(const std::string& path)
{
  return is_standard_stream(path) ? "standard input" : '\'' + path + '\'';
}

// The extension of a path, with its dot, in small letters; that of a compressed file is the one before ".gz".
std::string extension_of(const std::string& path);

// The name of a file without folder and extension, nor ".gz".
std::string stem_of(const std::string& path);

bool is_compressed(const std::string& path); // by its extension

// Whether a file that is written there has others beside it.
inline bool has_files_beside(const std::string& path)
{
  return !is_standard_stream(path) && !is_compressed(path);
}

// Loads the appearance of a surface from its file, if that was kept. What is wrong about it is left out.
void load_appearance(Mesh_file& mesh);

// Reads a file. Afterward, coordinates are finite and indices in range; nothing else is checked.
// Throws std::invalid_argument with the defect and the element. This is why CGAL's readers are not
// used: they only report failure. With KEPT, the mesh can be written again as the file with other positions.
// With UNCHECKED, coordinates may be not finite, and indices too large.
enum class Source { DROPPED, KEPT, UNCHECKED };
Mesh_file read_mesh_file(const std::string& path, Source source = Source::DROPPED);

// Of the vertices of a surface; empty if a vertex has several.
std::vector<std::array<float, 3>> normals_of_vertices(const Mesh_file& mesh);

// Turns the normals of a surface with its faces, from other positions to its own.
void turn_normals(Mesh_file& mesh, const std::vector<std::array<double, 3>>& before);

// The same, with its appearance.
inline Mesh_file read_shown_mesh_file(const std::string& path)
{
  Mesh_file mesh = read_mesh_file(path, Source::KEPT);
  load_appearance(mesh);
  return mesh;
}

// The same, for a file other than the main input of a command: the message also names the file.
Mesh_file read_other_mesh_file(const std::string& path, Source source = Source::DROPPED);

// Throws std::invalid_argument unless it is a surface.
inline void check_is_surface(const Mesh_file& mesh)
{
  if(mesh.is_tetrahedral)
    throw std::invalid_argument("a surface is needed, but this is a tetrahedral mesh");
}

// Returns the lines of a text, without their ends. Throws std::invalid_argument if the file cannot be
// read, is empty, or is encoded in UTF-16.
std::vector<std::string> read_lines(const std::string& path);

// Reads numbers separated by blanks or line ends from a text file; '#' starts a comment. Throws
// std::invalid_argument, which also names the file.
std::vector<double> read_numbers(const std::string& path);

// Whether rewrite_mesh() writes this format: that of the file, which was kept.
bool is_rewritable(const Mesh_file& mesh, Format format);

// Loads the appearance if another file than that of the mesh is to be written.
inline void load_appearance_for(Mesh_file& mesh, const Format format)
{
  if(!is_rewritable(mesh, format))
    load_appearance(mesh);
}

// What the file of a mesh holds beside positions and faces, for instance "texture coordinates".
std::vector<std::string> attributes_of_file(const Mesh_file& mesh);
inline constexpr const char* COMMENTS = "comments"; // one of them

// A file that the file of a mesh names, or an image that its MTL file names.
struct File_beside
{
  std::string name, path;
};

// Those that are there.
std::vector<File_beside> files_beside(const Source_file& source);
std::vector<File_beside> files_beside(const Mesh_file& mesh);

// The paths of those of a file that is not read yet; none if it cannot be read.
std::vector<std::string> paths_beside(const std::string& path);

// Those that a mesh from the standard input names, but that are not beside the file at `path`.
std::vector<std::string> names_not_beside(const Mesh_file& mesh, const std::string& path);

// Whether the same file is, or will be, beside the file at `path` that rewrite_mesh() writes: it is, if it is in the folder
// of the mesh, and replaces no other file.
bool is_copied(const Mesh_file& mesh, const File_beside& file, const std::string& path);

// Whether a different file has its name there.
bool is_another_there(const Mesh_file& mesh, const File_beside& file, const std::string& path);

// Adds the files that are not there yet.
void copy_files_beside(const Mesh_file& mesh, Companion_files& beside);

// What of the file of a mesh its pose in this format lacks, whether it is written by rewrite_mesh() or not, and whether
// there are files beside it.
std::vector<std::string> losses(const Mesh_file& mesh, Format format, bool is_rewritten,
                                bool has_files_beside = true);
inline std::vector<std::string> losses(const Mesh_file& mesh, const Format format)
{
  return losses(mesh, format, is_rewritable(mesh, format));
}

// Throws std::invalid_argument if the format is only read, or cannot represent the mesh.
void check_format_holds(Format format, const Mesh_file& mesh);

// Writes a mesh. Numbers in text have enough digits for the same numbers to be read. Materials of OBJ, and textures
// of OBJ and PLY, are files beside it, if it can have such.
void write_mesh(std::ostream& out, Format format, const Mesh_file& mesh,
                Companion_files* beside = nullptr);

// With colors of the vertices, texture coordinates and normals of the corners, and materials, if there are.
void write_obj(std::ostream& out, const Mesh_file& mesh, Companion_files* beside);

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_MESH_FILE_H
