/// Lines, words and numbers of untrusted text, and the log of changes.
///
/// Numbers are parsed independently of the locale. Internal to the readers. Thread rule: an object
/// belongs to one thread.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/warning.hpp"

namespace wrc::reading {

/// Messages about one file: errors with its name, and corrections.
class Log {
public:
  Log(std::string_view name, bool strict) : name_(name), strict_(strict) {}

  /// Throws Error(file_malformed): "<file>: <text>" or "<file>:<line>: <text>".
  [[noreturn]] void refuse(const std::string& text) const;
  [[noreturn]] void refuse(std::size_t line, const std::string& text) const;
  /// A number of a slice for a file of one profile.
  void refuse_slice(int slice) const;
  /// A change that the file or the options ask for.
  void note(const std::string& text) { corrections_.push_back(text); }
  /// A change that rests on a guess; an error in strict mode. `remedy` says how to avoid it.
  void guess(const std::string& text, const std::string& remedy);
  /// Something that no wheel or rail has; an error in strict mode.
  void warn(WarningClass kind, const std::string& text);
  /// Something that measurements have, which takes no guess: no error in strict mode.
  void advise(WarningClass kind, const std::string& text) { warnings_.push_back({kind, text}); }

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::vector<std::string>& corrections() { return corrections_; }
  [[nodiscard]] Warnings& warnings() { return warnings_; }
  /// How many corrections rest on a guess.
  [[nodiscard]] std::size_t guesses() const { return guesses_; }

private:
  std::string name_;
  bool strict_;
  std::vector<std::string> corrections_;
  Warnings warnings_;
  std::size_t guesses_ = 0;
};

/// Hands out the lines of a text (ends: LF, CR LF or CR), without their ends and outer blanks.
class Lines {
public:
  Lines(std::string_view text, const Log& log);
  /// False at the end. Refuses lines that are too long or hold control characters.
  bool next();
  [[nodiscard]] std::string_view text() const { return line_; }
  /// With its outer blanks, of which tabs separate cells.
  [[nodiscard]] std::string_view whole() const { return whole_; }
  [[nodiscard]] std::size_t number() const { return number_; }

private:
  std::string_view rest_;
  std::string_view line_;
  std::string_view whole_;
  std::size_t number_ = 0;
  const Log& log_;
};

/// Counts lines of one sort, so that many of them make one correction.
struct LineCount {
  std::size_t count = 0;
  std::size_t first = 0;

  void add(std::size_t line) {
    if (count++ == 0) {
      first = line;
    }
  }
  /// "<count> <what>, first in line <first>".
  [[nodiscard]] std::string text(const std::string& what) const;
};

std::string_view trimmed(std::string_view text);

/// The words of a line, at most `max_words`; `count` goes on beyond.
struct Words {
  /// Bounds of input (not a tuning constant).
  static constexpr std::size_t max_words = 16;
  std::array<std::string_view, max_words> word;
  std::size_t count = 0;
};
Words words_of(std::string_view line, std::string_view separators);
/// The cells of a row: words, of which 2*0.0 is two, or if cells may be empty, what stands between
/// semicolons.
Words cells_of(std::string_view row, bool may_be_empty);

/// A row of numbers with points and blanks: quotes go, separators ; , and tab become `separator`,
/// and a comma between digits becomes a decimal point where something else separates the numbers.
std::string plain_row(std::string_view line, char separator = ' ');

/// Whether a word says that a number is missing: NaN, NA, N/A, null, or an error of a
/// spreadsheet such as #N/A, in capital or small letters.
bool is_missing(std::string_view word);
/// Where a comment that begins with # ! or % starts, which errors of spreadsheets do not; npos if
/// there is none.
std::size_t comment_of(std::string_view line);

/// The number a word stands for, also with Fortran's exponents D+01 and -101; none if it is not
/// one. May be infinite or not a number.
std::optional<double> number_of(std::string_view word);
/// The finite number a word stands for; refuses anything else.
double finite_number(std::string_view word, std::size_t line, const Log& log);

/// A word in the form used in messages: shortened, only printable characters.
std::string printable(std::string_view word);
/// The same between quotes.
std::string quoted(std::string_view word);

} // namespace wrc::reading
