/// The study as table of ranges, CSV (one line a point) and JSON.
#pragma once

#include <cstdint>
#include <ostream>
#include <vector>

#include "wrc_extremes/row.hpp"

namespace extremes {

/// Neighbouring points of the same kind that came out alike.
struct Range {
  std::string quantity, base;
  std::string first, last; ///< settings
  double from = 0.0;
  double to = 0.0;
  int points = 0;
  Verdict verdict = Verdict::wrong;
  std::optional<double> worst_residual; ///< of overlap and complementarity
  std::optional<double> worst_pressure_error;
  std::optional<double> worst_error;
  std::string message; ///< of its first point
};
std::vector<Range> ranges_of(const std::vector<Row>& rows);

void print_table(const std::vector<Row>& rows, std::ostream& out);
void print_csv(const std::vector<Row>& rows, std::ostream& out);
void print_json(const std::vector<Row>& rows, std::uint64_t seed, std::ostream& out);

} // namespace extremes
