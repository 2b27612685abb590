#include "wrc_report/pair.hpp"

#include <algorithm>

#include "support/parallel.hpp"
#include "support/scene_file.hpp"

namespace driver {
namespace {

constexpr double conicity_reach = 9.0;
constexpr double conicity_step = 0.05;

/// Elements that press, as an extent of y.
struct Extent {
  double least = std::numeric_limits<double>::infinity();
  double greatest = -std::numeric_limits<double>::infinity();
};

void include_pressed(const Scene& scene, const std::string& patch, Extent& extent) {
  const std::vector<double> y = scene.field(patch + "y");
  const std::vector<double> pressure = scene.field(patch + "pressure");
  for (std::size_t i = 0; i < y.size(); ++i) {
    if (pressure[i] > 0.0) {
      extent.least = std::min(extent.least, y[i]);
      extent.greatest = std::max(extent.greatest, y[i]);
    }
  }
}

/// Of the left wheel, where y grows to the field side as s and t do. The roll and the inclination
/// of the rail shift positions by less than 0.1 mm over the height of a patch.
std::vector<PressedBand> bands_of(const Scene& scene) {
  std::vector<PressedBand> bands;
  const int patches = scene.count_of("left.patches");
  for (int i = 0; i < patches; ++i) {
    const std::string patch = "left.patches." + std::to_string(i) + '.';
    Extent extent;
    const int parts = scene.count_of(patch + "parts");
    for (int part = 0; part < parts; ++part) {
      include_pressed(scene, patch + "parts." + std::to_string(part) + '.', extent);
    }
    if (parts == 0) {
      include_pressed(scene, patch, extent);
    }
    if (extent.least <= extent.greatest) {
      const double y = scene.number(patch + "centroid.y");
      const double s = scene.number(patch + "centroid.s_wheel") - y;
      const double t = scene.number(patch + "centroid.t_rail") - y;
      bands.push_back(
          {s + extent.least, s + extent.greatest, t + extent.least, t + extent.greatest});
    }
  }
  return bands;
}

Position solved(Scene& scene, double lateral) {
  Position position;
  position.lateral = lateral;
  try {
    scene.set("solve.side", "left");
    scene.set("pose.lateral", lateral);
    if (!scene.solve()) {
      position.trouble = "not converged";
    }
    position.warnings = warnings_of(scene);
    position.pmax = scene.number("left.pmax");
    position.elastic = scene.number("left.pmax_elastic");
    position.area = scene.number("left.area");
    position.angle = scene.number("left.angle");
    position.radius = scene.number("left.rigid_contact.rolling_radius");
    position.s_wheel = scene.number("left.rigid_contact.s_wheel");
    position.t_rail = scene.number("left.rigid_contact.t_rail");
    position.bands = bands_of(scene);
  } catch (const std::exception& error) {
    position.trouble = error.what();
  }
  return position;
}

} // namespace

Pair::Pair(const std::string& wheel_name, const std::string& rail_name,
           std::vector<std::string> keys)
    : assignments(std::move(keys)), rail_text(rail_name) {
  for (const std::string& text : assignments) {
    const std::string key = split_assignment(text).key;
    for (const char* own : {"wheelset.wheel", "track.rail", "pose.lateral", "solve.side",
                            "solve.until", "convention.units", "convention.frame"}) {
      if (key == own || profile_of(key) == own) {
        throw Failure("--set " + text + ": must be another key; the report sets " + key +
                      " itself");
      }
    }
  }
  Scene plain;
  apply_assignments(plain, assignments);
  wheel = load_profile(plain, WRC_WHEEL, wheel_name);
  rail = load_profile(plain, WRC_RAIL, rail_name);
}

Scene Pair::scene() const {
  Scene made;
  made.set("solve.accuracy", 1e-2);
  apply_assignments(made, assignments);
  made.set("wheelset.wheel", wheel);
  use_rail(made, rail, rail_text);
  return made;
}

std::vector<Position> positions_of(const Pair& pair, int threads) {
  std::vector<Position> positions(static_cast<std::size_t>(2.0 * position_reach / position_step) +
                                  1);
  std::vector<Scene> scenes; // made by one thread: a profile serves one at a time
  for (std::size_t i = 0; i < positions.size(); ++i) {
    scenes.push_back(pair.scene());
  }
  for_each_index(positions.size(), threads, [&](std::size_t i) {
    positions[i] = solved(scenes[i], -position_reach + position_step * static_cast<double>(i));
  });
  return positions;
}

ConicityCurve conicity_of(const Pair& pair) {
  Scene scene = pair.scene();
  scene.set("solve.until", "geometry");
  scene.set("pose.roll", "en15302");
  const auto count = static_cast<std::size_t>(2.0 * conicity_reach / conicity_step + 0.5) + 1;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> lateral(count);
  std::vector<double> radius(count, none);
  std::vector<double> left(count, none);
  std::vector<double> right(count, none);
  for (std::size_t i = 0; i < count; ++i) {
    lateral[i] = conicity_step * (static_cast<double>(i) - 0.5 * static_cast<double>(count - 1));
    scene.set("pose.lateral", lateral[i]);
    try {
      scene.solve();
      radius[i] = scene.number("rolling_radius_difference");
      left[i] = scene.number("left.rigid_contact.angle");
      right[i] = scene.number("right.rigid_contact.angle");
    } catch (const std::exception&) { // off the rail: there is none
    }
  }
  ConicityCurve curve = conicity_curve(lateral, radius, left, right);
  add_spread(curve, std::move(scene), "pose.lateral");
  return curve;
}

} // namespace driver
