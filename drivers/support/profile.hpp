/// A profile handle for the drivers: owned, and with failures as exceptions.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "wrcontact.h"

namespace driver {

/// A curve at one place: mm, rad, 1/mm, in the frame of the profile.
struct ProfilePoint {
  double arc = 0.0;
  double lateral = 0.0;
  double height = 0.0;
  double angle = 0.0;
  double curvature = 0.0;
};

class Profile {
public:
  /// Both throw Failure.
  static Profile standard(const std::string& name);
  static Profile file(const std::string& path, const wrc_read_options& options);

  [[nodiscard]] bool is_wheel() const;
  /// "wheel" or "rail".
  [[nodiscard]] std::string kind_name() const { return is_wheel() ? "wheel" : "rail"; }
  /// "name", "title", "source", "confidence".
  [[nodiscard]] std::string text(const std::string& name) const;
  [[nodiscard]] std::vector<std::string> corrections() const;
  [[nodiscard]] double length() const;
  /// Arc lengths of the nodes, at which the curve may have a kink or a step.
  [[nodiscard]] std::vector<double> nodes() const;
  [[nodiscard]] ProfilePoint at(double arc) const;
  void write(const std::string& path, double spacing) const;

private:
  Profile();
  void check(wrc_status status) const;
  std::unique_ptr<wrc_profile, void (*)(wrc_profile*)> handle_;
};

/// Names of the built-in profiles, WRC_WHEEL or WRC_RAIL.
std::vector<std::string> standard_profile_names(std::int32_t kind);
/// "Built-in wheels: ...\nBuilt-in rails: ...\n".
std::string standard_names_text();

} // namespace driver
