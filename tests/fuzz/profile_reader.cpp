// Any text as a profile file: it is read or refused with a text that names it, without a crash, a
// hang or memory without bound; strict reading takes nothing that reading by guesses does not, and
// gives the same then. What is accepted has the extent of a wheel or a rail, or a warning; nothing
// accepted in strict mode has one. One executable for each format, FUZZED_FORMAT. The first byte
// selects the options, the rest is the file.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "measured/readers.hpp"

namespace {

using enum wrc::ProfileFormat;
constexpr wrc::ProfileFormat format = FUZZED_FORMAT;
constexpr std::string_view wheel_name = format == simpack    ? "a.prw"
                                        : format == miniprof ? "a.whl"
                                                             : "a.txt";
constexpr std::string_view rail_name = format == simpack    ? "a.prr"
                                       : format == miniprof ? "a.ban"
                                                            : "a.rail";

wrc::ReadOptions options_from(std::uint8_t bits) {
  wrc::ReadOptions options;
  if ((bits & 1U) != 0) {
    options.kind = (bits & 2U) != 0 ? wrc::ProfileKind::rail : wrc::ProfileKind::wheel;
  }
  if ((bits & 4U) != 0) {
    options.smoothing_wavelength = 2.0; // mm
  }
  if ((bits & 32U) != 0) {
    options.mirror_lateral = (bits & 2U) != 0;
    options.mirror_height = (bits & 16U) != 0;
    options.origin = static_cast<wrc::WheelOrigin>((bits & 12U) % 3U);
  }
  if ((bits & 64U) != 0) {
    options.scale = (bits & 128U) != 0 ? 1e-3 : 25.4;
  }
  if ((bits & 128U) != 0) {
    options.slice = 1;
  }
  if ((bits & 192U) == 192U) {
    options.align_to = (bits & 2U) != 0 ? "60E1" : "S1002";
    options.rotation = 0.01;
  }
  return options;
}

void demand(bool promise) {
  if (!promise) {
    __builtin_trap();
  }
}

/// Whether points lie on the circle through the first, the middle and the last one, of any width.
bool is_disc(const std::vector<wrc::Position>& points) {
  const wrc::Position& a = points.front();
  const wrc::Position& c = points.back();
  const double chord = std::hypot(c[0] - a[0], c[1] - a[1]);
  double least = 0.0;
  double greatest = 0.0;
  for (const wrc::Position& point : points) {
    const double along =
        ((point[0] - a[0]) * (c[0] - a[0]) + (point[1] - a[1]) * (c[1] - a[1])) / chord;
    const double off =
        ((point[1] - a[1]) * (c[0] - a[0]) - (point[0] - a[0]) * (c[1] - a[1])) / chord;
    // Of the products of intersecting chords; the rest is the circle's second height.
    if (along > 0.25 * chord && along < 0.75 * chord) {
      const double bulge = off * chord * chord / (4.0 * along * (chord - along));
      least = least == 0.0 ? bulge : std::min(least, bulge);
      greatest = greatest == 0.0 ? bulge : std::max(greatest, bulge);
    }
  }
  return greatest - least <= 0.2 + 0.5 * std::max(std::abs(least), std::abs(greatest));
}

/// Extents of wheels and rails, in numbers of their own: those of plausibility.cpp are on trial.
bool is_plausible(const wrc::Profile& profile, const std::vector<wrc::Position>& points) {
  wrc::Position least = points.front();
  wrc::Position greatest = points.front();
  for (const wrc::Position& point : points) {
    for (std::size_t i = 0; i < 2; ++i) {
      least[i] = std::min(least[i], point[i]);
      greatest[i] = std::max(greatest[i], point[i]);
    }
  }
  const double width = greatest[0] - least[0];
  const double height = greatest[1] - least[1];
  const bool is_wheel = profile.kind == wrc::ProfileKind::wheel;
  return width >= 50.0 && width <= 200.0 &&
         (is_wheel ? least[0] <= -20.0 && greatest[0] >= 20.0 && height >= 18.0 && height <= 80.0
                   : std::abs(greatest[1]) <= 5.0);
}

void check(const wrc::ReadResult& read) {
  const wrc::Profile& profile = read.profile;
  demand(is_plausible(profile, read.measured) || is_disc(read.measured) ||
         !read.profile.warnings.empty());
  const double length = profile.curve.length();
  demand(std::isfinite(length) && length > 0.0);
  for (const double share : {0.0, 0.3, 0.7, 1.0}) {
    const wrc::CurvePoint at = profile.curve.at(share * length);
    demand(std::isfinite(at.lateral) && std::isfinite(at.height) && std::isfinite(at.curvature()));
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) {
    return 0;
  }
  wrc::ReadOptions options = options_from(data[0]);
  const std::string_view name = (data[0] & 16U) != 0 ? rail_name : wheel_name;
  const std::string_view text(reinterpret_cast<const char*>(data + 1), size - 1);
  bool is_read = false;
  wrc::ReadResult read;
  try {
    read = wrc::read_profile_text(text, format, name, options);
    is_read = true;
    check(read);
  } catch (const wrc::Error& error) {
    demand(error.code() == wrc::ErrorCode::file_malformed);
    demand(std::string_view(error.what()).starts_with(name));
  }
  if ((data[0] & 8U) == 0) {
    return 0;
  }
  options.strict = true;
  try {
    const wrc::ReadResult strict = wrc::read_profile_text(text, format, name, options);
    demand(is_read && strict.profile.points == read.profile.points &&
           strict.corrections == read.corrections &&
           strict.profile.warnings == read.profile.warnings &&
           std::all_of(read.profile.warnings.begin(), read.profile.warnings.end(),
                       [](const wrc::Warning& warning) {
                         return warning.kind == wrc::WarningClass::profile_noise;
                       }));
  } catch (const wrc::Error& error) {
    demand(error.code() == wrc::ErrorCode::file_malformed);
  }
  return 0;
}
