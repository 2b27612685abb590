#include "geometry/sliced_sheets.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "geometry/constants.hpp"
#include "profile/limits.hpp"

namespace wrc {
namespace {

std::size_t part_count(const SlicedProfile& profile) {
  const std::size_t features = profile.slices.front().features.size();
  return features < 2 ? 1 : features - 1;
}

bool has_part(const ProfileSlice& slice, std::size_t part) {
  return slice.features.size() < 2 || (slice.features[part] && slice.features[part + 1]);
}

std::vector<SheetExtent> runs_of(const SlicedProfile& profile, std::size_t part) {
  std::vector<SheetExtent> runs;
  const std::size_t slices = profile.slices.size();
  for (std::size_t i = 0; i < slices; ++i) {
    if (!has_part(profile.slices[i], part)) {
      continue;
    }
    const std::size_t first = i;
    while (i + 1 < slices && has_part(profile.slices[i + 1], part)) {
      ++i;
    }
    if (i > first || slices == 1) {
      runs.push_back({part, part, first, i});
    }
  }
  return runs;
}

/// As AlongSpline limits it, in the words of those who wrote the list of slices.
void check_smoothing_length(const std::string& name, const std::vector<SheetSection>& sections,
                            double smoothing_length, double period, const AlongUnit& unit) {
  if (sections.size() < (period > 0.0 ? 2 : 3)) {
    return; // nothing to smooth
  }
  double closest = period > 0.0 ? sections.front().place + period - sections.back().place
                                : std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < sections.size(); ++i) {
    closest = std::min(closest, sections[i].place - sections[i - 1].place);
  }
  const double most = longest_along_smoothing * closest;
  if (closest > 0.0 && smoothing_length > most) {
    const auto text = [&unit](double length) {
      const double value = unit.of_place * length;
      return (value < 1000.0 ? short_text_of(value) : text_of(std::round(value))) + ' ' +
             std::string(unit.name);
    };
    throw_invalid_argument("smoothing length along profile " + name, text(smoothing_length),
                           "at most " + text(most) + ", " + text_of(longest_along_smoothing) +
                               " times the smallest distance between two slices, " + text(closest));
  }
}

} // namespace

std::vector<SheetExtent> sheet_extents(const SlicedProfile& profile) {
  std::vector<SheetExtent> sheets;
  for (std::size_t part = 0; part < part_count(profile); ++part) {
    for (const SheetExtent& run : runs_of(profile, part)) {
      const auto joined = std::find_if(sheets.begin(), sheets.end(), [&](const SheetExtent& sheet) {
        return sheet.last_part + 1 == part && sheet.first_slice == run.first_slice &&
               sheet.last_slice == run.last_slice;
      });
      if (joined != sheets.end()) {
        joined->last_part = part;
      } else if (sheets.size() == SliceLimits::max_sheets) {
        throw_invalid_argument("parts that begin and end of profile " + profile.name,
                               "more than " + std::to_string(sheets.size()),
                               "at most " + std::to_string(SliceLimits::max_sheets));
      } else {
        sheets.push_back(run);
      }
    }
  }
  return sheets;
}

double smoothing_length_of(const SlicedProfile& profile, std::optional<double> given) {
  if (given || !profile.is_smoothed || profile.slices.size() < 2) {
    return given.value_or(0.0);
  }
  std::vector<double> distances;
  for (std::size_t i = 1; i < profile.slices.size(); ++i) {
    distances.push_back(profile.slices[i].place - profile.slices[i - 1].place);
  }
  const auto median = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), median, distances.end());
  return smoothed_slice_distances * *median;
}

std::vector<SurfaceSheet> sheets_of(const SlicedProfile& profile, double smoothing_length,
                                    double period, const AlongUnit& unit) {
  std::vector<SurfaceSheet> sheets;
  std::size_t memory = 0;
  for (const SheetExtent& extent : sheet_extents(profile)) {
    std::vector<SheetSection> sections;
    for (std::size_t i = extent.first_slice; i <= extent.last_slice; ++i) {
      const ProfileSlice& slice = profile.slices[i];
      SheetSection section{i + 1, slice.place, &slice.curve, {0.0, slice.curve.length()}};
      if (slice.features.size() >= 2) {
        section.features.clear();
        for (std::size_t k = extent.first_part; k <= extent.last_part + 1; ++k) {
          section.features.push_back(*slice.features[k]);
        }
      }
      sections.push_back(std::move(section));
    }
    const bool closes = sections.size() == profile.slices.size();
    check_smoothing_length(profile.name, sections, smoothing_length, closes ? period : 0.0, unit);
    sheets.emplace_back(sections, smoothing_length, closes ? period : 0.0);
    memory += sheets.back().memory();
    if (memory > SliceLimits::sheet_bytes) {
      throw_invalid_argument("surfaces of profile " + profile.name,
                             short_text_of(1e-6 * static_cast<double>(memory)) + " MB",
                             "at most " + std::to_string(SliceLimits::sheet_bytes >> 20) +
                                 " MB; use fewer slices");
    }
  }
  if (sheets.empty()) {
    throw_invalid_argument("profile " + profile.name,
                           "no part in two slices that follow each other",
                           "features with a part in neighbouring slices");
  }
  return sheets;
}

} // namespace wrc
