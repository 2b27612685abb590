/// Scenes drawn at random over what vehicles may meet: all built-in wheels on all built-in rails
/// with the dimensions that belong to them, lateral displacements to 8 mm, yaw to 0.1 rad, cant to
/// 0.15 rad, radii of 150 to 2500 mm, 1 to 400 kN a wheel, moduli from 70 GPa. Units mm, N, MPa,
/// rad.
#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

namespace driver {

/// Numbers that do not depend on the standard library's distributions.
class Draw {
public:
  explicit Draw(std::uint64_t seed) : engine_(seed) {}
  double between(double least, double greatest) {
    return least + (greatest - least) * 0x1p-64 * static_cast<double>(engine_());
  }
  double between_by_ratio(double least, double greatest) {
    return least * std::exp(between(0.0, std::log(greatest / least)));
  }
  bool chance(double share) { return between(0.0, 1.0) < share; }
  template <class List> const auto& one_of(const List& list) {
    return list[engine_() % list.size()];
  }

private:
  std::mt19937_64 engine_;
};

/// Keys and values of a scene, to be set in this order.
struct Settings {
  std::vector<std::pair<std::string, std::string>> texts;
  std::vector<std::pair<std::string, double>> numbers;

  /// Replaces the number of a key, or adds it.
  void set(const std::string& key, double value);
  [[nodiscard]] double number_or(const std::string& key, double otherwise) const;
  /// As options of wrc_case that replay the scene: --set KEY=VALUE --set ...
  [[nodiscard]] std::string options() const;

  /// To a scene of the drivers, or of wrcontact.hpp.
  template <class Scene> void apply(Scene& scene) const {
    for (const auto& [key, value] : texts) {
      scene.set(key, value);
    }
    for (const auto& [key, value] : numbers) {
      scene.set(key, value);
    }
  }
};

/// A wheel on a rail, with the distance of the wheels' inner faces and the height at which the
/// gauge is measured that are usual where both run.
Settings make_pair(const std::string& wheel, const std::string& rail);

/// The scene of this number, the same wherever and in whatever order scenes are drawn.
Settings random_scene(std::uint64_t seed, std::uint64_t index);

} // namespace driver
