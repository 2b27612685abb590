/// MiniProf .ban/.whl: header lines Key=Value, a blank line, rows of columns as ColumnDef says.
///
/// Old files have a header of free text and two or three columns; MiniProf 2.43 leaves no blank
/// line. A key in quotes counts only where it does not stand without them. Rows that start with a
/// quote or another comment sign are comments, as in CONTACT's reader. Units mm.
///
/// Project files have sections, [Profile1Points] and the like, whose rows may have keys of their
/// own (XYPoint1=x,y). Keys of [Profile1] are those of its points, keys of sections without a
/// number and before the first section those of all.
///
/// Signs, by measured files: a wheel's X counts from the flange back to the field side, Y towards
/// larger radius. A rail's X counts towards the gauge side, Y upwards; the instrument's own program
/// writes rails half turned (X to the field side, Y downwards).
#include <algorithm>
#include <array>
#include <map>
#include <optional>

#include "base/error.hpp"
#include "base/lower_case.hpp"
#include "measured/reader_formats.hpp"
#include "measured/readers.hpp"
#include "profile/limits.hpp"

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
  if (text.starts_with('"')) {
    text.remove_prefix(1);
  }
  if (text.ends_with('"')) {
    text.remove_suffix(1);
  }
  return trimmed(text);
}

/// Two or more numbers and nothing else.
bool is_row(std::string_view line) {
  if (is_comment(line)) {
    return false;
  }
  const std::string row = plain_row(line);
  const Words words = words_of(row, " ");
  for (std::size_t i = 0; i < std::min(words.count, Words::max_words); ++i) {
    if (!number_of(words.word[i]) && !is_missing(words.word[i])) {
      return false;
    }
  }
  return words.count >= 2;
}

constexpr std::size_t most_sections = 10000; // bound of input, not a tuning constant
constexpr std::size_t most_listed = 20;      // in a message; not a tuning constant

/// The name of the section that a line begins.
std::optional<std::string_view> section_in(std::string_view line) {
  if (!line.starts_with('[') || !line.ends_with(']') || line.size() < 3) {
    return std::nullopt;
  }
  return trimmed(line.substr(1, line.size() - 2));
}

/// What a line of a section says of a point: behind its key, if that has a number of its own.
std::string_view row_in(std::string_view line) {
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos || is_comment(line)) {
    return line;
  }
  const std::string_view key = trimmed(line.substr(0, equals));
  return !key.empty() && key.back() >= '0' && key.back() <= '9' ? trimmed(line.substr(equals + 1))
                                                                : line;
}

struct Section {
  std::string name;
  std::string owner; ///< the name up to its number, in small letters; empty: of all profiles
  std::size_t line = 0;
  std::size_t rows = 0; ///< that may be points
};

std::string owner_of(std::string_view name) {
  const std::size_t digit = name.find_first_of("0123456789");
  return digit == std::string_view::npos
             ? std::string()
             : lower_case(name.substr(0, name.find_first_not_of("0123456789", digit)));
}

/// Those of a project file, the first one before any name; none of other files.
std::vector<Section> sections_of(std::string_view text, const Log& log) {
  std::vector<Section> sections(1);
  for (Lines lines(text, log); lines.next();) {
    if (const std::optional<std::string_view> name = section_in(lines.text())) {
      if (sections.size() >= most_sections) {
        log.refuse(lines.number(), "more than " + std::to_string(most_sections) + " sections");
      }
      sections.push_back({printable(*name), owner_of(*name), lines.number()});
    } else if (sections.size() > 1 && is_row(row_in(lines.text()))) {
      ++sections.back().rows;
    }
  }
  std::size_t with_points = 0;
  for (const Section& section : sections) {
    with_points += section.rows >= rows_of_points ? 1U : 0U;
  }
  if (with_points == 0) {
    sections.clear();
  }
  return sections;
}

/// The section whose points are read, by the number of a profile or as the only one.
const Section& chosen_section(const std::vector<Section>& sections, int choice, const Log& log) {
  std::vector<const Section*> profiles;
  for (const Section& section : sections) {
    if (section.rows >= rows_of_points) {
      profiles.push_back(&section);
    }
  }
  const auto count = static_cast<int>(profiles.size());
  if (choice == 0 && count == 1) {
    return *profiles.front();
  }
  if (choice >= 1 && choice <= count) {
    return *profiles[static_cast<std::size_t>(choice - 1)];
  }
  std::string text;
  for (std::size_t i = 0; i < profiles.size(); ++i) {
    if (i >= most_listed && i + 1 < profiles.size()) {
      continue;
    }
    text += (i == 0             ? " "
             : i == most_listed ? " ..., "
                                : ", ") +
            std::to_string(i + 1) + " [" + profiles[i]->name + "] of " +
            std::to_string(profiles[i]->rows) + " points";
  }
  log.refuse("slice = " + std::to_string(choice) + ", must be between 1 and " +
             std::to_string(count) + " of its " + std::to_string(count) + " profiles:" + text);
}

/// Number of the line with which the points begin: the first row or comment after the blank line
/// that ends the header; without such a line, or if points stand before it, the first row.
std::size_t first_row(std::string_view text, const Log& log) {
  std::size_t first = 0;
  std::size_t in_header = 0;
  bool blank = false;
  for (Lines lines(text, log); lines.next();) {
    blank = blank || lines.text().empty();
    if (!is_row(lines.text()) && !(blank && is_comment(lines.text()))) {
      continue;
    }
    if (blank && in_header < rows_of_points) {
      return lines.number();
    }
    if (first == 0) {
      first = lines.number();
    }
    if (blank || ++in_header >= rows_of_points) {
      return first;
    }
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
    if (words.word[i] == "X") {
      x = i;
    } else if (words.word[i] == "Y") {
      y = i;
    } else if (words.word[i] != "*") {
      others += (others.empty() ? "" : ", ") + printable(words.word[i]);
    }
  }
  if (!x || !y || words.count > Words::max_words) {
    log.refuse(line, "ColumnDef=" + printable(value) + ", it must name X and Y among at most " +
                         std::to_string(Words::max_words) + " columns");
  }
  header.columns = std::max(*x, *y) + 1;
  header.x = *x;
  header.y = *y;
  header.other_columns = others;
}

/// The keys that change the points, or say what they are; the others do not.
void apply(Header& header, std::string_view key, std::string_view value, std::size_t line,
           const Log& log) {
  if (key == "ColumnDef") {
    read_columns_of(header, value, line, log);
  } else if (key == "XOffset") {
    header.offset[0] = finite_number(value, line, log);
  } else if (key == "YOffset") {
    header.offset[1] = finite_number(value, line, log);
  } else if (key == "XYPoints") {
    header.points = finite_number(value, line, log);
  } else if (key == "Grade") {
    header.grade = number_of(value);
  } else if (key == "WheelDiameterTaperline") {
    header.tape_offset = number_of(value);
  } else if (key == "ProgramName") {
    header.program = value;
  }
}

void read_header_line(Header& header, std::string_view line, std::size_t number, Log& log) {
  const bool is_quoted = line.starts_with('"');
  line = unquoted(line);
  const std::size_t equals = line.find('=');
  if (equals == std::string_view::npos) {
    return; // old files: free text
  }
  std::string key(unquoted(line.substr(0, equals)));
  const std::string value(unquoted(line.substr(equals + 1)));
  if (key == "Xoffset" || key == "Yoffset") { // as MiniProf's own program writes them
    key[1] = 'O';
  }
  constexpr std::array known{"ColumnDef",  "XOffset", "YOffset",
                             "XYPoints",   "Grade",   "WheelDiameterTaperline",
                             "ProgramName"};
  if (value.empty() || std::find(known.begin(), known.end(), key) == known.end()) {
    return;
  }
  const auto [entry, is_new] = header.values.try_emplace(key, Header::Value{value, is_quoted});
  if (!is_new && is_quoted && !entry->second.quoted) {
    return;
  }
  if (!is_new && is_quoted == entry->second.quoted && entry->second.text != value) {
    log.guess(key + " occurs again in line " + std::to_string(number) +
                  " with another value, the last one is used",
              "remove the others");
  }
  entry->second = {value, is_quoted};
  apply(header, key, value, number, log);
}

struct Counts {
  LineCount gaps;
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
  if (words.count > header.columns) {
    counts.long_rows.add(number);
  }
  if (is_missing(words.word[header.x]) || is_missing(words.word[header.y])) {
    counts.gaps.add(number);
    return;
  }
  const double x = finite_number(words.word[header.x], number, log);
  const double y = finite_number(words.word[header.y], number, log);
  add_point(raw, {x + header.offset[0], y + header.offset[1]}, number, log);
}

void report(const RawProfile& raw, const Header& header, const Counts& counts, Log& log) {
  note_gaps(counts.gaps, log);
  if (counts.comments.count > 0) {
    log.note(counts.comments.text("rows after the header skipped as comments"));
  }
  if (counts.short_rows.count > 0) {
    log.guess(counts.short_rows.text("rows with fewer columns than ColumnDef skipped"),
              "remove them");
  }
  if (!header.other_columns.empty()) {
    log.note("columns ignored: " + header.other_columns);
  } else if (counts.long_rows.count > 0) {
    log.note(counts.long_rows.text("rows have more columns than X and Y, which were ignored"));
  }
  if (header.points && *header.points != static_cast<double>(raw.points.size())) {
    log.note("XYPoints in the header differs from the " + std::to_string(raw.points.size()) +
             " points found");
  }
  if (header.offset[0] != 0.0 || header.offset[1] != 0.0) {
    log.note("XOffset and YOffset added");
  }
  if (header.grade && *header.grade != 0.0) {
    log.note(
        "Grade=" + text_of(*header.grade) +
        ": if the rail was measured with its inclination, set track.inclination to 0, or a scene "
        "inclines it again");
  }
}

/// A header and rows after it.
void read_plain(RawProfile& raw, Header& header, Counts& counts, std::string_view text, Log& log) {
  const std::size_t first = first_row(text, log);
  for (Lines lines(text, log); lines.next();) {
    const std::string_view line = lines.text();
    if (first == 0 || lines.number() < first) {
      read_header_line(header, line, lines.number(), log);
    } else if (!line.empty()) {
      read_row(raw, header, counts, line, lines.number(), log);
    }
  }
}

/// Keys of a project file that belong to one profile, or to all if `owner` is empty.
void read_keys_of(Header& header, std::string_view text, const std::vector<Section>& sections,
                  std::string_view owner, Log& log) {
  header.values.clear(); // those of the profile win over those of all
  auto section = sections.begin();
  for (Lines lines(text, log); lines.next();) {
    if (section + 1 != sections.end() && (section + 1)->line == lines.number()) {
      ++section;
    } else if (section->owner == owner && row_in(lines.text()) == lines.text()) {
      read_header_line(header, lines.text(), lines.number(), log);
    }
  }
}

void read_section(RawProfile& raw, Header& header, Counts& counts, std::string_view text,
                  const std::vector<Section>& sections, const Section& chosen, Log& log) {
  read_keys_of(header, text, sections, "", log);
  if (!chosen.owner.empty()) {
    read_keys_of(header, text, sections, chosen.owner, log);
  }
  bool is_inside = false;
  for (Lines lines(text, log); lines.next();) {
    const std::string_view line = lines.text();
    if (section_in(line)) {
      is_inside = lines.number() == chosen.line;
    } else if (is_inside && !line.empty() &&
               (row_in(line) != line || is_comment(line) ||
                line.find('=') == std::string_view::npos)) {
      read_row(raw, header, counts, row_in(line), lines.number(), log);
    }
  }
  const std::string name = lower_case(chosen.name);
  if (name.find("wheel") != std::string::npos) {
    raw.kind = ProfileKind::wheel;
  } else if (name.find("rail") != std::string::npos) {
    raw.kind = ProfileKind::rail;
  }
  log.note("points of the section [" + chosen.name + "] in line " + std::to_string(chosen.line));
}

std::size_t line_count(std::string_view text, const Log& log) {
  std::size_t last = 0;
  for (Lines lines(text, log); lines.next();) {
    last = lines.number();
  }
  return last;
}

} // namespace

RawProfile read_miniprof(std::string_view text, int choice, Log& log) {
  RawProfile raw;
  Header header;
  Counts counts;
  const std::vector<Section> sections = sections_of(text, log);
  if (sections.empty()) {
    log.refuse_slice(choice);
    read_plain(raw, header, counts, text, log);
  } else {
    read_section(raw, header, counts, text, sections, chosen_section(sections, choice, log), log);
  }
  if (raw.points.empty()) {
    log.refuse(line_count(text, log),
               "the file ends without a row of " + std::to_string(header.columns) + " numbers");
  }
  report(raw, header, counts, log);
  const bool by_instrument = header.program.starts_with("MiniProf");
  raw.signs = Signs::usual;
  raw.lateral_towards_gauge = !by_instrument;
  raw.rail_height_down = by_instrument;
  raw.unit_is_stated = true;
  raw.counts_from_flange_back = true;
  if (header.tape_offset && *header.tape_offset >= ReadLimits::min_tape_offset &&
      *header.tape_offset <= ReadLimits::max_tape_offset) {
    raw.tape_offset = header.tape_offset;
  }
  return raw;
}

} // namespace wrc::reading
