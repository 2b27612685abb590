/// The errors of a table by place, and where they are too large.
///
/// A box of two variables in cells, with errors of several kinds at their vertices. Between
/// vertices errors go over by 3 t^2 - 2 t^3 in each variable, so that they have a continuous slope.
/// In the same way a weight goes over from 1 at vertices whose error exceeds a tolerance to 0 at
/// others. Thread rule: plain values.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "table/wheel_outputs.hpp"

namespace wrc {

/// The first kinds; those of the outputs follow.
enum ErrorKind : std::size_t {
  bound_of_force, ///< over the load, as TableErrors
  likely_of_force,
  likely_of_derivatives, ///< of a column, over the column
  first_of_outputs
};
constexpr std::size_t error_kind_count = first_of_outputs + output_count;

class ErrorMap {
public:
  using Place = std::array<double, 2>;
  using Counts = std::array<std::size_t, 2>;
  using Errors = std::array<double, error_kind_count>;
  struct Range {
    double first = 0.0;
    double last = 1.0;
  };
  using Ranges = std::array<Range, 2>;

  ErrorMap() : ErrorMap(Ranges{}, Counts{1, 1}) {}
  ErrorMap(const Ranges& ranges, const Counts& counts);

  /// Of some kinds; the others are 0.
  [[nodiscard]] Errors at(const Place& place, std::size_t first = 0,
                          std::size_t last = error_kind_count) const;

  struct Weight {
    double value = 0.0;
    Place slope{};
  };
  /// Of the exact solution, where the likely error of forces exceeds a tolerance.
  [[nodiscard]] Weight weight_at(const Place& place, double tolerance) const;
  /// Fraction of the vertices that do.
  [[nodiscard]] double share_beyond(double tolerance) const;

  [[nodiscard]] std::size_t cell_count() const { return counts_[0] * counts_[1]; }
  [[nodiscard]] std::size_t cell_of(const Place& place) const;
  /// The ranges of a cell, and its vertices.
  [[nodiscard]] Ranges ranges_of(std::size_t cell) const;
  [[nodiscard]] std::array<std::size_t, 4> vertices_of(std::size_t cell) const;

  [[nodiscard]] const Ranges& ranges() const { return ranges_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] std::vector<Errors>& vertices() { return vertices_; }
  [[nodiscard]] const std::vector<Errors>& vertices() const { return vertices_; }

private:
  [[nodiscard]] std::size_t index_in(std::size_t variable, double place, double& fraction) const;
  /// Calls `add(vertex, weight, slope)` for the four around a place.
  template <class Add> void around(const Place& place, const Add& add) const;

  Ranges ranges_{};
  Counts counts_{1, 1};
  std::vector<Errors> vertices_;
};

} // namespace wrc
