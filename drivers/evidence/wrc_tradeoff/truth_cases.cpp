#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <functional>
#include <numbers>

#include "support/random_scenes.hpp"
#include "wrc_tradeoff/truth.hpp"
#include "wrcontact.hpp"

namespace tradeoff {
namespace {

const std::filesystem::path folder = "truth_lists";
constexpr double flat_radius = 460.0;

/// A wheel with a flat, S1002 with the radius `flat_radius`.
struct Flat {
  const char* name;
  double half;     ///< of the chord, mm
  double rounding; ///< of its ends, mm of depth; 0: they are kinks
};
/// Depths of 0.9, 0.9 and 0.3 mm.
constexpr std::array flats{Flat{"sharp.slcw", 28.5, 0.0}, Flat{"rounded.slcw", 28.5, 0.03},
                           Flat{"shallow.slcw", 16.5, 0.02}};

double depth_of(const Flat& flat, double angle) {
  const double to_chord = std::sqrt(flat_radius * flat_radius - flat.half * flat.half);
  const double depth = flat_radius - to_chord / std::cos(angle);
  return flat.rounding > 0.0 ? flat.rounding * std::log1p(std::exp(depth / flat.rounding))
                             : std::max(depth, 0.0);
}

/// Slices every millimetre, to 10 mm beside the ends.
std::string written(const Flat& flat) {
  wrcontact::Profile profile;
  profile.load_standard("S1002");
  const int most = static_cast<int>(std::ceil(flat.half)) + 10;
  std::ofstream list(folder / flat.name);
  list << "0 1\n" << 2 * most + 1 << "\n0 0 0\n1\n";
  for (int i = -most; i <= most; ++i) {
    const double angle = i / flat_radius;
    const std::string slice = flat.name + std::to_string(i) + ".txt";
    list << angle << " '" << slice << "'\n";
    std::ofstream points(folder / slice);
    points.precision(12);
    const double depth = depth_of(flat, angle);
    const int count = static_cast<int>(profile.length() / 0.5);
    for (int k = 0; k <= count; ++k) {
      const auto at = profile.at(profile.length() * k / count);
      points << at.lateral << ' ' << at.height - depth << '\n';
    }
  }
  return (folder / flat.name).string();
}

constexpr std::array cants{1.0 / 40.0, 1.0 / 20.0, 0.0};

/// As vehicles use it.
void draw_use(driver::Draw& draw, driver::Settings& scene) {
  scene.set("track.inclination", std::atan(draw.one_of(cants)));
  scene.set("pose.lateral", draw.between(-8.0, 8.0));
  const double yaw = draw.between(-0.01, 0.01);
  scene.set("pose.yaw", draw.chance(0.5) ? yaw : 0.0);
  scene.set("load.both", draw.between_by_ratio(20e3, 150e3));
}

void draw_motion(driver::Draw& draw, driver::Settings& scene) {
  constexpr double speed = 20000.0;
  scene.set("motion.speed", speed);
  const double slip = draw.between_by_ratio(1e-4, 1e-2);
  scene.set("motion.pitch", speed / scene.number_or("wheelset.radius", flat_radius) *
                                (1.0 + (draw.chance(0.5) ? slip : -slip)));
  scene.set("motion.lateral", draw.between(-40.0, 40.0));
  scene.set("motion.yaw", draw.between(-0.05, 0.05));
  scene.set("friction.coefficient", draw.between(0.1, 0.5));
}

driver::Settings drawn_wheelset(driver::Draw& draw) {
  static const std::vector<std::string> wheels = wrcontact::standard_profile_names(WRC_WHEEL);
  static const std::vector<std::string> rails = wrcontact::standard_profile_names(WRC_RAIL);
  const std::string& wheel = draw.one_of(wheels);
  driver::Settings scene = driver::make_pair(wheel, draw.one_of(rails));
  scene.set("wheelset.radius",
            scene.number_or("wheelset.radius", flat_radius) * draw.between(0.9, 1.0));
  draw_use(draw, scene);
  return scene;
}

driver::Settings drawn_flat(driver::Draw& draw) {
  constexpr std::array rails{"60E1", "56E1", "54E2"};
  constexpr double beside = 4.0; // mm, where contact still reaches the flat
  const Flat& flat = draw.one_of(flats);
  driver::Settings scene = driver::make_pair("S1002", draw.one_of(rails));
  scene.texts.front().second = (folder / flat.name).string();
  scene.texts.emplace_back("solve.side", "left");
  draw_use(draw, scene);
  const double most = (flat.half + beside) / flat_radius;
  scene.set("pose.pitch", draw.between(-most, most));
  scene.set("pose.roll", 0.0);
  draw_motion(draw, scene);
  return scene;
}

driver::Settings drawn_crossing(driver::Draw& draw) {
  driver::Settings scene = driver::make_pair("S1002", "60E1");
  scene.texts.emplace_back("track.left.rail", (folder / "crossing.slcs").string());
  scene.texts.emplace_back("solve.side", "left");
  draw_use(draw, scene);
  scene.set("pose.lateral", draw.between(-4.0, 4.0));
  scene.set("pose.longitudinal", draw.between(-400.0, 700.0));
  scene.set("pose.roll", 0.0);
  draw_motion(draw, scene);
  return scene;
}

} // namespace

std::vector<Case> make_truth_cases(std::size_t wheels) {
  std::filesystem::create_directories(folder);
  for (const auto& entry : std::filesystem::directory_iterator(WRC_TRADEOFF_CROSSING)) {
    std::filesystem::copy_file(entry.path(), folder / entry.path().filename(),
                               std::filesystem::copy_options::overwrite_existing);
  }
  for (const Flat& flat : flats) {
    written(flat);
  }
  std::vector<Case> cases;
  const auto add = [&cases](const char* kind, std::size_t count, std::uint64_t seed, auto drawn) {
    driver::Draw draw(seed);
    for (std::size_t i = 0; i < count; ++i) {
      cases.push_back({kind + ('-' + std::to_string(i)), kind, drawn(draw)});
    }
  };
  add("flats", wheels / 5, 20261203, drawn_flat);
  add("crossings", wheels / 5, 20261204, drawn_crossing);
  add("creep", wheels * 3 / 20, 20261202, [](driver::Draw& draw) {
    driver::Settings scene = drawn_wheelset(draw);
    draw_motion(draw, scene);
    return scene;
  });
  add("wheels", wheels / 2, 20261127, drawn_wheelset);
  return cases;
}

} // namespace tradeoff
