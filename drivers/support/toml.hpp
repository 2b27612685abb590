/// toml++ and what the drivers ask of it: files of a sensible size, failures in one line.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "support/values.hpp"

// toml++ is a well-kept library whose headers do not follow our warning levels.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#define TOML_EXCEPTIONS 1
#include <toml++/toml.h>
#pragma GCC diagnostic pop

namespace driver {

/// Reads a file; `what` names it in failures, for example "scene file".
toml::table read_toml(const std::string& what, const std::string& path);
/// The same of its text.
toml::table parse_toml(const std::string& what, const std::string& path, const std::string& text);
/// Parses `key = value` of an option "--set key=value".
toml::table parse_assignment(const std::string& assignment, const std::string& key,
                             const std::string& value);

/// A node as it was written.
std::string text_of(const toml::node& node);
std::optional<double> number_of(const toml::node& node);
/// A number, a text or a list of numbers; throws Failure for others.
Value value_of(const std::string& key, const toml::node& node);

/// Letters of ASCII made small, as those of all keys are.
std::string lower_case(std::string_view text);

/// The name of a key of a table within others, whose names come before it, in small letters; throws
/// Failure for one that is longer than any key could be.
std::string name_within(const std::string& prefix, const toml::key& key);

/// Whether a table is a profile with its options: {file = "worn.txt", smoothing = 5}.
bool is_profile(const toml::table& table);
/// The texts of such a table for the key, "worn.txt; smoothing = 5": one for each entry of a list,
/// of which there may be one, of files or of an option.
std::vector<std::string> profile_texts(const std::string& key, const toml::table& table);

/// Adds the values of a table and of those within it, by names with points between; of a profile
/// its text.
void flatten(const toml::table& table, const std::string& prefix, Values& values);

/// Reads one table; every key has to be asked for, so that a wrong one is refused. All throw
/// Failure naming table, key, value and what is allowed.
class TableReader {
public:
  TableReader(const toml::table& table, std::string name) : table_(table), name_(std::move(name)) {}

  std::string text(const char* key, const std::string& otherwise);
  double number(const char* key, double otherwise);
  /// Lists and tables; empty if the key is not there.
  std::vector<double> numbers(const char* key);
  std::vector<std::string> texts(const char* key);
  std::vector<const toml::table*> tables(const char* key);
  Values values(const char* key);

  void refuse_others() const;
  /// `value` as it was written.
  [[noreturn]] void refuse(const char* key, const std::string& value,
                           const std::string& allowed) const;

private:
  /// The value of a key, which must be such a one; null if the key is not there.
  const toml::node* find(const char* key, bool (*is)(const toml::node&), const char* allowed);

  const toml::table& table_;
  std::string name_;
  std::vector<std::string> asked_;
};

} // namespace driver
