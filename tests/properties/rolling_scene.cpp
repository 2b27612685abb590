#include "rolling_scene.hpp"

#include <array>
#include <cmath>

#include "draw.hpp"

namespace properties {

namespace {

void draw_motion(Draw& draw, DrawnScene& scene) {
  scene.set("motion.speed", draw.chance(0.9) ? draw.signed_by_ratio(10.0, 1e5) : 0.0);
  if (draw.chance(0.3)) {
    scene.set("motion.pitch", std::string("free"));
    scene.set("motion.torque", draw.chance(0.5) ? 0.0 : draw.signed_by_ratio(1e3, 1e8));
  } else if (draw.chance(0.3)) {
    scene.set("motion.pitch", draw.signed_by_ratio(1e-1, 1e3));
  }
  if (draw.chance(0.5)) {
    scene.set("motion.lateral", draw.signed_by_ratio(1e-2, 1e3));
    scene.set("motion.yaw", draw.signed_by_ratio(1e-4, 1.0));
  }
  if (draw.chance(0.2)) {
    scene.set("motion.roll", draw.signed_by_ratio(1e-4, 10.0));
    scene.set("motion.vertical", draw.signed_by_ratio(1e-2, 1e3));
  }
  if (draw.chance(0.1)) {
    scene.set("motion.standstill_speed", std::abs(draw.signed_by_ratio(1e-2, 1e3)));
  }
}

void draw_creepages(Draw& draw, DrawnScene& scene) {
  const auto creepages = [&] {
    std::vector<double> values;
    for (const double largest : {1.0, 1.0, 0.1}) {
      values.push_back(draw.chance(0.2) ? 0.0 : draw.signed_by_ratio(1e-6 * largest, largest));
    }
    return values;
  };
  scene.set("creepage.left", creepages());
  scene.set("creepage.right", creepages());
}

void draw_rolling(Draw& draw, DrawnScene& scene) {
  if (draw.chance(0.5)) {
    draw_motion(draw, scene);
  } else {
    draw_creepages(draw, scene);
  }
  if (draw.chance(0.7)) {
    scene.set("friction.coefficient", draw.chance(0.9)   ? draw.by_ratio(0.01, 2.0)
                                      : draw.chance(0.5) ? draw.by_ratio(1e-307, 1e-2)
                                                         : 0.0);
  }
  if (draw.chance(0.2)) {
    scene.set("friction.limit_ratio", draw.between(0.1, 1.0));
    scene.set("friction.decay", draw.by_ratio(1e-4, 1.0));
  }
  constexpr std::array models{"linear", "shen-hedrick-elkins", "polach", "fastsim"};
  if (draw.chance(0.3)) {
    scene.set("solve.creep", std::string(models.at(static_cast<std::size_t>(
                                 draw.between(0.0, static_cast<double>(models.size()))))));
  }
  if (draw.chance(0.5)) {
    scene.set("solve.derivatives", std::string("yes"));
  }
}

/// Below where the first wheel touches; the middle of a wheelset that does not touch.
void draw_height(Draw& draw, DrawnScene& scene) {
  double height = draw.between(0.0, 6000.0);
  try {
    wrcontact::Scene touching = scene.made();
    touching.set("solve.until", "geometry");
    if (touching.solve()) {
      height = touching.number("vertical");
    }
  } catch (const wrcontact::Error&) {
    // Refused, or off the rail: found where this scene is solved.
  }
  const double depth = draw.chance(0.7) ? draw.by_ratio(1e-9, 1.0) : draw.by_ratio(1.0, 60.0);
  scene.set("pose.vertical", std::max(height - depth, 0.0));
}

} // namespace

DrawnScene rolling_loaded_scene(std::uint64_t seed) {
  DrawnScene scene(seed);
  Draw draw(~seed);
  if (draw.chance(0.1)) { // hardly any: contact on few elements
    const double share = draw.by_ratio(1e-6, 1e-1);
    for (const char* key : {"load.left", "load.right", "load.both"}) {
      scene.multiply(key, share);
    }
  }
  if (draw.chance(0.1)) {
    scene.set("wheelset.radius", draw.between(1000.0, 5000.0));
    scene.set("pose.yaw", draw.between(-0.1, 0.1));
  }
  draw_rolling(draw, scene);
  return scene;
}

DrawnScene rolling_posed_scene(std::uint64_t seed) {
  DrawnScene scene(seed);
  Draw draw(~seed);
  const bool large = draw.chance(0.4);
  if (large) {
    scene.set("wheelset.radius", draw.between(1000.0, 5000.0));
  }
  const bool far = draw.chance(0.5);
  if (far) {
    scene.set("pose.lateral", (draw.chance(0.5) ? 1.0 : -1.0) * draw.between(20.0, 60.0));
  }
  if (large || far || draw.chance(0.3)) {
    scene.set("pose.yaw",
              draw.chance(0.7) ? draw.between(-0.2, 0.2) : (draw.chance(0.5) ? 0.2 : -0.2));
  }
  scene.set("pose.roll", draw.chance(0.8) ? draw.between(-0.03, 0.03) : draw.between(-0.2, 0.2));
  draw_height(draw, scene);
  draw_rolling(draw, scene);
  return scene;
}

} // namespace properties
