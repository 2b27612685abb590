/// Small profiles as text, for the readers' tests.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "measured/readers.hpp"
#include "profile/segments.hpp"

namespace wrc {

/// Points of a coarse wheel: flange up at negative lateral, ascending.
inline std::vector<Position> wheel_points() {
  std::vector<Position> points;
  for (double y = -70.0; y <= 60.0; y += 2.0)
    points.push_back({y, 28.0 * std::exp(-std::pow((y + 50.0) / 10.0, 2)) - y / 20.0});
  return points;
}

/// Points of a coarse rail head, height upwards, ascending; higher on the gauge side.
inline std::vector<Position> rail_points() {
  std::vector<Position> points;
  for (double y = -34.0; y <= 34.0; y += 2.0)
    points.push_back({y, -20.0 * std::pow(y / 34.0, 4) - 0.01 * y});
  return points;
}

inline std::string rows_of(const std::vector<Position>& points,
                           const std::function<Position(Position)>& change = {}) {
  std::string text;
  for (const Position& point : points) {
    const Position written = change ? change(point) : point;
    text += text_of(written[0]) + "\t" + text_of(written[1]) + "\n";
  }
  return text;
}

/// With coordinates multiplied.
inline std::string rows_of(const std::vector<Position>& points, double lateral, double height) {
  return rows_of(points, [&](Position p) { return Position{lateral * p[0], height * p[1]}; });
}

/// The text of the error, or "accepted". Expects it to name the file.
inline std::string refusal_of(const std::string& text, ProfileFormat format,
                              const ReadOptions& options = {}) {
  try {
    (void)read_profile_text(text, format, "sample", options);
  } catch (const Error& error) {
    const std::string what = error.what();
    return error.code() == ErrorCode::file_malformed && what.starts_with("sample:")
               ? what
               : "unexpected: " + what;
  }
  return "accepted";
}

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline bool says(const ReadResult& read, const std::string& part) {
  for (const std::string& line : read.corrections)
    if (contains(line, part))
      return true;
  return false;
}

/// Largest distance of the nodes of two curves at the given points.
inline double distance_at(const Curve& curve, const std::vector<Position>& points) {
  double largest = 0.0;
  for (const Position& point : points) {
    double least = HUGE_VAL;
    for (const double s : curve.starts())
      least = std::min(least,
                       std::hypot(curve.at(s).lateral - point[0], curve.at(s).height - point[1]));
    largest = std::max(largest, least);
  }
  return largest;
}

} // namespace wrc
