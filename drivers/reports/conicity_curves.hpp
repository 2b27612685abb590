/// Rolling radius difference and contact angle difference over the lateral position, and equivalent
/// conicity over the amplitude: as numbers, in words, and drawn.
///
/// Units mm and rad; frame and signs of the track.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// The amplitude at which conicities are compared (EN 15302), mm.
inline constexpr double standard_amplitude = 3.0;

struct ConicityCurve {
  std::string name;  ///< in tables
  std::string title; ///< in the picture, with markup
  std::vector<double> lateral;
  std::vector<double> radius;
  std::vector<double> angle;     ///< tan of the left contact angle minus tan of the right one
  std::vector<double> amplitude; ///< 0.5 to 12 mm
  std::vector<double> conicity;  ///< NaN where there is none
  std::vector<std::string> no_conicity; ///< why
  /// Half of the range in which the conicity lies in 95 of 100 cases, as far as noise and short
  /// waves of profiles go; 0 with profiles that are built in, NaN where it is not known.
  std::vector<double> spread;

  /// At `standard_amplitude`; NaN if there is none.
  [[nodiscard]] double standard() const;
  /// Its spread; NaN if it is not known.
  [[nodiscard]] double standard_spread() const;
  /// The nonlinearity parameter: half of the difference of conicities at 4 and 2 mm, 1/mm (Polach,
  /// Characteristic parameters of nonlinear wheel/rail contact geometry, Veh. Syst. Dyn. 48, 2010);
  /// NaN if there is none.
  [[nodiscard]] double nonlinearity() const;
  /// A sentence without full stop about what is called `shown`.
  [[nodiscard]] std::string in_words(const std::string& shown) const;
};

/// From ascending positions, the differences of rolling radii and the contact angles of both wheels
/// there; NaN where there are none.
ConicityCurve conicity_curve(const std::vector<double>& lateral, const std::vector<double>& radius,
                             const std::vector<double>& left_angle,
                             const std::vector<double>& right_angle);

/// Fills the spread, by solving the scene at positions `key` (pose.lateral) from the first to the
/// last of the curve, with each curve that is as likely as that of the profiles.
void add_spread(ConicityCurve& curve, Scene scene, const std::string& key);

/// Curves below each other; `note` and `end_of_note` are script lines before the first panel and
/// after each one.
void draw_conicity_curves(const std::vector<ConicityCurve>& curves, const std::string& title,
                          const std::filesystem::path& path, const std::string& note = "",
                          const std::string& end_of_note = "");

} // namespace driver
