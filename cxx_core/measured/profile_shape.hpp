/// What the shape of a profile's points shows about them: which way a wheel's flange or a rail's
/// head points, whether the outline is closed.
///
/// A flange is the widest part that stands more than 8 mm off the tread: 15 to 35 mm wide on a
/// wheel, while the face of its field side, however deep it was measured, is a few mm wide. A
/// rail's head is wide near its top and narrow near the ends of its side faces; a whole rail has a
/// foot wider than its head. Units mm, frame of the points as given. Thread rule: pure functions.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "profile/curve.hpp"

namespace wrc::reading {

/// What stands off the tread on one side of it.
struct Flange {
  bool is_down = false;    ///< towards negative heights
  bool is_outside = false; ///< towards positive lateral
  double width = 0.0;      ///< mm, 8 mm above the tread
  double other_width = 0;  ///< mm, of the part that rises on the other side
  double height = 0.0;     ///< mm, of the tip above the tread
  double tread_width = 0;  ///< mm, within 8 mm of the tread's height, to one side of the tip
  double beyond_tip = 0;   ///< mm, the same to the other side, where there is less
  Position tip{};          ///< the point farthest from the tread
};

/// The flange of a wheel's points; none if nothing stands off plainly.
std::optional<Flange> flange_of(std::span<const Position> points);

/// Of a rail's points.
struct Head {
  bool is_down = false;
  double top_width = 0.0;    ///< mm, within a few mm of the top
  double bottom_width = 0.0; ///< mm, within as much of the bottom
};

/// Which way a rail's head points; none if the shape does not show it.
std::optional<Head> head_of(std::span<const Position> points);

/// Radius of the circle that all points lie on, mm, its middle above or below theirs, and theirs at
/// lateral 0: a roller or the disc of a test rig; infinite for a cylinder. None for other bodies.
std::optional<double> disc_radius_of(std::span<const Position> points);

/// Least and greatest value of a coordinate.
Position extent_of(std::span<const Position> points, std::size_t coordinate);
/// Height of a rail's crown, from the gauge to the field side.
double crown_height_of(std::span<const Position> points);
double distance_between(const Position& a, const Position& b);
double chord_length(std::span<const Position> points);
/// The median distance of a point from the previous one.
double median_spacing(std::span<const Position> points);
/// Angle from direction a-b to direction c-d.
double angle_between(const Position& a, const Position& b, const Position& c, const Position& d);
/// Drops points closer than `least` to the one kept before. Returns how many.
std::size_t drop_close_points(std::vector<Position>& points, double least);
/// "(lateral, height)" with three digits behind the point.
std::string place_text(const Position& point);
/// With digits behind the point, as a message has them.
std::string fixed_text(double value, int digits = 2);

} // namespace wrc::reading
