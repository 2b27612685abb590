/// From the points of a format to those of a profile: kind, units, cleaning, signs, order, origin,
/// rotation.
///
/// What the format defines comes first, then what the options state; where both are silent the
/// shape decides, which is reported as a guess with its evidence. Units mm. Thread rule: no
/// state.
#pragma once

#include "measured/read_options.hpp"
#include "measured/reader_formats.hpp"

namespace wrc::reading {

struct Settled {
  ProfileKind kind = ProfileKind::wheel;
  std::vector<Position> points;
  std::vector<Position> dropped;
};

/// `nominal` is the profile of options.align_to. Throws Error(file_malformed).
Settled settle(RawProfile& raw, const ReadOptions& options, Log& log,
               const Profile* nominal = nullptr);

} // namespace wrc::reading
