/// The error of a table by place, and where it is too large.
///
/// A box of three variables in cells. Each vertex has the largest error of the cells around it;
/// between vertices the error goes over by 3 t^2 - 2 t^3 in each variable, so that it has a
/// continuous slope and is nowhere below that of its cell. In the same way a weight is 1 throughout
/// cells whose error exceeds a tolerance, and falls to 0 over the next cells. Thread rule: plain
/// values.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace wrc {

class ErrorMap {
public:
  using Place = std::array<double, 3>;
  using Counts = std::array<std::size_t, 3>;
  struct Range {
    double first = 0.0;
    double last = 1.0;
  };
  using Ranges = std::array<Range, 3>;

  ErrorMap() = default;
  /// `errors`: of the cells, the last variable fastest.
  ErrorMap(const Ranges& ranges, const Counts& counts, std::vector<double> errors);

  [[nodiscard]] std::size_t cell_of(const Place& place) const;
  /// The ranges of a cell.
  [[nodiscard]] Ranges ranges_of(std::size_t cell) const;
  [[nodiscard]] double error_at(const Place& place) const { return at(errors_, place).value; }

  struct Weight {
    double value = 0.0;
    std::array<double, 3> slope{};
  };
  /// Weight of the exact solution; 0 everywhere before set_tolerance.
  [[nodiscard]] Weight weight_at(const Place& place) const { return at(weights_, place); }
  void set_tolerance(double tolerance);
  /// Fraction of the cells whose weight is 1.
  [[nodiscard]] double share_beyond(double tolerance) const;

  [[nodiscard]] const Ranges& ranges() const { return ranges_; }
  [[nodiscard]] const Counts& counts() const { return counts_; }
  [[nodiscard]] const std::vector<double>& cells() const { return cells_; }

private:
  [[nodiscard]] Weight at(const std::vector<double>& vertices, const Place& place) const;
  template <class Value> [[nodiscard]] std::vector<double> largest_around(const Value& value) const;
  [[nodiscard]] std::size_t index_in(std::size_t variable, double place, double& fraction) const;

  Ranges ranges_{};
  Counts counts_{1, 1, 1};
  std::vector<double> cells_{0.0};
  std::vector<double> errors_ = std::vector<double>(8);
  std::vector<double> weights_ = std::vector<double>(8);
};

} // namespace wrc
