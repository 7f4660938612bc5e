// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "gzip.h"

#ifdef CANONICAL_POSE_WITH_ZLIB
#include <zlib.h>
#endif

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace Canonical_pose_tool {

bool is_gzip(const std::string_view bytes) { return bytes.substr(0, 2) == "\x1F\x8B"; }

#ifdef CANONICAL_POSE_WITH_ZLIB

namespace {

constexpr int GZIP_WINDOW = MAX_WBITS + 16; // a gzip file, not a stream of zlib

// Lets zlib work on bytes in parts, since it counts in 32 bits. `step(stream, is_last)` returns whether
// it goes on.
template <class Step>
std::string converted(z_stream& stream, const std::string& bytes, const Step& step)
{
  constexpr std::size_t largest_part = std::size_t(1) << 20;
  std::vector<unsigned char> part(largest_part);
  std::string result;
  std::size_t taken = 0;
  for(bool goes_on = true; goes_on;)
  {
    const std::size_t size = (std::min)(bytes.size() - taken, largest_part);
    stream.next_in = reinterpret_cast<unsigned char*>(const_cast<char*>(bytes.data() + taken));
    stream.avail_in = static_cast<unsigned int>(size);
    stream.next_out = part.data();
    stream.avail_out = static_cast<unsigned int>(part.size());
    goes_on = step(stream, taken + size == bytes.size());
    taken += size - stream.avail_in;
    result.append(reinterpret_cast<const char*>(part.data()), part.size() - stream.avail_out);
  }
  return result;
}

} // namespace

bool is_gzip_available() { return true; }

std::string decompressed(const std::string& bytes)
{
  struct Inflation : z_stream
  {
    Inflation() : z_stream()
    {
      if(inflateInit2(this, GZIP_WINDOW) != Z_OK)
        throw std::runtime_error("zlib cannot be used");
    }
    ~Inflation() { inflateEnd(this); }
  } stream;
  return converted(stream, bytes, [](z_stream& s, const bool is_last) {
    const int code = inflate(&s, Z_NO_FLUSH);
    if(code == Z_STREAM_END)
    {
      const unsigned char *const rest = s.next_in, *const end = rest + s.avail_in;
      if(is_last && std::all_of(rest, end, [](const unsigned char byte) { return byte == 0; }))
        return false;                  // what tapes add is no file
      return inflateReset(&s) == Z_OK; // another compressed file follows
    }
    if(code == Z_BUF_ERROR && is_last && s.avail_in == 0)
      throw std::invalid_argument("the compressed file is truncated");
    if(code != Z_OK && code != Z_BUF_ERROR)
      throw std::invalid_argument("the compressed file is damaged");
    return true;
  });
}

std::string compressed(const std::string& bytes)
{
  struct Deflation : z_stream
  {
    Deflation() : z_stream()
    {
      constexpr int memory_level = 8; // zlib's default
      if(deflateInit2(this, Z_DEFAULT_COMPRESSION, Z_DEFLATED, GZIP_WINDOW, memory_level,
                      Z_DEFAULT_STRATEGY)
         != Z_OK)
        throw std::runtime_error("zlib cannot be used");
    }
    ~Deflation() { deflateEnd(this); }
  } stream;
  return converted(stream, bytes, [](z_stream& s, const bool is_last) {
    const int code = deflate(&s, is_last ? Z_FINISH : Z_NO_FLUSH);
    if(code == Z_STREAM_ERROR)
      throw std::runtime_error("zlib failed");
    return code != Z_STREAM_END;
  });
}

#else

bool is_gzip_available() { return false; }

std::string decompressed(const std::string&)
{
  throw std::invalid_argument("the file is compressed, but this program was built without zlib");
}

std::string compressed(const std::string&)
{
  throw std::runtime_error("this program was built without zlib");
}

#endif

} // namespace Canonical_pose_tool
