#include "support/random_scenes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "support/numbers.hpp"
#include "wrcontact.hpp"

namespace driver {
namespace {

void draw_track(Draw& draw, Settings& scene) {
  constexpr std::array usual{0.0, 1.0 / 40.0, 1.0 / 20.0};
  scene.set("track.inclination",
            draw.chance(0.4) ? std::atan(draw.one_of(usual)) : draw.between(0.0, 0.15));
  scene.set("wheelset.radius", draw.between_by_ratio(150.0, 2500.0));
}

void draw_pose(Draw& draw, Settings& scene) {
  scene.set("pose.lateral", draw.between(-8.0, 8.0));
  // A quarter without yaw, a quarter as in curves, and half beyond what tracks ask for.
  const double greatest = draw.chance(0.5) ? 0.1 : draw.chance(0.5) ? 0.01 : 0.0;
  scene.set("pose.yaw", greatest > 0.0 ? draw.between(-greatest, greatest) : 0.0);
}

void draw_load(Draw& draw, Settings& scene) {
  const double left = draw.between_by_ratio(1e3, 4e5);
  scene.set("load.left", left);
  scene.set("load.right", draw.chance(0.5) ? left : draw.between_by_ratio(1e3, 4e5));
  if (draw.chance(0.3)) {
    scene.set("material.wheel.youngs_modulus", draw.between_by_ratio(7e4, 2.1e5));
    scene.set("material.rail.youngs_modulus", draw.between_by_ratio(7e4, 2.1e5));
  }
}

} // namespace

void Settings::set(const std::string& key, double value) {
  const auto found = std::find_if(numbers.begin(), numbers.end(),
                                  [&key](const auto& number) { return number.first == key; });
  if (found == numbers.end()) {
    numbers.emplace_back(key, value);
  } else {
    found->second = value;
  }
}

double Settings::number_or(const std::string& key, double otherwise) const {
  const auto found = std::find_if(numbers.begin(), numbers.end(),
                                  [&key](const auto& number) { return number.first == key; });
  return found == numbers.end() ? otherwise : found->second;
}

std::string Settings::options() const {
  std::string line;
  for (const auto& [key, value] : texts) {
    line.append(" --set ").append(key).append("=").append(value);
  }
  for (const auto& [key, value] : numbers) {
    line.append(" --set ").append(key).append("=").append(text_of(value));
  }
  return line.empty() ? line : line.substr(1);
}

Settings make_pair(const std::string& wheel, const std::string& rail) {
  const bool chinese_rail = rail == "CHN60";
  const bool chinese_wheel = wheel.starts_with("LM");
  const double radius = wheel == "LMA" ? 430.0 : chinese_wheel ? 420.0 : 460.0;
  Settings made;
  made.texts = {{"wheelset.wheel", wheel}, {"track.rail", rail}};
  made.numbers = {{"wheelset.back_to_back", chinese_rail || chinese_wheel ? 1353.0 : 1360.0},
                  {"wheelset.radius", radius},
                  {"track.gauge_height", chinese_rail ? 16.0 : 14.0}};
  return made;
}

Settings random_scene(std::uint64_t seed, std::uint64_t index) {
  static const std::vector<std::string> wheels = wrcontact::standard_profile_names(WRC_WHEEL);
  static const std::vector<std::string> rails = wrcontact::standard_profile_names(WRC_RAIL);
  constexpr std::uint64_t odd = 0x9e3779b97f4a7c15; // spreads neighbours over all seeds
  Draw draw(seed + odd * (index + 1));
  const std::string& wheel = draw.one_of(wheels);
  Settings scene = make_pair(wheel, draw.one_of(rails));
  draw_track(draw, scene);
  draw_pose(draw, scene);
  draw_load(draw, scene);
  return scene;
}

} // namespace driver
