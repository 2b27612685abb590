/// How smoothly results follow the scene, and whether they depend on it alone: five measurements
/// through the public interface, each printed as a table with what exceeds its limit.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "wrcontact.hpp"

namespace smoothness {

struct Options {
  std::string parts = "12345";
  double accuracy = 1e-3;
  std::string accuracy_of = "forces";
  std::string curved = "no";                ///< planes; or "yes" or "auto", along curves
  std::string derivative = "sensitivities"; ///< of Newton's iteration; or "difference", of 1 um
  int positions = 50;
  double first = -6.0; ///< position, mm
  double last = 6.0;   ///< likewise
  int steps = 400;
  long scenes = 5000;     ///< moved by 1e-9 mm
  long sequence = 10000;  ///< scenes solved one after the other
  std::uint64_t seed = 1; ///< of what is drawn
  int threads = 1;
  int fresh = 0;               ///< not 0: each scene by itself instead of through one solver
  int list = 20;               ///< lines of each list, at most
  double limit = 1e-6;         ///< of forces; in part 4 of depth, too; relative
  double pressure_share = 0.1; ///< limit of pmax, relative to the accuracy
  double scene_share = 0.999;  ///< least share of the scenes within both
  int newton = 4;              ///< most iterations
  long differing = 0;          ///< most scenes of the sequence whose results differ
};

/// Solves a scene as the options say.
class Solving {
public:
  explicit Solving(const Options& options) : fresh_(options.fresh != 0) {}
  bool solve(wrcontact::Scene& scene) { return fresh_ ? scene.solve() : solver_.solve(scene); }

private:
  bool fresh_;
  wrcontact::Solver solver_;
};

inline constexpr std::array<std::array<const char*, 2>, 3> pairs{
    {{"S1002", "60E1"}, {"LMA", "CHN60"}, {"S1002", "56E1"}}};
inline constexpr double load = 80e3;

/// Sets the accuracy asked, and whether contacts are curved.
void ask(wrcontact::Scene& scene, const Options& options);
/// A pair with its load at a displacement, asked as above.
wrcontact::Scene make_scene(const Options& options, std::size_t pair, double lateral);
/// Displacement of a position.
double lateral_of(const Options& options, std::size_t position);

/// Each returns whether all limits are kept.
bool measure_lateral_sweeps(const Options& options);  // part 1
bool measure_vertical_sweeps(const Options& options); // part 2
bool measure_newton(const Options& options);          // part 3
bool measure_moved_scenes(const Options& options);    // part 4
bool measure_sequences(const Options& options);       // part 5

} // namespace smoothness
