/// Stresses below a grid of elements with constant pressure and tractions.
///
/// At points as far apart as the elements, at one depth, they are convolutions of the loads with
/// the closed forms of damage/element_stress.hpp: one corner sum for each offset, and for each row
/// of points and elements sums over the non-zero loads. At a depth of some elements the field
/// depends only on their moments, so that larger elements with the same moments up to the third
/// serve there: a section costs what its shallow depths cost. Sections and searches are in single
/// precision.
///
/// Frame: x longitudinal, y lateral as the grid's, z into the body. Pressures press, tractions act
/// on the body; tension is positive. Units mm, MPa. Thread rule: pure functions.
///
/// Near the surface, above the depth of about one element, values are those of the elements: good
/// below their centres, which sections interpolate between; at a boundary of the contact, or of
/// slip, they are as coarse as the grid.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "base/grid.hpp"
#include "damage/element_stress.hpp"

namespace wrc {

/// What acts on a body.
struct SurfaceLoads {
  Grid grid;
  std::span<const double> pressure;   ///< per element
  std::span<const double> traction_x; ///< none: empty
  std::span<const double> traction_y;
};

/// A plane across the contact, along x or along y.
struct StressSection {
  std::vector<double> places; ///< x or y
  std::vector<double> depths;
  std::vector<Stress> stresses; ///< points run fastest
};

struct GreatestStress {
  double von_mises = 0.0;
  double shear = 0.0;   ///< greatest shear at that point
  double tension = 0.0; ///< first principal stress at that point
  double x = 0.0, y = 0.0, depth = 0.0;
  double error_estimate = 0.0; ///< relative: what elements leave near the surface, under tractions
};

class SubsurfaceStress {
public:
  /// Throws Error(invalid_argument) for loads that do not fit the grid.
  SubsurfaceStress(const SurfaceLoads& loads, double poisson);

  /// The sum over all elements.
  [[nodiscard]] Stress at(double x, double y, double depth) const;
  /// At points x (rising, equally spaced) and depths at one y.
  [[nodiscard]] StressSection along(std::span<const double> x, double y,
                                    std::span<const double> depths) const;
  /// At points y at one x.
  [[nodiscard]] StressSection across(std::span<const double> y, double x,
                                     std::span<const double> depths) const;
  /// The greatest von Mises stress in the body, by search on coarse elements and parabolas.
  [[nodiscard]] GreatestStress greatest() const;

private:
  /// Loads on elements of one size.
  struct Level {
    Grid grid;
    std::vector<double> loads[3]; ///< p, q_x, q_y; rows backwards, which makes the sums contiguous
    std::vector<std::size_t> first, last; ///< of a row, where it holds something
    [[nodiscard]] double size() const;    ///< of an element, the longer side
  };
  SubsurfaceStress() = default;
  static Level coarsened(const Level& fine);
  static void find_extents(Level& level);
  void make_levels();
  /// As a line at y sees it: near rows as they are, farther ones on larger elements.
  static std::vector<Level> seen_from(const Level& level, double y);
  [[nodiscard]] SubsurfaceStress transposed() const;
  [[nodiscard]] const Level& level_for(double depth, double sizes) const;
  /// Points a whole number of the level's elements apart.
  struct Places {
    double x_first;
    std::size_t x_count;
    double y_first;
    std::size_t y_count;
    std::size_t x_stride = 1;
    std::size_t y_stride = 1;
  };
  /// There, x running fastest.
  template <class Real>
  [[nodiscard]] std::vector<Stress> sums(const Level& level, const Places& places,
                                         double depth) const;
  [[nodiscard]] Stress point(const Level& level, double x, double y, double depth) const;
  /// Raises `found` to the greatest of them.
  void scan(const Level& level, const Places& places, double depth, GreatestStress& found) const;
  [[nodiscard]] double half_width() const; ///< of the contact, the smaller one
  /// The coarsest that shows the contact.
  [[nodiscard]] std::size_t level_shown() const;
  /// The centres of a level's elements without the margin that coarsening adds; of very slender
  /// contacts every second, third ... along the longer side.
  [[nodiscard]] Places below_contact(const Level& level) const;
  /// On it, the greatest at each of some depths, deepest first.
  [[nodiscard]] std::vector<GreatestStress> search() const;
  /// Whether there is pressure on a strip so narrow that it does not show it.
  [[nodiscard]] bool has_narrow_top() const;
  /// Below the greatest pressure, which may be on a strip that coarse elements do not show.
  [[nodiscard]] GreatestStress below_pressure(double deepest) const;
  /// To the top nearby: by parabolas, or below the centres of smaller and smaller elements.
  void climb_below(GreatestStress& found) const;
  void climb_on_surface(GreatestStress& found) const;

  double poisson_ = 0.0;
  bool tractions_ = false;
  std::vector<Level> levels_; ///< finest first
};

} // namespace wrc
