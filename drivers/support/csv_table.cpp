#include "support/csv_table.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <fstream>
#include <limits>
#include <string_view>

#include "support/scene.hpp"

namespace driver {
namespace {

/// What a spreadsheet takes for the beginning of a formula (OWASP, CSV injection), and our mark.
constexpr std::string_view begins_formula = "=+-@\t\r\n'";
constexpr char is_text = '\'';

bool is_number(const std::string& text) {
  double number = 0.0;
  const char* end = text.data() + text.size();
  const auto parsed = std::from_chars(text.data(), end, number);
  return parsed.ec == std::errc() && parsed.ptr == end && !std::isnan(number);
}

/// Entries of a line; quotes around those with commas, and doubled within.
std::vector<std::string> entries_of(const std::string& line) {
  std::vector<std::string> entries(1);
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char letter = line[i];
    if (quoted && letter == '"' && i + 1 < line.size() && line[i + 1] == '"') {
      entries.back() += '"';
      ++i;
    } else if (letter == '"') {
      quoted = !quoted;
    } else if (letter == ',' && !quoted) {
      entries.emplace_back();
    } else {
      entries.back() += letter;
    }
  }
  for (std::string& entry : entries) {
    if (entry.size() > 1 && entry[0] == is_text &&
        begins_formula.find(entry[1]) != std::string_view::npos) {
      entry.erase(0, 1);
    }
  }
  return entries;
}

double number_of(const std::string& text) {
  double number = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

} // namespace

std::string csv_entry(const std::string& text) {
  const bool formula =
      !text.empty() && begins_formula.find(text[0]) != std::string_view::npos && !is_number(text);
  const std::string shown = formula ? is_text + text : text;
  if (shown.find_first_of(",\"\n\r\t;") == std::string::npos) {
    return shown;
  }
  std::string out = "\"";
  for (const char letter : shown) {
    out += letter == '"' ? "\"\"" : std::string(1, letter);
  }
  return out + '"';
}

CsvTable::CsvTable(const std::filesystem::path& path) : path_(path.string()) {
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line)) {
    throw Failure("cannot read " + path_ + ": is it there?");
  }
  const auto entries = [&line] { // lines of Excel end in \r\n
    return entries_of(line.ends_with('\r') ? line.substr(0, line.size() - 1) : line);
  };
  if (line.starts_with("\xEF\xBB\xBF")) { // and its files begin so
    line.erase(0, 3);
  }
  names_ = entries();
  while (std::getline(in, line)) {
    rows_.push_back(entries());
    if (rows_.back().size() != names_.size()) {
      throw Failure(path_ + ", line " + std::to_string(rows_.size() + 1) +
                    ": the number of entries must be that of the names in the first line");
    }
  }
}

std::size_t CsvTable::column(const std::string& name) const {
  const auto found = std::find(names_.begin(), names_.end(), name);
  if (found == names_.end()) {
    throw Failure(path_ + " has no column " + name);
  }
  if (std::find(found + 1, names_.end(), name) != names_.end()) {
    throw Failure(path_ + " has the column " + name + " twice");
  }
  return static_cast<std::size_t>(found - names_.begin());
}

std::vector<std::string> CsvTable::texts(const std::string& name) const {
  const std::size_t at = column(name);
  std::vector<std::string> texts;
  for (const auto& row : rows_) {
    texts.push_back(row[at]);
  }
  return texts;
}

std::vector<double> CsvTable::numbers(const std::string& name) const {
  std::vector<double> numbers;
  for (const std::string& text : texts(name)) {
    numbers.push_back(number_of(text));
  }
  return numbers;
}

CsvTable CsvTable::where(const std::string& name, const std::string& text) const {
  const std::size_t at = column(name);
  CsvTable part = *this;
  std::erase_if(part.rows_, [&](const auto& row) { return row[at] != text; });
  return part;
}

double CsvTable::at(const std::string& x, double value, const std::string& name) const {
  const std::vector<double> places = numbers(x);
  constexpr double rounding = 1e-9;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (std::abs(places[i] - value) <= rounding) {
      return numbers(name)[i];
    }
  }
  throw Failure(path_ + " has no row with " + x + " = " + std::to_string(value));
}

} // namespace driver
