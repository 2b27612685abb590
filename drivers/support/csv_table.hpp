/// Tables in CSV: written line by line, and read again with the names of their first line.
#pragma once

#include <filesystem>
#include <optional>
#include <ostream>
#include <string>
#include <type_traits>
#include <vector>

namespace driver {

/// A text, in quotes where it needs some. A text that a spreadsheet would run as a formula gets an
/// apostrophe in front: one that begins with = + - @, a tab or a line break and is not a number. So
/// does a text that begins with an apostrophe, which is why CsvTable reads every text as it was.
std::string csv_entry(const std::string& text);

/// One line: CsvLine(out) << "left" << 3.5 << std::nullopt; with numbers as the stream writes them.
class CsvLine {
public:
  explicit CsvLine(std::ostream& out) : out_(out) {}
  CsvLine(const CsvLine&) = delete;
  CsvLine& operator=(const CsvLine&) = delete;
  ~CsvLine() { out_ << '\n'; }

  template <class Entry> CsvLine& operator<<(const Entry& entry) {
    out_ << separator_;
    separator_ = ",";
    if constexpr (std::is_same_v<Entry, std::optional<double>>) {
      if (entry) {
        out_ << *entry;
      }
    } else if constexpr (std::is_arithmetic_v<Entry>) {
      out_ << entry;
    } else {
      out_ << csv_entry(entry);
    }
    return *this;
  }
  /// All entries of a list.
  template <class List> CsvLine& add(const List& list) {
    for (const auto& entry : list) {
      *this << entry;
    }
    return *this;
  }

private:
  std::ostream& out_;
  const char* separator_ = "";
};

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
