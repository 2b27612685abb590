#include "pressure/edge_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace wrc {
namespace {

/// The first of some rows under pressure from one side, and the next.
template <class Rows> double first_moment_of_edge(Rows first, Rows end, double place, double step) {
  while (first != end && !(first->force > 0.0)) {
    ++first;
    place += step;
  }
  const double last = first->force;
  const double next = first + 1 != end ? (first + 1)->force : 0.0;
  const double slope = std::max(next - last, last);
  const double beyond = last / slope;
  const double excess = -0.5 * slope * (beyond * beyond - beyond + 1.0 / 6.0);
  return excess * (place - step * beyond);
}

} // namespace

double edge_error(std::span<const ContactRow> rows) {
  double force = 0.0;
  double first = 0.0;
  double second = 0.0;
  double place = 0.0;
  for (const ContactRow& row : rows) {
    force += row.force;
    first += row.force * place;
    second += row.force * place * place;
    place += 1.0;
  }
  const double middle = first / force;
  const double variance = second / force - middle * middle;
  if (!(variance > 0.0)) {
    return 0.0;
  }
  const double moment =
      first_moment_of_edge(rows.begin(), rows.end(), -middle, 1.0) +
      first_moment_of_edge(rows.rbegin(), rows.rend(), place - 1.0 - middle, -1.0);
  return std::abs(moment) / (force * std::sqrt(5.0 * variance));
}

} // namespace wrc
