#include "measured/reader_lines.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "base/lower_case.hpp"
#include "measured/read_options.hpp"
#include "profile/limits.hpp"

namespace wrc::reading {
namespace {

/// Words in place of a number, in small letters; those with # are errors of spreadsheets.
constexpr std::array<std::string_view, 20> missing_words{
    "nan",     "-nan",    "+nan",  "nan(ind)", "-nan(ind)", "1.#qnan", "na",
    "n/a",     "null",    "none",  "#n/a",     "#na",       "#nv",     "#num!",
    "#value!", "#div/0!", "#ref!", "#null!",   "#zahl!",    "#wert!"};

/// Fortran writes equal numbers once, as 2*0.0.
Words repeated(const Words& words) {
  Words all;
  for (std::size_t i = 0; i < std::min(words.count, Words::max_words); ++i) {
    std::string_view word = words.word[i];
    std::size_t count = 1;
    const std::size_t star = word.find('*');
    if (star == 1 && word[0] >= '1' && word[0] <= '9' && number_of(word.substr(2))) {
      count = static_cast<std::size_t>(word[0] - '0');
      word.remove_prefix(2);
    }
    for (; count > 0; --count, ++all.count) {
      if (all.count < Words::max_words) {
        all.word[all.count] = word;
      }
    }
  }
  all.count += words.count - std::min(words.count, Words::max_words);
  return all;
}

} // namespace

void Log::refuse(const std::string& text) const {
  throw Error(ErrorCode::file_malformed, name_ + ": " + text);
}

void Log::refuse(std::size_t line, const std::string& text) const {
  throw Error(ErrorCode::file_malformed, name_ + ":" + std::to_string(line) + ": " + text);
}

void Log::refuse_slice(int slice) const {
  if (slice != 0) {
    refuse("slice = " + std::to_string(slice) +
           ", allowed with a slices file (.slcs, .slcw) or a project file of MiniProf; this file "
           "has one profile");
  }
}

void Log::guess(const std::string& text, const std::string& remedy) {
  if (strict_) {
    refuse("strict reading refuses guesses: " + text + "; " + remedy);
  }
  corrections_.push_back(text);
  ++guesses_;
}

void Log::warn(WarningClass kind, const std::string& text) {
  if (strict_) {
    refuse("strict reading refuses warnings: " + text);
  }
  warnings_.push_back({kind, text});
}

Lines::Lines(std::string_view text, const Log& log) : rest_(text), log_(log) {}

bool Lines::next() {
  if (rest_.empty()) {
    return false;
  }
  ++number_;
  const std::size_t end = std::min(rest_.find_first_of("\r\n"), rest_.size());
  if (end > ReadLimits::line_bytes) {
    log_.refuse(number_, "line of " + std::to_string(end) + " bytes, at most " +
                             std::to_string(ReadLimits::line_bytes) + " are allowed");
  }
  line_ = rest_.substr(0, end);
  rest_.remove_prefix(end);
  if (rest_.starts_with("\r\n")) {
    rest_.remove_prefix(2);
  } else if (!rest_.empty()) {
    rest_.remove_prefix(1);
  }
  for (const char c : line_) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte < 0x20 && c != '\t') || byte == 0x7F) {
      log_.refuse(number_, "byte " + std::to_string(byte) + ", only text is allowed");
    }
  }
  whole_ = line_;
  line_ = trimmed(line_);
  return true;
}

std::string LineCount::text(const std::string& what) const {
  return std::to_string(count) + " " + what + ", first in line " + std::to_string(first);
}

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

Words words_of(std::string_view line, std::string_view separators) {
  Words words;
  std::size_t begin = line.find_first_not_of(separators);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(separators, begin), line.size());
    if (words.count < Words::max_words) {
      words.word[words.count] = line.substr(begin, end - begin);
    }
    ++words.count;
    begin = line.find_first_not_of(separators, end);
  }
  return words;
}

Words cells_of(std::string_view row, bool may_be_empty) {
  if (!may_be_empty) {
    return repeated(words_of(row, " ;"));
  }
  Words cells;
  for (std::size_t begin = 0; begin <= row.size();) {
    const std::size_t end = std::min(row.find(';', begin), row.size());
    if (cells.count < Words::max_words) {
      cells.word[cells.count] = trimmed(row.substr(begin, end - begin));
    }
    ++cells.count;
    begin = end + 1;
  }
  return cells;
}

std::string plain_row(std::string_view line, char separator) {
  const bool decimal_commas = line.find_first_of(" \t;") != std::string_view::npos;
  const auto is_digit = [line](std::size_t i) {
    return i < line.size() && line[i] >= '0' && line[i] <= '9';
  };
  std::string row;
  bool in_quotes = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    const bool between_digits = i > 0 && is_digit(i - 1) && is_digit(i + 1);
    if (c == '"') {
      in_quotes = !in_quotes;
    } else if (c == ',' && between_digits && (decimal_commas || in_quotes)) {
      row += '.';
    } else {
      row += c == ',' || c == ';' || c == '\t' ? separator : c;
    }
  }
  return row;
}

bool is_missing(std::string_view word) {
  return word.size() <= 9 && std::find(missing_words.begin(), missing_words.end(),
                                       lower_case(word)) != missing_words.end();
}

std::size_t comment_of(std::string_view line) {
  constexpr std::string_view separators = " \t,;\"";
  std::size_t begin = 0; // of the word that holds the sign
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (separators.find(line[i]) != std::string_view::npos) {
      begin = i + 1;
      continue;
    }
    if (line[i] != '#' && line[i] != '!' && line[i] != '%') {
      continue;
    }
    const std::size_t end = std::min(line.find_first_of(separators, i), line.size());
    if (!is_missing(line.substr(begin, end - begin))) {
      return i;
    }
    i = end - 1;
  }
  return std::string_view::npos;
}

std::optional<double> number_of(std::string_view word) {
  if (word.starts_with('+') && !word.starts_with("+-")) {
    word.remove_prefix(1);
  }
  std::string with_e; // of 1.5D+01, and of 0.15-101, for which Fortran has no room for the letter
  if (const std::size_t d = word.find_first_of("dD");
      d != std::string_view::npos && d > 0 && word.size() <= 40) {
    with_e = word;
    with_e[d] = 'e';
    word = with_e;
  } else if (const std::size_t sign = word.size() - std::min<std::size_t>(word.size(), 4);
             sign > 0 && (word[sign] == '-' || word[sign] == '+') && word.size() <= 40 &&
             word.find_first_not_of("0123456789.", 1) == sign && word.find('.') < sign) {
    with_e = word;
    with_e.insert(sign, 1, 'e');
    word = with_e;
  }
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, fault] = std::from_chars(word.data(), end, value);
  if (word.empty() || stop != end) {
    return std::nullopt;
  }
  if (fault == std::errc::result_out_of_range) {
    return HUGE_VAL;
  }
  return fault == std::errc{} ? std::optional(value) : std::nullopt;
}

double finite_number(std::string_view word, std::size_t line, const Log& log) {
  const std::optional<double> value = number_of(word);
  if (!value) {
    log.refuse(line, quoted(word) + " is not a number");
  }
  if (!std::isfinite(*value)) {
    log.refuse(line, quoted(word) + " is not a finite number");
  }
  return *value;
}

std::string printable(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string result(word.substr(0, longest));
  for (char& c : result) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) >= 0x7F) {
      c = '?';
    }
  }
  return word.size() > longest ? result + "..." : result;
}

std::string quoted(std::string_view word) {
  std::string result = "'";
  return result.append(printable(word)).append("'");
}

} // namespace wrc::reading
