// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Collection_database.h"
#include "Output_files.h"

#include <sqlite3.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace Canonical_pose_tool {

namespace {

// The identification of the files of this tool, and of their tables.
constexpr int APPLICATION = 0x43506f33, TABLES = 3;

const char* const create_shapes = R"(
CREATE TABLE shape(
  id INTEGER PRIMARY KEY, path TEXT NOT NULL, checksum TEXT NOT NULL, options TEXT NOT NULL,
  version TEXT NOT NULL, outcome TEXT NOT NULL, message TEXT NOT NULL, report TEXT NOT NULL,
  pose TEXT NOT NULL, parts BLOB NOT NULL, seconds REAL NOT NULL, time_limit REAL NOT NULL,
  memory_limit REAL NOT NULL, "match" TEXT NOT NULL DEFAULT '', UNIQUE(path, options));
CREATE INDEX content ON shape(checksum);
)";
const char* const create_descriptors = R"(
CREATE TABLE descriptor(
  shape INTEGER NOT NULL REFERENCES shape(id) ON DELETE CASCADE, name TEXT NOT NULL,
  version INTEGER NOT NULL, "values" BLOB NOT NULL, PRIMARY KEY(shape, name));
)";
// In version 1, there was one row per path, and it was not known which poses belong to it.
const char* const begin_upgrade = "ALTER TABLE shape RENAME TO shape_1;";
const char* const end_upgrade = R"(
INSERT INTO shape SELECT id, path, checksum, options, version, outcome, message, report, '', parts, seconds,
  time_limit, memory_limit, '' FROM shape_1;
DROP TABLE shape_1;
)";
// In version 2, there were no matches.
const char* const add_matches = R"(ALTER TABLE shape ADD COLUMN "match" TEXT NOT NULL DEFAULT '')";

constexpr std::array<Outcome, 6> all_outcomes
  = {Outcome::DONE,      Outcome::REFUSED,       Outcome::CRASHED,
     Outcome::TIMED_OUT, Outcome::OUT_OF_MEMORY, Outcome::NOT_WRITTEN};

Outcome outcome_of(const std::string& name)
{
  const auto found = std::find_if(all_outcomes.begin(), all_outcomes.end(),
                                  [&](const Outcome outcome) { return name_of(outcome) == name; });
  if(found == all_outcomes.end())
    throw std::runtime_error("the database has an unknown outcome '" + name + "'");
  return *found;
}

[[noreturn]] void fail(sqlite3* database, const std::string& path)
{
  if(database && sqlite3_errcode(database) == SQLITE_NOTADB)
    throw std::runtime_error("'" + path + "' is not a collection of this program");
  throw std::runtime_error("the database '" + path
                           + "': " + (database ? sqlite3_errmsg(database) : "out of memory"));
}

// A prepared statement.
class Statement
{
public:
  Statement(sqlite3* database, const std::string& path, const std::string& sql)
    : m_database(database), m_path(path)
  {
    if(sqlite3_prepare_v2(database, sql.c_str(), -1, &m_statement, nullptr) != SQLITE_OK)
      fail(database, path);
  }
  Statement(const Statement&) = delete;
  Statement& operator=(const Statement&) = delete;
  ~Statement() { sqlite3_finalize(m_statement); }

  Statement& bind(const std::string& text)
  {
    return check(sqlite3_bind_text(m_statement, ++m_bound, text.data(),
                                   static_cast<int>(text.size()), SQLITE_TRANSIENT));
  }
  Statement& bind(const double number)
  {
    return check(sqlite3_bind_double(m_statement, ++m_bound, number));
  }
  Statement& bind(const std::int64_t number)
  {
    return check(sqlite3_bind_int64(m_statement, ++m_bound, number));
  }
  Statement& bind_blob(const void* data, const std::size_t size)
  {
    return check(size == 0
                   ? sqlite3_bind_zeroblob(m_statement, ++m_bound, 0)
                   : sqlite3_bind_blob64(m_statement, ++m_bound, data, size, SQLITE_TRANSIENT));
  }

  // Returns whether there is another row.
  bool step()
  {
    const int code = sqlite3_step(m_statement);
    if(code != SQLITE_ROW && code != SQLITE_DONE)
      fail(m_database, m_path);
    return code == SQLITE_ROW;
  }

  std::string text(const int column)
  {
    const auto* const data = sqlite3_column_text(m_statement, column);
    return data ? std::string(reinterpret_cast<const char*>(data),
                              static_cast<std::size_t>(sqlite3_column_bytes(m_statement, column)))
                : std::string();
  }
  double number(const int column) { return sqlite3_column_double(m_statement, column); }
  std::int64_t integer(const int column) { return sqlite3_column_int64(m_statement, column); }

  // Copies a blob of that size. Returns whether it has this size.
  bool copy_blob(const int column, void* destination, const std::size_t size)
  {
    const void* const data = sqlite3_column_blob(m_statement, column);
    if(static_cast<std::size_t>(sqlite3_column_bytes(m_statement, column)) != size)
      return false;
    if(size > 0)
      std::memcpy(destination, data, size);
    return true;
  }

private:
  Statement& check(const int code)
  {
    if(code != SQLITE_OK)
      fail(m_database, m_path);
    return *this;
  }

  sqlite3* m_database;
  const std::string& m_path;
  sqlite3_stmt* m_statement = nullptr;
  int m_bound = 0;
};

} // namespace

std::string name_of(const Outcome outcome)
{
  switch(outcome)
  {
  case Outcome::DONE:
    return "done";
  case Outcome::REFUSED:
    return "refused";
  case Outcome::TIMED_OUT:
    return "time limit";
  case Outcome::OUT_OF_MEMORY:
    return "out of memory";
  case Outcome::NOT_WRITTEN:
    return "not written";
  default:
    return "crashed";
  }
}

// Held by the process that writes a database, on a file beside it: a lock of SQLite would keep others
// from reading, too. The system releases it with the process.
class Collection_database::Write_lock
{
public:
  explicit Write_lock(const std::string& database) : m_path(database + ".lock")
  {
    while(!is_held(database))
      ::close(m_file);
    add_unfinished_file(m_path);
  }
  Write_lock(const Write_lock&) = delete;
  Write_lock& operator=(const Write_lock&) = delete;
  ~Write_lock()
  {
    drop_unfinished_file(m_path); // afterward, there may be that of another process
    unlink(m_path.c_str());
    ::close(m_file);
  }

private:
  // Whether the lock is on the file that now has this path: the process before may have removed it.
  bool is_held(const std::string& database)
  {
    m_file = open(m_path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if(m_file < 0)
      throw std::runtime_error("'" + m_path + "' cannot be created: " + std::strerror(errno));
    struct flock lock = {};
    lock.l_type = F_WRLCK;
    lock.l_whence = SEEK_SET;
    if(fcntl(m_file, F_SETLK, &lock) != 0 && (errno == EACCES || errno == EAGAIN))
    {
      ::close(m_file);
      throw std::runtime_error(
        "another process writes the database '" + database
        + "'; run again after it has ended, or write another database and merge them");
    }
    struct stat of_file, of_path;
    return fstat(m_file, &of_file) == 0 && stat(m_path.c_str(), &of_path) == 0
           && of_file.st_ino == of_path.st_ino && of_file.st_dev == of_path.st_dev;
  }

  std::string m_path;
  int m_file = -1;
};

void Collection_database::Close::operator()(sqlite3* database) const { sqlite3_close(database); }

Collection_database::Collection_database(const std::string& path, const bool is_writable)
  : m_path(path)
{
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(
    std::filesystem::absolute(path).c_str(), &database, // not what SQLite sees in other names
    is_writable ? SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE : SQLITE_OPEN_READONLY, nullptr);
  m_database.reset(database);
  if(code != SQLITE_OK)
    fail(database, path);
  constexpr int milliseconds_to_wait = 10000;
  sqlite3_busy_timeout(database, milliseconds_to_wait);
  if(is_writable)
    m_lock = std::make_unique<Write_lock>(path);
  const auto pragma = [&](const std::string& name) {
    Statement statement(database, m_path, "PRAGMA " + name);
    return statement.step() ? statement.integer(0) : 0;
  };
  const std::int64_t application = pragma("application_id"), tables = pragma("user_version"),
                     number_of_pages = pragma("page_count");
  const bool is_new = number_of_pages == 0 && is_writable;
  if(!is_new && application != APPLICATION)
    throw std::runtime_error("'" + path + "' is not a collection of this program");
  if(!is_new && (tables < 1 || tables > TABLES))
    throw std::runtime_error("'" + path + "' was written by another version of this program");
  if(is_writable && (is_new || tables < TABLES))
  {
    execute("PRAGMA legacy_alter_table = ON"); // descriptors go on referring to `shape`
    in_transaction([&] {
      if(tables == 2)
        execute(add_matches);
      else
      {
        if(!is_new)
          execute(begin_upgrade);
        execute(create_shapes);
        execute(is_new ? create_descriptors : end_upgrade);
      }
      execute(("PRAGMA application_id = " + std::to_string(APPLICATION)).c_str());
      execute(("PRAGMA user_version = " + std::to_string(TABLES)).c_str());
    });
  }
  m_tables = is_writable ? TABLES : static_cast<int>(tables);
  execute("PRAGMA foreign_keys = ON");
}

Collection_database::~Collection_database() = default;

void Collection_database::execute(const char* const sql)
{
  if(sqlite3_exec(m_database.get(), sql, nullptr, nullptr, nullptr) != SQLITE_OK)
    fail(m_database.get(), m_path);
}

template <class Function>
void Collection_database::in_transaction(const Function& f)
{
  execute("BEGIN IMMEDIATE");
  try
  {
    f();
    execute("COMMIT");
  }
  catch(...)
  {
    sqlite3_exec(m_database.get(), "ROLLBACK", nullptr, nullptr, nullptr);
    throw;
  }
}

std::optional<Shape_row> Collection_database::row_of(const std::string& path,
                                                     const std::string& options)
{
  Statement statement(m_database.get(), m_path,
                      "SELECT checksum, options, version, outcome, message, "
                        + std::string(m_tables >= 2 ? "pose" : "''")
                        + ", length(parts), time_limit, memory_limit, id, "
                        + (m_tables >= 3 ? "\"match\"" : "''")
                        + " FROM shape WHERE path = ? AND options = ?");
  if(!statement.bind(path).bind(options).step())
    return std::nullopt;
  Shape_row row;
  row.key = {path, statement.text(0), statement.text(1), statement.text(2)};
  row.outcome = outcome_of(statement.text(3));
  row.message = statement.text(4);
  row.pose = statement.text(5);
  row.parts.resize(static_cast<std::size_t>(statement.integer(6)) / sizeof(int));
  row.time_limit = statement.number(7);
  row.memory_limit = statement.number(8);
  row.match = statement.text(10);
  Statement descriptors(m_database.get(), m_path,
                        "SELECT name, version FROM descriptor WHERE shape = ? ORDER BY name");
  descriptors.bind(statement.integer(9));
  while(descriptors.step())
    row.descriptors.push_back(
      {descriptors.text(0), static_cast<int>(descriptors.integer(1)), Eigen::VectorXd()});
  return row;
}

void Collection_database::complete(Shape_row& row)
{
  Statement statement(
    m_database.get(), m_path,
    "SELECT report, parts, seconds, id FROM shape WHERE path = ? AND options = ?");
  statement.bind(row.key.path).bind(row.key.options).step();
  row.report = statement.text(0);
  statement.copy_blob(1, row.parts.data(), row.parts.size() * sizeof(int));
  row.seconds = statement.number(2);
  for(Descriptor_values& descriptor : row.descriptors)
  {
    Statement values(
      m_database.get(), m_path,
      "SELECT length(\"values\"), \"values\" FROM descriptor WHERE shape = ? AND name = ?");
    values.bind(statement.integer(3)).bind(descriptor.name).step();
    const auto size = static_cast<std::size_t>(values.integer(0));
    descriptor.values.resize(static_cast<Eigen::Index>(size / sizeof(double)));
    if(!values.copy_blob(1, descriptor.values.data(), descriptor.values.size() * sizeof(double)))
      throw std::runtime_error("the database '" + m_path + "' has wrong values of "
                               + descriptor.name + " for '" + row.key.path + "'");
  }
}

void Collection_database::for_each_row(const std::function<void(Shape_row&)>& f)
{
  Statement keys(m_database.get(), m_path,
                 "SELECT path, options FROM shape ORDER BY path, options");
  while(keys.step())
    if(std::optional<Shape_row> row = row_of(keys.text(0), keys.text(1)))
      f(*row);
}

void Collection_database::write(const Shape_row& row)
{
  in_transaction([&] { write_row(row); });
}

void Collection_database::write_row(const Shape_row& row)
{
  const std::optional<Shape_row> before = row_of(row.key.path, row.key.options);
  if(before && (!(before->key == row.key) || row.outcome != Outcome::DONE))
    Statement(m_database.get(), m_path, "DELETE FROM shape WHERE path = ? AND options = ?")
      .bind(row.key.path)
      .bind(row.key.options)
      .step();
  Statement(m_database.get(), m_path,
            "INSERT INTO shape(path, checksum, options, version, outcome, message, report, "
            "pose, parts, seconds, time_limit, memory_limit, \"match\") "
            "VALUES(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?) "
            "ON CONFLICT(path, options) DO UPDATE SET "
            "outcome = excluded.outcome, message = excluded.message, "
            "report = iif(excluded.report <> '', excluded.report, report), "
            "pose = iif(excluded.pose <> '', excluded.pose, pose), "
            "parts = iif(length(excluded.parts) > 0, excluded.parts, parts), "
            "seconds = iif(excluded.report <> '', excluded.seconds, seconds), "
            "time_limit = excluded.time_limit, memory_limit = excluded.memory_limit, "
            "\"match\" = iif(excluded.\"match\" <> '', excluded.\"match\", \"match\")")
    .bind(row.key.path)
    .bind(row.key.checksum)
    .bind(row.key.options)
    .bind(row.key.version)
    .bind(name_of(row.outcome))
    .bind(row.message)
    .bind(row.report)
    .bind(row.pose)
    .bind_blob(row.parts.data(), row.parts.size() * sizeof(int))
    .bind(row.seconds)
    .bind(row.time_limit)
    .bind(row.memory_limit)
    .bind(row.match)
    .step();
  for(const Descriptor_values& descriptor : row.descriptors)
    Statement(m_database.get(), m_path,
              "INSERT OR REPLACE INTO descriptor(shape, name, version, \"values\") "
              "SELECT id, ?, ?, ? FROM shape WHERE path = ? AND options = ?")
      .bind(descriptor.name)
      .bind(static_cast<std::int64_t>(descriptor.version))
      .bind_blob(descriptor.values.data(),
                 static_cast<std::size_t>(descriptor.values.size()) * sizeof(double))
      .bind(row.key.path)
      .bind(row.key.options)
      .step();
}

bool Collection_database::take_moved(const Shape_key& key)
{
  std::optional<std::string> moved;
  {
    Statement rows(m_database.get(), m_path,
                   "SELECT path FROM shape WHERE checksum = ? AND options = ? AND version = ? "
                   "ORDER BY path");
    rows.bind(key.checksum).bind(key.options).bind(key.version);
    namespace fs = std::filesystem;
    std::error_code error;
    while(!moved && rows.step())
      if(const fs::path path = rows.text(0);
         path.extension() == fs::path(key.path).extension() && !fs::exists(path, error))
        moved = path.string();
  }
  if(moved) // under all options
    Statement(m_database.get(), m_path,
              "UPDATE OR IGNORE shape SET path = ? WHERE path = ? AND checksum = ?")
      .bind(key.path)
      .bind(*moved)
      .bind(key.checksum)
      .step();
  return moved.has_value();
}

void Collection_database::merge(const std::vector<Collection_database*>& others)
{
  in_transaction([&] {
    for(Collection_database* const other : others)
      other->for_each_row([&](Shape_row& row) {
        const auto before = row_of(row.key.path, row.key.options);
        if(before && before->outcome == Outcome::DONE && row.outcome != Outcome::DONE)
          return;
        other->complete(row);
        write_row(row);
      });
  });
}

std::vector<std::pair<std::string, int>> Collection_database::descriptors()
{
  Statement statement(m_database.get(), m_path,
                      "SELECT DISTINCT name, version FROM descriptor ORDER BY name, version");
  std::vector<std::pair<std::string, int>> result;
  while(statement.step())
    result.emplace_back(statement.text(0), static_cast<int>(statement.integer(1)));
  return result;
}

std::vector<std::string> Collection_database::texts(const char* const sql)
{
  Statement statement(m_database.get(), m_path, sql);
  std::vector<std::string> result;
  while(statement.step())
    result.push_back(statement.text(0));
  return result;
}

std::vector<std::string> Collection_database::paths_of_described()
{
  return texts("SELECT DISTINCT path FROM shape WHERE outcome = 'done' ORDER BY path");
}

std::vector<std::string> Collection_database::options()
{
  return texts("SELECT DISTINCT options FROM shape WHERE outcome = 'done' ORDER BY options");
}

Described_collection Collection_database::values(const std::vector<Requested_descriptor>& requested,
                                                 const std::string& options)
{
  // One pass per descriptor; then the shapes that have them all.
  std::map<std::string, std::vector<Eigen::VectorXd>> values_of;
  for(std::size_t k = 0; k < requested.size(); ++k)
  {
    Statement statement(m_database.get(), m_path,
                        "SELECT path, \"values\" FROM descriptor JOIN shape ON shape.id = shape "
                        "WHERE name = ? AND descriptor.version = ? AND options = ?");
    statement.bind(requested[k].name)
      .bind(static_cast<std::int64_t>(requested[k].version))
      .bind(options);
    while(statement.step())
    {
      const std::string path = statement.text(0);
      Eigen::VectorXd values(requested[k].size);
      if(!statement.copy_blob(1, values.data(),
                              static_cast<std::size_t>(values.size()) * sizeof(double))
         || !values.allFinite())
        throw std::runtime_error("the database '" + m_path + "' has wrong values of "
                                 + requested[k].name + " for '" + path + "'");
      std::vector<Eigen::VectorXd>& of_shape = values_of[path];
      if(of_shape.size() == k)
        of_shape.push_back(std::move(values));
    }
  }
  Described_collection result;
  for(const auto& [path, values] : values_of)
    if(values.size() == requested.size())
      result.paths.push_back(path);
  for(std::size_t k = 0; k < requested.size(); ++k)
  {
    result.values.emplace_back(requested[k].size, static_cast<Eigen::Index>(result.paths.size()));
    for(std::size_t i = 0; i < result.paths.size(); ++i)
      result.values.back().col(static_cast<Eigen::Index>(i)) = values_of[result.paths[i]][k];
  }
  return result;
}

} // namespace Canonical_pose_tool
