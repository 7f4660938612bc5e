// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_COLLECTION_DATABASE_H
#define CGAL_CANONICAL_POSE_3_TOOL_COLLECTION_DATABASE_H

#include <Eigen/Core>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

struct sqlite3;

namespace Canonical_pose_tool {

// How it ended for a shape.
enum class Outcome { DONE, REFUSED, CRASHED, TIMED_OUT, OUT_OF_MEMORY, NOT_WRITTEN };

std::string name_of(Outcome outcome);

// What the values of a shape depend on.
struct Shape_key
{
  std::string path;     // absolute
  std::string checksum; // of the file
  std::string options;
  std::string version; // of the tool

  bool operator==(const Shape_key& other) const
  {
    return path == other.path && checksum == other.checksum && options == other.options
           && version == other.version;
  }
};

struct Descriptor_values
{
  std::string name;
  int version;
  Eigen::VectorXd values;
};

// A row of the table of shapes.
struct Shape_row
{
  Shape_key key;
  Outcome outcome = Outcome::DONE;
  std::string message; // of a refusal
  std::string report;  // JSON; empty unless DONE
  std::string pose;    // checksum of its file; empty if not requested
  std::string match;   // JSON; empty if not requested
  std::vector<int> parts; // of the faces; empty if not requested
  double seconds = 0;
  double time_limit = 0, memory_limit = 0; // at that time; 0: none
  std::vector<Descriptor_values> descriptors;
};

// A descriptor of all shapes that have it, in the order of their paths; a column per shape.
struct Described_collection
{
  std::vector<std::string> paths;
  std::vector<Eigen::MatrixXd> values; // per requested descriptor
};

// The shapes of a collection in a file of SQLite, one row per path and options. Each change is a
// transaction, so that the file is whole at any time. All functions throw std::runtime_error if SQLite
// fails.
class Collection_database
{
public:
  // Creates the file if `is_writable` and it does not exist. Throws std::runtime_error if it cannot be
  // opened, is not a database of this tool, or is to be written, and another process writes it.
  Collection_database(const std::string& path, bool is_writable);

  ~Collection_database();

  // Returns the row of a shape, without report, parts and values of the descriptors.
  std::optional<Shape_row> row_of(const std::string& path, const std::string& options);

  // Calls f for all rows as row_of() returns them, in the order of paths and options.
  void for_each_row(const std::function<void(Shape_row&)>& f);

  // Adds report, parts and values of the descriptors.
  void complete(Shape_row& row);

  // Replaces the row of a shape. If the key is the same, results are kept that the new row has not.
  void write(const Shape_row& row);

  // If there is a row with this checksum, options and version whose file is gone, the rows of that file
  // get this path. Returns whether there was one.
  bool take_moved(const Shape_key& key);

  // Writes the rows of others, all or none. Results stay if others have none for the same shape.
  void merge(const std::vector<Collection_database*>& others);

  // Returns name and version of each descriptor that a shape has.
  std::vector<std::pair<std::string, int>> descriptors();

  // Returns the paths of all shapes with a result, in their order.
  std::vector<std::string> paths_of_described();

  // Returns the options under which shapes were described.
  std::vector<std::string> options();

  // Returns the shapes, described under these options, that have all the descriptors, given by name,
  // version and size.
  struct Requested_descriptor
  {
    std::string name;
    int version;
    Eigen::Index size;
  };
  Described_collection values(const std::vector<Requested_descriptor>& requested,
                              const std::string& options);

private:
  struct Close
  {
    void operator()(sqlite3* database) const;
  };

  class Write_lock;

  void execute(const char* sql);

  // All of it, or nothing.
  template <class Function>
  void in_transaction(const Function& f);

  void write_row(const Shape_row& row);

  // The first column of the answer.
  std::vector<std::string> texts(const char* sql);

  std::string m_path;
  int m_tables;                       // their version
  std::unique_ptr<Write_lock> m_lock; // released after the file is closed
  std::unique_ptr<sqlite3, Close> m_database;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_COLLECTION_DATABASE_H
