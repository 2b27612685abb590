/// Slices files of CONTACT: profiles that vary along a rail (.slcs: switches, crossings) or around
/// a wheel (.slcw: flats), each place with the file of its profile.
///
/// Free format, comments %: offset and scale of the places, number of slices, number of features
/// (with numbers of kinks and accelerations), interpolation, then a line of each slice: its place
/// and 'file', relative to the slices file. Features and interpolation are not read: one slice is
/// used as a profile that is the same everywhere.
/// Places are scale (offset + place), mm or rad. Thread rule: no state.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "profile/profile.hpp"

namespace wrc {

struct Slice {
  double place = 0.0; ///< mm along the rail, rad around the wheel
  std::filesystem::path file;
};

/// The slices in a text; `path` gives the folder of their files and the name in messages. Throws
/// Error(file_malformed).
std::vector<Slice> read_slices(std::string_view text, const std::filesystem::path& path);

/// One line: "3 slices: 1 at 0 mm 'a.prr', ...".
std::string slices_text(const std::vector<Slice>& slices, ProfileKind kind);

} // namespace wrc
