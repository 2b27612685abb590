#include "scene/table.hpp"

#include <algorithm>
#include <cmath>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/lower_case.hpp"
#include "base/nearest_names.hpp"
#include "keys/scene_file.hpp"
#include "keys/scene_keys.hpp"
#include "scene/constants.hpp"

namespace wrc {
namespace {

std::vector<std::string> words_of(std::string_view text) {
  std::vector<std::string> words;
  for (std::size_t from = text.find_first_not_of(' '); from != std::string_view::npos;) {
    const std::size_t to = std::min(text.find(' ', from), text.size());
    words.emplace_back(text.substr(from, to - from));
    from = text.find_first_not_of(' ', to);
  }
  return words;
}

} // namespace

TableGrid::TableGrid(const Scene& scene, std::string_view keys, const double* values,
                     const std::int64_t* counts, std::string_view results)
    : scene_(scene) {
  for (const std::string& name : words_of(results)) {
    const auto id = number_id(name);
    if (!id) {
      if (const auto removed = removed_number(name)) {
        throw Error(ErrorCode::unknown_name, "results: " + *removed);
      }
      throw Error(ErrorCode::unknown_name,
                  "results: there is no result \"" + name +
                      "\"; nearest: " + nearest_names(name, possible_number_names()));
    }
    results_.push_back({name, *id});
  }
  if (results_.empty()) {
    throw Error(ErrorCode::invalid_argument, "results: at least one name is needed");
  }
  Scene tried = scene_;
  for (const std::string& key : words_of(keys)) {
    const std::int64_t count = counts[axes_.size()];
    if (count < 1 ||
        static_cast<std::uint64_t>(count) > most_table_values / (cell_count_ * results_.size())) {
      throw_invalid_argument("counts[" + std::to_string(axes_.size()) + ']',
                             static_cast<double>(count),
                             "must be at least 1, with at most 2^28 numbers in all");
    }
    if (std::any_of(axes_.begin(), axes_.end(),
                    [&](const Axis& axis) { return lower_case(axis.key) == lower_case(key); })) {
      throw Error(ErrorCode::invalid_argument,
                  "keys: \"" + key + "\" occurs twice; each key is allowed once");
    }
    const auto n = static_cast<std::size_t>(count);
    axes_.push_back({key, std::vector<double>(values, values + n)});
    values += n;
    cell_count_ *= n;
    for (const double value : axes_.back().values) {
      set_number(tried, key, value);
    }
  }
}

std::vector<double> TableGrid::values_at(std::size_t cell) const {
  std::vector<double> values;
  for (const Axis& axis : axes_) {
    values.push_back(axis.values[cell % axis.values.size()]);
    cell /= axis.values.size();
  }
  return values;
}

void TableGrid::solve_cell(std::size_t cell, SceneSolver& solver, double* results) const {
  Scene scene = scene_;
  const std::vector<double> values = values_at(cell);
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    set_number(scene, axes_[i].key, values[i]);
  }
  try {
    SceneResult result = solver.solve(scene);
    for (const Column& column : results_) {
      *results++ = number_value(result, column.id, scene.convention);
    }
  } catch (const Error& error) {
    if (error.code() != ErrorCode::no_contact) {
      throw;
    }
    std::fill_n(results, results_.size(), NAN);
  }
}

void TableGrid::write(const std::filesystem::path& path, std::string_view version,
                      std::span<const double> values) const {
  std::string text = "# Results of wrcontact " + std::string(version) + " over a grid of keys\n# " +
                     std::string(name_of(scene_.convention.units)) + "; " +
                     std::string(name_of(scene_.convention.frame)) +
                     "\n# nan: no contact, or no such patch\n#\n# Grid, the first key fastest:\n";
  for (const Axis& axis : axes_) {
    text += "#   " + axis.key + ": " + std::to_string(axis.values.size()) + " values\n";
  }
  text += "#\n# Scene, in mm, N, MPa, rad, y left, z up:";
  for (const char c : '\n' + scene_text(scene_)) {
    text += c;
    text += c == '\n' ? "# " : "";
  }
  text += "\n# Columns:\n#";
  for (const Axis& axis : axes_) {
    text += ' ' + axis.key;
  }
  for (const Column& column : results_) {
    text += ' ' + column.name;
  }
  text += '\n';
  for (std::size_t cell = 0; cell < cell_count_; ++cell) {
    for (const double value : values_at(cell)) {
      text += text_of(value) + ' ';
    }
    for (std::size_t i = 0; i < results_.size(); ++i) {
      text += text_of(values[cell * results_.size() + i]) + (i + 1 < results_.size() ? ' ' : '\n');
    }
  }
  write_file(path, text);
}

} // namespace wrc
