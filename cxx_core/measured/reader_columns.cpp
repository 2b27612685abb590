/// Text in columns: lateral and height, one point per line, perhaps with a heading and further
/// columns.
///
/// Between numbers stand blanks, tabs, semicolons or commas; decimal commas are read where
/// something else separates the numbers. Comments begin with # ! %. A row whose lateral or height
/// is missing (an empty cell, NaN, #N/A) is a gap and no point. A heading says which columns are
/// lateral and height and in which unit. Without one they are the first two that neither count
/// the rows nor are constant. Signs are not defined; the common part of the readers settles them.
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "base/lower_case.hpp"
#include "measured/plausible_shapes.hpp"
#include "measured/reader_formats.hpp"
#include "measured/readers.hpp"
#include "profile/limits.hpp"

namespace wrc::reading {
namespace {

struct Unit {
  std::string_view name;
  double millimetres;
};

/// Names of units in headings (not a tuning constant).
constexpr std::array<Unit, 13> units{{{"mm", 1.0},
                                      {"millimetre", 1.0},
                                      {"millimeter", 1.0},
                                      {"cm", 10.0},
                                      {"m", 1000.0},
                                      {"metre", 1000.0},
                                      {"meter", 1000.0},
                                      {"in", 25.4},
                                      {"inch", 25.4},
                                      {"inche", 25.4},
                                      {"um", 0.001},
                                      {"\xC2\xB5m", 0.001},
                                      {"\xCE\xBCm", 0.001}}};

/// A unit, also in the plural.
const Unit* unit_of(std::string_view word) {
  if (word.size() > 2 && word.ends_with('s')) {
    word.remove_suffix(1);
  }
  const auto* const unit =
      std::find_if(units.begin(), units.end(), [&](const Unit& each) { return each.name == word; });
  return unit == units.end() ? nullptr : unit;
}

/// Names of columns in headings.
constexpr std::array<std::string_view, 10> column_names{
    "x", "y", "z", "s", "t", "h", "lateral", "lat", "height", "vertical"};

/// What the lines before the rows say.
struct Heading {
  std::size_t line = 0;
  std::vector<std::string> names; ///< of columns, without units
  std::vector<Unit> units;
  bool has_brackets = false; ///< about a unit

  /// It names two columns, has a unit in brackets, or nothing but units, perhaps after the word:
  /// other lines may have an "in" or an "m" in them.
  [[nodiscard]] bool is_of_columns() const {
    const auto known = std::count_if(names.begin(), names.end(), [](const std::string& name) {
      return std::find(column_names.begin(), column_names.end(), name) != column_names.end();
    });
    return known >= 2 || has_brackets ||
           (!units.empty() && (names.empty() || names.front().starts_with("unit")));
  }
};

Heading heading_of(std::string_view text, std::size_t line) {
  Heading heading;
  heading.line = line;
  const std::string clean = lower_case(text);
  const Words words = words_of(clean, " \t,;:\"'[](){}/|_=");
  const std::size_t count = std::min(words.count, Words::max_words);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view word = words.word[i];
    const Unit* const unit = unit_of(word);
    if (unit == nullptr) {
      heading.names.emplace_back(word);
    } else if (word != "in" || i + 1 == count || unit_of(words.word[i + 1]) == nullptr ||
               words.word[i + 1] == "in") { // else as in "y in mm"
      heading.units.push_back(*unit);
      heading.has_brackets =
          heading.has_brackets ||
          (word.data() != clean.data() && (word.data()[-1] == '[' || word.data()[-1] == '('));
    }
  }
  return heading;
}

/// In place of a number that is missing (a name, not a tuning constant); a word has NaN.
constexpr double missing = HUGE_VAL;

/// Rows of equally many numbers.
struct Table {
  /// Cells may be empty; then one separator stands between two of them. Otherwise any number does.
  bool has_empty_cells = false;
  std::size_t columns = 0;
  std::size_t gap = 0;         ///< first_gap of the first row
  std::vector<double> numbers; ///< row by row
  std::vector<std::size_t> lines;
  Heading heading;
  LineCount headings;
  bool only_commas = true; ///< between numbers, in all rows
  bool has_point = false;  ///< a decimal point somewhere
  std::string last_heading;
  LineCount decimal_commas;

  [[nodiscard]] std::size_t rows() const { return lines.size(); }
  [[nodiscard]] double at(std::size_t row, std::size_t column) const {
    return numbers[row * columns + column];
  }
};

bool is_empty_or_missing(std::string_view cell) {
  return cell.empty() || is_missing(cell);
}

/// Before the first row: text, or a number of points alone.
bool is_heading(std::string_view line, bool has_empty_cells) {
  const std::string row = plain_row(line, ';');
  const Words cells = cells_of(row, has_empty_cells);
  if (cells.count < 2) {
    return true;
  }
  bool has_number = false;
  for (std::size_t i = 0; i < std::min(cells.count, Words::max_words); ++i) {
    const bool is_number = number_of(cells.word[i]).has_value();
    has_number = has_number || is_number;
    if (i < 2 && !is_number && !is_empty_or_missing(cells.word[i])) {
      return true;
    }
  }
  return !has_number;
}

/// Names may be in one line and units in the next.
void take_heading(Table& table, std::string_view text, std::size_t line) {
  const Heading heading = heading_of(text, line);
  if (!heading.is_of_columns()) {
    return;
  }
  if (heading.names.empty() && table.heading.units.empty()) {
    table.heading.units = heading.units;
  } else {
    table.heading = heading;
  }
  table.heading.line = line;
}

/// Whether a separator has nothing on one of its sides.
bool has_empty_cell(std::string_view row) {
  const Words cells = cells_of(row, true);
  const auto* const end = cells.word.begin() + std::min(cells.count, Words::max_words);
  return cells.count > 1 &&
         std::any_of(cells.word.begin(), end, [](std::string_view cell) { return cell.empty(); });
}

/// Number, from 1, of the first empty cell that others follow; 0 if there is none.
std::size_t first_gap(std::string_view row) {
  const Words cells = cells_of(row, true);
  std::size_t gap = 0;
  for (std::size_t i = 0; i < std::min(cells.count, Words::max_words); ++i) {
    if (!cells.word[i].empty() && gap != 0) {
      return gap;
    }
    if (cells.word[i].empty() && gap == 0) {
      gap = i + 1;
    }
  }
  return 0;
}

double number_in(std::string_view cell, bool may_be_text, std::size_t line, const Log& log) {
  if (is_empty_or_missing(cell)) {
    return missing;
  }
  return may_be_text && !number_of(cell) ? std::nan("") : finite_number(cell, line, log);
}

/// False if its cells do not fit the rows before, but may do so as empty ones.
bool read_row(Table& table, std::string_view line, std::size_t number, const Log& log) {
  const std::string row = plain_row(line, ';');
  if (!table.has_empty_cells) {
    // Where rows have gaps in different places, words are not the same columns.
    const std::size_t gap = first_gap(row);
    if (table.columns != 0 && gap != table.gap) {
      return false;
    }
    table.gap = gap;
  }
  const Words cells = cells_of(row, table.has_empty_cells);
  if (cells.count < 2 || (table.columns != 0 && cells.count != table.columns)) {
    if (!table.has_empty_cells && has_empty_cell(row)) {
      return false;
    }
    if (cells.count < 2) {
      log.refuse(number, quoted(line) + " is one column, two are needed");
    }
    log.refuse(number, std::to_string(cells.count) + " columns, the rows before have " +
                           std::to_string(table.columns));
  }
  if (cells.count > Words::max_words) {
    log.refuse(number, std::to_string(cells.count) + " columns, at most " +
                           std::to_string(Words::max_words) + " are allowed");
  }
  if (table.rows() >= ReadLimits::max_points) {
    log.refuse(number, "more than " + std::to_string(ReadLimits::max_points) + " points");
  }
  table.columns = cells.count;
  for (std::size_t i = 0; i < cells.count; ++i) {
    table.numbers.push_back(number_in(cells.word[i], i >= 2, number, log));
  }
  table.lines.push_back(number);
  table.only_commas = table.only_commas && line.find_first_of(" \t;\"") == std::string_view::npos;
  table.has_point = table.has_point || line.find('.') != std::string_view::npos;
  if (line.find(',') != std::string_view::npos && row.find('.') != std::string::npos &&
      line.find('.') == std::string_view::npos) {
    table.decimal_commas.add(number);
  }
  return true;
}

/// A first row that gives the number of rows and columns is none.
void drop_counts(Table& table) {
  if (table.rows() < 2 || table.at(0, 0) != static_cast<double>(table.rows() - 1) ||
      table.at(0, 1) != static_cast<double>(table.columns)) {
    return;
  }
  table.headings.add(table.lines.front());
  table.lines.erase(table.lines.begin());
  table.numbers.erase(table.numbers.begin(),
                      table.numbers.begin() + static_cast<std::ptrdiff_t>(table.columns));
}

bool is_empty(const Table& table, std::size_t column) {
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (table.at(row, column) != missing) {
      return false;
    }
  }
  return true;
}

/// At the end of the rows, behind the last separator.
void drop_empty_columns(Table& table) {
  std::size_t columns = table.columns;
  while (columns > 2 && is_empty(table, columns - 1)) {
    --columns;
  }
  if (columns == table.columns) {
    return;
  }
  std::vector<double> numbers;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    for (std::size_t column = 0; column < columns; ++column) {
      numbers.push_back(table.at(row, column));
    }
  }
  table.numbers = std::move(numbers);
  table.columns = columns;
}

/// None if a row shows that cells are empty.
std::optional<Table> read_table(std::string_view text, bool has_empty_cells, Log& log) {
  Table table;
  table.has_empty_cells = has_empty_cells;
  for (Lines lines(text, log); lines.next();) {
    const std::string_view all = lines.whole();
    const std::size_t comment = comment_of(all);
    const std::string_view line = trimmed(all.substr(0, comment));
    if (table.rows() == 0 && line.empty() && comment != std::string_view::npos) {
      take_heading(table, all.substr(comment + 1), lines.number());
    }
    if (line.find_first_not_of(";,") == std::string_view::npos) {
      continue;
    }
    if (table.rows() == 0 && is_heading(line, has_empty_cells)) {
      table.last_heading = quoted(line) + " in line " + std::to_string(lines.number());
      table.headings.add(lines.number());
      take_heading(table, line, lines.number());
      continue;
    }
    if (!read_row(table, all.substr(0, comment), lines.number(), log)) {
      return std::nullopt;
    }
  }
  drop_counts(table);
  drop_empty_columns(table);
  return table;
}

Table read_table(std::string_view text, Log& log) {
  std::optional<Table> table = read_table(text, false, log);
  if (!table) {
    table = read_table(text, true, log);
  }
  return std::move(*table);
}

/// Whether rows are numbered: 0, 1, 2 or 10, 20, 30.
bool counts_rows(const Table& table, std::size_t column) {
  const double first = table.at(0, column);
  const double step = table.at(1, column) - first;
  if (std::trunc(step) != step || step < 1.0 || (first != 0.0 && first != 1.0 && first != step)) {
    return false;
  }
  for (std::size_t row = 2; row < table.rows(); ++row) {
    if (table.at(row, column) - table.at(row - 1, column) != step) {
      return false;
    }
  }
  return true;
}

/// Greatest less least number of a column; missing ones do not count.
double extent_of_column(const Table& table, std::size_t column) {
  double least = HUGE_VAL;
  double greatest = -HUGE_VAL;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (const double number = table.at(row, column); number != missing) {
      least = std::min(least, number);
      greatest = std::max(greatest, number);
    }
  }
  return greatest - least;
}

/// Whether the first column counts the rows, and is no lateral in whole mm beside one that has not
/// the width of a profile in any unit.
bool is_count(const Table& table, const std::vector<std::size_t>& left) {
  const double other = extent_of_column(table, left[1]);
  return counts_rows(table, left[0]) &&
         (!plausible::width.holds(extent_of_column(table, left[0])) ||
          plausible::width.holds(other) || plausible::width.holds(10.0 * other) ||
          plausible::width.holds(25.4 * other) || plausible::width.holds(1000.0 * other));
}

/// Missing numbers do not count.
bool is_constant(const Table& table, std::size_t column) {
  std::optional<double> constant;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const double number = table.at(row, column);
    if (number == missing) {
      continue;
    }
    if (constant && number != *constant) {
      return false;
    }
    constant = number;
  }
  return true;
}

using Pair = std::array<std::size_t, 2>;

/// Columns of lateral and height by their names.
std::optional<Pair> named_columns(const Table& table) {
  const std::vector<std::string>& names = table.heading.names;
  if (names.size() != table.columns) {
    return std::nullopt;
  }
  const auto place_of = [&names](std::initializer_list<std::string_view> wanted) {
    const auto found = std::find_if(names.begin(), names.end(), [&](const std::string& name) {
      return std::find(wanted.begin(), wanted.end(), name) != wanted.end();
    });
    return found == names.end() ? std::optional<std::size_t>()
                                : std::optional(static_cast<std::size_t>(found - names.begin()));
  };
  const std::optional<std::size_t> x = place_of({"x"});
  const std::optional<std::size_t> y = place_of({"y"});
  const std::optional<std::size_t> z = place_of({"z", "height", "h", "vertical", "vert"});
  std::optional<std::size_t> lateral = place_of({"lateral", "lat", "s", "t"});
  std::optional<std::size_t> height = z;
  if (!lateral && z && y) {
    if (x && !is_constant(table, *x)) { // along the track, or across?
      return std::nullopt;
    }
    lateral = y;
  } else if (!lateral) {
    lateral = x;
    height = y ? y : z;
  } else if (!height) {
    height = y;
  }
  return lateral && height ? std::optional(Pair{*lateral, *height}) : std::nullopt;
}

/// What is left of the columns without constant ones and the numbers of the rows.
Pair unnamed_columns(const Table& table, Log& log) {
  std::vector<std::size_t> left(table.columns);
  std::iota(left.begin(), left.end(), 0U);
  const auto ignore = [&](std::size_t place, const std::string& why) {
    log.guess("column " + std::to_string(left[place] + 1) + " ignored, since it " + why,
              "remove it, or name the columns");
    left.erase(left.begin() + static_cast<std::ptrdiff_t>(place));
  };
  for (std::size_t place = 0; place < left.size() && left.size() > 2;) {
    if (is_constant(table, left[place])) {
      ignore(place, "is constant");
    } else {
      ++place;
    }
  }
  if (left.size() > 2 && table.rows() > 1 && is_count(table, left)) {
    ignore(0, "counts the rows");
  }
  if (left.size() > 2) {
    std::string numbers;
    for (std::size_t i = 2; i < left.size(); ++i) {
      numbers += (i > 2 ? ", " : "") + std::to_string(left[i] + 1);
    }
    log.guess("columns " + numbers + " ignored", "remove them, or name the columns in a heading");
  }
  return {left[0], left[1]};
}

/// Which columns are lateral and height.
Pair columns_of(const Table& table, RawProfile& raw, Log& log) {
  if (const std::optional<Pair> named = named_columns(table)) {
    raw.columns_are_named = true;
    log.note("columns by the heading in line " + std::to_string(table.heading.line) +
             ": lateral is column " + std::to_string((*named)[0] + 1) + ", height column " +
             std::to_string((*named)[1] + 1));
    return *named;
  }
  return unnamed_columns(table, log);
}

void settle_unit(RawProfile& raw, const Table& table, Log& log) {
  const std::vector<Unit>& stated = table.heading.units;
  if (stated.empty()) {
    return;
  }
  for (const Unit& unit : stated) {
    if (unit.millimetres != stated.front().millimetres) {
      log.refuse(table.heading.line, "two units, " + std::string(stated.front().name) + " and " +
                                         std::string(unit.name) + "; one is allowed");
    }
  }
  raw.unit_is_stated = true;
  const double scale = stated.front().millimetres;
  if (scale == 1.0) {
    return;
  }
  scale_points(raw, scale, scale);
  log.note("multiplied by " + text_of(scale) + " to mm, from " + printable(stated.front().name) +
           " in line " + std::to_string(table.heading.line));
}

} // namespace

RawProfile read_columns(std::string_view text, Log& log) {
  const Table table = read_table(text, log);
  RawProfile raw;
  if (table.rows() == 0) {
    log.refuse("no row of two numbers" +
               (table.last_heading.empty() ? "" : "; the last line is " + table.last_heading));
  }
  if (table.columns > 2 && table.only_commas && !table.has_point) {
    log.refuse(table.lines.front(),
               "commas between the numbers and perhaps in them; separate the numbers by "
               "semicolons, or write decimal points");
  }
  const Pair columns = columns_of(table, raw, log);
  LineCount gaps;
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const Position point{table.at(row, columns[0]), table.at(row, columns[1])};
    if (std::isnan(point[0]) || std::isnan(point[1])) {
      log.refuse(table.lines[row], "no number in column " + std::to_string(columns[0] + 1) +
                                       " or " + std::to_string(columns[1] + 1));
    }
    if (point[0] == missing || point[1] == missing) {
      gaps.add(table.lines[row]);
    } else {
      add_point(raw, point, table.lines[row], log);
    }
  }
  if (table.headings.count > 0) {
    log.note(table.headings.text("lines before the first number skipped as headings"));
  }
  if (table.decimal_commas.count > 0) {
    log.note(table.decimal_commas.text("rows with decimal commas"));
  }
  note_gaps(gaps, log);
  settle_unit(raw, table, log);
  return raw;
}

} // namespace wrc::reading
