#include "scene/surface_cache.hpp"

#include <utility>

#include "base/error.hpp"
#include "base/stopwatch.hpp"
#include "profile/readers.hpp"

namespace wrc {
namespace {

[[noreturn]] void refuse_name(const std::string& key, const std::string& name, ProfileKind kind,
                              const Error& error) {
  std::string text = key + " = \"" + name + "\": allowed is a profile file or one of";
  for (const auto known : standard_profile_names(kind)) {
    text += ' ';
    text += known;
  }
  throw Error(ErrorCode::unknown_name, text + " (" + error.what() + ")");
}

Profile read_file(const std::string& name, ProfileKind kind, double smoothing,
                  const std::string& key, std::vector<std::string>& corrections) {
  ReadOptions options;
  options.kind = kind;
  options.smoothing_wavelength = smoothing;
  try {
    ReadResult read = read_profile(name, options);
    for (const std::string& correction : read.corrections) {
      corrections.push_back(name);
      corrections.back().append(": ").append(correction);
    }
    return std::move(read.profile);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::file_unreadable) {
      throw;
    }
    refuse_name(key, name, kind, error);
  }
}

template <class Dimensions>
Profile load_profile(const SurfaceSource<Dimensions>& source, ProfileKind kind,
                     const std::string& key, std::vector<std::string>& corrections) {
  const auto refuse_smoothing = [&](const std::string& reason) {
    if (source.smoothing > 0.0) {
      throw_invalid_argument(key + "_smoothing", source.smoothing, "allowed is 0 with " + reason);
    }
  };
  if (source.given) {
    refuse_smoothing("a profile given by the program");
    return *source.given;
  }
  const auto names = standard_profile_names(kind);
  if (std::find(names.begin(), names.end(), source.name) != names.end()) {
    refuse_smoothing("a built-in profile, which is exact");
    return standard_profile(source.name);
  }
  return read_file(source.name, kind, source.smoothing, key, corrections);
}

/// One of the two surfaces; corrections and time are added to those of the scene.
template <class Surface, class Dimensions>
std::shared_ptr<const Surface> get_one(RecentSurfaces<Surface, Dimensions>& kept,
                                       const SurfaceSource<Dimensions>& source, ProfileKind kind,
                                       const std::string& key, SceneSurfaces& all) {
  auto entry = kept.get(source, [&] {
    const Stopwatch stopwatch;
    typename RecentSurfaces<Surface, Dimensions>::Entry made{source, nullptr, {}};
    const Profile profile = load_profile(source, kind, key, made.corrections);
    all.profile_milliseconds += stopwatch.milliseconds();
    made.surface = std::make_shared<Surface>(profile, source.dimensions);
    return made;
  });
  all.corrections.insert(all.corrections.end(), entry.corrections.begin(), entry.corrections.end());
  return entry.surface;
}

} // namespace

SceneSurfaces SurfaceCache::get(const Scene& scene) {
  SceneSurfaces surfaces;
  surfaces.wheel =
      get_one(wheels_, {scene.wheel_profile, scene.wheel, scene.wheel_smoothing, scene.wheelset},
              ProfileKind::wheel, "wheelset.wheel", surfaces);
  surfaces.rail =
      get_one(rails_, {scene.rail_profile, scene.rail, scene.rail_smoothing, scene.track},
              ProfileKind::rail, "track.rail", surfaces);
  return surfaces;
}

} // namespace wrc
