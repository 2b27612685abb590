/// Points as text, in the ways programs write them.
#pragma once

#include <functional>
#include <iomanip>
#include <sstream>
#include <string>
#include <vector>

#include "profile/curve.hpp"

namespace wrc {

struct RowStyle {
  std::string between = " ";
  std::string before = "";
  std::string after = "\n";
  char decimal = '.';
  char exponent = 0; ///< of every number, if given
};

inline std::string number_text(double value, const RowStyle& style = {}) {
  std::ostringstream out;
  if (style.exponent != 0)
    out << std::scientific << std::setprecision(12) << value;
  else
    out << std::fixed << std::setprecision(9) << value;
  std::string text = out.str();
  for (char& c : text)
    if (c == '.')
      c = style.decimal;
    else if (c == 'e')
      c = style.exponent;
  return text;
}

inline std::string rows(const std::vector<Position>& points, const RowStyle& style = {}) {
  std::string text;
  for (const Position& point : points)
    text += style.before + number_text(point[0], style) + style.between +
            number_text(point[1], style) + style.after;
  return text;
}

inline std::vector<Position> changed(std::vector<Position> points,
                                     const std::function<Position(Position)>& change) {
  for (Position& point : points)
    point = change(point);
  return points;
}

inline std::vector<Position> scaled(const std::vector<Position>& points, double lateral,
                                    double height) {
  return changed(points, [=](Position p) { return Position{lateral * p[0], height * p[1]}; });
}

inline std::vector<Position> reversed(const std::vector<Position>& points) {
  return {points.rbegin(), points.rend()};
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
  return text;
}

/// ASCII text in UTF-16.
inline std::string utf16(const std::string& text, bool little, bool mark) {
  std::string bytes;
  const auto add = [&](unsigned char high, unsigned char low) {
    bytes += static_cast<char>(little ? low : high);
    bytes += static_cast<char>(little ? high : low);
  };
  if (mark)
    add(0xFE, 0xFF);
  for (const char c : text)
    add(0, static_cast<unsigned char>(c));
  return bytes;
}

} // namespace wrc
