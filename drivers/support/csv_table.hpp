/// Tables that the drivers write as CSV, and read again: a line of names, then rows.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace driver {

/// A text in quotes.
std::string csv_quoted(const std::string& text);
/// The same, but without quotes where none are needed.
std::string csv_entry(const std::string& text);

class CsvTable {
public:
  /// Throws Failure if the file cannot be read, or has a row of another length than its first line.
  explicit CsvTable(const std::filesystem::path& path);

  [[nodiscard]] std::size_t row_count() const { return rows_.size(); }
  /// A column as texts, or as numbers (NaN for empty ones). Throws Failure for an unknown name.
  [[nodiscard]] std::vector<std::string> texts(const std::string& name) const;
  [[nodiscard]] std::vector<double> numbers(const std::string& name) const;
  /// The rows in which a column has this text.
  [[nodiscard]] CsvTable where(const std::string& name, const std::string& text) const;
  /// A number of the row in which another column has a number. Throws Failure if there is none.
  [[nodiscard]] double at(const std::string& x, double value, const std::string& name) const;

private:
  [[nodiscard]] std::size_t column(const std::string& name) const;

  std::string path_;
  std::vector<std::string> names_;
  std::vector<std::vector<std::string>> rows_;
};

} // namespace driver
