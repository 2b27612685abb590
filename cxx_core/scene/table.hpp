/// Results of a scene over a grid of some of its keys, and a file that says what it holds.
///
/// For programs that cannot afford a solution each step: they interpolate. The grid is the product
/// of the values of each key; cells are numbered with the first key fastest. Numbers are in the
/// scene's convention. Thread rule: a table is constant; one solver for each thread.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "scene/number_ids.hpp"
#include "scene/solve_scene.hpp"

namespace wrc {

class TableGrid {
public:
  /// Names are separated by blanks; `counts` says how many of the values belong to each key, one
  /// after the other. Throws Error(unknown_name, invalid_argument), also for a value that the scene
  /// refuses.
  TableGrid(const Scene& scene, std::string_view keys, const double* values,
            const std::int64_t* counts, std::string_view results);

  [[nodiscard]] std::size_t cell_count() const { return cell_count_; }
  [[nodiscard]] std::size_t result_count() const { return results_.size(); }
  /// The results of a cell; not-a-number is what there is none of: without contact, or of a patch
  /// that is not there.
  void solve_cell(std::size_t cell, SceneSolver& solver, double* results) const;
  /// Columns of numbers, keys first, under comments that say what they are. `values`: of all cells.
  /// Throws Error(file_unreadable).
  void write(const std::filesystem::path& path, std::string_view version,
             std::span<const double> values) const;

private:
  struct Axis {
    std::string key;
    std::vector<double> values;
  };
  struct Column {
    std::string name;
    NumberId id;
  };
  [[nodiscard]] std::vector<double> values_at(std::size_t cell) const;
  [[nodiscard]] Scene scene_at(std::size_t cell) const;

  Scene scene_;
  std::vector<Axis> axes_;
  std::vector<Column> results_;
  std::size_t cell_count_ = 1;
};

} // namespace wrc
