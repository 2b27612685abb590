/// Where a wheelset runs: straight track and curves, with their shares of the distance.
#pragma once

#include <string>
#include <vector>

namespace driver {

struct Curve {
  double radius = 0.0; ///< m, 0: straight
  double speed = 0.0;  ///< m/s
  double share = 0.0;  ///< of the distance
};

struct Mission {
  double wheelbase = 2500.0; ///< of a bogie whose wheelsets stay parallel, mm
  double clearance = 6.5;    ///< greatest displacement in curves, mm
  double wander = 3.0;       ///< greatest displacement in straight track, mm
  std::vector<Curve> curves{
      {0.0, 40.0, 0.60}, {1500.0, 35.0, 0.20}, {600.0, 25.0, 0.14}, {300.0, 18.0, 0.06}};
};

/// The default mission as a file.
extern const char* const mission_text;

/// Throws Failure naming file, key, value and what is allowed.
Mission read_mission(const std::string& path);

} // namespace driver
