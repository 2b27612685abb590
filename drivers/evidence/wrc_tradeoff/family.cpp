#include "support/service_run.hpp"
#include "wrc_tradeoff/creep.hpp"
#include "wrc_tradeoff/measure.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <sstream>

namespace tradeoff {
namespace {

constexpr std::uint64_t seed = 20240607;

/// Wheel, rail and a radius that is not the usual one.
struct Pairing {
  const char* wheel;
  const char* rail;
  double radius = 0.0;
};

constexpr std::array pairings{Pairing{"S1002", "60E1"},         Pairing{"LMA", "CHN60"},
                              Pairing{"S1002", "54E2"},         Pairing{"LM", "60E1"},
                              Pairing{"S1002", "56E1"},         Pairing{"LM", "CHN60"},
                              Pairing{"S1002", "60E2"},         Pairing{"LMA", "60E1"},
                              Pairing{"S1002", "CHN60", 457.5}, Pairing{"S1002", "49E1", 400.0}};

Case drawn_case(std::size_t index, driver::Draw& draw) {
  const Pairing& pair = pairings[index % pairings.size()];
  Case made;
  made.group = "spread";
  made.name = "spread-" + std::to_string(index);
  made.settings = driver::make_pair(pair.wheel, pair.rail);
  if (pair.radius > 0.0) {
    made.settings.set("wheelset.radius", pair.radius);
  }
  constexpr std::array cants{1.0 / 40.0, 1.0 / 20.0, 0.0};
  made.settings.set("track.inclination", std::atan(cants[(index / pairings.size()) % 3]));
  made.settings.set("pose.lateral", draw.between(-6.5, 6.5));
  const double yaw = draw.between(-0.04, 0.04);
  made.settings.set("pose.yaw", index % 2 == 0 ? 0.0 : yaw);
  made.settings.set("load.both", std::exp(draw.between(std::log(1e3), std::log(3e5))));
  return made;
}

std::vector<Case> sweep(const std::string& group, const std::string& wheel, const std::string& rail,
                        double first, double step, int count, double yaw) {
  std::vector<Case> cases;
  for (int i = 0; i < count; ++i) {
    Case made;
    made.group = group;
    const double lateral = first + step * i;
    std::ostringstream name;
    name << group << (yaw != 0.0 ? "-yawed" : "") << "-y" << lateral;
    made.name = name.str();
    made.settings.texts = {{"wheelset.wheel", wheel}, {"track.rail", rail}};
    made.settings.numbers = {{"pose.lateral", lateral}, {"pose.yaw", yaw}};
    cases.push_back(std::move(made));
  }
  return cases;
}

} // namespace

double load_of(const driver::Settings& scene, std::size_t side) {
  constexpr double usual = 80e3;
  return scene.number_or(side == 0 ? "load.left" : "load.right",
                         scene.number_or("load.both", usual));
}

std::vector<Case> make_family(std::size_t count) {
  constexpr double yaw = 0.03;
  std::vector<Case> special = sweep("table1", "S1002", "60E1", -5.0, 0.5, 21, 0.0);
  for (const auto& more : {sweep("table1", "S1002", "60E1", -5.0, 1.0, 11, yaw),
                           sweep("manchester", "S1002", "UIC60-Manchester", -5.0, 1.0, 11, 0.0),
                           sweep("two-patch", "S1002", "56E1", 5.9, 0.05, 10, 0.0),
                           sweep("flange", "S1002", "60E1", 5.25, 0.25, 10, 0.0),
                           sweep("flange", "S1002", "54E2", 5.25, 0.25, 10, yaw)}) {
    special.insert(special.end(), more.begin(), more.end());
  }
  // In an order that has a bit of all: steps of a number without common divisor.
  constexpr std::size_t stride = 31;
  driver::Draw draw(seed);
  std::vector<Case> family;
  std::size_t drawn = 0;
  for (std::size_t i = 0; family.size() < count; ++i) {
    if (i < special.size()) {
      family.push_back(special[i * stride % special.size()]);
    }
    for (int k = 0; k < 6 && family.size() < count; ++k) {
      family.push_back(drawn_case(drawn++, draw));
    }
  }
  return family;
}

std::vector<Case> make_random(std::size_t count) {
  std::vector<Case> cases;
  for (std::size_t i = 0; i < count; ++i) {
    cases.push_back({"random-" + std::to_string(i), "random", driver::random_scene(seed, i)});
  }
  return cases;
}

std::vector<CreepCase> make_creep_cases(std::size_t count) {
  driver::Draw draw(seed);
  std::vector<CreepCase> cases;
  for (std::size_t i = 0; i < count; ++i) {
    CreepCase made;
    made.scene = drawn_case(i, draw);
    made.scene.settings.set("friction.coefficient", draw.between(0.1, 0.5));
    const double spin = draw.between(-1.0, 1.0); // uniform on the sphere
    const double angle = draw.between(0.0, 2.0 * std::numbers::pi);
    const double rest = std::sqrt(1.0 - spin * spin);
    made.direction = {rest * std::cos(angle), rest * std::sin(angle), spin};
    made.size = draw.between_by_ratio(0.1, 10.0);
    cases.push_back(std::move(made));
  }
  return cases;
}

std::vector<CreepCase> make_motion_cases(std::size_t count) {
  struct Pair {
    const char* wheel;
    const char* rail;
  };
  constexpr std::array pairs{Pair{"S1002", "60E1"}, Pair{"LMA", "CHN60"}, Pair{"S1002", "56E1"}};
  constexpr double steps = 2000.0;
  std::vector<CreepCase> cases;
  for (std::size_t i = 0; i < count; ++i) {
    CreepCase made;
    const Pair& pair = pairs.at(i % pairs.size());
    made.scene.settings = driver::make_pair(pair.wheel, pair.rail);
    const driver::ServiceStep step = driver::service_step(
        static_cast<int>((static_cast<double>(i) + 0.5) * steps / static_cast<double>(count)));
    driver::set_pose(step, made.scene.settings);
    driver::set_motion(step, made.scene.settings);
    made.scene.settings.set("friction.coefficient", 0.3);
    cases.push_back(std::move(made));
  }
  return cases;
}

} // namespace tradeoff
