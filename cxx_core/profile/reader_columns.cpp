/// Two-column text: lateral and height, one point a line. Signs and units are not defined by the
/// format; they are settled by the common part of the readers.
#include <algorithm>

#include "profile/reader_formats.hpp"

namespace wrc::reading {
namespace {

/// "1,5 2,3": a comma between digits in a line that is separated by something else.
bool has_decimal_comma(std::string_view line) {
  if (line.find_first_of(" \t;") == std::string_view::npos)
    return false;
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    if (line[i] == ',' && is_digit(line[i - 1]) && is_digit(line[i + 1]))
      return true;
  return false;
}

bool has_no_number(const Words& words) {
  for (std::size_t i = 0; i < std::min(words.count, Words::max_words); ++i)
    if (number_of(words.word[i]))
      return false;
  return true;
}

} // namespace

RawProfile read_columns(std::string_view text, Log& log) {
  RawProfile raw;
  LineCount headings;
  std::size_t columns = 0;
  for (Lines lines(text, log); lines.next();) {
    const std::string_view line =
        trimmed(lines.text().substr(0, lines.text().find_first_of("#!%")));
    if (line.empty())
      continue;
    const Words words = words_of(line, " \t,;");
    if (columns == 0 && has_no_number(words)) {
      headings.add(lines.number());
      continue;
    }
    if (has_decimal_comma(line))
      log.refuse(lines.number(), quoted(line) + " has decimal commas, use points");
    if (words.count < 2)
      log.refuse(lines.number(), quoted(line) + " is one column, two are needed");
    if (columns != 0 && words.count != columns)
      log.refuse(lines.number(), std::to_string(words.count) + " columns, the rows before have " +
                                     std::to_string(columns));
    columns = words.count;
    const double lateral = finite_number(words.word[0], lines.number(), log);
    const double height = finite_number(words.word[1], lines.number(), log);
    add_point(raw, {lateral, height}, lines.number(), log);
  }
  if (headings.count > 0)
    log.guess(headings.text("lines before the first number skipped as headings"),
              "mark them as comments with #");
  if (columns > 2)
    log.guess("columns 3 to " + std::to_string(columns) + " ignored", "remove them");
  return raw;
}

} // namespace wrc::reading
