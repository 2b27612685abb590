/// What the contacts on a grid of the caller's have in common, normal and rolling: the grid, arrays
/// that are taken in, words and names that are refused.
#pragma once

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <vector>

#include "base/grid.hpp"
#include "base/lower_case.hpp"
#include "handles.hpp"

namespace wrc {

/// Iterations are counted in an int.
inline constexpr double most_iterations = 1e9;

/// Throws Error(unknown_name): no `what` of a `contact` has this name; there are the `known` ones.
[[noreturn]] void refuse_name(const char* what, const char* contact, const std::string& name,
                              const std::string& known);

/// Throws Error(invalid_argument): a text is none of the words that are allowed.
[[noreturn]] void refuse_word(const std::string& key, const std::string& text,
                              const std::vector<std::string>& words);

/// A word and what it stands for.
template <class Value> struct Word {
  const char* word;
  Value value;
};

/// What a text stands for; throws Error(invalid_argument) if it is none of the words.
template <class Value>
Value chosen(const std::string& key, const std::string& text,
             std::initializer_list<Word<Value>> words) {
  std::vector<std::string> known;
  for (const auto& [word, value] : words) {
    if (text == word) {
      return value;
    }
    known.emplace_back(word);
  }
  refuse_word(key, text, known);
}

/// A grid whose first element is at 0. Throws Error(invalid_argument).
Grid checked_grid(std::int64_t lateral_count, std::int64_t longitudinal_count, double lateral_step,
                  double longitudinal_step);

/// Copies `count` values; throws Error(invalid_argument) for NULL, a count that no grid has, and
/// the first value that is not permitted, with the text of permitted values.
std::vector<double> copied(const char* name, const double* values, std::int64_t count,
                           bool (*permitted)(double), const char* allowed);

/// The names of a table's entries, with commas.
template <class Table> std::string names_in(const Table& table) {
  std::string names;
  for (const auto& entry : table) {
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  return names;
}

/// The entry of a name in a table; throws Error(unknown_name) if there is none.
template <class Table>
const auto& entry_in(const Table& table, const char* what, const char* contact,
                     const std::string& name) {
  const std::string spelled = lower_case(name); // as all keys are
  for (const auto& entry : table) {
    if (spelled == entry.name) {
      return entry;
    }
  }
  refuse_name(what, contact, name, names_in(table));
}

/// A number that can be set: its range, which may leave a gap down to 0, and the text of allowed
/// values.
template <class Problem> struct NumberKey {
  const char* name;
  double least;
  double largest;
  const char* allowed;
  void (*set)(Problem&, double);
  bool whole = false;
  bool or_zero = false;
};

/// Throws Error(unknown_name) or Error(invalid_argument).
template <class Table, class Problem>
void set_number_in(const Table& table, const char* contact, Problem& problem, const char* key,
                   double value) {
  require_pointer(key, "key");
  const auto& entry = entry_in(table, "number", contact, key);
  const bool within = value >= entry.least && value <= entry.largest;
  if (!(within || (entry.or_zero && value == 0.0)) || (entry.whole && value != std::floor(value))) {
    throw_invalid_argument(key, value, entry.allowed);
  }
  entry.set(problem, value);
}

/// A text that can be set.
template <class AnObject> struct TextKey {
  const char* name;
  void (*set)(AnObject&, const char* key, const char* value);
};

/// Those of a solver's options.
inline void set_precision(SolverOptions& options, const char* key, const char* value) {
  options.precision = chosen<Precision>(
      key, value, {{"mixed", Precision::mixed}, {"double", Precision::double_only}});
}
inline void set_planner(SolverOptions& options, const char* key, const char* value) {
  using Rigor = PlannerRigor;
  options.planner =
      chosen<Rigor>(key, value, {{"estimate", Rigor::estimate}, {"measure", Rigor::measure}});
}

/// Runs a body that needs results.
template <class Handle, class Body> wrc_status with_result(Handle* handle, Body&& body) {
  return guard(handle, [&](Object<Handle>& object) -> wrc_status {
    if (!object.result) {
      object.error = "the contact has not been solved yet";
      return WRC_NO_RESULT;
    }
    return std::forward<Body>(body)(object, *object.result);
  });
}

} // namespace wrc
