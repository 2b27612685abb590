#include "varying_scene.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <utility>

#include "draw.hpp"
#include "rolling_scene.hpp"

namespace properties {

namespace {

constexpr double revolution = 2.0 * std::numbers::pi;
const std::filesystem::path folder = "varying_lists";

struct Point {
  double lateral;
  double height;
};
using Section = std::vector<Point>;

/// A built-in profile, every half millimetre of its arc.
Section standard(const std::string& name) {
  wrcontact::Profile profile;
  profile.load_standard(name);
  Section section;
  const int count = static_cast<int>(profile.length() / 0.5);
  for (int i = 0; i <= count; ++i) {
    const auto at = profile.at(profile.length() * i / count);
    section.push_back({at.lateral, at.height});
  }
  return section;
}

/// Places from `begin` on, `step` apart; sections without points are left out.
std::string write(const std::string& name, double begin, double end, double step,
                  const std::function<Section(double)>& section) {
  std::string places;
  int slices = 0;
  for (int i = 0; i <= std::lround((end - begin) / step); ++i) {
    const double place = begin + step * i;
    const std::string file = name + '_' + std::to_string(i) + ".txt";
    std::ofstream stream(folder / file);
    stream.precision(12);
    for (const Point& point : section(place)) {
      stream << point.lateral << ' ' << point.height << '\n';
    }
    places += std::to_string(place) + " '" + file + "'\n";
    ++slices;
  }
  std::ofstream(folder / name) << "0 1\n" << slices << "\n0 0 0\n1\n" << places;
  return (folder / name).string();
}

/// From 0 before `from` to 1 beyond `to`, without a kink.
double ramp(double x, double from, double to) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

/// A crown of 300 mm, flanks that steepen, about a lateral place.
double head(double y) {
  return -y * y / 600.0 - 6.0 * std::pow(std::abs(y) / 36.0, 6.0);
}

/// The nose, which rises, and the wing, which goes aside; in between a groove.
Section crossing(double x) {
  Section section;
  const bool nose = x > 60.0;
  const bool wing = x < 340.0;
  const double aside = 0.1 * x;
  const double begin = nose ? -36.0 : aside - 20.0;
  const double end = wing ? aside + 36.0 : 30.0;
  for (double y = begin; y <= end; y += 0.5) {
    const double of_nose = nose ? head(y + 10.0) - 6.0 + 6.0 * ramp(x, 60.0, 260.0) : -40.0;
    const double of_wing = wing ? head(y - aside) : -40.0;
    const double high = std::max(of_nose, of_wing);
    const double low = std::min(of_nose, of_wing);
    section.push_back({y, std::max(high + 0.3 * std::log1p(std::exp((low - high) / 0.3)), -38.0)});
  }
  return section;
}

} // namespace

VaryingLists::VaryingLists(const std::filesystem::path& others) {
  std::filesystem::create_directories(folder);
  const auto raised = [](Section section, double by) {
    for (Point& point : section) {
      point.height += by;
    }
    return section;
  };
  const Section rail = standard("60E1");
  const auto along = [&](const std::string& name, double begin, double end, double step,
                         const std::function<double(double)>& height) {
    const auto section = [&](double x) { return raised(rail, height(x)); };
    rails_.push_back({write(name, begin, end, step, section), begin, end, 0.0});
  };
  along("wave.slcs", -200.0, 200.0, 5.0,
        [](double x) { return 0.1 * std::cos(revolution * x / 100.0); });
  along("corrugation.slcs", -80.0, 80.0, 2.0,
        [](double x) { return 0.03 * std::cos(revolution * x / 40.0); });
  along("ramp.slcs", -100.0, 200.0, 10.0, [](double x) { return 8.0 * ramp(x, 0.0, 120.0); });
  const auto taper = [&](double x) {
    Section section = rail;
    for (Point& point : section) {
      point.lateral *= 1.0 + 0.0005 * x;
      point.height *= 1.0 - 0.001 * x;
    }
    return section;
  };
  rails_.push_back({write("taper.slcs", -100.0, 100.0, 10.0, taper), -100.0, 100.0, 0.0});
  rails_.push_back({write("crossing.slcs", 0.0, 400.0, 10.0, crossing), 0.0, 400.0, 750.0});
  const auto gap = [](double x) { // the field side is missing for a while
    Section section;
    const double end = x > 45.0 && x < 75.0 ? 0.0 : 36.0;
    for (double y = -36.0; y <= end; y += 0.5) {
      section.push_back({y, head(y)});
    }
    return section;
  };
  rails_.push_back({write("gap.slcs", 0.0, 120.0, 10.0, gap), 0.0, 120.0, 750.0});

  const Section wheel = standard("S1002");
  const auto around = [&](const std::string& name, double end, double step,
                          const std::function<double(double)>& height) {
    wheels_.push_back(
        write(name, -end, end, step, [&](double theta) { return raised(wheel, height(theta)); }));
  };
  around("flat.slcw", 0.2, 0.005, [](double theta) {
    return std::abs(theta) < 0.06 ? -0.45 * (1.0 + std::cos(theta * std::numbers::pi / 0.06)) : 0.0;
  });
  around("eccentric.slcw", 3.0, 0.1, [](double theta) { return 0.5 * std::cos(theta); });
  around("polygon.slcw", 3.1, 0.02, [](double theta) { return 0.05 * std::cos(18.0 * theta); });
  const auto shelled = [&](double theta) {
    Section section = wheel;
    for (Point& point : section) {
      const double from = std::hypot(point.lateral / 12.0, theta / 0.03);
      point.height -= 0.8 * std::exp(-from * from);
    }
    return section;
  };
  wheels_.push_back(write("shelled.slcw", -0.15, 0.15, 0.005, shelled));

  std::vector<std::filesystem::path> found;
  if (std::filesystem::is_directory(others)) {
    for (const auto& entry : std::filesystem::directory_iterator(others)) {
      found.push_back(entry.path());
    }
  }
  std::sort(found.begin(), found.end());
  for (const std::filesystem::path& path : found) {
    if (path.extension() == ".slcw") {
      wheels_.push_back(path.string());
    } else if (path.extension() == ".slcs") {
      const bool long_one = path.filename().string().starts_with("uk_");
      rails_.push_back(
          {path.string(), long_one ? -1000.0 : -200.0, long_one ? 2000.0 : 600.0, 750.0});
    }
  }
}

DrawnScene VaryingLists::scene(std::uint64_t seed) const {
  Draw draw(~seed);
  DrawnScene scene = draw.chance(0.7) ? rolling_loaded_scene(seed) : rolling_posed_scene(seed);
  scene.drop_points();
  const auto one_of = [&](const auto& all) -> const auto& {
    return all.at(static_cast<std::size_t>(draw.between(0.0, static_cast<double>(all.size()))));
  };
  for (const auto& [key, permitted] :
       {std::pair("solve.method", "auto"), {"solve.model", "half-space"}}) {
    if (draw.chance(0.95)) { // mostly the default
      scene.set(key, std::string(permitted));
    }
  }
  const bool by_rail = draw.chance(0.7);
  if (by_rail) {
    const List& list = one_of(rails_);
    scene.set("track.rail", list.path);
    if (list.origin != 0.0) {
      scene.set("track.rail.origin", list.origin);
    }
    scene.set("pose.longitudinal", draw.between(list.begin - 20.0, list.end + 20.0));
  }
  if (!by_rail || draw.chance(0.4)) {
    scene.set("wheelset.wheel", one_of(wheels_));
    scene.set("pose.pitch", draw.chance(0.7) ? draw.between(-0.15, 0.15) : draw.between(-1e3, 1e3));
  }
  return scene;
}

} // namespace properties
