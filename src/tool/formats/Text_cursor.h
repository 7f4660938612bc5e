// Copyright (c) 2026 The Canonical_pose_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_CANONICAL_POSE_3_TOOL_TEXT_CURSOR_H
#define CGAL_CANONICAL_POSE_3_TOOL_TEXT_CURSOR_H

#include <cerrno>
#include <charconv>
#include <cstddef>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace Canonical_pose_tool {

// An element of a mesh file, for messages.
struct Element
{
  static constexpr std::size_t THE_ONLY_ONE = std::size_t(-1);

  const char* kind;
  std::size_t index = THE_ONLY_ONE;

  std::string name() const
  {
    return index == THE_ONLY_ONE ? kind : std::string(kind) + ' ' + std::to_string(index);
  }
};

inline constexpr const char* BYTE_ORDER_MARK = "\xEF\xBB\xBF"; // of UTF-8

// Removes the mark that some editors write before a text. Returns whether there is one. Throws if the text
// is in UTF-16.
inline bool remove_byte_order_mark(std::string& text)
{
  if(text.compare(0, 2, "\xFF\xFE") == 0 || text.compare(0, 2, "\xFE\xFF") == 0)
    throw std::invalid_argument("the text is encoded in UTF-16; UTF-8 and ASCII are read");
  const bool is_marked = text.compare(0, 3, BYTE_ORDER_MARK) == 0;
  if(is_marked)
    text.erase(0, 3);
  return is_marked;
}

// Reads words and numbers from a text, one after the other. '#' starts a comment, up to the end of
// the line. Lines end in LF, CR LF, or CR alone. What DOS writes at the end of a text is left out.
class Text_cursor
{
public:
  // Whether a line goes on in the next one after a backslash, between words that are read by word_on_line().
  enum class Lines { SINGLE, CONTINUED };

  // `text` must outlive the cursor.
  explicit Text_cursor(const std::string& text, const Lines lines = Lines::SINGLE)
    : m_position(text.c_str()), m_end(m_position + text.size()),
      m_is_continued(lines == Lines::CONTINUED)
  {
    while(m_end != m_position && m_end[-1] == '\x1A')
      --m_end;
  }

  // Returns the next word, on any line; empty at the end of the text.
  std::string_view word()
  {
    while(m_position != m_end && (is_blank(*m_position) || is_line_end() || *m_position == '#'))
      *m_position == '#' ? skip_line() : step();
    return rest_of_word();
  }

  // Returns the next word on this line; empty at the end of the line.
  std::string_view word_on_line()
  {
    while(m_position != m_end)
      if(const std::size_t length = continuation())
      {
        m_position += length;
        ++m_line;
      }
      else if(is_blank(*m_position) && !is_line_end())
        ++m_position;
      else
        break;
    return m_position != m_end && *m_position == '#' ? std::string_view() : rest_of_word();
  }

  // Goes to the end of this line.
  void skip_line()
  {
    while(m_position != m_end && !is_line_end())
      ++m_position;
  }

  // Goes to the first byte of the next line.
  void next_line()
  {
    skip_line();
    if(m_position != m_end)
      step();
  }

  // Number of the line, from 1.
  std::size_t line() const { return m_line; }

  const char* position() const { return m_position; }
  const char* end() const { return m_end; }

  // Converts a word that is part of `element`.
  double number(const std::string_view word, const Element& element) const
  {
    double result;
    if(is_converted(word, result))
      return result;
    // hexadecimal, with a plus sign, too large or too small
    char* end;
    result = std::strtod(checked(word, element).data(), &end);
    if(end != word.data() + word.size())
      throw wrong(word, element, "is not a number");
    return result;
  }

  // Converts a word that need not be a number.
  double number_or(const std::string_view word, const double otherwise) const
  {
    double result;
    if(is_converted(word, result))
      return result;
    char* end = nullptr;
    result = word.empty() ? otherwise : std::strtod(word.data(), &end);
    return word.empty() || end != word.data() + word.size() ? otherwise : result;
  }

  long long integer(const std::string_view word, const Element& element) const
  {
    long long result;
    if(is_converted(word, result))
      return result;
    char* end;
    errno = 0;
    result = std::strtoll(checked(word, element).data(), &end, 10);
    if(end != word.data() + word.size())
      throw wrong(word, element, "is not an integer");
    if(errno == ERANGE)
      throw wrong(word, element, "is out of range");
    return result;
  }

  // Converts a word that is a number of elements.
  std::size_t count(const std::string_view word, const Element& element) const
  {
    const long long result = integer(word, element);
    if(result < 0)
      throw wrong(word, element, "is negative");
    return static_cast<std::size_t>(result);
  }

  // Throws if the text continues after `last`.
  void check_is_at_end(const Element& last)
  {
    if(!word().empty())
      throw goes_on_after(last);
  }

  std::invalid_argument goes_on_after(const Element& last) const
  {
    return std::invalid_argument(
      "the file goes on after " + last.name()
      + (last.index == Element::THE_ONLY_ONE ? "" : ", the last one announced") + " (line "
      + std::to_string(m_line) + ")");
  }

  // The first part of a word, for messages.
  static std::string shown(const std::string_view word)
  {
    std::string result = "'";
    for(const char c : word.substr(0, 40))
      result += c < ' ' || c > '~' ? '?' : c;
    return result + '\'';
  }

private:
  // Takes a third of the time of std::strtod() and std::strtoll().
  template <class Number>
  static bool is_converted(const std::string_view word, Number& number)
  {
    const char* const end = word.data() + word.size();
    const std::from_chars_result result = std::from_chars(word.data(), end, number);
    return result.ec == std::errc() && result.ptr == end;
  }

#ifndef __cpp_lib_to_chars // not in all libraries of C++17
  static bool is_converted(std::string_view, double&) { return false; }
#endif

  static bool is_blank(const char c)
  {
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
  }
  // Of a text that is not at its end.
  bool is_line_end() const
  {
    return *m_position == '\n'
           || (*m_position == '\r' && (m_position + 1 == m_end || m_position[1] != '\n'));
  }

  // The length of a backslash with the end of line after it, if lines go on there.
  std::size_t continuation() const
  {
    if(!m_is_continued || *m_position != '\\')
      return 0;
    const char* p = m_position + 1;
    if(p != m_end && *p == '\r')
      ++p;
    if(p != m_end && *p == '\n')
      ++p;
    return p == m_position + 1 ? 0 : static_cast<std::size_t>(p - m_position);
  }

  void step()
  {
    if(is_line_end())
      ++m_line;
    ++m_position;
  }

  std::string_view rest_of_word()
  {
    const char* const begin = m_position;
    while(m_position != m_end && !is_blank(*m_position) && *m_position != '\n'
          && continuation() == 0)
      ++m_position;
    return std::string_view(begin, static_cast<std::size_t>(m_position - begin));
  }

  std::string_view checked(const std::string_view word, const Element& element) const
  {
    if(!word.empty())
      return word;
    const bool at_end = std::string_view(m_position, static_cast<std::size_t>(m_end - m_position))
                          .find_first_not_of(" \t\r\n\v\f")
                        == std::string_view::npos;
    throw std::invalid_argument(at_end ? "the file is truncated: it ends in " + element.name()
                                       : element.name() + " is incomplete (line "
                                           + std::to_string(m_line) + ")");
  }

  std::invalid_argument wrong(const std::string_view word, const Element& element,
                              const std::string& defect) const
  {
    return std::invalid_argument(element.name() + ": " + shown(word) + ' ' + defect + " (line "
                                 + std::to_string(m_line) + ")");
  }

  const char* m_position;
  const char* m_end;
  bool m_is_continued;
  std::size_t m_line = 1;
};

} // namespace Canonical_pose_tool

#endif // CGAL_CANONICAL_POSE_3_TOOL_TEXT_CURSOR_H
