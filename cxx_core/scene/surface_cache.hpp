/// Surfaces of the wheel and the rail a scene names, kept for the scenes that follow.
///
/// A profile is one given by the program, or else a built-in one of that name, or else a file of
/// that name. A file is not read again while its surface is kept, or, if the cache watches files,
/// while its size and time stay. Rails are kept where the track's dimensions put them, and
/// displaced from there for each scene. Thread rule: any number of threads; one makes a surface,
/// the others wait for it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "geometry/wheelset_equilibrium.hpp"
#include "keys/scene.hpp"
#include "scene/constants.hpp"
#include "scene/noisy_scene.hpp"
#include "scene/profile_warnings.hpp"

namespace wrc {

struct SideSurfaces {
  using Doubt = NoisyScene::Doubt;

  std::shared_ptr<const WheelSurface> wheel;
  std::shared_ptr<const RailSurface> rail; ///< where it is displaced to, left-hand frame
  Doubt wheel_doubt;
  Doubt rail_doubt;

  [[nodiscard]] WheelAndRail pair() const { return {*wheel, *rail}; }
};

struct SceneSurfaces {
  SideSurfaces left;
  SideSurfaces right;
  std::vector<std::string> corrections; ///< made to profiles read from files
  ProfileWarnings warnings;             ///< of the profiles, those of both sides once
  double profile_milliseconds = 0.0;    ///< spent on reading profiles, none on those kept
};

/// What a surface is made from.
template <class Dimensions> struct SurfaceSource {
  ProfileChoice profile;
  Dimensions dimensions;

  bool operator==(const SurfaceSource&) const = default;
};

/// By which a file that has changed is found, without reading it.
struct FileStamp {
  std::uintmax_t size = 0;
  std::filesystem::file_time_type time{};
  std::int64_t device = 0; ///< another file may have the same name, size and time
  std::int64_t file = 0;
  std::int64_t changed = 0; ///< when its status changed last: no program can set that
  bool operator==(const FileStamp&) const = default;
};

/// The surfaces of one kind that were last used, with the corrections their files needed and the
/// warnings of their profiles.
template <class Surface, class Dimensions> class RecentSurfaces {
public:
  struct Entry {
    SurfaceSource<Dimensions> source;
    std::shared_ptr<const Surface> surface;
    std::vector<std::string> corrections;
    std::shared_ptr<const Warnings> warnings; ///< none: NULL
    NoisyScene::Doubt doubt;
    std::vector<FileStamp> files{}; ///< of a cache that watches them, as they were before
  };

  explicit RecentSurfaces(std::size_t most) : most_(most) {}

  template <class Make>
  Entry get(const SurfaceSource<Dimensions>& source, const std::vector<FileStamp>& files,
            Make&& make) {
    const std::lock_guard<std::mutex> guard(mutex_);
    const auto found = std::find_if(entries_.begin(), entries_.end(), [&](const auto& entry) {
      return entry.source == source && entry.files == files;
    });
    if (found != entries_.end()) {
      std::rotate(entries_.begin(), found, found + 1);
    } else {
      entries_.insert(entries_.begin(), make());
      entries_.front().files = files;
      entries_.resize(std::min(entries_.size(), most_));
    }
    return entries_.front();
  }

private:
  std::size_t most_;
  std::mutex mutex_;
  std::vector<Entry> entries_; ///< last used first
};

class SurfaceCache {
public:
  enum class For { scenes, one_scene };

  /// Of many scenes, whose files do not change, or of one, whose files may: it watches them, and
  /// keeps no slices, which are many files.
  explicit SurfaceCache(For scenes = For::scenes)
      : watches_files_(scenes == For::one_scene),
        wheels_(watches_files_ ? most_surfaces_of_scene : most_cached_surfaces),
        rails_(watches_files_ ? most_surfaces_of_scene : most_cached_surfaces) {}

  /// Throws Error(unknown_name) for a name that is neither built in nor that of a file.
  SceneSurfaces get(const Scene& scene);

private:
  bool watches_files_;
  RecentSurfaces<WheelSurface, WheelsetDimensions> wheels_;
  RecentSurfaces<RailSurface, TrackDimensions> rails_;
};

} // namespace wrc
