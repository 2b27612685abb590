/// Solves a scene in all the ways that are compared, each timed beside its error.
///
/// Truth: the half-space on a grid of `truth_grid`, tolerance 1e-8, in double; its own uncertainty
/// is the difference to a grid half as fine in both directions. Its error is a third of that where
/// errors fall with the square of the step, and as much as that where they fall with the step, as
/// on the edge of a chamfer; pressures there have no bound, and no truth.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "support/random_scenes.hpp"
#include "support/scene.hpp"

namespace tradeoff {

/// Errors that are measured, each relative:
///   pmax, depth, normal_force, area   to themselves
///   lateral_force                     to the normal force
///   centre_lateral                    distance of the centres of pressure in the y-z plane, to the
///                                     contact's semi-axis across the rail
///   centre_longitudinal               their distance along x, to the semi-axis along the rail
///   moment                            about one point; of its components the largest error, to the
///                                     normal force times the semi-axis across (about x) or along
///                                     the rail (about y and z)
/// The contact's semi-axes are those of the ellipse that would have the second moments of the
/// pressures of all patches together, if they were Hertz's: five times the variance is the square.
enum class Quantity : std::size_t {
  depth,
  normal_force,
  lateral_force,
  centre_lateral,
  centre_longitudinal,
  moment,
  area,
  pmax
};
inline constexpr std::array quantity_names{
    "depth",  "normal_force", "lateral_force", "centre_lateral", "centre_longitudinal",
    "moment", "area",         "pmax"};

/// What an accuracy stands for in the area: 11 times as much at 1e-2, 22 times at 3e-4, since
/// errors of the area fall with the rows to the power of 1.6, others of 2.
double area_in_accuracies(double accuracy);

struct WheelError {
  std::array<double, quantity_names.size()> values{};
  std::optional<double> estimate;
  std::optional<double> validity;
  std::string warnings;
  double area_share = area_in_accuracies(1e-2);

  [[nodiscard]] double of(Quantity quantity) const {
    return values[static_cast<std::size_t>(quantity)];
  }
  /// As it counts against an accuracy: that of the area by less, infinite if it is no number.
  [[nodiscard]] double counted(Quantity quantity) const;
  /// The quantity that is furthest off among those that an accuracy of this meaning, "forces" or
  /// another way's, is of: all but pmax, or all.
  [[nodiscard]] Quantity largest(const std::string& label) const;
  /// Its error, as it counts.
  [[nodiscard]] double controlled(const std::string& label) const {
    return counted(largest(label));
  }
};

/// Results of a wheel, as solved.
struct Figures {
  double pmax = 0.0, depth = 0.0, area = 0.0, normal_force = 0.0;
  std::array<double, 3> force{};     ///< along x, y, z
  std::array<double, 3> centre{};    ///< of pressure
  std::array<double, 3> reference{}; ///< of the moment
  std::array<double, 3> moment{};
  double semi_axis_along = 0.0, semi_axis_across = 0.0;
};

Figures figures_of(const driver::Scene& scene, const std::string& side);
WheelError error_of(const Figures& found, const Figures& truth);
/// With the error that the scene itself reports.
WheelError error_of(const driver::Scene& scene, const std::string& side, const Figures& truth);

/// A scene on which accuracy is measured: always the same ones.
///
/// Groups: `table1` (the paper's Table 1 at 21 lateral displacements), `manchester` (S1002 on the
/// Manchester UIC60), `two-patch` (S1002 on 56E1 where tread and flange carry together), `flange`
/// (displacements at the flange), and `spread`: pairs of profiles drawn in turn; displacement, yaw,
/// load (1 kN to 300 kN, uniform in its logarithm) and cant drawn from a fixed seed.
struct Case {
  std::string name;
  std::string group;
  driver::Settings settings;
};
/// Load of a wheel, 0 left and 1 right.
double load_of(const driver::Settings& scene, std::size_t side);

/// The first `count` scenes of the family, groups mixed so that few already show all of them; all
/// groups but `spread` have an end, `spread` has none.
std::vector<Case> make_family(std::size_t count);
/// Instead of the family: `count` scenes of driver::random_scene, group `random`.
std::vector<Case> make_random(std::size_t count);

inline constexpr std::array<double, 2> truth_grid{576.0, 240.0};
inline constexpr std::array accuracies{1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 3e-4};

/// How a scene is solved.
struct Way {
  /// "forces" or "pressures", of which the accuracy is; "double": pressures, in double precision;
  /// "hertz", "kik-piotrowski" or "grid".
  std::string label;
  double accuracy = 0.0;
  std::array<double, 2> grid{}; ///< of "grid"
};

struct Run {
  Way way;
  double time_ms = 0.0;             ///< median
  std::array<WheelError, 2> errors; ///< left and right
};

struct Measured {
  Case scene;
  std::string failure; ///< why there is none; else empty
  std::array<double, 2> truth_pmax{};
  std::array<WheelError, 2> truth_uncertainty;
  std::array<int, 2> patches{};
  std::vector<Run> runs;
};

struct MeasureOptions {
  std::vector<std::string> labels; ///< of the ways
  int repeats = 15;                ///< timed, at most
  bool position = false;           ///< prescribed, to what the load gave
};

/// All ways with these labels.
std::vector<Way> ways_of(const std::vector<std::string>& labels);

/// Never throws for what a scene may do: that is its `failure`.
Measured measure(const Case& scene, const MeasureOptions& options);

} // namespace tradeoff
