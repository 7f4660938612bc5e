// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Stance_file.h"
#include "option_values.h"
#include "formats/Mesh_file.h"
#include "formats/Text_cursor.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

namespace Canonical_pose_tool {

namespace {

using CGAL::Canonical_pose_3::Limb_direction_3;
using Words = std::vector<std::string>;

Words words_of(const std::string& line)
{
  Words words;
  Text_cursor text(line);
  for(std::string_view word = text.word_on_line(); !word.empty(); word = text.word_on_line())
    words.emplace_back(word);
  return words;
}

std::string joined(const Words& words, const std::size_t first, const std::size_t last)
{
  std::string result;
  for(std::size_t i = first; i < last; ++i)
    result += (i == first ? "" : " ") + words[i];
  return result;
}

// How many words at the beginning are the name of a limb; 0 if they are not.
std::size_t length_of_name(const Words& words)
{
  for(std::size_t n = (std::min)(words.size(), std::size_t(3)); n > 0; --n)
    if(LIMBS.count(joined(words, 0, n)) > 0)
      return n;
  return 0;
}

// The words before the first number.
std::string before_numbers(const Words& words)
{
  std::size_t n = 1;
  while(n < words.size() && !real_of(words[n]))
    ++n;
  return joined(words, 0, n);
}

} // namespace

Stance_file::Stance_file(const std::string& path) : m_path(path)
{
  std::vector<std::string> lines;
  try
  {
    lines = read_lines(path);
  }
  catch(const std::invalid_argument& error)
  {
    throw std::invalid_argument("'" + path + "': " + error.what());
  }
  for(std::size_t i = 0; i < lines.size(); ++i)
    if(const Words words = words_of(lines[i].substr(0, lines[i].find('#'))); !words.empty())
      words[0] == "stance" ? read_stance(words, i + 1) : read_line(words, i + 1);
  if(m_directions.empty() && m_line_of_stance == 0)
    throw std::invalid_argument("'" + path + "': there are no directions of limbs");
}

std::string Stance_file::name() const { return std::filesystem::path(m_path).stem().string(); }

std::invalid_argument Stance_file::error(const std::size_t line, const std::string& defect) const
{
  return std::invalid_argument("'" + m_path + "': line " + std::to_string(line) + ' ' + defect);
}

void Stance_file::read_stance(const Words& words, const std::size_t line)
{
  const std::string name = joined(words, 1, words.size());
  const auto found = STANCES.find(name);
  if(found == STANCES.end())
    throw error(line, "names the stance " + Text_cursor::shown(name) + ", but must name "
                        + range_of_values(STANCES));
  if(m_line_of_stance > 0)
    throw error(line,
                "names a stance, as line " + std::to_string(m_line_of_stance) + " does already");
  m_stance = found->second;
  m_line_of_stance = line;
}

void Stance_file::read_line(const Words& words, const std::size_t line)
{
  Limb_direction_3 result;
  std::size_t n = 2; // the words of the limb
  if(words[0] == "vertex")
  {
    const std::optional<std::size_t> vertex
      = words.size() > 1 ? count_of<std::size_t>(words[1]) : std::nullopt;
    if(!vertex)
      throw error(line, "names a vertex, but not by its number");
    result.limb = *vertex;
  }
  else if((n = length_of_name(words)) > 0)
    result.limb = LIMBS.at(joined(words, 0, n));
  else
    throw error(line, "names the limb " + Text_cursor::shown(before_numbers(words))
                        + ", but must name " + range_of_values(LIMBS)
                        + ", or a vertex as vertex and its number");
  for(std::size_t i = 0; i < m_directions.size(); ++i)
    if(m_directions[i].limb == result.limb)
      throw error(line, "names the same limb as line " + std::to_string(m_lines[i]));
  std::size_t end = words.size();
  if(end == n + 4)
  {
    --end;
    result.is_straightened = words[end] == "straight";
    if(!result.is_straightened && words[end] != "as-is")
      throw error(line, "ends in " + Text_cursor::shown(words[end])
                          + ", but must end in straight, as-is, or the direction");
  }
  if(end != n + 3)
    throw error(line, "has the direction " + Text_cursor::shown(joined(words, n, end))
                        + ", but must have three numbers");
  for(std::size_t k = 0; k < 3; ++k)
  {
    const std::optional<double> number = real_of(words[n + k]);
    if(!number)
      throw error(line, "has " + Text_cursor::shown(words[n + k])
                          + " in its direction, which is not a finite number");
    result.direction[static_cast<Eigen::Index>(k)] = *number;
  }
  if((result.direction.array() == 0).all())
    throw error(line, "has a direction of length 0");
  m_directions.push_back(result);
  m_lines.push_back(line);
}

} // namespace Canonical_pose_tool
