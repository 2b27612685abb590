#include "remesh/contact_border.hpp"

#include <algorithm>

#include "remesh/met_distance.hpp"

namespace wrc {

std::vector<BorderPair> contact_border(const Grid& grid, std::span<const double> pressure,
                                       std::span<const double> distance) {
  const std::size_t columns = grid.longitudinal_count;
  std::vector<BorderPair> border;
  for (std::size_t i = 0; i < pressure.size(); ++i) {
    if (!(pressure[i] > 0.0) || !is_met(distance[i])) {
      continue;
    }
    const auto add = [&](bool is_there, std::size_t beside, bool is_along) {
      if (is_there && (!(pressure[beside] > 0.0) || !is_met(distance[beside]))) {
        border.push_back({i, beside, is_along, !is_met(distance[beside])});
      }
    };
    add(i % columns > 0, i - 1, true);
    add(i % columns + 1 < columns, i + 1, true);
    add(i >= columns, i - columns, false);
    add(i + columns < pressure.size(), i + columns, false);
  }
  return border;
}

bool body_ends_in_contact(const Grid& grid, std::span<const double> pressure,
                          std::span<const double> distance) {
  return std::ranges::any_of(contact_border(grid, pressure, distance), &BorderPair::ends);
}

} // namespace wrc
