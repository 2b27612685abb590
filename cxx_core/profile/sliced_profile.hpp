/// A profile that varies along the track or around the wheel: the slices of a list, as curves.
///
/// All slices are read by one rule, so that none is moved against the others: Simpack .prr/.prw as
/// the format defines, other files as two columns, lateral and height; unit and sense of heights
/// are decided once, by all slices together, or by the options. No cleaning, no search for a tilt
/// or a taping line, no smoothing but the one that is requested: noise of a measured slice stays.
/// Places: mm along the rail, or rad around the wheel. Curves in the frame of profile.hpp, mm;
/// those of a wheel have height 0 at the nominal radius. Features become arc lengths of the curves,
/// which ascend from the flange (gauge) side: those of a wheel, which its file counts from the
/// field side, in the opposite order. A list without features has those of slice_matching.hpp.
/// Limits: SliceLimits, ReadLimits. Not covered: other formats
/// as slices (MiniProf), kinks within a slice (curve_through rings about them). Thread rule: plain
/// values, no state.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "profile/profile.hpp"
#include "profile/read_options.hpp"

namespace wrc {

struct ProfileSlice {
  double place = 0.0; ///< mm along the rail, rad around the wheel
  Curve curve;
  /// Arc lengths, the same number in each slice; none: absent from it.
  std::vector<std::optional<double>> features{};
};

struct SlicedProfile {
  std::string name;
  ProfileKind kind = ProfileKind::rail;
  std::vector<ProfileSlice> slices; ///< in ascending order
  bool is_smoothed = false;         ///< along, as the list requests
  std::vector<std::string> corrections{};
};

/// Whether all slices are the same, to the last bit, and whole.
bool has_equal_slices(const SlicedProfile& profile);

/// Reads a .slcs or .slcw file with its slices. Of the options: kind, mirrors, scale (also of
/// Simpack files) and smoothing_wavelength. Throws Error(file_unreadable) or Error(file_malformed),
/// naming file, slice and line.
SlicedProfile read_sliced_profile(const std::filesystem::path& path,
                                  const ReadOptions& options = {});

} // namespace wrc
