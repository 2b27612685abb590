#include "wrc_wear/mission.hpp"

#include <cmath>

#include "support/numbers.hpp"
#include "support/scene.hpp"
#include "support/toml.hpp"

namespace driver {
namespace {

/// By which shares may differ from 1 in total, for those written with few digits.
constexpr double share_rounding = 1e-3;

double number_between(TableReader& reader, const char* key, double otherwise, double least,
                      double most) {
  const double value = reader.number(key, otherwise);
  if (!(value >= least) || !(value <= most)) {
    reader.refuse(key, text_of(value), "between " + text_of(least) + " and " + text_of(most));
  }
  return value;
}

} // namespace

const char* const mission_text =
    "  wheelbase = 2500.0   # of the bogie, mm\n"
    "  clearance = 6.5      # greatest displacement in curves, mm\n"
    "  wander = 3.0         # greatest displacement in straight track, mm\n"
    "  [[curve]]\n"
    "  radius = 0.0         # m; 0 is straight track\n"
    "  speed = 40.0         # m/s\n"
    "  share = 0.60         # of the distance\n"
    "  [[curve]]\n"
    "  radius = 1500.0\n"
    "  speed = 35.0\n"
    "  share = 0.20\n"
    "  [[curve]]\n"
    "  radius = 600.0\n"
    "  speed = 25.0\n"
    "  share = 0.14\n"
    "  [[curve]]\n"
    "  radius = 300.0\n"
    "  speed = 18.0\n"
    "  share = 0.06\n";

Mission read_mission(const std::string& path) {
  const toml::table file = read_toml("mission file", path);
  TableReader reader(file, "mission");
  Mission mission;
  mission.wheelbase = number_between(reader, "wheelbase", mission.wheelbase, 0.0, 20000.0);
  mission.clearance = number_between(reader, "clearance", mission.clearance, 0.0, 30.0);
  mission.wander = number_between(reader, "wander", mission.wander, 0.0, 30.0);
  mission.curves.clear();
  double sum = 0.0;
  for (const toml::table* table : reader.tables("curve")) {
    TableReader curve_reader(*table, "curve");
    Curve curve;
    curve.radius = number_between(curve_reader, "radius", -1.0, 0.0, 1e6);
    if (curve.radius > 0.0 && curve.radius < 10.0) {
      curve_reader.refuse("radius", text_of(curve.radius), "0 (straight), or between 10 and 1e6 m");
    }
    curve.speed = number_between(curve_reader, "speed", 0.0, 0.1, 200.0);
    curve.share = number_between(curve_reader, "share", 0.0, 1e-6, 1.0);
    curve_reader.refuse_others();
    sum += curve.share;
    mission.curves.push_back(curve);
  }
  reader.refuse_others();
  if (!(std::abs(sum - 1.0) <= share_rounding)) {
    throw Failure(path + ": the shares of all [[curve]] sum to " + text_of(sum) + "; must be 1");
  }
  return mission;
}

} // namespace driver
