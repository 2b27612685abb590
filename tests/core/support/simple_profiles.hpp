/// Profiles simple enough for closed forms: a cylindrical wheel and a rail with a circular crown.
#pragma once

#include <array>
#include <cmath>

#include "profile/profile.hpp"
#include "profile/segments.hpp"

namespace wrc::test {

inline Profile cylindrical_wheel() {
  const std::array<Segment, 1> segments{
      Segment{"tread", LineSegment{{{-70.0, 0.0}}, {{60.0, 0.0}}}}};
  return {"cylinder", ProfileKind::wheel, "", "", "", curve_of(segments)};
}

/// A cylindrical tread that turns into a flank of 60 degrees 30 mm from the taping line.
inline Profile wheel_with_flank() {
  const std::array<Segment, 2> segments{
      Segment{"flank", LineSegment{{{-40.0, 10.0 * std::sqrt(3.0)}}, {{-30.0, 0.0}}}},
      Segment{"tread", LineSegment{{{-30.0, 0.0}}, {{60.0, 0.0}}}}};
  return {"flank", ProfileKind::wheel, "", "", "", curve_of(segments)};
}

/// Crown of the given radius, 70 mm wide, between upright sides that are 20 mm deep.
inline Profile circular_rail(double radius) {
  constexpr double half_width = 35.0;
  const double drop = radius - std::sqrt(radius * radius - half_width * half_width);
  const std::array<Segment, 3> segments{
      Segment{"gauge side", LineSegment{{{-half_width, -drop - 20.0}}, {{-half_width, -drop}}}},
      Segment{"crown",
              ArcSegment{{{0.0, -radius}}, radius, {{-half_width, -drop}}, {{half_width, -drop}}}},
      Segment{"field side", LineSegment{{{half_width, -drop}}, {{half_width, -drop - 20.0}}}}};
  return {"circle", ProfileKind::rail, "", "", "", curve_of(segments)};
}

/// A sphere about the middle of the axle, 450 mm to both sides.
inline Profile spherical_wheel(double radius) {
  constexpr double half_width = 450.0;
  const double drop = radius - std::sqrt(radius * radius - half_width * half_width);
  const std::array<Segment, 1> segments{
      Segment{"sphere",
              ArcSegment{{{0.0, -radius}}, radius, {{-half_width, -drop}}, {{half_width, -drop}}}}};
  return {"sphere", ProfileKind::wheel, "", "", "", curve_of(segments)};
}

/// A plane 70 mm wide that rises to the field side, between an upright side and a ledge.
inline Profile inclined_rail(double angle) {
  const double half_width = 35.0 * std::cos(angle);
  const double rise = 35.0 * std::sin(angle);
  const std::array<Segment, 3> segments{
      Segment{"gauge side", LineSegment{{{-half_width, -rise - 20.0}}, {{-half_width, -rise}}}},
      Segment{"plane", LineSegment{{{-half_width, -rise}}, {{half_width, rise}}}},
      Segment{"ledge", LineSegment{{{half_width, rise}}, {{half_width + 20.0, rise - 2.0}}}}};
  return {"inclined", ProfileKind::rail, "", "", "", curve_of(segments)};
}

} // namespace wrc::test
