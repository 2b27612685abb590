/// MiniProf .ban/.whl: header lines Key=Value, a blank line, rows of columns as ColumnDef says.
///
/// Natively X is positive towards the gauge or flange side and Y upwards in the track, mm. Rows
/// that start with a quote or another comment sign are comments, as in CONTACT's reader.
#include <algorithm>
#include <optional>
#include <set>

#include "profile/reader_formats.hpp"

namespace wrc::reading {
namespace {

bool is_comment(std::string_view line) {
  return line.find_first_of("\"!%#") == 0;
}

std::string_view unquoted(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('"'))
    text.remove_prefix(1);
  if (text.ends_with('"'))
    text.remove_suffix(1);
  return trimmed(text);
}

struct Header {
  std::size_t columns = 2;
  std::size_t x = 0;
  std::size_t y = 1;
  Position offset = {0.0, 0.0};
  std::optional<double> points;
  std::string other_columns; ///< that ColumnDef names besides
  std::set<std::string, std::less<>> keys;
};

void read_columns_of(Header& header, std::string_view value, std::size_t line, const Log& log) {
  const Words words = words_of(value, ", \t");
  std::optional<std::size_t> x;
  std::optional<std::size_t> y;
  std::string others;
  for (std::size_t i = 0; i < std::min(words.count, Words::max_words); ++i) {
    if (words.word[i] == "X")
      x = i;
    else if (words.word[i] == "Y")
      y = i;
    else
      others += (others.empty() ? "" : ", ") + printable(words.word[i]);
  }
  if (!x || !y || words.count > Words::max_words)
    log.refuse(line, "ColumnDef=" + printable(value) + ", it must name X and Y among at most " +
                         std::to_string(Words::max_words) + " columns");
  header.columns = words.count;
  header.x = *x;
  header.y = *y;
  header.other_columns = others;
}

void read_header_line(Header& header, std::string_view line, std::size_t number, Log& log) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos)
    return; // old files: free text
  const std::string_view key = unquoted(line.substr(0, equals));
  const std::string_view value = unquoted(line.substr(equals + 1));
  if (value.empty() ||
      (key != "ColumnDef" && key != "XOffset" && key != "YOffset" && key != "XYPoints"))
    return; // the other keys do not change the points
  if (!header.keys.emplace(key).second)
    log.guess(std::string(key) + " stands again in line " + std::to_string(number) +
                  ", the last one counts",
              "remove the others");
  if (key == "ColumnDef")
    read_columns_of(header, value, number, log);
  else if (key == "XOffset")
    header.offset[0] = finite_number(value, number, log);
  else if (key == "YOffset")
    header.offset[1] = finite_number(value, number, log);
  else
    header.points = finite_number(value, number, log);
}

} // namespace

RawProfile read_miniprof(std::string_view text, Log& log) {
  RawProfile raw;
  Header header;
  LineCount comments;
  LineCount short_rows;
  LineCount long_rows;
  bool in_header = true;
  for (Lines lines(text, log); lines.next();) {
    const std::string_view line = lines.text();
    if (in_header) {
      if (line.empty())
        in_header = false;
      else
        read_header_line(header, line, lines.number(), log);
      continue;
    }
    if (line.empty())
      continue;
    if (is_comment(line)) {
      comments.add(lines.number());
      continue;
    }
    const Words words = words_of(line, " \t,;");
    if (words.count < header.columns) {
      short_rows.add(lines.number());
      continue;
    }
    if (words.count > header.columns)
      long_rows.add(lines.number());
    const double x = finite_number(words.word[header.x], lines.number(), log);
    const double y = finite_number(words.word[header.y], lines.number(), log);
    add_point(raw, {x + header.offset[0], y + header.offset[1]}, lines.number(), log);
  }
  if (in_header)
    log.refuse("no blank line found; it must stand between the header and the points");
  if (comments.count > 0)
    log.note(comments.text("rows after the header skipped as comments"));
  if (short_rows.count > 0)
    log.guess(short_rows.text("rows with fewer columns than ColumnDef skipped"), "remove them");
  if (long_rows.count > 0)
    log.guess(long_rows.text("rows have more columns than ColumnDef, which were ignored"),
              "name them in ColumnDef");
  if (!header.other_columns.empty())
    log.note("columns ignored: " + header.other_columns);
  if (header.points && *header.points != static_cast<double>(raw.points.size()))
    log.note("XYPoints in the header differs from the " + std::to_string(raw.points.size()) +
             " points found");
  if (header.offset[0] != 0.0 || header.offset[1] != 0.0)
    log.note("XOffset and YOffset added");
  raw.lateral_towards_gauge = true;
  raw.wheel_height_up = true;
  return raw;
}

} // namespace wrc::reading
