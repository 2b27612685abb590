/// The largest pressure of wheels as vehicles use them: whether an accuracy of 1e-2 is met, and
/// what estimates and warnings say where it is not.
///
/// Scenes: all built-in wheels on all built-in rails with the dimensions that belong to them, radii
/// worn by up to a tenth, cant 0, 1:40 or 1:20, lateral displacements to 8 mm, yaw to 10 mrad on
/// half of them, 20 to 150 kN a wheel.
///
/// Reference: pmax of a prescribed grid, `first_truth`, made twice as fine in both directions until
/// two of them agree; their difference is its uncertainty. Wheels whose uncertainty exceeds half of
/// the permitted error are counted separately.
#pragma once

#include <array>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "wrc_tradeoff/measure.hpp"

namespace tradeoff {

inline constexpr double practical_accuracy = 1e-2;

std::vector<Case> make_practical(std::size_t count);

struct PracticalWheel {
  double truth = 0.0;       ///< pmax, MPa
  double uncertainty = 0.0; ///< of it, relative
  double error = 0.0;       ///< of pmax at practical_accuracy, relative
  double estimate = 0.0;
  std::string warnings;

  [[nodiscard]] bool misses() const { return error > practical_accuracy; }
  [[nodiscard]] bool misses_silently() const { return misses() && warnings.empty(); }
  [[nodiscard]] bool exceeds_estimate() const { return error > estimate; }
};

struct PracticalMeasured {
  Case scene;
  std::string failure; ///< why there is none; else empty
  std::array<PracticalWheel, 2> wheels;
};

/// Never throws for what a scene may do: that is its `failure`.
PracticalMeasured measure_practical(const Case& scene);

void print_practical_summary(const std::vector<PracticalMeasured>& all, std::ostream& out);
nlohmann::json practical_json_of(const std::vector<PracticalMeasured>& all);

} // namespace tradeoff
