// The steps of vehicle_steps.f90 from C++, to tell what the Fortran interface costs.
// Usage: vehicle_steps_cxx [N]
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <numbers>
#include <string>

#include "wrcontact.hpp"

namespace {

long resident_kb() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.starts_with("VmRSS:")) {
      return std::stol(line.substr(6));
    }
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  const std::string names[] = {
      "left.lateral_force", "right.lateral_force", "left.pmax", "right.pmax",
      "left.centroid.y",    "right.centroid.y",    "roll",      "vertical"};
  const int steps = argc > 1 ? std::atoi(argv[1]) : 3000;
  wrcontact::Scene scene;
  wrcontact::Solver solver;
  scene.set("solve.accuracy", 1.0e-2);
  double total = 0.0;
  long early = 0;
  const auto start = std::chrono::steady_clock::now();
  for (int i = 1; i <= steps; ++i) {
    scene.set("pose.lateral", 5.0 * std::sin(2.0 * std::numbers::pi * i / 2000.0));
    scene.set("pose.yaw", 2.0e-3 * std::cos(2.0 * std::numbers::pi * i / 2000.0));
    if (!solver.solve(scene)) {
      return 1;
    }
    for (const std::string& name : names) {
      total += scene.number(name);
    }
    if (i == std::max(steps / 10, 1000)) {
      early = resident_kb();
    }
  }
  const std::chrono::duration<double, std::micro> elapsed =
      std::chrono::steady_clock::now() - start;
  std::printf("steps %d\nmicroseconds_per_step %.3f\nsum %.16e\nresident_kb %ld\ngrowth_kb %ld\n",
              steps, elapsed.count() / steps, total, resident_kb(), resident_kb() - early);
  return 0;
}
