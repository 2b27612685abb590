// Profiles as they are measured and worn: few and many points, noise, kinks, points twice, hollow
// wheels, conformal gauge corners.
#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <numbers>
#include <random>

#include "wrc_extremes/measure.hpp"

namespace extremes {
namespace {

struct Points {
  std::vector<double> lateral;
  std::vector<double> height;

  void add(double y, double z) {
    lateral.push_back(y);
    height.push_back(z);
  }
};

/// Points of a built-in profile at equal arcs.
Points points_of(const std::string& name, std::size_t count) {
  wrcontact::Profile profile;
  profile.load_standard(name);
  const double length = profile.length();
  Points points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto at = profile.at(length * static_cast<double>(i) / static_cast<double>(count - 1));
    points.add(at.lateral, at.height);
  }
  return points;
}

constexpr std::size_t usual_count = 400; // about half a millimetre apart
constexpr const char* wheel_name = "S1002";
constexpr const char* rail_name = "60E1";

wrcontact::Profile profile_of(const Points& points, std::int32_t kind, double smoothing = 0.0) {
  wrcontact::Profile profile;
  profile.set_points(kind == WRC_WHEEL ? "study wheel" : "study rail", kind, points.lateral,
                     points.height, smoothing);
  return profile;
}

using Make = std::function<Points(std::uint64_t seed)>;

/// A scene with a wheel (or rail) of the study's making.
Point profile_point(const std::string& quantity, const std::string& base,
                    const std::string& setting, double value, bool quick, std::int32_t kind,
                    const Make& make, double smoothing = 0.0, double lateral = 0.0) {
  return {quantity, base, setting, value, quick, [=](Row& row, std::uint64_t seed) {
            const wrcontact::Profile profile = profile_of(make(seed), kind, smoothing);
            measure_scene(
                [&](wrcontact::Scene& scene) {
                  scene.set(kind == WRC_WHEEL ? "wheelset.wheel" : "track.rail", profile);
                  scene.set("pose.lateral", lateral);
                },
                row, seed);
          }};
}

void add_counts(std::vector<Point>& points) {
  struct Body {
    const char* base;
    const char* profile;
    std::int32_t kind;
  };
  for (const std::size_t count : std::initializer_list<std::size_t>{
           1, 2, 3, 4, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000, 20000, 50000}) {
    for (const Body& body : {Body{"wheel S1002, y = 3 mm", wheel_name, WRC_WHEEL},
                             Body{"rail 60E1, y = 3 mm", rail_name, WRC_RAIL}}) {
      const bool quick = body.kind == WRC_WHEEL && (count == 1 || count == 50 || count == 50000);
      const auto value = static_cast<double>(count);
      points.push_back(profile_point(
          "points", body.base, in_words("points", value), value, quick, body.kind,
          [count, name = body.profile](std::uint64_t) {
            Points made = points_of(name, std::max<std::size_t>(count, 2));
            made.lateral.resize(count);
            made.height.resize(count);
            return made;
          },
          0.0, 3.0));
    }
  }
}

/// Normally distributed heights, by Box and Muller.
void add_noise(Points& points, double deviation, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  const auto uniform = [&engine] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1p-53; };
  for (double& height : points.height) {
    height += deviation * std::sqrt(-2.0 * std::log(uniform())) *
              std::cos(2.0 * std::numbers::pi * uniform());
  }
}

void add_noises(std::vector<Point>& points) {
  for (const double smoothing : {0.0, 5.0}) {
    for (const double deviation :
         {1e-9, 1e-6, 1e-5, 1e-4, 3e-4, 1e-3, 2e-3, 5e-3, 1e-2, 2e-2, 5e-2, 0.1, 0.3, 1.0}) {
      points.push_back(profile_point(
          "noise", smoothing > 0.0 ? "wheel, smoothed over 5 mm" : "wheel, points every 0.5 mm",
          in_words("standard deviation", deviation, " mm"), deviation, deviation == 1e-4, WRC_WHEEL,
          [deviation](std::uint64_t seed) {
            Points made = points_of(wheel_name, usual_count);
            add_noise(made, deviation, seed);
            return made;
          },
          smoothing));
    }
  }
}

/// A wheel hollow by `depth` around the contact, as a worn one.
Points hollow(double depth) {
  Points made = points_of(wheel_name, usual_count);
  for (std::size_t i = 0; i < made.lateral.size(); ++i) {
    const double share = made.lateral[i] / 20.0;
    made.height[i] -= depth * std::exp(-share * share);
  }
  return made;
}

void add_hollows(std::vector<Point>& points) {
  for (const double depth : {0.1, 0.2, 0.5, 1.0, 2.0, 3.0, 4.0, 5.0, 7.0, 10.0}) {
    for (const double lateral : {0.0, 4.0}) {
      points.push_back(profile_point(
          "hollow", in_words("y =", lateral, " mm"), in_words("hollow by", depth, " mm"), depth,
          depth == 2.0, WRC_WHEEL, [depth](std::uint64_t) { return hollow(depth); }, 0.0, lateral));
    }
  }
}

/// Where a conformal wheel is on the rail: moved towards the flange by a multiple of its excess
/// width, in mm.
struct Place {
  const char* name;
  double per_share, further;
};
constexpr Place places[] = {{"on the crown", 0.0, 0.0},
                            {"in the gauge corner", 28.0, 0.0},
                            {"wedged between gauge faces", 36.0, 0.1}};

/// The scene with an upright rail and a wheel whose profile is the rail's, turned over and widened
/// by a fraction: near a conformal fit.
SceneSetup conformal(double share, const Place& place) {
  Points made = points_of(rail_name, usual_count);
  for (std::size_t i = 0; i < made.lateral.size(); ++i) {
    made.lateral[i] *= 1.0 + share;
    made.height[i] *= -(1.0 + share);
  }
  const auto wheel = std::make_shared<wrcontact::Profile>(profile_of(made, WRC_WHEEL));
  wrcontact::Scene where;
  where.set("track.inclination", 0.0);
  where.set("solve.until", "geometry");
  where.solve();
  const double axis =
      where.number("left.rigid_contact.y") - where.number("left.rigid_contact.t_rail");
  const double taping_line =
      0.5 * where.get_number("wheelset.back_to_back") + where.get_number("wheelset.tape_offset");
  const double lateral = axis - taping_line + place.per_share * share + place.further;
  return [wheel, lateral](wrcontact::Scene& scene) {
    scene.set("wheelset.wheel", *wheel);
    scene.set("track.inclination", 0.0);
    scene.set("pose.roll", 0.0);
    scene.set("pose.lateral", lateral);
  };
}

void add_conformals(std::vector<Point>& points) {
  for (const Place& place : places) {
    for (const double share : {0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3}) {
      if (place.further > 0.0 && share < 0.2) {
        continue;
      }
      points.push_back({"conformal", place.name, in_words("wheel wider by", share), share,
                        share == 0.05, [share, place](Row& row, std::uint64_t seed) {
                          measure_scene(conformal(share, place), row, seed);
                        }});
    }
  }
}

Points with_points_twice(double apart) {
  const Points single = points_of(wheel_name, usual_count);
  Points made;
  for (std::size_t i = 0; i < single.lateral.size(); ++i) {
    made.add(single.lateral[i], single.height[i]);
    if (i % 5 == 2) {
      made.add(single.lateral[i] + apart, single.height[i]);
    }
  }
  return made;
}

/// A ridge or groove of the wheel's slope at s = -1.5 mm, in the contact.
Points with_kink(double angle) {
  Points made = points_of(wheel_name, usual_count);
  for (std::size_t i = 0; i < made.lateral.size(); ++i) {
    made.height[i] -= 0.5 * angle * std::abs(made.lateral[i] + 1.5);
  }
  return made;
}

Points with_step(double height) {
  Points made = points_of(wheel_name, usual_count);
  for (std::size_t i = 0; i < made.lateral.size(); ++i) {
    made.height[i] += made.lateral[i] > -1.5 ? height : 0.0;
  }
  return made;
}

Points reversed() {
  Points made = points_of(wheel_name, usual_count);
  std::reverse(made.lateral.begin(), made.lateral.end());
  std::reverse(made.height.begin(), made.height.end());
  return made;
}

Points in_disorder(std::uint64_t seed) {
  Points made = points_of(wheel_name, usual_count);
  std::mt19937_64 engine(seed);
  for (std::size_t i = made.lateral.size(); i-- > 1;) {
    const std::size_t k = engine() % (i + 1);
    std::swap(made.lateral[i], made.lateral[k]);
    std::swap(made.height[i], made.height[k]);
  }
  return made;
}

void add_shapes(std::vector<Point>& points) {
  double index = 0.0;
  bool quick = true;
  const auto add = [&](const std::string& name, const Make& make) {
    points.push_back(
        profile_point("profile", "wheel S1002", name, ++index, quick, WRC_WHEEL, make));
  };
  add("unchanged", [](std::uint64_t) { return points_of(wheel_name, usual_count); });
  add("right to left", [](std::uint64_t) { return reversed(); });
  add("shuffled", in_disorder);
  add("duplicate points", [](std::uint64_t) { return with_points_twice(0.0); });
  quick = false;
  add("duplicates 1e-12 mm apart", [](std::uint64_t) { return with_points_twice(1e-12); });
  add("duplicates 1e-6 mm apart", [](std::uint64_t) { return with_points_twice(1e-6); });
  add("duplicates 1e-3 mm apart", [](std::uint64_t) { return with_points_twice(1e-3); });
  for (const double angle : {1e-6, 1e-4, 1e-3, 0.01, 0.1}) {
    add(in_words("ridge of", angle, " rad"), [angle](std::uint64_t) { return with_kink(angle); });
    add(in_words("groove of", angle, " rad"), [angle](std::uint64_t) { return with_kink(-angle); });
  }
  for (const double height : {1e-6, 1e-4, 0.01, 1.0}) {
    add(in_words("step of", height, " mm"), [height](std::uint64_t) { return with_step(height); });
  }
  quick = true;
  add("all points equal", [](std::uint64_t) {
    return Points{std::vector<double>(100, 1.0), std::vector<double>(100, 2.0)};
  });
  add("all points at one height", [](std::uint64_t) {
    Points made = points_of(wheel_name, usual_count);
    std::fill(made.height.begin(), made.height.end(), 0.0);
    return made;
  });
  add("one height NaN", [](std::uint64_t) {
    Points made = points_of(wheel_name, usual_count);
    made.height[200] = std::nan("");
    return made;
  });
  add("one point 1 m off", [](std::uint64_t) {
    Points made = points_of(wheel_name, usual_count);
    made.height[200] += 1000.0;
    return made;
  });
  add("in metres", [](std::uint64_t) {
    Points made = points_of(wheel_name, usual_count);
    for (std::vector<double>* values : {&made.lateral, &made.height}) {
      for (double& value : *values) {
        value *= 1e-3;
      }
    }
    return made;
  });
}

} // namespace

void add_profile_points(std::vector<Point>& points) {
  add_counts(points);
  add_noises(points);
  add_hollows(points);
  add_conformals(points);
  add_shapes(points);
}

} // namespace extremes
