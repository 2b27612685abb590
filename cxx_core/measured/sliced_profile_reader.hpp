/// Reading a profile that varies along the track or around the wheel: the slices of a list.
///
/// All slices are read by one rule, so that none is moved against the others: Simpack .prr/.prw as
/// the format defines, other files as two columns, lateral and height; unit and sense of heights
/// are decided once, by all slices together, or by the options. No cleaning, no search for a tilt
/// or a taping line, no smoothing but the one that is requested: noise of a measured slice stays.
/// Features become arc lengths of the curves: those of a wheel, which its file counts from the
/// field side, in the opposite order. A list without features has those of slice_matching.hpp.
/// Limits: SliceLimits, ReadLimits. Not covered: other formats as slices (MiniProf), kinks within a
/// slice (curve_through rings about them). Thread rule: no state.
#pragma once

#include <filesystem>

#include "measured/read_options.hpp"
#include "profile/sliced_profile.hpp"

namespace wrc {

/// Reads a .slcs or .slcw file with its slices. Of the options: kind, mirrors, scale (also of
/// Simpack files) and smoothing_wavelength. Throws Error(file_unreadable) or Error(file_malformed),
/// naming file, slice and line.
SlicedProfile read_sliced_profile(const std::filesystem::path& path,
                                  const ReadOptions& options = {});

} // namespace wrc
