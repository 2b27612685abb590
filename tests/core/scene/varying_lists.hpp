/// Lists of slices that tests write into a folder of their own, and scenes with them.
#pragma once

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <unistd.h>

#include <gtest/gtest.h>

#include "geometry/varying_shapes.hpp"
#include "keys/scene.hpp"
#include "profile/standard_profiles.hpp"

namespace wrc::test {

class VaryingScene : public ::testing::Test {
protected:
  VaryingScene()
      : folder_(std::filesystem::path(::testing::TempDir()) /
                ("wrcontact_varying_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~VaryingScene() override { std::filesystem::remove_all(folder_); }

  /// A list of a built-in profile, raised by a height at each place; places are moved and heights
  /// of the profile multiplied.
  [[nodiscard]] std::string list(const std::string& name, const std::string& profile,
                                 const std::vector<double>& places,
                                 const std::function<double(double)>& height, double moved = 0.0,
                                 double flattened = 1.0) const {
    const Curve curve = standard_profile(profile).curve;
    std::ofstream list(folder_ / name);
    list.precision(17);
    list << moved << " 1.0\n" << places.size() << "\n0 0 0\n1\n";
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::string slice = name + "_" + std::to_string(i) + ".txt";
      list << places[i] << " '" << slice << "'\n";
      std::ofstream file(folder_ / slice);
      file.precision(17);
      const int count = static_cast<int>(curve.length() / 0.5);
      for (int k = 0; k <= count; ++k) {
        const CurvePoint point = curve.at(curve.length() * k / count);
        file << point.lateral << ' ' << flattened * point.height + height(places[i]) << '\n';
      }
    }
    return folder_ / name;
  }
  [[nodiscard]] std::string wavy_rail(double moved = 0.0) const {
    return list(
        "wave" + std::to_string(moved) + ".slcs", "60E1", places_every(-120.0, 120.0, 4.0),
        [](double x) { return 0.05 * std::cos(2.0 * std::numbers::pi * x / 50.0); }, moved);
  }
  [[nodiscard]] std::string wheel_with_flat() const {
    return list("flat.slcw", "S1002", places_every(-0.2, 0.2, 0.01),
                [](double theta) { return -rounded_depth(theta, 0.6, 0.06); });
  }
  /// A flat with sharp ends.
  [[nodiscard]] std::string wheel_with_chord() const {
    return list("chord.slcw", "S1002", places_every(-0.1, 0.1, 0.004),
                [](double theta) { return -chord_depth(theta, 460.0, 57.0); });
  }

  /// A 60E1 that is absent between -half and half.
  [[nodiscard]] std::string rail_with_gap(const std::string& name, double half) const {
    const std::vector<double> places{-300.0, -half, 0.0, half, 300.0};
    std::ostringstream features;
    for (const double place : places)
      features << place << (place == 0.0 ? " -1 -1\n" : " 0 999\n");
    return with_features(list(name, "60E1", places, [](double) { return 0.0; }), "2",
                         features.str());
  }

  /// A list with lines of features at its end.
  static std::string with_features(const std::string& path, const std::string& count,
                                   const std::string& lines) {
    std::ifstream file(path);
    std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
    text.replace(text.find("0 0 0\n"), 1, count);
    std::ofstream(path) << text << lines;
    return path;
  }

private:
  std::filesystem::path folder_;
};

inline Scene scene_on(const std::string& rail, const std::string& wheel = "S1002") {
  Scene scene;
  scene.left.rail.name = scene.right.rail.name = rail;
  scene.left.wheel.name = scene.right.wheel.name = wheel;
  for (SceneSide* side : {&scene.left, &scene.right})
    side->rail.options.smoothing = side->wheel.options.smoothing = 0.0;
  scene.lateral = 1.5;
  scene.yaw = 0.003;
  scene.along = 7.0;
  scene.pitch = 0.03;
  scene.accuracy = 1e-2;
  scene.accuracy_of = AccuracyOf::forces;
  scene.motion = Motion{.speed = 20000.0, .lateral = 10.0};
  return scene;
}

} // namespace wrc::test
