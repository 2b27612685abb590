#include "scene/surface_cache.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <sys/stat.h>
#include <utility>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "geometry/along_check.hpp"
#include "geometry/constants.hpp"
#include "keys/profile_text.hpp"
#include "measured/readers.hpp"
#include "measured/sliced_profile_reader.hpp"
#include "scene/constants.hpp"

namespace wrc {
namespace {

[[noreturn]] void refuse_name(const std::string& key, const std::string& name, ProfileKind kind,
                              const Error& error) {
  std::string text = key + " = \"" + name + "\": ";
  if (is_sliced(ProfileChoice{name})) { // built-in names would not help
    throw Error(ErrorCode::unknown_name, text + error.what());
  }
  text += "must be a profile file or one of";
  for (const auto known : standard_profile_names(kind)) {
    text += ' ';
    text += known;
  }
  const bool is_wheel = kind == ProfileKind::wheel;
  const bool is_other =
      !standard_name(name, is_wheel ? ProfileKind::rail : ProfileKind::wheel).empty();
  const std::string reason =
      is_other ? name + " is a built-in " + (is_wheel ? "rail" : "wheel") : error.what();
  throw Error(ErrorCode::unknown_name, text + " (" + reason + ")");
}

/// Of a wheel.
double radius_of(const WheelsetDimensions& wheelset) {
  return wheelset.radius;
}
double radius_of(const TrackDimensions&) {
  return 1.0; // rails have no waves
}

/// What the file is read with besides the choice: of a wheel, where the scene has its taping line.
void set_tape_offset(ReadOptions& options, const WheelsetDimensions& wheelset) {
  options.tape_offset = wheelset.tape_offset;
}
void set_tape_offset(ReadOptions&, const TrackDimensions&) {}

Profile read_file(const ProfileChoice& choice, const ReadOptions& options, ProfileKind kind,
                  const std::string& key, std::vector<std::string>& corrections) {
  const std::string& name = choice.name;
  try {
    ReadResult read = read_profile(name, options);
    for (const std::string& line : read.corrections) {
      corrections.push_back(name);
      corrections.back().append(": ").append(line);
    }
    return std::move(read.profile);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::file_malformed) {
      throw Error(error.code(), key + ": " + error.what());
    }
    if (error.code() != ErrorCode::file_unreadable) {
      throw;
    }
    refuse_name(key, name, kind, error);
  }
}

Profile profile_of(const SlicedProfile& sliced) {
  Profile profile;
  profile.name = sliced.name;
  profile.kind = sliced.kind;
  profile.curve = sliced.slices.front().curve;
  return profile;
}

std::shared_ptr<const RailSurface> surface_of(const SlicedProfile& sliced,
                                              const SurfaceSource<TrackDimensions>& source,
                                              Warnings& warnings) {
  auto slices = sliced_rail(sliced, source.profile.options.smoothing_along);
  warnings = warnings_of(check_along(sliced, slices->sheets()), ProfileKind::rail);
  return std::make_shared<const RailSurface>(std::move(slices), sliced.slices.front().curve,
                                             source.dimensions);
}

std::shared_ptr<const WheelSurface> surface_of(const SlicedProfile& sliced,
                                               const SurfaceSource<WheelsetDimensions>& source,
                                               Warnings& warnings) {
  const double radius = source.dimensions.radius;
  auto slices = sliced_wheel(sliced, radius, source.profile.harmonics,
                             source.profile.options.smoothing_along);
  warnings = warnings_of(check_along(sliced, slices->sheets(), {"mm", radius}), ProfileKind::wheel);
  return std::make_shared<const WheelSurface>(std::move(slices), source.dimensions, 0.0);
}

std::shared_ptr<const RailSurface> surface_of(const Profile& profile,
                                              const SurfaceSource<TrackDimensions>& source) {
  return std::make_shared<const RailSurface>(profile, source.dimensions);
}

std::shared_ptr<const WheelSurface> surface_of(const Profile& profile,
                                               const SurfaceSource<WheelsetDimensions>& source) {
  if (source.profile.harmonics.empty()) {
    return std::make_shared<const WheelSurface>(profile, source.dimensions);
  }
  return std::make_shared<const WheelSurface>(sliced_wheel(profile.curve.without_steps(),
                                                           source.dimensions.radius,
                                                           source.profile.harmonics),
                                              source.dimensions, 0.0);
}

/// Throws for what slices cannot be read with.
void check_slices(const ProfileChoice& choice, ProfileKind kind, const std::string& key) {
  const char last = choice.name.back();
  if ((last == 's' || last == 'S') != (kind == ProfileKind::rail)) {
    throw_invalid_argument(key, choice.name,
                           kind == ProfileKind::rail
                               ? "these are slices of a wheel; they must be of a rail, .slcs"
                               : "these are slices of a rail; they must be of a wheel, .slcw");
  }
  if (choice.options.placement != ProfilePlacement{}) {
    throw_invalid_argument(key, '"' + profile_text(choice, {}) + '"',
                           "must have no origin, shift, rotation or align_to: slices are where "
                           "their list has them");
  }
}

void check_waves(const std::vector<RadiusHarmonic>& waves, double radius) {
  for (const RadiusHarmonic& wave : waves) {
    const double length = 2.0 * std::numbers::pi * radius / wave.order;
    if (!(length >= shortest_wheel_wave)) {
      throw Error(ErrorCode::invalid_argument, "wheelset.harmonics: order " + text_of(wave.order) +
                                                   " gives waves of " + short_text_of(length) +
                                                   " mm; they must be at least " +
                                                   short_text_of(shortest_wheel_wave) + " mm long");
    }
    if (const double slope = std::abs(wave.amplitude) * wave.order / radius;
        !(slope <= steepest_along)) {
      throw_invalid_argument("amplitude in wheelset.harmonics", wave.amplitude,
                             "order times amplitude over radius must be at most " +
                                 short_text_of(steepest_along) + ", not " + short_text_of(slope));
    }
  }
}

/// From the slices of a file; of equal ones that of their profile.
template <class Surface, class Dimensions>
std::shared_ptr<const Surface>
surface_of_slices(const SurfaceSource<Dimensions>& source, ProfileKind kind, const std::string& key,
                  std::vector<std::string>& corrections, Warnings& warnings) {
  const std::string& name = source.profile.name;
  check_slices(source.profile, kind, key);
  ReadOptions options;
  options.kind = kind;
  options.smoothing_wavelength = source.profile.options.smoothing.value_or(automatic_smoothing);
  try {
    const SlicedProfile sliced = read_sliced_profile(name, options);
    for (const std::string& line : sliced.corrections) {
      corrections.push_back(name);
      corrections.back().append(": ").append(line);
    }
    if (has_equal_slices(sliced)) {
      return surface_of(profile_of(sliced), source);
    }
    return surface_of(sliced, source, warnings);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::file_unreadable) {
      throw Error(error.code(), key + " = \"" + name + "\": " + error.what());
    }
    refuse_name(key, name, kind, error);
  }
}

template <class Dimensions>
Profile load_profile(const SurfaceSource<Dimensions>& source, ProfileKind kind,
                     const std::string& key, std::vector<std::string>& corrections) {
  const ProfileChoice& choice = source.profile;
  // Where its profile is has an effect on any rail.
  const auto refuse_options = [&](const std::string& reason) {
    ProfileOptions without = choice.options;
    without.rail_origin.reset();
    if (without.smoothing == 0.0) {
      without.smoothing.reset();
    }
    if (without != ProfileOptions{}) {
      throw_invalid_argument(key, '"' + profile_text(choice, {}) + '"',
                             "must have no such options: it is " + reason);
    }
  };
  if (choice.given) {
    refuse_options("a profile given by the program");
    return *choice.given;
  }
  if (!standard_name(choice.name, kind).empty()) {
    refuse_options("a built-in profile, which is exact");
    return standard_profile(choice.name);
  }
  ReadOptions options;
  options.kind = kind;
  options.smoothing_wavelength = choice.options.smoothing.value_or(automatic_smoothing);
  static_cast<ProfilePlacement&>(options) = choice.options.placement;
  set_tape_offset(options, source.dimensions);
  return read_file(choice, options, kind, key, corrections);
}

void warn_of_place(const RailSurface& surface, const TrackDimensions& track, Warnings& warnings) {
  if (surface.is_placed_by_axis()) {
    warnings.push_back({WarningClass::profile_origin,
                        "no gauge face " + short_text_of(track.gauge_height) +
                            " mm below its top: placed by its axis, lateral 0 is " +
                            short_text_of(surface.origin_y()) + " mm from the track centre"});
  }
}
void warn_of_place(const WheelSurface&, const WheelsetDimensions&, Warnings&) {}

/// Of the files of a profile; one that cannot be seen has size 0.
std::vector<FileStamp> stamps_of(const ProfileChoice& choice) {
  std::vector<FileStamp> stamps;
  for (const std::string& name : {choice.name, choice.options.placement.align_to}) {
    std::error_code unseen;
    FileStamp stamp;
    stamp.size = std::filesystem::file_size(name, unseen);
    if (unseen) {
      stamp.size = 0;
    } else {
      stamp.time = std::filesystem::last_write_time(name, unseen);
      struct stat status {};
      if (stat(name.c_str(), &status) == 0) {
        stamp.device = static_cast<std::int64_t>(status.st_dev);
        stamp.file = static_cast<std::int64_t>(status.st_ino);
#ifdef __linux__
        constexpr std::int64_t nano = 1000000000;
        stamp.changed = nano * status.st_ctim.tv_sec + status.st_ctim.tv_nsec;
#else
        stamp.changed = static_cast<std::int64_t>(status.st_ctime);
#endif
      }
    }
    stamps.push_back(stamp);
  }
  return stamps;
}

/// One of the two surfaces; corrections, warnings and time are added to those of the scene.
template <class Surface, class Dimensions>
std::shared_ptr<const Surface>
get_one(RecentSurfaces<Surface, Dimensions>& kept, bool watches_files,
        const SurfaceSource<Dimensions>& source, ProfileKind kind, const std::string& key,
        SideChoice side, bool is_solved, NoisyScene::Doubt& doubt, SceneSurfaces& all) {
  const auto make = [&] {
    const Stopwatch stopwatch;
    check_waves(source.profile.harmonics, radius_of(source.dimensions));
    typename RecentSurfaces<Surface, Dimensions>::Entry made{source, nullptr, {}, nullptr, {}, {}};
    if (is_sliced(source.profile)) {
      Warnings warnings;
      made.surface = surface_of_slices<Surface>(source, kind, key, made.corrections, warnings);
      if (!warnings.empty()) {
        made.warnings = std::make_shared<const Warnings>(std::move(warnings));
      }
      all.profile_milliseconds += stopwatch.milliseconds();
      return made;
    }
    Profile profile = load_profile(source, kind, key, made.corrections);
    all.profile_milliseconds += stopwatch.milliseconds();
    made.surface = surface_of(profile, source);
    made.doubt = profile.doubt;
    warn_of_place(*made.surface, source.dimensions, profile.warnings);
    if (!profile.warnings.empty()) {
      made.warnings = std::make_shared<const Warnings>(std::move(profile.warnings));
    }
    return made;
  };
  const bool has_file = !source.profile.given && standard_name(source.profile.name, kind).empty();
  auto entry = !watches_files || !has_file ? kept.get(source, {}, make)
               : is_sliced(source.profile) ? make()
                                           : kept.get(source, stamps_of(source.profile), make);
  for (const std::string& correction : entry.corrections) { // both sides may have the same
    if (std::find(all.corrections.begin(), all.corrections.end(), correction) ==
        all.corrections.end()) {
      all.corrections.push_back(correction);
    }
  }
  if (entry.warnings && is_solved) {
    all.warnings.add({kind, side, source.profile.name, entry.warnings});
  }
  doubt = entry.doubt;
  return entry.surface;
}

} // namespace

SceneSurfaces SurfaceCache::get(const Scene& scene) {
  SceneSurfaces surfaces;
  const auto get_side = [&](const SceneSide& side, const SceneSide& other, const std::string& name,
                            SideChoice which, const RailDisplacement& displacement) {
    const auto key = [&](ProfileChoice SceneSide::*choice, const std::string& table,
                         const std::string& kind) {
      return table + (side.*choice == other.*choice ? "" : name) + kind;
    };
    const bool is_solved = scene.side == SideChoice::both || scene.side == which;
    ProfileChoice wheel = side.wheel;
    if (!has_waves(wheel, scene.accuracy)) {
      wheel.harmonics.clear();
    }
    SideSurfaces found;
    found.wheel = get_one(wheels_, watches_files_,
                          {wheel, {scene.back_to_back, scene.tape_offset, side.radius}},
                          ProfileKind::wheel, key(&SceneSide::wheel, "wheelset.", "wheel"), which,
                          is_solved, found.wheel_doubt, surfaces);
    TrackDimensions track = scene.track;
    track.origin = side.rail.options.rail_origin;
    found.rail = get_one(rails_, watches_files_, {side.rail, track}, ProfileKind::rail,
                         key(&SceneSide::rail, "track.", "rail"), which, is_solved,
                         found.rail_doubt, surfaces);
    if (is_solved || !scene.roll) { // without a roll both wheels are needed
      found.rail->refuse_beyond_slices(scene.along);
    }
    found.rail = posed(found.rail, displacement, scene.along, *found.wheel, scene.yaw);
    found.wheel =
        turned(found.wheel, scene.pitch, scene.yaw, !found.rail->is_prismatic_along(along_track));
    return found;
  };
  surfaces.left =
      get_side(scene.left, scene.right, "left.", SideChoice::left, scene.left.displacement);
  surfaces.right = get_side(scene.right, scene.left, "right.", SideChoice::right,
                            mirrored(scene.right.displacement));
  return surfaces;
}

} // namespace wrc
