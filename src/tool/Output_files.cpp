// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Output_files.h"
#include "Command_line.h"
#include "formats/Companion_files.h"
#include "formats/Mesh_file.h"
#include "formats/gzip.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <functional>
#include <iostream>
#include <map>
#include <ostream>
#include <set>
#include <sstream>
#include <stdexcept>
#include <streambuf>
#include <string>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace Canonical_pose_tool {

namespace {

namespace fs = std::filesystem;

std::string cannot_write(const std::string& path, const std::string& reason)
{
  return "'" + path + "' cannot be written: " + reason;
}

// The file to which symbolic links lead, since a renamed file would replace the link.
fs::path place_of(const std::string& path)
{
  const int most_links = 40; // as on Linux
  std::error_code error;
  fs::path place = fs::absolute(path);
  for(int links = 0; fs::is_symlink(fs::symlink_status(place, error)); ++links)
  {
    if(links == most_links)
      throw std::invalid_argument(
        cannot_write(path, make_error_code(std::errc::too_many_symbolic_link_levels).message()));
    place = place.parent_path() / fs::read_symlink(place, error);
  }
  const fs::path directory = fs::canonical(place.parent_path(), error);
  if(error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
    throw std::invalid_argument(cannot_write(path, error.message()));
  if(error || !fs::is_directory(directory))
    throw std::invalid_argument(cannot_write(path, "there is no such directory"));
  return directory / place.filename();
}

// The same, if a file can be written there.
fs::path writable_place_of(const std::string& path)
{
  fs::path place = place_of(path);
  std::error_code error;
  const fs::file_status status = fs::status(place, error);
  if(!fs::status_known(status))
    throw std::invalid_argument(cannot_write(path, error.message()));
  if(fs::exists(status) && !fs::is_regular_file(status))
    throw std::invalid_argument(cannot_write(path, "it is not a file"));
  if(access(place.parent_path().c_str(), W_OK) != 0)
    throw std::invalid_argument(cannot_write(path, "the directory cannot be written to"));
  return place;
}

// The files that a signal removes: a list from which nothing is taken, so that a handler can walk through it.
struct Unfinished_file
{
  std::string path;
  std::atomic<bool> exists;
  Unfinished_file* next;
};
std::atomic<Unfinished_file*> unfinished_files{nullptr};
std::atomic<pid_t> owner{0}; // of the files: not a child before it becomes another program
std::atomic<bool> is_committing{false};
std::atomic<int> signal_during_commit{0};

// Only what is safe in a handler.
extern "C" void remove_files_and_exit(const int signal)
{
  if(is_committing)
  {
    signal_during_commit = signal;
    return;
  }
  for(Unfinished_file* file = unfinished_files; file && owner == getpid(); file = file->next)
    if(file->exists && unlink(file->path.c_str()) != 0)
      rmdir(file->path.c_str()); // after the files in it, which are newer
  _exit(128 + signal);
}

// A name for another file in the same directory as `place`.
fs::path beside(const fs::path& place, const int attempt)
{
  const std::size_t longest = 200; // so that there is room for the rest
  std::string name = place.filename().string().substr(0, longest);
  name += ".part-" + std::to_string(getpid());
  if(attempt > 0)
    name += '-' + std::to_string(attempt);
  return place.parent_path() / name;
}

// Returns a name in the directory of `place` under which `make` created a file; empty on failure.
// `make` returns a negative number and sets errno on failure, like open(). Names in use are
// skipped, including those of links.
template <class Make>
fs::path make_beside(const fs::path& place, const Make& make)
{
  const int most_attempts = 1000;
  for(int attempt = 0;; ++attempt)
  {
    fs::path name = beside(place, attempt);
    add_unfinished_file(name.string());
    if(make(name.c_str()) >= 0)
      return name;
    const int error = errno;
    drop_unfinished_file(name.string());
    errno = error;
    if(errno != EEXIST || attempt == most_attempts)
      return {};
  }
}

// Writes to a file descriptor, and closes it afterward.
class Descriptor_buffer : public std::streambuf
{
public:
  explicit Descriptor_buffer(const int descriptor) : m_descriptor(descriptor)
  {
    setp(m_bytes.data(), m_bytes.data() + m_bytes.size());
  }

  Descriptor_buffer(const Descriptor_buffer&) = delete;
  Descriptor_buffer& operator=(const Descriptor_buffer&) = delete;
  ~Descriptor_buffer() override { close(); }

  // Returns whether everything was written to the file; otherwise errno states the reason.
  bool close()
  {
    if(m_descriptor < 0)
      return m_error == 0;
    sync();
    if(::close(m_descriptor) != 0 && m_error == 0)
      m_error = errno;
    m_descriptor = -1;
    errno = m_error;
    return m_error == 0;
  }

private:
  int_type overflow(const int_type byte) override
  {
    if(sync() != 0)
      return traits_type::eof();
    if(!traits_type::eq_int_type(byte, traits_type::eof()))
      sputc(traits_type::to_char_type(byte));
    return traits_type::not_eof(byte);
  }

  int sync() override
  {
    for(const char* position = pbase(); m_error == 0 && position != pptr();)
    {
      const ssize_t n
        = ::write(m_descriptor, position, static_cast<std::size_t>(pptr() - position));
      if(n >= 0)
        position += n;
      else if(errno != EINTR)
        m_error = errno;
    }
    setp(m_bytes.data(), m_bytes.data() + m_bytes.size());
    return m_error == 0 ? 0 : -1;
  }

  std::array<char, 65536> m_bytes;
  int m_descriptor;
  int m_error = 0; // the first one
};

} // namespace

void add_unfinished_file(const std::string& path)
{
  auto* const file = new Unfinished_file{path, true, unfinished_files.load()};
  unfinished_files.store(file);
}

void drop_unfinished_file(const std::string& path)
{
  for(Unfinished_file* file = unfinished_files; file; file = file->next)
    if(file->path == path)
      file->exists = false;
}

void remove_files_on_signals()
{
  owner = getpid();
  for(const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXFSZ})
  {
    struct sigaction action = {};
    sigaction(signal, nullptr, &action);
    if(action.sa_handler != SIG_DFL)
      continue;
    action.sa_handler = remove_files_and_exit;
    sigaction(signal, &action, nullptr);
  }
}

std::ostream& messages_beside(const std::vector<std::string>& outputs)
{
  return std::any_of(outputs.begin(), outputs.end(), is_standard_stream) ? std::cerr : std::cout;
}

bool is_same_file(const std::string& path, const std::string& other)
{
  std::error_code error;
  return fs::equivalent(path, other, error);
}

Output_files::Output_files(const std::vector<std::string>& paths,
                           const std::vector<std::string>& inputs, const std::string& replaced)
{
  std::map<std::string, std::string> input_of; // of the files that inputs name
  for(const std::string& input : inputs)
    for(const std::string& file : paths_beside(input))
      input_of[file] = input;
  for(const std::string& file : paths_beside(replaced))
    input_of[file] = replaced;
  for(const auto& [file, input] : input_of)
    m_files_of_inputs.push_back(file);
  std::set<fs::path> places;
  for(const std::string& path : paths)
  {
    if(path.empty())
      continue;
    if(is_compressed(path) && !is_gzip_available())
      throw std::invalid_argument(cannot_write(path, "this program was built without zlib"));
    if(is_standard_stream(path))
    {
      if(!places.insert("-").second)
        throw Usage_error("two outputs cannot both be the standard output");
      continue;
    }
    const fs::path place = writable_place_of(path);
    for(const std::string& input : inputs)
      if(is_same_file(place.string(), input))
        throw std::invalid_argument(cannot_write(path, "it is an input"));
    for(const auto& [file, input] : input_of)
      if(is_same_file(place.string(), file))
        throw std::invalid_argument(cannot_write(path, "the input '" + input + "' names it"));
    if(!places.insert(place).second)
      throw Usage_error(cannot_write(path, "another output has the same name"));
    m_places[path] = place;
  }
}

Output_files::~Output_files()
{
  std::error_code error;
  for(const File& file : m_files)
    for(const fs::path& name : {file.beside, file.before})
      if(!name.empty())
      {
        fs::remove(name, error);
        drop_unfinished_file(name.string());
      }
  is_committing = false;
  if(signal_during_commit != 0)
    remove_files_and_exit(signal_during_commit);
}

void Output_files::write(const std::string& path,
                         const std::function<void(std::ostream&)>& write_to)
{
  write_with_files(path, [&](std::ostream& out, Companion_files*) { write_to(out); });
}

void Output_files::write_with_files(const std::string& path, const Write_with_files& write_to)
{
  if(path.empty())
    return;
  if(is_standard_stream(path))
  {
    std::ostringstream out;
    write_to(out, nullptr);
    m_standard_output = out.str();
    return;
  }
  write_file(path, m_places.at(path), write_to);
}

void Output_files::write_file(const std::string& path, const fs::path& place,
                              const Write_with_files& write_to)
{
  int descriptor = -1;
  const fs::path name = make_beside(place, [&](const char* const candidate) {
    return descriptor = open(candidate, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  });
  if(name.empty())
    throw std::runtime_error(cannot_write(path, std::strerror(errno)));
  m_files.push_back({path, place, name});
  Descriptor_buffer buffer(descriptor);
  std::ostream out(&buffer);
  Companion_files beside{place, m_files_of_inputs};
  if(is_compressed(path))
  {
    std::ostringstream content;
    write_to(content, nullptr);
    out << compressed(content.str());
  }
  else
    write_to(out, &beside);
  if(!buffer.close())
    throw std::runtime_error(cannot_write(path, std::strerror(errno)));
  if(!out)
    throw std::runtime_error(cannot_write(path, "the numbers could not be turned into text"));
  for(const auto& [name_beside, content] : beside.contents)
  {
    const std::string path_beside = (fs::path(path).parent_path() / name_beside).string();
    const fs::path place_beside = writable_place_of((place.parent_path() / name_beside).string());
    const auto is_there = [&, p = place_beside](const auto& file) { return file.place == p; };
    const auto is_output = [&, p = place_beside](const auto& output) { return output.second == p; };
    if(std::any_of(m_files.begin(), m_files.end(), is_there)
       || std::any_of(m_places.begin(), m_places.end(), is_output))
      throw std::runtime_error(cannot_write(path_beside, "another output has the same name"));
    write_file(path_beside, place_beside,
               [&, bytes = &content](std::ostream& file, Companion_files*) { file << *bytes; });
  }
}

void Output_files::commit()
{
  if(!(std::cout << m_standard_output).flush())
    throw std::runtime_error("the standard output cannot be written");
  keep_what_is_there();
  is_committing = true; // until the files that were there are removed
  for(std::size_t i = 0; i < m_files.size(); ++i)
  {
    std::error_code error;
    fs::rename(m_files[i].beside, m_files[i].place, error);
    if(error)
    {
      undo(i);
      throw std::runtime_error(cannot_write(m_files[i].path, error.message()));
    }
    drop_unfinished_file(m_files[i].beside.string());
    m_files[i].beside.clear();
  }
}

// If the file system has no hard links, nothing can be kept.
void Output_files::keep_what_is_there()
{
  std::error_code error;
  for(File& file : m_files)
  {
    file.is_new = !fs::exists(file.place, error);
    if(!file.is_new && m_files.size() > 1)
      file.before = make_beside(file.place, [&](const char* const candidate) {
        return link(file.place.c_str(), candidate);
      });
  }
}

void Output_files::undo(const std::size_t number_of_renamed_files)
{
  std::error_code error;
  for(std::size_t i = 0; i < number_of_renamed_files; ++i)
  {
    File& file = m_files[i];
    if(file.is_new)
      fs::remove(file.place, error);
    else if(!file.before.empty())
      fs::rename(file.before, file.place, error);
  }
}

} // namespace Canonical_pose_tool
