/// What programs show of a profile that varies along the track or around the wheel: lines of a
/// summary, and points of its surface.
///
/// Frame and units of geometry/sliced_surface.hpp: mm, along mm or, of a wheel, rad.
/// Thread rule: immutable after construction, safe to share.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geometry/sliced_sheets.hpp"
#include "measured/read_options.hpp"

namespace wrc {

class ProfileSurface {
public:
  /// `smoothing_length` in the unit of places, none: as the list says. Throws as
  /// read_sliced_profile does, and Error(file_malformed) for slices that make no surface.
  ProfileSurface(const std::filesystem::path& path, const ReadOptions& options,
                 std::optional<double> smoothing_length);

  [[nodiscard]] const SlicedProfile& profile() const { return profile_; }
  [[nodiscard]] const std::vector<SurfaceSheet>& sheets() const { return sheets_; }
  /// Slices and their range, corrections, smoothing, absent features, sheets.
  [[nodiscard]] std::vector<std::string> summary() const;

private:
  SlicedProfile profile_;
  double smoothing_length_;
  std::vector<SurfaceSheet> sheets_;
};

} // namespace wrc
