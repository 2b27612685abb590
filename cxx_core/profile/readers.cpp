#include "profile/readers.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numeric>
#include <system_error>

#include "base/error.hpp"
#include "profile/reader_formats.hpp"
#include "profile/smoothing.hpp"
#include "profile/spline.hpp"

namespace wrc {
namespace reading {

void add_point(RawProfile& raw, const Position& point, std::size_t line, const Log& log) {
  if (raw.points.size() >= ReadLimits::max_points)
    log.refuse(line, "more than " + std::to_string(ReadLimits::max_points) + " points");
  raw.points.push_back(point);
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

} // namespace reading

namespace {

using reading::Log;
using reading::RawProfile;

std::string lower_extension(std::string_view name) {
  std::string extension = std::filesystem::path(name).extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

std::string_view name_of(ProfileKind kind) {
  return kind == ProfileKind::wheel ? "wheel" : "rail";
}

double chord_length(const std::vector<Position>& points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += std::hypot(points[i][0] - points[i - 1][0], points[i][1] - points[i - 1][1]);
  return length;
}

void scale_points(std::vector<Position>& points, double lateral, double height) {
  for (Position& point : points)
    point = {lateral * point[0], height * point[1]};
}

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
}

/// Options, then content, then extension; a two-column file may say nothing.
std::optional<ProfileKind> stated_kind(const RawProfile& raw, const ReadOptions& options,
                                       Log& log) {
  const std::string extension = lower_extension(log.name());
  std::optional<ProfileKind> by_name;
  if (extension == ".prr" || extension == ".ban" || extension == ".rail")
    by_name = ProfileKind::rail;
  else if (extension == ".prw" || extension == ".whl" || extension == ".wheel")
    by_name = ProfileKind::wheel;
  const std::optional<ProfileKind> by_content = raw.kind ? raw.kind : by_name;
  if (raw.kind && by_name && *raw.kind != *by_name)
    log.note("the header says " + std::string(name_of(*raw.kind)) + ", the extension " +
             std::string(name_of(*by_name)) + "; the header counts");
  if (options.kind && by_content && *options.kind != *by_content)
    log.note("read as a " + std::string(name_of(*options.kind)) + " as asked; the file says " +
             std::string(name_of(*by_content)));
  return options.kind ? options.kind : by_content;
}

void settle_units(std::vector<Position>& points, const ReadOptions& options, Log& log) {
  const auto is_allowed = [](double length) {
    return length >= ReadLimits::min_length && length <= ReadLimits::max_length;
  };
  if (options.scale && *options.scale != 1.0) {
    scale_points(points, *options.scale, *options.scale);
    log.note("multiplied by " + text_of(*options.scale) + " to mm as asked");
  }
  const double length = chord_length(points);
  if (!is_allowed(length)) {
    double guess = 1.0;
    for (const double factor : {1000.0, 0.001})
      if (!options.scale && is_allowed(factor * length))
        guess = factor;
    if (guess == 1.0)
      log.refuse("the points are " + text_of(length) + " mm long in all, allowed are " +
                 text_of(ReadLimits::min_length) + " to " + text_of(ReadLimits::max_length) +
                 " mm");
    log.guess("multiplied by " + text_of(guess) + ", since the points are " + text_of(length) +
                  " long in all and 5 to 500 mm are allowed",
              "state the scale");
    scale_points(points, guess, guess);
  }
  for (const Position& point : points)
    if (!(std::max(std::abs(point[0]), std::abs(point[1])) <= ReadLimits::max_coordinate))
      log.refuse("point (" + text_of(point[0]) + ", " + text_of(point[1]) + "), at most " +
                 text_of(ReadLimits::max_coordinate) + " mm are allowed");
}

/// Area between the points and the line from the first to the last, positive if the points are
/// above it when they run to positive lateral.
double bulge(const std::vector<Position>& points) {
  const Position& origin = points.front();
  double twice = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
    twice += (points[i - 1][1] - origin[1]) * (points[i][0] - origin[0]) -
             (points[i - 1][0] - origin[0]) * (points[i][1] - origin[1]);
  return points.back()[0] >= origin[0] ? 0.5 * twice : -0.5 * twice;
}

/// A rail's ends are both on one side of its middle, a wheel's on either.
ProfileKind kind_by_shape(const std::vector<Position>& points) {
  const double middle = points[points.size() / 2][1];
  return (points.front()[1] - middle) * (points.back()[1] - middle) > 0.0 ? ProfileKind::rail
                                                                          : ProfileKind::wheel;
}

/// The flange tip stands out from the median height further than anything on the other side.
bool flange_is_down(const std::vector<Position>& points) {
  std::vector<double> height;
  height.reserve(points.size());
  for (const Position& point : points)
    height.push_back(point[1]);
  const auto middle = height.begin() + static_cast<std::ptrdiff_t>(height.size() / 2);
  std::nth_element(height.begin(), middle, height.end());
  const double median = *middle;
  const auto [lowest, highest] = std::minmax_element(height.begin(), height.end());
  return median - *lowest > *highest - median;
}

bool flange_is_outside(const std::vector<Position>& points) {
  const auto by_lateral = [](const Position& a, const Position& b) { return a[0] < b[0]; };
  const auto by_height = [](const Position& a, const Position& b) { return a[1] < b[1]; };
  const auto [left, right] = std::minmax_element(points.begin(), points.end(), by_lateral);
  const Position tip = *std::max_element(points.begin(), points.end(), by_height);
  return tip[0] > 0.5 * ((*left)[0] + (*right)[0]);
}

/// Step 1: what the format defines.
void turn_to_frame(RawProfile& raw, ProfileKind kind, Log& log) {
  if (raw.lateral_towards_gauge) {
    scale_points(raw.points, -1.0, 1.0);
    log.note("lateral mirrored, the format counts it towards the gauge side");
  }
  if (kind == ProfileKind::rail ? raw.rail_height_down : raw.wheel_height_up) {
    scale_points(raw.points, 1.0, -1.0);
    log.note(kind == ProfileKind::rail
                 ? "height mirrored, the format counts a rail's height downwards"
                 : "height mirrored, the format counts a wheel's height upwards in the track");
  }
}

/// Step 3: the signs that were asked for, or else those that the shape shows.
void orient(std::vector<Position>& points, ProfileKind kind, const ReadOptions& options, Log& log) {
  if (options.mirror_height) {
    if (*options.mirror_height) {
      scale_points(points, 1.0, -1.0);
      log.note("height mirrored as asked");
    }
  } else if (kind == ProfileKind::rail ? bulge(points) < 0.0 : flange_is_down(points)) {
    scale_points(points, 1.0, -1.0);
    log.guess(kind == ProfileKind::rail ? "height mirrored, since the rail head bulged down"
                                        : "height mirrored, since the flange pointed down",
              "state mirror_height");
  }
  if (options.mirror_lateral) {
    if (*options.mirror_lateral) {
      scale_points(points, -1.0, 1.0);
      log.note("lateral mirrored as asked");
    }
  } else if (kind == ProfileKind::wheel && flange_is_outside(points)) {
    scale_points(points, -1.0, 1.0);
    log.guess("lateral mirrored, since the flange was on the positive side",
              "state mirror_lateral");
  }
}

std::vector<Position> settle_points(RawProfile& raw, ProfileKind& kind, const ReadOptions& options,
                                    Log& log) {
  const std::optional<ProfileKind> stated = stated_kind(raw, options, log);
  std::vector<Position>& points = raw.points;
  if (points.size() < ReadLimits::min_points)
    log.refuse(std::to_string(points.size()) + " points, at least " +
               std::to_string(ReadLimits::min_points) + " are needed");
  settle_units(points, options, log);
  if (const std::size_t dropped = reading::drop_close_points(points, options.least_point_distance))
    log.note(std::to_string(dropped) + " points closer than " +
             text_of(options.least_point_distance) + " mm to the one before dropped");
  if (points.size() < ReadLimits::min_points)
    log.refuse(std::to_string(points.size()) + " different points, at least " +
               std::to_string(ReadLimits::min_points) + " are needed");
  kind = stated ? *stated : kind_by_shape(points);
  if (!stated)
    log.guess("taken for a " + std::string(name_of(kind)) + " by its shape", "state the kind");
  turn_to_frame(raw, kind, log);
  orient(points, kind, options, log);
  if (points.front()[0] > points.back()[0]) {
    std::reverse(points.begin(), points.end());
    log.note("order reversed, to run from the flange or gauge side to the field side");
  }
  return std::move(points);
}

/// Smooths if asked to, then joins the points. A fault there is one of the file's points.
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
}

/// What the formats have in common, once their points are there.
ReadResult complete(RawProfile& raw, std::string_view name, const ReadOptions& options, Log& log) {
  Profile profile;
  profile.points = settle_points(raw, profile.kind, options, log);
  profile.name = std::filesystem::path(name).stem().string();
  profile.title = raw.title.empty() ? profile.name : raw.title;
  join(profile, options, log);
  return {std::move(profile), std::move(log.corrections())};
}

RawProfile parse(std::string_view text, ProfileFormat format, Log& log) {
  switch (format) {
  case ProfileFormat::simpack:
    return reading::read_simpack(text, log);
  case ProfileFormat::miniprof:
    return reading::read_miniprof(text, log);
  case ProfileFormat::columns:
    break;
  }
  return reading::read_columns(text, log);
}

[[noreturn]] void refuse_file(const std::filesystem::path& path, const std::string& text) {
  throw Error(ErrorCode::file_unreadable, path.string() + ": " + text);
}

std::string content_of(const std::filesystem::path& path) {
  std::error_code fault;
  if (!std::filesystem::exists(path, fault))
    refuse_file(path, "no such file");
  // Devices and pipes could deliver without end.
  if (!std::filesystem::is_regular_file(path, fault))
    refuse_file(path, "is not a regular file");
  const auto size = std::filesystem::file_size(path, fault);
  std::ifstream stream(path, std::ios::binary);
  if (fault || !stream)
    refuse_file(path, "cannot be opened");
  std::string content;
  std::vector<char> block(std::size_t{1} << 16);
  if (size <= ReadLimits::file_bytes)
    content.reserve(size + block.size());
  // The file may be longer than it says: those of the system have no size, others still grow.
  while (size <= ReadLimits::file_bytes && content.size() <= ReadLimits::file_bytes && stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    content.append(block.data(), static_cast<std::size_t>(stream.gcount()));
  }
  if (size > ReadLimits::file_bytes || content.size() > ReadLimits::file_bytes)
    refuse_file(path, "is larger than " + std::to_string(ReadLimits::file_bytes) +
                          " bytes, which is the most allowed");
  if (stream.bad())
    refuse_file(path, "cannot be read");
  return content;
}

} // namespace

ProfileFormat format_of(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path.string());
  if (extension == ".prr" || extension == ".prw")
    return ProfileFormat::simpack;
  if (extension == ".ban" || extension == ".whl")
    return ProfileFormat::miniprof;
  if (extension == ".slcs" || extension == ".slcw")
    throw Error(ErrorCode::file_malformed,
                path.string() + ": slices of a profile that varies are not supported, use one of "
                                "the constant profiles they name");
  return ProfileFormat::columns;
}

ReadResult read_profile_text(std::string_view text, ProfileFormat format, std::string_view name,
                             const ReadOptions& options) {
  check_options(options);
  Log log(name, options.strict);
  if (text.size() > ReadLimits::file_bytes)
    log.refuse("larger than " + std::to_string(ReadLimits::file_bytes) + " bytes");
  if (text.empty())
    log.refuse("is empty");
  RawProfile raw = parse(text, format, log);
  ReadResult result = complete(raw, name, options, log);
  result.profile.source = "file " + std::filesystem::path(name).filename().string();
  result.profile.confidence = "as the file";
  return result;
}

ReadResult read_profile(const std::filesystem::path& path, const ReadOptions& options) {
  check_options(options);
  const ProfileFormat format = format_of(path);
  return read_profile_text(content_of(path), format, path.string(), options);
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
    ReadResult result = complete(raw, name, options, log);
    result.profile.source = "points given by the program";
    result.profile.confidence = "as the points";
    return result;
  } catch (const Error& error) { // of a file that is none
    throw Error(ErrorCode::invalid_argument, error.what());
  }
}

} // namespace wrc
