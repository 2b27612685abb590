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
/// for the scatter of points. Input is not trusted: sizes are bounded, every error names file and
/// line. Does not know: kinks (points are joined by one smooth spline). Units mm. Thread rule: no
/// state.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profile/profile.hpp"

namespace wrc {

enum class ProfileFormat { columns, simpack, miniprof, slices };

/// Where a wheel's file has lateral 0.
enum class WheelOrigin { by_file, tape, flange_back };

struct ReadOptions {
  std::optional<ProfileKind> kind; ///< wins over what the file says
  /// Mirroring in addition to the format's own; if set, replaces the check of the shape.
  std::optional<bool> mirror_lateral;
  std::optional<bool> mirror_height;
  std::optional<double> scale;       ///< mm per unit of the file; if not set, units may be guessed
  double smoothing_wavelength = 0.0; ///< mm, waves of this length are halved; 0 = no smoothing
  /// mm; points closer to the one before are dropped, since the rounding of their digits would
  /// dominate the curvature.
  double least_point_distance = 0.01;
  bool strict = false; ///< corrections that are guesses, and warnings, are errors
  /// Of a wheel; `tape` leaves lateral and heights as they are.
  WheelOrigin origin = WheelOrigin::by_file;
  std::optional<double> tape_offset;   ///< flange back to taping line, mm; else by the file, or 70
  std::optional<double> lateral_shift; ///< instead of `origin`: to the taping line, mm
  int slice = 0; ///< of a slices file (.slcs, .slcw): which one, from 1; 0: refused with a list
};

struct ReadResult {
  Profile profile;
  std::vector<std::string> corrections;
  std::vector<Position> measured{}; ///< the points before they were smoothed
  std::vector<Position> dropped{};  ///< points that were removed, in the same frame
};

/// Bounds on what is read.
struct ReadLimits {
  static constexpr std::size_t file_bytes = std::size_t{64} << 20;
  static constexpr std::size_t line_bytes = 4096;
  static constexpr std::size_t min_points = 5;
  static constexpr std::size_t max_points = 200000;
  static constexpr double min_length = 5.0;        ///< mm, total chord length
  static constexpr double max_length = 500.0;      ///< mm
  static constexpr double max_coordinate = 1e5;    ///< mm
  static constexpr double min_tape_offset = 20.0;  ///< mm
  static constexpr double max_tape_offset = 120.0; ///< mm
};

/// What a file's extension says.
struct FileType {
  ProfileFormat format = ProfileFormat::columns;
  std::optional<ProfileKind> kind;
};
FileType type_of(const std::filesystem::path& path);

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
