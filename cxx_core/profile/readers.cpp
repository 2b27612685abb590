#include "profile/readers.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.hpp"
#include "base/file.hpp"
#include "profile/plausibility.hpp"
#include "profile/reader_formats.hpp"
#include "profile/reader_text.hpp"
#include "profile/settling.hpp"
#include "profile/slices.hpp"
#include "profile/smoothing.hpp"
#include "profile/spline.hpp"

namespace wrc {
namespace reading {

void add_point(RawProfile& raw, const Position& point, std::size_t line, const Log& log) {
  if (raw.points.size() >= ReadLimits::max_points)
    log.refuse(line, "more than " + std::to_string(ReadLimits::max_points) + " points");
  raw.points.push_back(point);
  raw.lines.push_back(line);
}

std::size_t drop_close_points(std::vector<Position>& points, double least) {
  std::vector<Position> kept;
  for (const Position& point : points)
    if (kept.empty() || std::hypot(point[0] - kept.back()[0], point[1] - kept.back()[1]) >= least)
      kept.push_back(point);
  const std::size_t dropped = points.size() - kept.size();
  points = std::move(kept);
  return dropped;
}

void scale_points(RawProfile& raw, double lateral, double height) {
  change_points(raw, [=](const Position& p) { return Position{lateral * p[0], height * p[1]}; });
}

} // namespace reading

namespace {

using reading::Log;
using reading::RawProfile;

void check_options(const ReadOptions& options) {
  if (options.scale && (!(*options.scale > 0.0) || !std::isfinite(*options.scale)))
    throw_invalid_argument("scale", *options.scale, "a positive finite number");
  if (!(options.smoothing_wavelength >= 0.0) ||
      options.smoothing_wavelength > ReadLimits::max_length)
    throw_invalid_argument("smoothing_wavelength", options.smoothing_wavelength,
                           "0 (none) to " + text_of(ReadLimits::max_length) + " mm");
  if (!(options.least_point_distance > 0.0) || options.least_point_distance > 1.0)
    throw_invalid_argument("least_point_distance", options.least_point_distance,
                           "above 0, at most 1 mm");
  if (options.tape_offset && !(*options.tape_offset >= ReadLimits::min_tape_offset &&
                               *options.tape_offset <= ReadLimits::max_tape_offset))
    throw_invalid_argument("tape_offset", *options.tape_offset,
                           text_of(ReadLimits::min_tape_offset) + " to " +
                               text_of(ReadLimits::max_tape_offset) + " mm");
  if (options.lateral_shift && !(std::abs(*options.lateral_shift) <= ReadLimits::max_length))
    throw_invalid_argument("lateral_shift", *options.lateral_shift,
                           "-" + text_of(ReadLimits::max_length) + " to " +
                               text_of(ReadLimits::max_length) + " mm");
}

/// Smooths if requested, then joins the points. A fault there is one of the file's points.
void join(Profile& profile, const ReadOptions& options, Log& log) {
  try {
    if (options.smoothing_wavelength > 0.0) {
      profile.points = smooth_points(profile.points, options.smoothing_wavelength);
      log.note("smoothed, waves of " + text_of(options.smoothing_wavelength) + " mm are halved");
    }
    profile.curve = curve_through(profile.points);
  } catch (const Error& error) {
    log.refuse(error.what());
  }
  if (!(options.smoothing_wavelength > 0.0))
    reading::tell_scatter(profile.points, log);
  reading::check_curve(profile, log);
}

/// What the formats have in common, once their points are there; `of` says from what they are.
ReadResult complete(RawProfile& raw, std::string_view name, const std::string& of,
                    const ReadOptions& options, Log& log) {
  reading::Settled settled = reading::settle(raw, options, log);
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

RawProfile parse(std::string_view text, ProfileFormat format, Log& log) {
  switch (format) {
  case ProfileFormat::simpack:
    return reading::read_simpack(text, log);
  case ProfileFormat::miniprof:
    return reading::read_miniprof(text, log);
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
  if (options.slice < 1 || options.slice > count)
    throw Error(ErrorCode::file_malformed,
                path.string() + ": slice = " + std::to_string(options.slice) +
                    ", allowed is 1 to " + std::to_string(count) + " of its " +
                    slices_text(slices, kind) +
                    "; profiles that vary along the track are not supported");
  const Slice& chosen = slices[static_cast<std::size_t>(options.slice - 1)];
  if (type_of(chosen.file).format == ProfileFormat::slices)
    throw Error(ErrorCode::file_malformed,
                path.string() + ": a slice is itself a slices file, " + chosen.file.string());
  ReadOptions of_slice = options;
  if (!of_slice.kind)
    of_slice.kind = kind;
  ReadResult result = read_profile(chosen.file, of_slice);
  result.corrections.insert(result.corrections.begin(),
                            "slice " + std::to_string(options.slice) + " of " +
                                std::to_string(count) + ", at " + text_of(chosen.place) +
                                (kind == ProfileKind::rail ? " mm" : " rad") +
                                ", as a profile that is the same everywhere");
  return result;
}

} // namespace

ReadResult read_profile_text(std::string_view text, ProfileFormat format, std::string_view name,
                             const ReadOptions& options) {
  check_options(options);
  Log log(name, options.strict);
  if (text.size() > ReadLimits::file_bytes)
    log.refuse("larger than " + std::to_string(ReadLimits::file_bytes) + " bytes");
  if (text.empty())
    log.refuse("is empty");
  reading::refuse_foreign(text, log);
  const std::optional<std::string> other_text = reading::decoded(text);
  RawProfile raw = parse(other_text ? *other_text : text, format, log);
  ReadResult result = complete(raw, name, "file", options, log);
  result.profile.source = "file " + std::filesystem::path(name).filename().string();
  return result;
}

ReadResult read_profile(const std::filesystem::path& path, const ReadOptions& options) {
  check_options(options);
  const FileType type = type_of(path);
  ProfileFormat format = type.format;
  const std::string content = read_file(path, ReadLimits::file_bytes);
  if (format == ProfileFormat::slices)
    return read_slice(content, path, *type.kind, options);
  if (format == ProfileFormat::columns)
    format = reading::format_by_content(content).value_or(format);
  return read_profile_text(content, format, path.string(), options);
}

ReadResult profile_through(std::span<const Position> points, std::string_view name,
                           const ReadOptions& options) {
  check_options(options);
  Log log(name, options.strict);
  RawProfile raw;
  try {
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (const double coordinate : points[i])
        if (!std::isfinite(coordinate))
          log.refuse("point " + std::to_string(i) + " is not finite");
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
