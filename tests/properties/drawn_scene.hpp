/// Scenes drawn at random over what a vehicle simulation may meet, as lists of keys and values, so
/// that they can be mirrored, told in other units and scaled before a handle is made of them.
/// Units mm, N, MPa, rad.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <variant>
#include <vector>

#include "wrcontact.hpp"

namespace properties {

using Value = std::variant<double, std::string, std::vector<double>>;

/// One of a unit in mm, N, N mm, MPa as a number in m, N, N m, Pa.
double size_of(const std::string& unit);

/// Points of a built-in profile with wear and noise, joined anew.
struct WornProfile {
  std::int32_t kind = WRC_WHEEL;
  std::vector<double> lateral;
  std::vector<double> height;
  double smoothing_wavelength = 0.0;
};

class DrawnScene {
public:
  /// The same seed draws the same scene.
  explicit DrawnScene(std::uint64_t seed);

  [[nodiscard]] bool has(const std::string& key) const { return values_.contains(key); }
  [[nodiscard]] double number(const std::string& key) const {
    return std::get<double>(values_.at(key));
  }
  [[nodiscard]] std::string text_or(const std::string& key, const std::string& otherwise) const;
  [[nodiscard]] double accuracy() const { return accuracy_; }
  [[nodiscard]] bool has_grid() const { return values_.contains("solve.grid"); }
  void set(const std::string& key, Value value) { values_[key] = std::move(value); }
  void multiply(const std::string& key, double factor);
  [[nodiscard]] const std::map<std::string, Value>& values() const { return values_; }
  /// Whether a profile is made of points, which no value tells.
  [[nodiscard]] bool has_points() const { return wheel_ || rail_; }
  /// Built-in profiles, or others by name, in their place.
  void drop_points() {
    wheel_.reset();
    rail_.reset();
  }

  /// Left and right exchanged.
  [[nodiscard]] DrawnScene mirrored() const;
  /// With moduli and loads multiplied.
  [[nodiscard]] DrawnScene stiffer(double factor) const;

  /// A scene with these values; throws wrcontact::Error if one is refused.
  [[nodiscard]] wrcontact::Scene made() const;
  /// The same through convention.units = "SI". The values of this scene become those that the
  /// made scene holds after the conversion, which rounds.
  [[nodiscard]] wrcontact::Scene made_in_si();

private:
  void draw_profiles();
  void draw_pose();
  void draw_load();
  void draw_solution();
  [[nodiscard]] double between(double least, double greatest);
  [[nodiscard]] double between_by_ratio(double least, double greatest);
  [[nodiscard]] bool chance(double share) { return between(0.0, 1.0) < share; }
  void set_profiles(wrcontact::Scene& scene) const;

  std::mt19937_64 random_;
  std::map<std::string, Value> values_;
  std::optional<WornProfile> wheel_;
  std::optional<WornProfile> rail_;
  double accuracy_ = 1e-3;
};

} // namespace properties
