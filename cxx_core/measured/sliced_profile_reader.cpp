#include "measured/sliced_profile_reader.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/error.hpp"
#include "base/file.hpp"
#include "measured/plausible_shapes.hpp"
#include "measured/profile_shape.hpp"
#include "measured/reader_formats.hpp"
#include "measured/reader_text.hpp"
#include "measured/readers.hpp"
#include "measured/slices.hpp"
#include "profile/file_type.hpp"
#include "profile/limits.hpp"
#include "profile/slice_matching.hpp"
#include "profile/smoothing.hpp"
#include "profile/spline.hpp"

namespace wrc {
namespace {

using reading::Log;
using reading::RawProfile;

RawProfile read_two_columns(std::string_view text, const Log& log) {
  RawProfile raw;
  reading::Lines lines(text, log);
  while (lines.next()) {
    const std::string row =
        reading::plain_row(lines.text().substr(0, reading::comment_of(lines.text())));
    const reading::Words words = reading::words_of(row, " ");
    if (words.count == 0) {
      continue;
    }
    if (words.count < 2) {
      log.refuse(lines.number(), "one number, a point has lateral and height");
    }
    reading::add_point(raw,
                       {reading::finite_number(words.word[0], lines.number(), log),
                        reading::finite_number(words.word[1], lines.number(), log)},
                       lines.number(), log);
  }
  return raw;
}

RawProfile read_points(const std::filesystem::path& file, const std::string& name) {
  Log log(name + " '" + file.string() + "'", false);
  const ProfileFormat format = type_of(file).format;
  if (format == ProfileFormat::slices || format == ProfileFormat::miniprof) {
    log.refuse("is no profile in columns or of Simpack, which a slice must be");
  }
  const std::string content = [&] {
    try {
      return read_file(file, ReadLimits::file_bytes);
    } catch (const Error& error) {
      throw Error(error.code(), name + ": " + error.what());
    }
  }();
  reading::refuse_foreign(content, log);
  const std::optional<std::string> other_text = reading::decoded(content);
  const std::string& text = other_text ? *other_text : content;
  const bool is_simpack = format == ProfileFormat::simpack ||
                          reading::format_by_content(text) == ProfileFormat::simpack;
  RawProfile raw = is_simpack ? reading::read_simpack(text, log) : read_two_columns(text, log);
  if (raw.points.size() < ReadLimits::min_points) {
    log.refuse(std::to_string(raw.points.size()) + " points, at least " +
               std::to_string(ReadLimits::min_points) + " are needed");
  }
  return raw;
}

double width_of(const RawProfile& raw) {
  const auto [least, greatest] =
      std::minmax_element(raw.points.begin(), raw.points.end(),
                          [](const Position& a, const Position& b) { return a[0] < b[0]; });
  return (*greatest)[0] - (*least)[0];
}

/// Sum of the least and the greatest height: below 0 if heights are upwards, since rails have
/// height 0 near their top.
double sum_of_extremes(const RawProfile& raw) {
  const auto [least, greatest] =
      std::minmax_element(raw.points.begin(), raw.points.end(),
                          [](const Position& a, const Position& b) { return a[1] < b[1]; });
  return (*least)[1] + (*greatest)[1];
}

/// Units, signs and order, the same for all slices.
class Settlement {
public:
  Settlement(SlicedProfile& profile, const ReadOptions& options)
      : profile_(profile), options_(options) {}

  void apply(std::vector<RawProfile>& all) {
    set_scale(all);
    set_height_sign(all);
    const double lateral_sign = options_.mirror_lateral.value_or(false) ? -1.0 : 1.0;
    if (lateral_sign < 0.0) {
      profile_.corrections.emplace_back("lateral mirrored as requested");
    }
    for (RawProfile& raw : all) {
      reading::scale_points(raw, lateral_sign * scale_, height_sign_ * scale_);
      if (raw.points.front()[0] > raw.points.back()[0]) {
        std::reverse(raw.points.begin(), raw.points.end());
      }
    }
  }

private:
  void set_scale(const std::vector<RawProfile>& all) {
    double width = 0.0;
    bool is_stated = true;
    for (const RawProfile& raw : all) {
      width = std::max(width, width_of(raw));
      is_stated = is_stated && raw.unit_is_stated;
    }
    if (options_.scale) {
      scale_ = *options_.scale;
    } else if (!is_stated && width < plausible::narrowest_slice) {
      scale_ = 1000.0;
    }
    if (scale_ != 1.0) {
      profile_.corrections.push_back(
          "points of all slices multiplied by " + text_of(scale_) + " to mm" +
          (options_.scale ? " as requested"
                          : ", since all are narrower than " + short_text_of(width)));
    }
  }
  void set_height_sign(const std::vector<RawProfile>& all) {
    double sum = 0.0;
    bool is_down = true; // as the format says
    for (const RawProfile& raw : all) {
      sum += sum_of_extremes(raw);
      is_down = is_down && raw.rail_height_down;
    }
    const bool is_rail = profile_.kind == ProfileKind::rail;
    const bool mirrors = options_.mirror_height.value_or(is_rail && (is_down || sum > 0.0));
    height_sign_ = mirrors ? -1.0 : 1.0;
    if (mirrors) {
      profile_.corrections.push_back(std::string("heights of all slices mirrored") +
                                     (options_.mirror_height ? " as requested"
                                      : is_down ? ", since the format has them downwards"
                                                : ", since the rails would lie above height 0"));
    }
  }

  SlicedProfile& profile_;
  const ReadOptions& options_;
  double scale_ = 1.0;
  double height_sign_ = 1.0;
};

/// The lengths along the points as arc lengths of the curve through them.
std::vector<std::optional<double>> features_of(const Slice& slice, double chords, double arc,
                                               ProfileKind kind) {
  std::vector<std::optional<double>> features = slice.features;
  for (std::optional<double>& feature : features) {
    if (feature) {
      const double share = std::min(*feature / chords, 1.0);
      feature = kind == ProfileKind::rail ? share * arc : (1.0 - share) * arc;
    }
  }
  if (kind == ProfileKind::wheel) {
    std::reverse(features.begin(), features.end());
  }
  return features;
}

ProfileSlice make_slice(const Slice& slice, RawProfile& raw, ProfileKind kind,
                        const ReadOptions& options, const Log& log) {
  const double chords = reading::chord_length(raw.points);
  if (!(chords >= ReadLimits::min_length && chords <= plausible::longest_outline)) {
    log.refuse("the points are " + short_text_of(chords) + " mm long in total, must be between " +
               text_of(ReadLimits::min_length) + " and " + text_of(plausible::longest_outline) +
               " mm");
  }
  for (const Position& point : raw.points) {
    if (!(std::max(std::abs(point[0]), std::abs(point[1])) <= ReadLimits::max_coordinate)) {
      log.refuse("a point at " + text_of(point[0]) + ", " + text_of(point[1]) + " mm, at most " +
                 text_of(ReadLimits::max_coordinate) + " mm are allowed");
    }
  }
  reading::drop_close_points(raw.points, options.least_point_distance);
  ProfileSlice result;
  result.place = slice.place;
  try {
    if (const double wavelength = options.smoothing_wavelength.value_or(0.0); wavelength > 0.0) {
      raw.points = smooth_points(raw.points, wavelength);
    }
    result.curve = curve_through(raw.points);
  } catch (const Error& error) {
    log.refuse(error.what());
  }
  result.features = features_of(slice, chords, result.curve.length(), kind);
  return result;
}

/// Those that the slices show by themselves.
void add_features(SlicedProfile& profile, const Log& log) {
  std::vector<const Curve*> curves;
  for (const ProfileSlice& slice : profile.slices) {
    curves.push_back(&slice.curve);
  }
  try {
    FoundFeatures found = find_features(curves);
    for (std::size_t i = 0; i < found.of_slices.size(); ++i) {
      profile.slices[i].features = std::move(found.of_slices[i]);
    }
    profile.corrections.insert(profile.corrections.end(), found.notes.begin(), found.notes.end());
  } catch (const Error& error) {
    log.refuse(error.what());
  }
}

} // namespace

SlicedProfile read_sliced_profile(const std::filesystem::path& path, const ReadOptions& options) {
  check_options(options);
  const Log log(path.string(), false);
  const FileType type = type_of(path);
  if (type.format != ProfileFormat::slices) {
    log.refuse("is no slices file, whose name ends in .slcs or .slcw");
  }
  const std::string content = read_file(path, ReadLimits::file_bytes);
  const std::optional<std::string> other_text = reading::decoded(content);
  const SliceList list = read_slice_list(other_text ? *other_text : content, path);
  SlicedProfile profile;
  profile.name = path.stem().string();
  profile.kind = options.kind.value_or(*type.kind);
  profile.is_smoothed = list.is_smoothed;
  const auto name_of = [&](std::size_t i) {
    return path.string() + ": slice " + std::to_string(i + 1);
  };
  std::vector<RawProfile> raw;
  std::size_t points = 0;
  std::uintmax_t bytes = 0;
  for (std::size_t i = 0; i < list.slices.size(); ++i) {
    std::error_code unreadable; // which read_points tells
    if (const auto size = std::filesystem::file_size(list.slices[i].file, unreadable);
        !unreadable) {
      bytes += size;
    }
    if (bytes > SliceLimits::file_bytes) {
      log.refuse("more than " + std::to_string(SliceLimits::file_bytes >> 20) +
                 " MB of files up to slice " + std::to_string(i + 1));
    }
    raw.push_back(read_points(list.slices[i].file, name_of(i)));
    points += raw.back().points.size();
    if (points > SliceLimits::max_points) {
      log.refuse("more than " + std::to_string(SliceLimits::max_points) + " points up to slice " +
                 std::to_string(i + 1));
    }
  }
  Settlement(profile, options).apply(raw);
  if (const double wavelength = options.smoothing_wavelength.value_or(0.0); wavelength > 0.0) {
    profile.corrections.push_back("points of all slices smoothed across: waves of " +
                                  text_of(wavelength) + " mm are halved");
  }
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const Log of_slice(name_of(i) + " '" + list.slices[i].file.string() + "'", false);
    profile.slices.push_back(make_slice(list.slices[i], raw[i], profile.kind, options, of_slice));
    raw[i] = {}; // frees its points
  }
  if (profile.slices.front().features.empty()) {
    add_features(profile, log);
  }
  return profile;
}

} // namespace wrc
