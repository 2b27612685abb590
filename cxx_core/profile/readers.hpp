/// Reading measured and published profiles from files.
///
/// Formats: two-column text (blank, tab, comma or semicolon between, comments # ! %), Simpack
/// .prr/.prw, MiniProf .ban/.whl; the extension selects, anything else is two-column text. Signs
/// and order of processing follow the keys of the formats as CONTACT reads them (user guide,
/// profile files). The result is in the frame of profile.hpp: steps are 1. what the format
/// defines, 2. units,
/// 3. a check of the shape (flange up and to negative lateral, rail head bulging up), 4. order.
/// A rail's lateral sign cannot be seen from its shape; state it if the format does not define it.
/// The origin is kept as it is in the file.
///
/// Every change of the data is one line of `corrections`. Changes that are guesses are errors in
/// strict mode. Input is not trusted: sizes are bounded, every error names file and line.
/// Does not know: kinks (points are joined by one smooth spline), slices (.slcs/.slcw).
/// Units mm. Thread rule: no state.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profile/profile.hpp"

namespace wrc {

enum class ProfileFormat { columns, simpack, miniprof };

struct ReadOptions {
  std::optional<ProfileKind> kind; ///< wins over what the file says
  /// Mirroring on top of what the format defines; if set, replaces the check of the shape.
  std::optional<bool> mirror_lateral;
  std::optional<bool> mirror_height;
  std::optional<double> scale;       ///< mm per unit of the file; if not set, units may be guessed
  double smoothing_wavelength = 0.0; ///< mm, waves of this length are halved; 0 = no smoothing
  /// mm; points closer to the one before are dropped, since the rounding of their digits would
  /// dominate the curvature.
  double least_point_distance = 0.01;
  bool strict = false; ///< corrections that are guesses are errors
};

struct ReadResult {
  Profile profile;
  std::vector<std::string> corrections;
};

/// Bounds on what is read.
struct ReadLimits {
  static constexpr std::size_t file_bytes = std::size_t{64} << 20;
  static constexpr std::size_t line_bytes = 4096;
  static constexpr std::size_t min_points = 5;
  static constexpr std::size_t max_points = 200000;
  static constexpr double min_length = 5.0;     ///< mm, total chord length
  static constexpr double max_length = 500.0;   ///< mm
  static constexpr double max_coordinate = 1e5; ///< mm
};

/// The format that goes with a file's extension. Throws Error(file_malformed) for slices.
ProfileFormat format_of(const std::filesystem::path& path);

/// Reads a profile. Throws Error: file_unreadable, file_malformed, or invalid_argument for
/// options.
ReadResult read_profile(const std::filesystem::path& path, const ReadOptions& options = {});

/// The same from memory. `name` stands for the file name in messages; its extension tells the kind
/// if the content does not.
ReadResult read_profile_text(std::string_view text, ProfileFormat format, std::string_view name,
                             const ReadOptions& options = {});

/// The same from points at hand, [lateral, height], in either order. Throws
/// Error(invalid_argument).
ReadResult profile_through(std::span<const Position> points, std::string_view name,
                           const ReadOptions& options);

} // namespace wrc
