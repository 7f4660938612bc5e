// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_OUTPUT_FILES_H
#define CGAL_CANONICAL_POSE_3_TOOL_OUTPUT_FILES_H

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

namespace Canonical_pose_tool {

struct Companion_files;

// On SIGINT, SIGTERM, SIGHUP, SIGPIPE and SIGXFSZ, unless they are ignored: removes the files that are not
// committed, and exits with 128 plus the number of the signal. A signal during commit() waits for its end.
void remove_files_on_signals();

// Lets signals remove a file, or an empty folder, too, until it is dropped.
void add_unfinished_file(const std::string& path);
void drop_unfinished_file(const std::string& path);

// Where messages go: not to the standard output if it is one of the outputs.
std::ostream& messages_beside(const std::vector<std::string>& outputs);

// Whether both paths lead to one file, which exists.
bool is_same_file(const std::string& path, const std::string& other);

// The output files of a run: either all of them are written completely, or none. They are first
// written to the same directories under unused names, and then renamed together. Symbolic links are
// followed, whether or not their target exists. Files with the extension ".gz" are compressed. The
// standard output gets its bytes before files are renamed.
class Output_files
{
public:
  // Checks whether `paths` can be written and are none of the inputs, nor of the files that inputs name, ignoring empty
  // ones. `replaced`: another input, which an output may replace. Writes nothing. Throws std::invalid_argument that names
  // the path.
  explicit Output_files(const std::vector<std::string>& paths,
                        const std::vector<std::string>& inputs = {},
                        const std::string& replaced = {});

  // Removes all files that were not committed.
  ~Output_files();

  Output_files(const Output_files&) = delete;
  Output_files& operator=(const Output_files&) = delete;

  // Writes the temporary file for `path`, one of those that were checked; an empty path is ignored. The files beside it
  // are written, too; null if it is compressed, or the standard output. Throws std::runtime_error on failure.
  using Write_with_files = std::function<void(std::ostream&, Companion_files*)>;
  void write_with_files(const std::string& path, const Write_with_files& write_to);

  // The same, of a file that has none beside it.
  void write(const std::string& path, const std::function<void(std::ostream&)>& write_to);

  // Moves all files to their final paths.
  // Throws std::runtime_error if this fails; the other files then are as they were before.
  void commit();

private:
  struct File
  {
    std::string path;
    std::filesystem::path place, beside;
    // Another name of the existing file that will be replaced; empty if there is none.
    std::filesystem::path before = {};
    bool is_new = true;
  };

  void write_file(const std::string& path, const std::filesystem::path& place,
                  const Write_with_files& write_to);
  void keep_what_is_there();
  void undo(std::size_t number_of_renamed_files);

  std::map<std::string, std::filesystem::path> m_places;
  std::vector<std::string> m_files_of_inputs;
  std::string m_standard_output;
  std::vector<File> m_files;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_OUTPUT_FILES_H
