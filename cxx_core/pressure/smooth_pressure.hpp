/// Pressures between element centres and up to the edge of contact.
///
/// p^2 is a smooth function up to the edge (Hertz: a quadratic one; Johnson, Contact Mechanics,
/// 1985, eq. 3.39). Along a row, the rolling direction, it has no kinks, since wheels and rails
/// have none there. Pressures of smooth elements are accurate except at the ends of rows,
/// which stand for elements that are not wholly in contact: these are replaced by p^2 continued
/// from three elements further in, 3 f1 - 3 f2 + f3. In the same way two elements outside are
/// filled in, as the mean of 8 directions, which weigh with the slope of p^2 along them; from fewer
/// elements where there are not three. In between p^2 is interpolated cubically along rows. Across,
/// where profiles have kinks, it has the smaller of the two second differences about the point,
/// none if their signs differ. Means over elements take p^2 as linear in each half of an element.
/// Where the gap bends along the row (remesh/bend_along.hpp) p^2 does, too, and has no continuation
/// from further in. There the end of a row bears what its element does: p^2 is linear from the next
/// element inwards, with the mean pressure that the solution has.
///
/// All of this is continuous in the pressures: an element that enters the contact counts as one
/// outside at first, and as one inside as its pressure grows (constants.hpp). Otherwise forces that
/// follow from the edge step whenever an element enters.
///
/// Units are the caller's. Thread rule: constant after construction.
///
/// Not known here: where contact ends laterally within an element. Contact of a single row ends
/// half an element outside it.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "base/grid.hpp"

namespace wrc {

class SmoothPressure {
public:
  /// `bend`: 0 to 1, how far ends of rows bear what their elements do, instead of p^2 continued.
  SmoothPressure(const Grid& grid, std::span<const double> pressure, double bend = 0.0);

  /// Two edges on a line through the grid, in its coordinates.
  struct Extent {
    double first = 0.0;
    double last = 0.0;
    double longest = 0.0; ///< of the lines in between, from the first to the last edge on each
  };
  /// The least interval that holds the contact of all lines; none without contact.
  [[nodiscard]] std::optional<Extent> longitudinal_extent() const;
  [[nodiscard]] std::optional<Extent> lateral_extent() const;
  /// Pressures at the centres of another grid in the same plane; 0 outside the contact.
  void fill(const Grid& other, std::vector<double>& pressure) const;
  /// Means over another grid's elements along the lines through their centres, and the fraction of
  /// these lengths that is in contact.
  void fill_means(const Grid& other, std::vector<double>& pressure,
                  std::vector<double>& covered) const;

  /// Sums of the means over its own elements, of the column at the position `first` and the next.
  struct Columns {
    double first = 0.0;
    std::vector<double> sums;
  };
  [[nodiscard]] Columns own_columns() const;

private:
  /// p^2 at positions along the rolling direction, on the line at a lateral position; outside the
  /// contact negative, minus infinity where nothing is filled in.
  class Line;
  /// p^2 continued from the next one, two and three elements in a direction to the position before
  /// them, and how far these are known, 0 to 1.
  struct Continuation {
    std::array<double, 3> values{};
    std::array<double, 3> known{};
    std::array<double, 3> slopes{}; ///< of p^2 inwards
  };
  [[nodiscard]] Continuation continuation(std::size_t at, std::ptrdiff_t step) const;
  [[nodiscard]] std::optional<Extent> extent(std::size_t lines, std::size_t line_stride,
                                             std::size_t count, std::size_t stride) const;
  void replace_ends_of_rows(const std::vector<double>& given, double bend);
  void fill_in_ring(const std::vector<double>& given);

  Grid grid_;                   ///< of the contact, with room for what is filled in
  std::vector<double> known_;   ///< how far elements are known, 0 to 1
  std::vector<double> squares_; ///< p^2 where it is known
};

} // namespace wrc
