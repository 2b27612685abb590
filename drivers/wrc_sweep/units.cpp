#include "wrc_sweep/units.hpp"

#include <array>
#include <string_view>

namespace driver {
namespace {

struct Unit {
  std::string_view part; ///< of a name
  const char* unit;
};

/// The first part that a name contains decides; docs/results.md says the same at length.
constexpr std::array units{
    Unit{"sensitivities.at_load.lateral_force.lateral", "N/mm"},
    Unit{"sensitivities.at_load.lateral_force.roll", "N/rad"},
    Unit{"sensitivities.at_load.vertical.lateral", "1"},
    Unit{"sensitivities.at_load.vertical.roll", "mm/rad"},
    Unit{"force.lateral", "N/mm"},
    Unit{"force.vertical", "N/mm"},
    Unit{"force.roll", "N/rad"},
    Unit{"time_ms", "ms"},
    Unit{"_force", "N"},
    Unit{"load.", "N"},
    Unit{"moment", "N mm"},
    Unit{"pmax", "MPa"},
    Unit{"pressure", "MPa"},
    Unit{"modulus", "MPa"},
    Unit{"area", "mm2"},
    Unit{"residuals", "1"},
    Unit{"error_estimate", "1"},
    Unit{"poisson", "1"},
    Unit{"solve.near_tolerance", "mm"},
    Unit{"solve.joining_distance", "mm"},
    Unit{"solve.", "1"},
    Unit{"fill", "1"},
    Unit{".grid", "1"},
    Unit{"closeness", "1"},
    Unit{"regions", "1"},
    Unit{"lobes", "1"},
    Unit{"count", "1"},
    Unit{"iterations", "1"},
    Unit{"convolutions", "1"},
    Unit{"solutions", "1"},
    Unit{"rolling_radius", "mm"},
    Unit{"angle", "rad"},
    Unit{"roll", "rad"},
    Unit{"yaw", "rad"},
    Unit{"cant", "rad"},
};

} // namespace

std::string unit_of(const std::string& name) {
  for (const Unit& unit : units) {
    if (name.find(unit.part) != std::string::npos) {
      return unit.unit;
    }
  }
  return "mm";
}

} // namespace driver
