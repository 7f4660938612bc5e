// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_BENCHMARK_ARGUMENT_LIST_H
#define CGAL_CANONICAL_POSE_3_BENCHMARK_ARGUMENT_LIST_H

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace Canonical_pose_benchmark {

/// The arguments of a command line, from which options are removed one by one.
class Argument_list
{
public:
  Argument_list(const int argc, char** argv) : m_words(argv + 1, argv + argc) {}

  /// Removes `name` and returns whether it was present.
  bool take_flag(const std::string& name)
  {
    const auto found = std::find(m_words.begin(), m_words.end(), name);
    if(found == m_words.end())
      return false;
    m_words.erase(found);
    return true;
  }

  /// Removes `name` and the following word, which is returned; returns `otherwise` if it is absent.
  std::string take_text(const std::string& name, const std::string& otherwise = "")
  {
    const auto found = std::find(m_words.begin(), m_words.end(), name);
    if(found == m_words.end())
      return otherwise;
    if(found + 1 == m_words.end())
      throw std::invalid_argument(name + " needs a value");
    const std::string value = found[1];
    m_words.erase(found, found + 2);
    return value;
  }

  /// Removes `name` and the following number, which must be nonnegative.
  double take_number(const std::string& name, const double otherwise)
  {
    const std::string text = take_text(name);
    if(text.empty())
      return otherwise;
    std::size_t end = 0;
    const double value
      = text.find_first_not_of("0123456789.") == text.npos ? std::stod(text, &end) : 0;
    if(end != text.size())
      throw std::invalid_argument(name + " needs a number, not " + text);
    return value;
  }

  /// Removes `name` and the following word, one of `words`, and returns its index.
  std::size_t take_choice(const std::string& name, const std::vector<std::string>& words)
  {
    const std::string text = take_text(name, words.front());
    const auto found = std::find(words.begin(), words.end(), text);
    if(found == words.end())
      throw std::invalid_argument(name + " does not know " + text);
    return static_cast<std::size_t>(found - words.begin());
  }

  /// Returns the remaining words; none may look like an option.
  const std::vector<std::string>& rest() const
  {
    for(const std::string& word : m_words)
      if(word.compare(0, 2, "--") == 0)
        throw std::invalid_argument("unknown option " + word);
    return m_words;
  }

private:
  std::vector<std::string> m_words;
};

} // namespace Canonical_pose_benchmark

#endif // CGAL_CANONICAL_POSE_3_BENCHMARK_ARGUMENT_LIST_H
