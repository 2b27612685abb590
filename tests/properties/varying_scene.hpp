/// Scenes on rails that vary along the track and under wheels that vary around the circumference.
///
/// Lists of slices are written by formula into the folder varying_lists, where the program runs: a
/// wave, corrugation, a taper, a ramp, a crossing's nose and wing, a gap; a flat, a shelled tread,
/// eccentricity and a polygon. Lists of another folder are drawn as well, if it has any. Positions
/// along, pitch, lateral position, yaw and loads are drawn over all of them and beyond their ends.
/// Units mm, N, rad.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "drawn_scene.hpp"

namespace properties {

class VaryingLists {
public:
  /// Writes its lists.
  explicit VaryingLists(const std::filesystem::path& others);
  /// The same seed draws the same scene.
  [[nodiscard]] DrawnScene scene(std::uint64_t seed) const;

private:
  struct List {
    std::string path;
    double begin; ///< of its places
    double end;
    double origin; ///< of its profiles beside the track's centre; 0: by the gauge
  };
  std::vector<List> rails_;
  std::vector<std::string> wheels_;
};

} // namespace properties
