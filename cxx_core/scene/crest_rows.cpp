#include "scene/crest_rows.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace wrc {
namespace {

/// Samples of the curvature, mm, and the widths of crests looked for, in samples.
constexpr double spacing = 0.025;
constexpr std::size_t least_width = 2;
constexpr std::size_t most_width = 80;
/// Of E*/(2 pi) k w, what rows as wide as the crest lose; it falls with their square. Measured on
/// LMA on CHN60 at y = 6.5 and 6.63 mm, a stretch of 0.3 mm: with 0.08 an accuracy of 1e-2 is met
/// by 5e-3 and 8e-3, with 0.03 missed by 3.5e-2; 0.5 triples the cost of 1e-3 and improves nothing
/// else.
constexpr double loss = 0.08;
/// The crest itself, in the same unit: the logarithm of its distance to the ends of contact.
constexpr double height = 4.0;

struct Line {
  std::vector<double> curvature_sums; ///< from the first sample on, one value more
  std::vector<double> pressure;       ///< largest of the row, MPa
};

Line sample_line(const PatchOnGrid& patch, const WheelSurface& wheel, const RailSurface& rail) {
  const Grid& grid = patch.grid;
  const double cosine = std::cos(patch.frame.angle());
  const auto first = static_cast<double>(patch.contact.box.lateral_first) - 0.5;
  const auto last = static_cast<double>(patch.contact.box.lateral_last) + 0.5;
  const double begin = grid.lateral_first + first * grid.lateral_step;
  const auto count = static_cast<std::size_t>((last - first) * grid.lateral_step / spacing);
  const std::vector<double> peaks = patch.row_peaks();
  Line line;
  line.curvature_sums.push_back(0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double lateral = begin + spacing * static_cast<double>(i);
    const double y = patch.frame.origin.y + cosine * lateral;
    const double s = patch.place.mean_s + (y - patch.place.mean_y);
    // Heights of both profiles grow towards the other body.
    const double curvature =
        -(rail.graph().heights().at(y).second + wheel.graph().heights().at(s).second) * cosine *
        cosine * cosine;
    line.curvature_sums.push_back(line.curvature_sums.back() + curvature);
    const auto row = static_cast<std::size_t>(
        std::clamp((lateral - grid.lateral_first) / grid.lateral_step + 0.5, 0.0,
                   static_cast<double>(grid.lateral_count - 1)));
    line.pressure.push_back(peaks[row]);
  }
  return line;
}

} // namespace

double row_step_for_crests(const PatchOnGrid& patch, const WheelSurface& wheel,
                           const RailSurface& rail, double combined_modulus, double highest,
                           double error) {
  const Line line = sample_line(patch, wheel, rail);
  const std::size_t count = line.pressure.size();
  const double unit = 0.5 / std::numbers::pi * combined_modulus * spacing; // of summed curvatures
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t width = least_width; width <= most_width && 3 * width <= count; width *= 2) {
    for (std::size_t i = width; i + 2 * width <= count; ++i) {
      const auto sum = [&line](std::size_t from, std::size_t to) {
        return line.curvature_sums[to] - line.curvature_sums[from];
      };
      const double inside = sum(i, i + width);
      const double around = sum(i - width, i) + sum(i + width, i + 2 * width);
      const double crest = unit * (inside - 0.5 * around);
      if (crest > 0.0 && line.pressure[i + width / 2] + height * crest > highest) {
        const double wide = spacing * static_cast<double>(width);
        step = std::min(step, wide * std::sqrt(error / (loss * crest)));
      }
    }
  }
  return step;
}

} // namespace wrc
