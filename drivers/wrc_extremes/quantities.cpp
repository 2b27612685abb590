#include <sstream>

#include "wrc_extremes/row.hpp"

namespace extremes {

const std::vector<Quantity>& quantities() {
  static const std::vector<Quantity> all{
      {"load", "Load", "load, N", true, false},
      {"modulus", "Young's modulus of both bodies", "Young's modulus, MPa", true, false},
      {"modulus-ratio", "Ratio of Young's moduli", "wheel/rail", true, false},
      {"poisson", "Poisson's ratio of both bodies", "Poisson's ratio", false, false},
      {"radius", "Wheel radius", "radius, mm", true, false},
      {"yaw", "Yaw", "yaw, rad", false, false},
      {"roll", "Roll, prescribed", "roll, rad", false, false},
      {"lateral", "Lateral displacement", "displacement to the left, mm", false, false},
      {"cant", "Inclination of the rails", "cant, rad", false, false},
      {"gauge", "Gauge", "gauge, mm", false, false},
      {"accuracy", "Accuracy asked", "accuracy", true, false},
      {"scene-grid", "Grid of a scene, by hand", "elements", true, false},
      {"grid", "Grid of a gap", "elements", true, false},
      {"aspect", "Aspect ratio of elements", "lateral/longitudinal", true, false},
      {"units", "Units of lengths and moduli", "factor", true, false},
      {"tolerance", "Tolerance", "tolerance", true, false},
      {"gap", "Shapes of gaps", "", false, true},
      {"points", "Points of a profile", "points", true, false},
      {"noise", "Noise on a profile", "standard deviation, mm", true, false},
      {"hollow", "Hollow wheel", "hollow, mm", true, false},
      {"conformal", "Conformal gauge corner", "wheel wider than the rail by a share of", true,
       false},
      {"profile", "Oddities of profiles", "", false, true},
      {"state", "States without usual contact", "", false, true},
  };
  return all;
}

std::vector<Point> all_points() {
  std::vector<Point> points;
  add_scene_points(points);
  add_normal_points(points);
  add_profile_points(points);
  add_state_points(points);
  return points;
}

std::string in_words(const std::string& name, double value, const std::string& unit) {
  std::ostringstream out;
  out << name << ' ' << value << unit;
  return out.str();
}

const char* name_of(Verdict verdict) {
  switch (verdict) {
  case Verdict::held:
    return "held";
  case Verdict::warned:
    return "warned";
  case Verdict::none:
    return "no contact";
  case Verdict::refused:
    return "refused";
  case Verdict::faded:
    return "faded";
  case Verdict::wrong:
    break;
  }
  return "wrong";
}

} // namespace extremes
