/// MiniProf .ban/.whl: header lines Key=Value, a blank line, rows of columns as ColumnDef says.
///
/// Old files have a header of free text and two or three columns; MiniProf 2.43 leaves no blank
/// line. A key in quotes counts only where it does not stand without them. Rows that start with a
/// quote or another comment sign are comments, as in CONTACT's reader. Units mm.
///
/// Signs, by measured files: a wheel's X counts from the flange back to the field side, Y towards
/// larger radius. A rail's X counts towards the gauge side, Y upwards; the instrument's own program
/// writes rails half turned (X to the field side, Y downwards).
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "profile/reader_formats.hpp"
#include "profile/readers.hpp"

namespace wrc::reading {
namespace {

/// From this number on, rows of numbers in a header are points (not a tuning constant: rows of a
/// format).
constexpr std::size_t rows_of_points = 5;

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

/// Two or more numbers and nothing else.
bool is_row(std::string_view line) {
  if (is_comment(line))
    return false;
  const std::string row = plain_row(line);
  const Words words = words_of(row, " ");
  for (std::size_t i = 0; i < std::min(words.count, Words::max_words); ++i)
    if (!number_of(words.word[i]))
      return false;
  return words.count >= 2;
}

/// Number of the line with which the points begin: the first row or comment after the blank line
/// that ends the header; without such a line, or if points stand before it, the first row.
std::size_t first_row(std::string_view text, const Log& log) {
  std::size_t first = 0;
  std::size_t in_header = 0;
  bool blank = false;
  for (Lines lines(text, log); lines.next();) {
    blank = blank || lines.text().empty();
    if (!is_row(lines.text()) && !(blank && is_comment(lines.text())))
      continue;
    if (blank && in_header < rows_of_points)
      return lines.number();
    if (first == 0)
      first = lines.number();
    if (blank || ++in_header >= rows_of_points)
      return first;
  }
  return first;
}

struct Header {
  std::size_t columns = 2;
  std::size_t x = 0;
  std::size_t y = 1;
  Position offset = {0.0, 0.0};
  std::optional<double> points;
  std::optional<double> grade;
  std::optional<double> tape_offset;
  std::string program;
  std::string other_columns; ///< that ColumnDef names besides
  struct Value {
    std::string text;
    bool quoted = false;
  };
  std::map<std::string, Value, std::less<>> values;
};

void read_columns_of(Header& header, std::string_view value, std::size_t line, const Log& log) {
  const Words words = words_of(value, ",; \t");
  std::optional<std::size_t> x;
  std::optional<std::size_t> y;
  std::string others;
  for (std::size_t i = 0; i < std::min(words.count, Words::max_words); ++i) {
    if (words.word[i] == "X")
      x = i;
    else if (words.word[i] == "Y")
      y = i;
    else if (words.word[i] != "*")
      others += (others.empty() ? "" : ", ") + printable(words.word[i]);
  }
  if (!x || !y || words.count > Words::max_words)
    log.refuse(line, "ColumnDef=" + printable(value) + ", it must name X and Y among at most " +
                         std::to_string(Words::max_words) + " columns");
  header.columns = std::max(*x, *y) + 1;
  header.x = *x;
  header.y = *y;
  header.other_columns = others;
}

/// The keys that change the points, or say what they are; the others do not.
void apply(Header& header, std::string_view key, std::string_view value, std::size_t line,
           const Log& log) {
  if (key == "ColumnDef")
    read_columns_of(header, value, line, log);
  else if (key == "XOffset")
    header.offset[0] = finite_number(value, line, log);
  else if (key == "YOffset")
    header.offset[1] = finite_number(value, line, log);
  else if (key == "XYPoints")
    header.points = finite_number(value, line, log);
  else if (key == "Grade")
    header.grade = number_of(value);
  else if (key == "WheelDiameterTaperline")
    header.tape_offset = number_of(value);
  else if (key == "ProgramName")
    header.program = value;
}

void read_header_line(Header& header, std::string_view line, std::size_t number, Log& log) {
  const bool is_quoted = line.starts_with('"');
  line = unquoted(line);
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos)
    return; // old files: free text
  std::string key(unquoted(line.substr(0, equals)));
  const std::string value(unquoted(line.substr(equals + 1)));
  if (key == "Xoffset" || key == "Yoffset") // as MiniProf's own program writes them
    key[1] = 'O';
  constexpr std::array known{"ColumnDef",  "XOffset", "YOffset",
                             "XYPoints",   "Grade",   "WheelDiameterTaperline",
                             "ProgramName"};
  if (value.empty() || std::find(known.begin(), known.end(), key) == known.end())
    return;
  const auto [entry, is_new] = header.values.try_emplace(key, Header::Value{value, is_quoted});
  if (!is_new && is_quoted && !entry->second.quoted)
    return;
  if (!is_new && is_quoted == entry->second.quoted && entry->second.text != value)
    log.guess(key + " occurs again in line " + std::to_string(number) +
                  " with another value, the last one is used",
              "remove the others");
  entry->second = {value, is_quoted};
  apply(header, key, value, number, log);
}

struct Counts {
  LineCount comments;
  LineCount short_rows;
  LineCount long_rows;
};

void read_row(RawProfile& raw, const Header& header, Counts& counts, std::string_view line,
              std::size_t number, const Log& log) {
  if (is_comment(line)) {
    counts.comments.add(number);
    return;
  }
  const std::string row = plain_row(line);
  const Words words = words_of(row, " ");
  if (words.count < header.columns) {
    counts.short_rows.add(number);
    return;
  }
  if (words.count > header.columns)
    counts.long_rows.add(number);
  const double x = finite_number(words.word[header.x], number, log);
  const double y = finite_number(words.word[header.y], number, log);
  add_point(raw, {x + header.offset[0], y + header.offset[1]}, number, log);
}

void report(const RawProfile& raw, const Header& header, const Counts& counts, Log& log) {
  if (counts.comments.count > 0)
    log.note(counts.comments.text("rows after the header skipped as comments"));
  if (counts.short_rows.count > 0)
    log.guess(counts.short_rows.text("rows with fewer columns than ColumnDef skipped"),
              "remove them");
  if (!header.other_columns.empty())
    log.note("columns ignored: " + header.other_columns);
  else if (counts.long_rows.count > 0)
    log.note(counts.long_rows.text("rows have more columns than X and Y, which were ignored"));
  if (header.points && *header.points != static_cast<double>(raw.points.size()))
    log.note("XYPoints in the header differs from the " + std::to_string(raw.points.size()) +
             " points found");
  if (header.offset[0] != 0.0 || header.offset[1] != 0.0)
    log.note("XOffset and YOffset added");
  if (header.grade && *header.grade != 0.0)
    log.note("Grade=" + text_of(*header.grade) +
             ": if the rail was measured with its inclination, set track.cant to 0, or a scene "
             "inclines it again");
}

} // namespace

RawProfile read_miniprof(std::string_view text, Log& log) {
  const std::size_t first = first_row(text, log);
  RawProfile raw;
  Header header;
  Counts counts;
  std::size_t last = 0;
  for (Lines lines(text, log); lines.next();) {
    const std::string_view line = lines.text();
    last = lines.number();
    if (first == 0 || lines.number() < first)
      read_header_line(header, line, lines.number(), log);
    else if (!line.empty())
      read_row(raw, header, counts, line, lines.number(), log);
  }
  if (raw.points.empty())
    log.refuse(last,
               "the file ends without a row of " + std::to_string(header.columns) + " numbers");
  report(raw, header, counts, log);
  const bool by_instrument = header.program.starts_with("MiniProf");
  raw.signs = Signs::usual;
  raw.lateral_towards_gauge = !by_instrument;
  raw.rail_height_down = by_instrument;
  raw.unit_is_stated = true;
  raw.counts_from_flange_back = true;
  if (header.tape_offset && *header.tape_offset >= ReadLimits::min_tape_offset &&
      *header.tape_offset <= ReadLimits::max_tape_offset)
    raw.tape_offset = header.tape_offset;
  return raw;
}

} // namespace wrc::reading
