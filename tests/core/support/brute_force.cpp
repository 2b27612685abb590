#include "support/brute_force.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace wrc::test {
namespace {

constexpr int coarse_arcs = 500;
constexpr int coarse_angles = 61;
constexpr double largest_angle = 0.3;
constexpr std::size_t starts = 6;
constexpr int fine_points = 11;

class Surface {
public:
  Surface(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose)
      : wheel_(wheel), rail_(rail), pose_(pose) {}

  [[nodiscard]] BruteForceContact at(double arc, double angle) const {
    const CurvePoint point = wheel_.graph().curve().at(arc);
    const double rho = wheel_.radius() + point.height;
    // Rz(yaw) Rx(roll), written out once more.
    const double bx = rho * std::sin(angle);
    const double by = wheel_.taping_line() + point.lateral;
    const double bz = -rho * std::cos(angle);
    const double ry = std::cos(pose_.roll) * by - std::sin(pose_.roll) * bz;
    const double rz = std::sin(pose_.roll) * by + std::cos(pose_.roll) * bz;
    BruteForceContact contact;
    contact.position = {std::cos(pose_.yaw) * bx - std::sin(pose_.yaw) * ry,
                        pose_.lateral + std::sin(pose_.yaw) * bx + std::cos(pose_.yaw) * ry, rz};
    contact.arc = arc;
    contact.angle = angle;
    const double below = rail_height(rail_, contact.position.y);
    contact.distance =
        std::isnan(below) ? std::numeric_limits<double>::infinity() : contact.position.z - below;
    return contact;
  }

private:
  const WheelSurface& wheel_;
  const RailSurface& rail_;
  const Pose pose_;
};

} // namespace

double rail_height(const RailSurface& rail, double y) {
  const Curve& curve = rail.graph().curve();
  double low = rail.graph().arc_begin();
  double high = rail.graph().arc_end();
  if (y < curve.at(low).lateral || y > curve.at(high).lateral) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (curve.at(middle).lateral < y ? low : high) = middle;
  }
  return curve.at(0.5 * (low + high)).height;
}

BruteForceContact brute_force_contact(const WheelSurface& wheel, const RailSurface& rail,
                                      const Pose& pose) {
  const Surface surface(wheel, rail, pose);
  const double length = wheel.graph().curve().length();
  const double arc_step = length / coarse_arcs;
  const double angle_step = 2.0 * largest_angle / (coarse_angles - 1);
  // The best angle for each arc, then the best arcs that are apart from each other.
  std::vector<BruteForceContact> best;
  for (int i = 0; i <= coarse_arcs; ++i) {
    BruteForceContact best_here;
    best_here.distance = std::numeric_limits<double>::infinity();
    for (int j = 0; j < coarse_angles; ++j) {
      const auto contact = surface.at(i * arc_step, -largest_angle + j * angle_step);
      if (contact.distance < best_here.distance) {
        best_here = contact;
      }
    }
    best.push_back(best_here);
  }
  std::sort(best.begin(), best.end(),
            [](const auto& a, const auto& b) { return a.distance < b.distance; });
  std::vector<BruteForceContact> chosen;
  for (const auto& contact : best) {
    const bool apart = std::none_of(chosen.begin(), chosen.end(), [&](const auto& other) {
      return std::abs(other.arc - contact.arc) < 2.0;
    });
    if (apart && chosen.size() < starts) {
      chosen.push_back(contact);
    }
  }
  BruteForceContact result = chosen.front();
  for (BruteForceContact contact : chosen) {
    double arc_window = 4.0 * arc_step;
    double angle_window = 4.0 * angle_step;
    while (arc_window > 1e-9) {
      const BruteForceContact centre = contact;
      for (int i = 0; i < fine_points; ++i) {
        for (int j = 0; j < fine_points; ++j) {
          const double arc = centre.arc + arc_window * (2.0 * i / (fine_points - 1) - 1.0);
          const double angle = centre.angle + angle_window * (2.0 * j / (fine_points - 1) - 1.0);
          const auto trial = surface.at(std::clamp(arc, 0.0, length), angle);
          if (trial.distance < contact.distance) {
            contact = trial;
          }
        }
      }
      arc_window *= 0.6; // slowly: the valley is oblique under yaw
      angle_window *= 0.6;
    }
    if (contact.distance < result.distance) {
      result = contact;
    }
  }
  return result;
}

} // namespace wrc::test
