/// Tables for people: columns as wide as they need, two blanks apart.
#pragma once

#include <ostream>
#include <string>
#include <vector>

namespace driver {

class TextTable {
public:
  /// A letter for each column, "l" or "r" for the side its cells stand on; the last one is that of
  /// all further columns. Columns are at least as wide as given, with the blanks before them.
  explicit TextTable(std::string sides, std::vector<std::size_t> widths = {})
      : sides_(std::move(sides)), widths_(std::move(widths)) {}

  /// Titles are rows as others.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }
  /// No line ends with blanks.
  void print(std::ostream& out) const;

private:
  std::string sides_;
  std::vector<std::size_t> widths_;
  std::vector<std::vector<std::string>> rows_;
};

} // namespace driver
