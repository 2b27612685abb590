/// Reading measured and published profiles from files.
///
/// Formats: text in columns (blank, tab, comma or semicolon between, comments # ! %), Simpack
/// .prr/.prw, MiniProf .ban/.whl; the extension selects, or else the content. Each is read by its
/// own rules. The result is in the frame of profile.hpp: 1. what the format defines, 2. units,
/// 3. cleaning, 4. signs and order, 5. of a wheel, the taping line to lateral 0. What neither the
/// format nor the options state the shape decides (settling.hpp). A rail's lateral sign cannot be
/// seen from its shape; state it if the format does not define it.
///
/// Every change of the data is one line of `corrections`; what no wheel or rail has is one of the
/// profile's warnings (plausibility.hpp). Guesses and warnings are errors in strict mode, except
/// scatter that the options smooth or leave. Input is not trusted: sizes are bounded, every error
/// names file and line. Does not know: kinks (points are joined by one smooth spline). Units mm.
/// Thread rule: no state.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measured/read_options.hpp"
#include "profile/file_type.hpp"
#include "profile/profile.hpp"

namespace wrc {

struct ReadResult {
  Profile profile;
  std::vector<std::string> corrections;
  std::vector<Position> measured{}; ///< the points before they were smoothed
  std::vector<Position> dropped{};  ///< points that were removed, in the same frame
};

/// Throws Error(invalid_argument) for numbers that are out of range.
void check_options(const ReadOptions& options);

/// Reads a profile, of a slices file (slices.hpp) the one of options.slice. Throws Error:
/// file_unreadable, file_malformed, or invalid_argument for options.
ReadResult read_profile(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from memory. `name` stands for the file name in messages; its extension gives the kind
/// if the content does not.
ReadResult read_profile_text(std::string_view text, ProfileFormat format, std::string_view name,
                             const ReadOptions& options = {});

/// The same from points given by the caller, [lateral, height], in either order. Throws
/// Error(invalid_argument).
ReadResult profile_through(std::span<const Position> points, std::string_view name,
                           const ReadOptions& options);

} // namespace wrc
