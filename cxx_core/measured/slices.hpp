/// Slices files of CONTACT: profiles that vary along a rail (.slcs: switches, crossings) or around
/// a wheel (.slcw: flats), each place with the file of its profile.
///
/// Free format, comments %: offset and scale of the places, number of slices, number of features
/// (with numbers of kinks and accelerations), interpolation (1 through the slices, 2 smoothed),
/// then a line of each slice: its place and 'file', relative to the slices file. With two features
/// or more a line of each slice follows: its place again, and the length along its points at which
/// each feature lies, from the gauge side of a rail and the field side of a wheel, where the format
/// has the first point, also in files with the other order; -1 where the slice does not have it,
/// beyond the end: the end. Places are scale (offset + place), mm or rad; features mm. Limits of
/// untrusted input: SliceLimits and ReadLimits. Not covered: kinks and accelerations, which are
/// refused where features are read. Thread rule: no state.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "profile/profile.hpp"

namespace wrc {

struct Slice {
  double place = 0.0; ///< mm along the rail, rad around the wheel
  std::filesystem::path file;
  std::vector<std::optional<double>> features{}; ///< mm along its points; none: absent
};

struct SliceList {
  std::vector<Slice> slices;
  bool is_smoothed = false; ///< along, as the interpolation says
};

/// The slices in a text, without features; `path` gives the folder of their files and the name in
/// messages. Throws Error(file_malformed), naming file and line.
std::vector<Slice> read_slices(std::string_view text, const std::filesystem::path& path);

/// The same with the features.
SliceList read_slice_list(std::string_view text, const std::filesystem::path& path);

/// One line: "3 slices: 1 at 0 mm 'a.prr', ...".
std::string slices_text(const std::vector<Slice>& slices, ProfileKind kind);

} // namespace wrc
