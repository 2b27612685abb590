#include "geometry/along_check.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/error.hpp"
#include "geometry/constants.hpp"

namespace wrc {
namespace {

constexpr double nothing = -std::numeric_limits<double>::infinity();

/// Heights of one section on all lines, and slopes across.
struct Section {
  double place = 0.0;
  std::vector<double> height; ///< of lines; `nothing` where the sheet is not
  std::vector<double> cosine; ///< of the slope across
};

class SheetCheck {
public:
  SheetCheck(const SurfaceSheet& sheet, const SlicedProfile& profile, const SheetExtent& extent,
             const AlongUnit& unit, AlongCheck& found)
      : sheet_(sheet), first_slice_(extent.first_slice), of_place_(unit.of_place), found_(found) {
    double begin = std::numeric_limits<double>::infinity();
    double end = nothing;
    for (std::size_t i = extent.first_slice; i <= extent.last_slice; ++i) {
      places_.push_back(profile.slices[i].place);
      begin = std::min(begin, sheet.at(sheet.across().begin, places_.back()).at[0]);
      end = std::max(end, sheet.at(sheet.across().end, places_.back()).at[0]);
    }
    if (sheet.is_periodic()) { // the first slice follows the last one
      places_.push_back(sheet.knots().back());
    }
    for (std::size_t line = 0; line < swing_lines; ++line) {
      const double share = (static_cast<double>(line) + 0.5) / static_cast<double>(swing_lines);
      laterals_.push_back(std::lerp(begin, end, share));
      laterals_.push_back(laterals_.back() + swing_slope_distance);
    }
  }

  void run() {
    std::vector<Section> at_slices;
    for (const double place : places_) {
      at_slices.push_back(section(place));
    }
    for (std::size_t i = 0; i + 1 < places_.size(); ++i) {
      explain(at_slices, i);
      between(at_slices, i);
    }
  }

private:
  [[nodiscard]] Section section(double place) {
    heights_.assign(laterals_.size(), nothing);
    sheet_.raise_to(place, laterals_, heights_);
    Section result{place, {}, {}};
    for (std::size_t line = 0; line < swing_lines; ++line) {
      const double one = heights_[2 * line];
      const double slope = (heights_[2 * line + 1] - one) / swing_slope_distance;
      const bool counts = std::isfinite(slope) && std::abs(slope) <= steepest_swing_section;
      result.height.push_back(counts ? one : nothing);
      result.cosine.push_back(counts ? 1.0 / std::sqrt(1.0 + slope * slope) : 0.0);
    }
    return result;
  }

  /// By how much a parabola is above (first) and below both slices of an interval, on each line.
  void explain(const std::vector<Section>& slices, std::size_t i) {
    above_.assign(swing_lines, 0.0);
    below_.assign(swing_lines, 0.0);
    const double step = places_[i + 1] - places_[i];
    for (std::size_t line = 0; line < swing_lines; ++line) {
      const std::optional<double> one = second(slices, i, line);
      const std::optional<double> other = second(slices, i + 1, line);
      if (!one && !other) {
        continue;
      }
      const double a = one.value_or(*(other ? other : one));
      const double b = other.value_or(a);
      above_[line] = std::max(0.0, -std::max(a, b)) * step * step / 8.0;
      below_[line] = std::max(0.0, std::min(a, b)) * step * step / 8.0;
    }
  }

  /// The second divided difference about a slice, twice; none at an end of the sheet and where a
  /// neighbour has not the line.
  [[nodiscard]] std::optional<double> second(const std::vector<Section>& slices, std::size_t i,
                                             std::size_t line) const {
    const std::size_t last = places_.size() - 1;
    if (!sheet_.is_periodic() && (i == 0 || i == last)) {
      return std::nullopt;
    }
    const std::size_t one = i > 0 ? i - 1 : last - 1; // the last place is the first one again
    const std::size_t other = i < last ? i : 0;
    const double low = slices[one].height[line];
    const double here = slices[i].height[line];
    const double high = slices[other + 1].height[line];
    if (!std::isfinite(low) || !std::isfinite(here) || !std::isfinite(high)) {
      return std::nullopt;
    }
    const double before = places_[one + 1] - places_[one];
    const double after = places_[other + 1] - places_[other];
    return 2.0 * ((high - here) / after - (here - low) / before) / (before + after);
  }

  /// All places between slice i and the next.
  void between(const std::vector<Section>& slices, std::size_t i) {
    const std::span<const double> knots = sheet_.knots();
    const auto first = std::ranges::lower_bound(knots, places_[i]);
    std::vector<Section> sections{slices[i]};
    double largest = 0.0;
    for (auto knot = first; knot + 1 < knots.end() && *knot < places_[i + 1]; ++knot) {
      for (int part = 1; part <= interval_parts; ++part) {
        const double share = static_cast<double>(part) / interval_parts;
        sections.push_back(part == interval_parts && knot[1] >= places_[i + 1]
                               ? slices[i + 1]
                               : section(std::lerp(knot[0], knot[1], share)));
        largest = std::max(largest, compare(slices[i], slices[i + 1], sections.back(), i));
      }
    }
    found_.swing.intervals += largest > notable_swing ? 1 : 0;
    measure_rises(sections, i);
  }

  /// Largest swing of the lines at a place.
  [[nodiscard]] double compare(const Section& one, const Section& other, const Section& here,
                               std::size_t i) {
    double largest = 0.0;
    for (std::size_t line = 0; line < swing_lines; ++line) {
      const double z = here.height[line];
      const double before = one.height[line];
      const double after = other.height[line];
      if (!std::isfinite(z) || !std::isfinite(before) || !std::isfinite(after)) {
        continue;
      }
      const double up = z - std::max(before, after) - above_[line];
      const double down = std::min(before, after) - z - below_[line];
      const double size = here.cosine[line] * std::max(up, down);
      largest = std::max(largest, size);
      if (size > std::abs(found_.swing.size)) {
        set(found_.swing, up > down ? size : -size, here.place, i);
      }
    }
    return largest;
  }

  /// Runs of places on a line that are steeper than the search looks for, also over several slices.
  void measure_rises(const std::vector<Section>& sections, std::size_t i) {
    for (std::size_t line = 0; line < swing_lines; ++line) {
      double& rise = rise_[line];
      double& length = length_[line];
      for (std::size_t k = 1; k < sections.size(); ++k) {
        const double step = of_place_ * (sections[k].place - sections[k - 1].place);
        const double up = std::min(sections[k].cosine[line], sections[k - 1].cosine[line]) *
                          (sections[k].height[line] - sections[k - 1].height[line]);
        if (!std::isfinite(up) || !(std::abs(up) > steepest_along * step)) {
          rise = length = 0.0; // not steep, or the sheet is not there
          continue;
        }
        const bool goes_on = rise * up > 0.0;
        rise = goes_on ? rise + up : up;
        length = goes_on ? length + step : step;
        if (std::abs(rise) > std::abs(found_.rise.size)) {
          const double middle = sections[k].place - 0.5 * length / of_place_;
          set(found_.rise, rise, std::abs(middle) > swing_place_rounding * length ? middle : 0.0,
              i);
          found_.rise.length = length;
        }
      }
    }
  }

  void set(AlongFault& fault, double size, double place, std::size_t i) const {
    fault.size = size;
    fault.place = place;
    fault.slice = first_slice_ + i + 1;
    fault.slice_next = sheet_.is_periodic() && i + 2 == places_.size() ? 1 : fault.slice + 1;
  }

  const SurfaceSheet& sheet_;
  std::size_t first_slice_;
  double of_place_;
  AlongCheck& found_;
  std::vector<double> places_;
  std::vector<double> laterals_; ///< two of each line
  std::vector<double> heights_;
  std::vector<double> above_; ///< what a parabola explains, of lines
  std::vector<double> below_;
  std::vector<double> rise_ = std::vector<double>(swing_lines); ///< of the run that goes on
  std::vector<double> length_ = std::vector<double>(swing_lines);
};

std::string others_text(std::size_t intervals) {
  const std::size_t others = intervals - 1;
  return intervals > 1 ? " (as in " + std::to_string(others) +
                             (others > 1 ? " other intervals)" : " other interval)")
                       : "";
}

} // namespace

AlongCheck check_along(const SlicedProfile& profile, std::span<const SurfaceSheet> sheets,
                       const AlongUnit& unit) {
  AlongCheck found;
  const std::vector<SheetExtent> extents = sheet_extents(profile);
  for (std::size_t k = 0; k < sheets.size(); ++k) {
    SheetCheck(sheets[k], profile, extents[k], unit, found).run();
  }
  return found;
}

Warnings warnings_of(const AlongCheck& check, ProfileKind kind) {
  const bool is_rail = kind == ProfileKind::rail;
  const std::string body = is_rail ? "rail" : "wheel";
  Warnings warnings;
  if (const AlongFault& swing = check.swing; std::abs(swing.size) > notable_swing) {
    warnings.push_back({WarningClass::profile_swing,
                        "between slices " + std::to_string(swing.slice) + " and " +
                            std::to_string(swing.slice_next) + " the " + body + " is " +
                            short_text_of(std::abs(swing.size)) + " mm " +
                            (swing.size > 0.0 ? "above" : "below") + " both" +
                            others_text(swing.intervals) +
                            ": add slices there, or state smoothing_along of the " + body});
  }
  if (const AlongFault& rise = check.rise; std::abs(rise.size) > notable_swing) {
    warnings.push_back({WarningClass::profile_swing,
                        "the " + body + (rise.size > 0.0 ? " rises by " : " falls by ") +
                            short_text_of(std::abs(rise.size)) + " mm within " +
                            short_text_of(rise.length) + " mm at " + short_text_of(rise.place) +
                            (is_rail ? " mm" : " rad") + ", steeper than 1:" +
                            text_of(1.0 / steepest_along) + ": contact there can be missed"});
  }
  return warnings;
}

std::string swing_text(const AlongCheck& check) {
  const AlongFault& swing = check.swing;
  if (swing.size == 0.0) {
    return "between slices the surface is nowhere above or below both";
  }
  return "between slices the surface is above or below both by at most " +
         short_text_of(std::abs(swing.size)) + " mm, between slices " +
         std::to_string(swing.slice) + " and " + std::to_string(swing.slice_next);
}

} // namespace wrc
