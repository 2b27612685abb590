/// p^2 next to contact: the field whose zero line is the edge of contact.
///
/// At a smooth edge p ~ sqrt of the distance from it (Johnson, Contact Mechanics, 1985, eq. 4.27),
/// so p^2 goes on linearly to negative values beyond: 2 near - far, from p^2 at one step (`near`)
/// and at two steps (`far`) in a direction with pressure at one step. All 8 directions count. With
/// no pressure at two steps it is -near, the edge half-way between the two centres.
/// For the edge itself, three elements show how p^2 bends (Hertz's is a quadratic function): areas
/// then have no error of second order.
/// Order of elements: that of base/grid.hpp. Thread rule: pure functions.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace wrc {

/// Rows and columns of a field.
struct LevelSize {
  std::size_t rows = 0;
  std::size_t columns = 0;
  [[nodiscard]] std::size_t count() const { return rows * columns; }
};

/// p^2 in contact; next to contact the mean of its linear continuations, never above 0; 0 beyond.
void square_and_continue(const LevelSize& size, std::span<const double> pressure,
                         std::vector<double>& squares);

/// p^2 of an element without pressure for measuring contact, at most 0: straight lines to it from
/// its neighbours' p^2 cross 0 at the edge. That is at the root of the parabola through three
/// elements, with `edge_beyond_pressures`. Where that lies past the element's own centre, which has
/// no pressure, the edge comes back with the slope of p^2 to half-way, where it is for even
/// pressures: between the centres in any case. Directions weigh with `near`, so that one that gains
/// or loses contact changes little; those whose second step leaves the grid count only when there
/// are no others. Pressures are multiplied by `scale` first.
double edge_square(const LevelSize& size, std::span<const double> pressure, double scale,
                   std::size_t row, std::size_t column);

} // namespace wrc
