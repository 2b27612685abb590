#include "wrc_tradeoff/family.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>

namespace tradeoff {
namespace {

/// Wheel, rail and the dimensions that go with them.
struct Pairing {
  const char* wheel;
  const char* rail;
  double back_to_back;
  double radius;
  double gauge_height;
};

constexpr std::array pairings{
    Pairing{"S1002", "60E1", 1360.0, 460.0, 14.0},  Pairing{"LMA", "CHN60", 1353.0, 430.0, 16.0},
    Pairing{"S1002", "54E2", 1360.0, 460.0, 14.0},  Pairing{"LM", "60E1", 1353.0, 420.0, 14.0},
    Pairing{"S1002", "56E1", 1360.0, 460.0, 14.0},  Pairing{"LM", "CHN60", 1353.0, 420.0, 16.0},
    Pairing{"S1002", "60E2", 1360.0, 460.0, 14.0},  Pairing{"LMA", "60E1", 1353.0, 430.0, 14.0},
    Pairing{"S1002", "CHN60", 1353.0, 457.5, 16.0}, Pairing{"S1002", "49E1", 1360.0, 400.0, 14.0},
};

/// Numbers that do not depend on the standard library's distributions.
class Draw {
public:
  double between(double least, double greatest) {
    constexpr double scale = 0x1p-64;
    return least + (greatest - least) * scale * static_cast<double>(engine_());
  }

private:
  static constexpr std::uint64_t seed = 20240607;
  std::mt19937_64 engine_{seed};
};

Case drawn_case(std::size_t index, Draw& draw) {
  const Pairing& pair = pairings[index % pairings.size()];
  Case made;
  made.group = "spread";
  made.name = "spread-" + std::to_string(index);
  made.settings.texts = {{"wheelset.wheel", pair.wheel}, {"track.rail", pair.rail}};
  made.settings.numbers = {{"wheelset.back_to_back", pair.back_to_back},
                           {"wheelset.radius", pair.radius},
                           {"track.gauge_height", pair.gauge_height}};
  constexpr std::array cants{1.0 / 40.0, 1.0 / 20.0, 0.0};
  made.settings.numbers.emplace_back("track.cant", std::atan(cants[(index / pairings.size()) % 3]));
  made.settings.numbers.emplace_back("pose.lateral", draw.between(-6.5, 6.5));
  const double yaw = draw.between(-0.04, 0.04);
  made.settings.numbers.emplace_back("pose.yaw", index % 2 == 0 ? 0.0 : yaw);
  made.settings.numbers.emplace_back("load.vertical",
                                     std::exp(draw.between(std::log(1e3), std::log(3e5))));
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
                         scene.number_or("load.vertical", usual));
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
  Draw draw;
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
  constexpr std::uint64_t seed = 20240607;
  std::vector<Case> cases;
  for (std::size_t i = 0; i < count; ++i) {
    cases.push_back({"random-" + std::to_string(i), "random", driver::random_scene(seed, i)});
  }
  return cases;
}

} // namespace tradeoff
