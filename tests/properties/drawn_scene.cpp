#include "drawn_scene.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace properties {

namespace {

/// A bump of wear at a place, with a width, and roughness of a height.
struct Wear {
  double place = 0.0;
  double width = 1.0;
  double depth = 0.0;
  double noise = 0.0;
};

WornProfile worn(std::int32_t kind, const std::string& name, const Wear& wear, double spacing,
                 std::mt19937_64& random) {
  WornProfile result;
  result.kind = kind;
  wrcontact::Profile profile;
  profile.load_standard(name);
  const double length = profile.length();
  std::normal_distribution<double> rough;
  const auto count = static_cast<int>(length / spacing);
  for (int i = 0; i <= count; ++i) {
    const wrcontact::Profile::Point at = profile.at(length * i / count);
    const double from = (at.lateral - wear.place) / wear.width;
    result.lateral.push_back(at.lateral);
    result.height.push_back(at.height - wear.depth * std::exp(-from * from) +
                            wear.noise * rough(random));
  }
  return result;
}

void set_value(wrcontact::Scene& scene, const std::string& key, const Value& value,
               double factor = 1.0) {
  if (const double* number = std::get_if<double>(&value)) {
    scene.set(key, *number * factor);
  } else {
    std::visit([&](const auto& other) { scene.set(key, other); }, value);
  }
}

} // namespace

double size_of(const std::string& unit) {
  if (unit == "MPa") {
    return 1e6;
  }
  double size = 1.0;
  for (std::size_t at = unit.find("mm"); at != std::string::npos; at = unit.find("mm", at + 1)) {
    const bool divides = at > 0 && unit[at - 1] == '/';
    const bool squared = unit.substr(at + 2, 1) == "2";
    size *= std::pow(1e-3, (divides ? -1.0 : 1.0) * (squared ? 2.0 : 1.0));
  }
  return size;
}

DrawnScene::DrawnScene(std::uint64_t seed) : random_(seed) {
  draw_profiles();
  draw_pose();
  draw_load();
  draw_solution();
}

double DrawnScene::between(double least, double greatest) {
  constexpr double steps = 9007199254740992.0; // 2^53
  return least + (greatest - least) * (static_cast<double>(random_() >> 11U) / steps);
}

double DrawnScene::between_by_ratio(double least, double greatest) {
  return least * std::exp(between(0.0, std::log(greatest / least)));
}

void DrawnScene::draw_profiles() {
  static const std::array names{wrcontact::standard_profile_names(WRC_WHEEL),
                                wrcontact::standard_profile_names(WRC_RAIL)};
  constexpr std::array keys{"wheelset.wheel", "track.rail"};
  for (const std::int32_t kind : {WRC_WHEEL, WRC_RAIL}) {
    const auto index = static_cast<std::size_t>(kind);
    const std::string& name = names[index][random_() % names[index].size()];
    values_[keys[index]] = name;
    if (chance(0.2)) {
      const Wear wear{between(-40.0, 40.0), between(5.0, 30.0),
                      chance(0.5) ? between(0.0, 3.0) : 0.0,
                      chance(0.5) ? between_by_ratio(1e-4, 0.02) : 0.0};
      WornProfile points = worn(kind, name, wear, between(0.3, 2.0), random_);
      points.smoothing_wavelength = wear.noise > 0.0 ? between(3.0, 10.0) : 0.0;
      (kind == WRC_WHEEL ? wheel_ : rail_) = std::move(points);
    }
  }
}

void DrawnScene::draw_pose() {
  if (chance(0.5)) {
    const double gauge = between(1425.0, 1445.0);
    set("track.gauge", gauge);
    set("wheelset.back_to_back", gauge - between(72.0, 84.0));
    set("wheelset.radius", between(300.0, 600.0));
    set("track.gauge_height", between(10.0, 16.0));
  }
  constexpr std::array cants{"1:20", "1:30", "1:40", "0"};
  if (chance(0.5)) {
    const std::size_t index = random_() % cants.size();
    set("track.inclination",
        index + 1 == cants.size() ? Value(0.0) : Value(std::string(cants[index])));
  } else if (chance(0.2)) {
    set("track.inclination", between(-0.1, 0.1));
  }
  set("pose.lateral", between(-10.0, 10.0));
  if (chance(0.6)) {
    set("pose.yaw", between(-0.03, 0.03));
  }
  if (chance(0.1)) {
    set("pose.roll", std::string("en15302"));
  } else if (chance(0.15)) {
    set("pose.roll", between(-0.005, 0.005));
  }
}

void DrawnScene::draw_load() {
  constexpr double least = 10.0;
  constexpr double greatest = 300e3;
  if (chance(0.15)) {
    set("load.both", between_by_ratio(least, greatest));
    set("load.of", std::string("normal"));
  } else {
    set("load.left", between_by_ratio(least, greatest));
    set("load.right", chance(0.5) ? number("load.left") : between_by_ratio(least, greatest));
  }
  if (chance(0.3)) {
    set("material.wheel.youngs_modulus", between_by_ratio(5e4, 1e6));
    set("material.rail.youngs_modulus", between_by_ratio(5e4, 1e6));
    set("material.wheel.poisson", between(0.0, 0.5));
    set("material.rail.poisson", between(0.0, 0.5));
  }
  if (chance(0.2)) { // the position instead: below where the first wheel touches
    try {
      wrcontact::Scene scene = made();
      scene.set("solve.until", "geometry");
      if (scene.solve()) {
        set("pose.vertical", scene.number("vertical") - between_by_ratio(1e-3, 0.4));
      }
    } catch (const wrcontact::Error&) {
      return; // refused, or off the rail: told where this scene is solved
    }
  }
}

void DrawnScene::draw_solution() {
  accuracy_ = between_by_ratio(1e-3, 1e-1);
  set("solve.accuracy", accuracy_);
  if (chance(0.1)) {
    accuracy_ = 0.1;
    set("solve.grid",
        std::vector<double>{std::floor(between(1.0, 65.0)), std::floor(between(1.0, 65.0))});
    set("solve.tolerance", between_by_ratio(1e-8, 1e-2));
  }
  const auto choose = [this](const std::string& key, double share, const std::string& word) {
    if (chance(share)) {
      set(key, word);
    }
  };
  choose("solve.model", 0.1, "hertz");
  choose("solve.model", 0.1, "kik-piotrowski");
  choose("solve.method", 0.05, "paper");
  choose("solve.side", 0.1, "left");
  choose("solve.side", 0.1, "right");
  if (chance(0.2)) {
    set("solve.joining_distance", chance(0.5) ? 0.0 : between(0.0, 20.0));
  }
  choose("solve.curved", 0.1, "yes");
  choose("solve.curved", 0.1, "auto");
  choose("solve.results", 0.2, "stress wear fatigue");
  if (chance(0.05)) {
    set("solve.element_limit", std::floor(between_by_ratio(1e3, 1e5)));
  }
  for (const char* key : {"material.wheel.yield_stress", "material.rail.yield_stress"}) {
    if (chance(0.3)) {
      set(key, between_by_ratio(200.0, 1200.0));
    }
  }
}

std::string DrawnScene::text_or(const std::string& key, const std::string& otherwise) const {
  const auto found = values_.find(key);
  const auto* text = found == values_.end() ? nullptr : std::get_if<std::string>(&found->second);
  return text == nullptr ? otherwise : *text;
}

void DrawnScene::multiply(const std::string& key, double factor) {
  const auto found = values_.find(key);
  if (found != values_.end()) {
    if (double* number = std::get_if<double>(&found->second)) {
      *number *= factor;
    }
  }
}

DrawnScene DrawnScene::mirrored() const {
  DrawnScene other = *this;
  for (const char* key : {"pose.lateral", "pose.yaw", "pose.roll"}) {
    other.multiply(key, -1.0);
  }
  if (has("load.left")) {
    other.set("load.left", number("load.right"));
    other.set("load.right", number("load.left"));
  }
  if (has("solve.side")) {
    other.set("solve.side", std::string(text_or("solve.side", "") == "left" ? "right" : "left"));
  }
  return other;
}

DrawnScene DrawnScene::stiffer(double factor) const {
  constexpr double steel = 210000.0;
  DrawnScene other = *this;
  if (!has("material.wheel.youngs_modulus")) {
    other.set("material.youngs_modulus", steel);
  }
  for (const char* key : {"material.youngs_modulus", "material.wheel.youngs_modulus",
                          "material.rail.youngs_modulus", "material.wheel.yield_stress",
                          "material.rail.yield_stress", "load.left", "load.right", "load.both"}) {
    other.multiply(key, factor);
  }
  return other;
}

void DrawnScene::set_profiles(wrcontact::Scene& scene) const {
  for (const auto* worn : {&wheel_, &rail_}) {
    if (*worn) {
      wrcontact::Profile profile;
      profile.set_points("worn", (*worn)->kind, (*worn)->lateral, (*worn)->height,
                         (*worn)->smoothing_wavelength);
      scene.set((*worn)->kind == WRC_WHEEL ? "wheelset.wheel" : "track.rail", profile);
    }
  }
}

wrcontact::Scene DrawnScene::made() const {
  wrcontact::Scene scene;
  for (const auto& [key, value] : values_) {
    set_value(scene, key, value);
  }
  set_profiles(scene);
  return scene;
}

wrcontact::Scene DrawnScene::made_in_si() {
  wrcontact::Scene scene;
  scene.set("convention.units", "SI");
  for (const auto& [key, value] : values_) {
    set_value(scene, key, value, size_of(wrcontact::Scene().key_unit(key)));
  }
  set_profiles(scene);
  scene.set("convention.units", "mm");
  for (auto& [key, value] : values_) {
    if (double* number = std::get_if<double>(&value)) {
      *number = scene.get_number(key);
    }
  }
  scene.set("convention.units", "SI");
  return scene;
}

} // namespace properties
