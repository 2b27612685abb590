#include "measured/readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/file.hpp"
#include "measured/constants.hpp"
#include "measured/noise_removal.hpp"
#include "measured/plausibility.hpp"
#include "measured/plausible_shapes.hpp"
#include "measured/profile_shape.hpp"
#include "measured/reader_formats.hpp"
#include "measured/reader_text.hpp"
#include "measured/settling.hpp"
#include "measured/slices.hpp"
#include "profile/limits.hpp"
#include "profile/smoothing.hpp"
#include "profile/spline.hpp"

namespace wrc {
namespace reading {

void add_point(RawProfile& raw, const Position& point, std::size_t line, const Log& log) {
  if (raw.points.size() >= ReadLimits::max_points) {
    log.refuse(line, "more than " + std::to_string(ReadLimits::max_points) + " points");
  }
  raw.points.push_back(point);
  raw.lines.push_back(line);
}

void note_gaps(const LineCount& gaps, Log& log) {
  if (gaps.count > 0) {
    log.note(gaps.text("rows without lateral or height skipped as gaps"));
  }
}

void scale_points(RawProfile& raw, double lateral, double height) {
  change_points(raw, [=](const Position& p) { return Position{lateral * p[0], height * p[1]}; });
}

} // namespace reading

namespace {

using reading::Log;
using reading::RawProfile;

std::string waves_text(const NoiseRemoval& clean) {
  return "waves of " + reading::fixed_text(clean.short_wave, 1) +
         " mm (where curvatures change fast) to " + reading::fixed_text(clean.long_wave, 1) + " mm";
}

std::string scatter_text(const reading::Scatter& scatter) {
  return "the points scatter by " + short_text_of(scatter.deviation) +
         " mm (rms) about a smooth line, which takes about " +
         reading::fixed_text(scatter.pressure, 0) + " MPa to flatten";
}

/// The lines as curves, without those that a curve cannot join.
std::vector<Curve> curves_through(const std::vector<std::vector<Position>>& lines) {
  std::vector<Curve> curves;
  for (const std::vector<Position>& line : lines) {
    try {
      curves.push_back(curve_through(line));
    } catch (const Error&) { // has a cusp, at an end whose points are far apart
    }
  }
  return curves;
}

/// The points with each of the smoothed_waves halved; none if it cannot be.
std::vector<Curve> smoothed_curves(std::span<const Position> points) {
  std::vector<Curve> curves;
  try {
    curves.push_back(curve_through(points));
    for (const double wavelength : std::span(smoothed_waves).subspan(1)) {
      curves.push_back(curve_through(smooth_points(points, wavelength)));
    }
  } catch (const Error&) {
    curves.clear();
  }
  return curves;
}

/// None of points that are too far apart to tell, or no line, which join() then refuses or
/// check_curve() reports.
std::optional<NoiseRemoval> noise_removed_from(std::span<const Position> points) {
  if (reading::median_spacing(points) > scatter_spacing) {
    return std::nullopt;
  }
  try {
    NoiseRemoval clean = remove_noise(points);
    static_cast<void>(curve_through(clean.points)); // that it can be joined
    return clean;
  } catch (const Error&) {
    return std::nullopt;
  }
}

/// Replaces the points by the line that their noise leaves.
void smooth_by_noise(Profile& profile, const NoiseRemoval& clean, bool stated, Log& log) {
  profile.points = clean.points;
  if (clean.lone_ends > 0) {
    log.note("points left out at the ends, far from the others: " +
             std::to_string(clean.lone_ends));
  }
  const std::string text = "smoothed automatically: " + waves_text(clean) + " are halved";
  if (stated || clean.long_wave < plausible::shape_wave) {
    log.note(text);
  } else {
    log.guess(text, "state the smoothing: \"auto\", a wavelength in mm or 0");
  }
}

/// What the noise leaves uncertain, with or without a smoothing of the caller's own.
void report_noise(const reading::Scatter& scatter, const NoiseRemoval* clean, double wavelength,
                  Log& log) {
  std::string text = scatter_text(scatter);
  if (wavelength == 0.0 || (clean == nullptr && wavelength < 0.0)) {
    text += ": not smoothed, pressures are those of the scatter";
  } else if (clean == nullptr) {
    text += ": the waves that it needs to be halved are unknown, smoothing halves " +
            text_of(wavelength) + " mm";
  } else if (wavelength == automatic_smoothing) {
    text += ": smoothed automatically, " + waves_text(*clean) +
            " are halved; spread.pmax is what remains uncertain";
  } else if (wavelength < wavelength_share * clean->long_wave) {
    text += ": its noise needs " + waves_text(*clean) + " to be halved, smoothing halves " +
            text_of(wavelength) + " mm; spread.pmax is what remains uncertain";
  } else {
    return;
  }
  log.advise(WarningClass::profile_noise, text);
}

/// The scatter without waves in which several neighbouring points agree: these are not noise.
reading::Scatter scatter_without_waves(std::span<const Position> points,
                                       const reading::Scatter& scatter,
                                       const std::optional<NoiseRemoval>& clean) {
  return clean && (clean->distance > 0.0 || scatter.matters())
             ? reading::scatter_of(points, clean->deviation, clean->distance)
             : scatter;
}

/// What the points leave open; without likely curves if that is not known.
ProfileDoubt doubt_of(std::span<const Position> points, const Curve& curve,
                      const std::optional<NoiseRemoval>& clean) {
  if (!clean) {
    return {curve, {}, {}, false};
  }
  const reading::Scatter scatter =
      scatter_without_waves(points, reading::scatter_of(points), clean);
  const bool is_white = scatter.matters() && clean->distance == 0.0;
  return {curve, curves_through(clean->likely), smoothed_curves(points), !is_white};
}

/// Smooths if requested or needed, then joins the points. A fault there is one of the file's
/// points.
void join(Profile& profile, const ReadOptions& options, Log& log) {
  const double wavelength = options.smoothing_wavelength.value_or(automatic_smoothing);
  reading::Scatter scatter = reading::scatter_of(profile.points);
  try {
    const std::vector<Position> points = profile.points;
    std::optional<NoiseRemoval> clean;
    if (wavelength != 0.0) {
      clean = noise_removed_from(points);
      scatter = scatter_without_waves(points, scatter, clean);
    }
    if (wavelength > 0.0) {
      profile.points = smooth_points(profile.points, wavelength);
      log.note("smoothed, waves of " + text_of(wavelength) + " mm are halved");
    } else if (clean && scatter.matters()) {
      smooth_by_noise(profile, *clean, options.smoothing_wavelength.has_value(), log);
    }
    if (scatter.matters()) {
      report_noise(scatter, clean ? &*clean : nullptr, wavelength, log);
    }
    profile.curve = curve_through(profile.points);
    const bool is_fitted = wavelength != 0.0;
    profile.doubt = Deferred<ProfileDoubt>([=, curve = profile.curve] {
      return doubt_of(points, curve, is_fitted ? clean : noise_removed_from(points));
    });
  } catch (const Error& error) {
    log.refuse(error.what());
  }
  reading::check_curve(profile, log);
}

/// The profile to which the points are aligned, if any.
std::optional<Profile> nominal_of(const ReadOptions& options, const Log& log) {
  const std::string& name = options.align_to;
  if (name.empty()) {
    return std::nullopt;
  }
  for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail}) {
    if (!standard_name(name, kind).empty()) {
      return standard_profile(name);
    }
  }
  ReadOptions plain;
  plain.kind = options.kind;
  try {
    return read_profile(name, plain).profile;
  } catch (const Error& error) {
    log.refuse("align_to = " + name + ", must be a built-in profile or a file: " + error.what());
  }
}

/// What the formats have in common, once their points are there; `of` says from what they are.
ReadResult complete(RawProfile& raw, std::string_view name, const std::string& of,
                    const ReadOptions& options, Log& log) {
  const std::optional<Profile> nominal = nominal_of(options, log);
  reading::Settled settled = reading::settle(raw, options, log, nominal ? &*nominal : nullptr);
  ReadResult result;
  Profile& profile = result.profile;
  profile.kind = settled.kind;
  profile.points = settled.points;
  profile.name = std::filesystem::path(name).stem().string();
  profile.title = raw.title.empty() ? profile.name : raw.title;
  join(profile, options, log);
  result.measured = std::move(settled.points);
  result.dropped = std::move(settled.dropped);
  result.corrections = std::move(log.corrections());
  profile.confidence = log.guesses() == 0 ? "as the " + of
                       : log.guesses() == 1
                           ? "as the " + of + ", except for one guess (corrected)"
                           : "as the " + of + ", except for " + std::to_string(log.guesses()) +
                                 " guesses (corrected)";
  profile.warnings = std::move(log.warnings());
  return result;
}

RawProfile parse(std::string_view text, ProfileFormat format, const ReadOptions& options,
                 Log& log) {
  if (format != ProfileFormat::miniprof) {
    log.refuse_slice(options.slice);
  }
  switch (format) {
  case ProfileFormat::simpack:
    return reading::read_simpack(text, log);
  case ProfileFormat::miniprof:
    return reading::read_miniprof(text, options.slice, log);
  case ProfileFormat::columns:
  case ProfileFormat::slices: // are a list of other files
    break;
  }
  return reading::read_columns(text, log);
}

/// One profile of a slices file.
ReadResult read_slice(const std::string& content, const std::filesystem::path& path,
                      ProfileKind kind, const ReadOptions& options) {
  const std::optional<std::string> other_text = reading::decoded(content);
  const std::vector<Slice> slices = read_slices(other_text ? *other_text : content, path);
  const auto count = static_cast<int>(slices.size());
  if (options.slice < 1 || options.slice > count) {
    throw Error(ErrorCode::file_malformed,
                path.string() + ": slice = " + std::to_string(options.slice) +
                    ", must be between 1 and " + std::to_string(count) + " of its " +
                    slices_text(slices, kind) +
                    "; one profile is read here. All slices together are a rail or a wheel of a "
                    "scene (track.rail, "
                    "wheelset.wheel); wrc_profile FILE --slice N --convert writes one of them");
  }
  const Slice& chosen = slices[static_cast<std::size_t>(options.slice - 1)];
  if (type_of(chosen.file).format == ProfileFormat::slices) {
    throw Error(ErrorCode::file_malformed,
                path.string() + ": a slice is itself a slices file, " + chosen.file.string());
  }
  ReadOptions of_slice = options;
  of_slice.slice = 0;
  if (!of_slice.kind) {
    of_slice.kind = kind;
  }
  ReadResult result = read_profile(chosen.file, of_slice);
  result.corrections.insert(result.corrections.begin(),
                            "slice " + std::to_string(options.slice) + " of " +
                                std::to_string(count) + ", at " + text_of(chosen.place) +
                                (kind == ProfileKind::rail ? " mm" : " rad") +
                                ", as a profile that is the same everywhere");
  return result;
}

} // namespace

void check_options(const ReadOptions& options) {
  if (options.scale && (!(*options.scale > 0.0) || !std::isfinite(*options.scale))) {
    throw_invalid_argument("scale", *options.scale, "must be a positive finite number");
  }
  const double wavelength = options.smoothing_wavelength.value_or(automatic_smoothing);
  if (wavelength != automatic_smoothing &&
      !(wavelength >= 0.0 && wavelength <= ReadLimits::max_length)) {
    throw_invalid_argument("smoothing_wavelength", wavelength,
                           "must be automatic, or 0 (none) to " + text_of(ReadLimits::max_length) +
                               " mm");
  }
  if (!(options.least_point_distance > 0.0) || options.least_point_distance > 1.0) {
    throw_invalid_argument("least_point_distance", options.least_point_distance,
                           "must be above 0 and at most 1 mm");
  }
  if (options.tape_offset && !(*options.tape_offset >= ReadLimits::min_tape_offset &&
                               *options.tape_offset <= ReadLimits::max_tape_offset)) {
    throw_invalid_argument("tape_offset", *options.tape_offset,
                           "must be between " + text_of(ReadLimits::min_tape_offset) + " and " +
                               text_of(ReadLimits::max_tape_offset) + " mm");
  }
  if (options.rotation && !(std::abs(*options.rotation) <= ReadLimits::max_rotation)) {
    throw_invalid_argument("rotation", *options.rotation,
                           "must be between -" + text_of(ReadLimits::max_rotation) + " and " +
                               text_of(ReadLimits::max_rotation) + " rad");
  }
  if (options.lateral_shift && !(std::abs(*options.lateral_shift) <= ReadLimits::max_length)) {
    throw_invalid_argument("lateral_shift", *options.lateral_shift,
                           "must be between -" + text_of(ReadLimits::max_length) + " and " +
                               text_of(ReadLimits::max_length) + " mm");
  }
}

ReadResult read_profile_text(std::string_view text, ProfileFormat format, std::string_view name,
                             const ReadOptions& options) {
  check_options(options);
  Log log(name, options.strict);
  if (text.size() > ReadLimits::file_bytes) {
    log.refuse("larger than " + std::to_string(ReadLimits::file_bytes) + " bytes");
  }
  if (text.empty()) {
    log.refuse("is empty");
  }
  reading::refuse_foreign(text, log);
  const std::optional<std::string> other_text = reading::decoded(text);
  RawProfile raw = parse(other_text ? *other_text : text, format, options, log);
  ReadResult result = complete(raw, name, "file", options, log);
  result.profile.source = "file " + std::filesystem::path(name).filename().string();
  return result;
}

ReadResult read_profile(const std::filesystem::path& path, const ReadOptions& options) {
  check_options(options);
  const FileType type = type_of(path);
  ProfileFormat format = type.format;
  const std::string content = read_file(path, ReadLimits::file_bytes);
  if (format == ProfileFormat::slices) {
    return read_slice(content, path, *type.kind, options);
  }
  if (format == ProfileFormat::columns) {
    format = reading::format_by_content(content).value_or(format);
  }
  return read_profile_text(content, format, path.string(), options);
}

ReadResult profile_through(std::span<const Position> points, std::string_view name,
                           const ReadOptions& options) {
  check_options(options);
  Log log(name, options.strict);
  RawProfile raw;
  try {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const std::size_t coordinate : {std::size_t{0}, std::size_t{1}}) {
        if (const double value = points[i][coordinate]; !std::isfinite(value)) {
          log.refuse("point " + std::to_string(i) + ": " +
                     (coordinate == 0 ? "lateral" : "height") + " = " + text_of(value) +
                     ", must be finite");
        }
      }
      reading::add_point(raw, points[i], i, log);
    }
    raw.lines.clear();
    ReadResult result = complete(raw, name, "points", options, log);
    result.profile.source = "points given by the program";
    return result;
  } catch (const Error& error) { // of a file that is none
    throw Error(ErrorCode::invalid_argument, error.what());
  }
}

} // namespace wrc
