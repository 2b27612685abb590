#include "profile/writers.hpp"

#include <cmath>
#include <string>

#include "base/error.hpp"
#include "base/file.hpp"
#include "profile/file_type.hpp"
#include "profile/limits.hpp"

namespace wrc {
namespace {

std::vector<Position> sample(const Curve& curve, double spacing) {
  const double parts = std::ceil(curve.length() / spacing);
  if (!(spacing > 0.0) || !(parts >= 1.0) ||
      parts + 1.0 > static_cast<double>(ReadLimits::max_points)) {
    throw_invalid_argument("spacing", spacing,
                           "a positive number of mm that gives 2 to " +
                               std::to_string(ReadLimits::max_points) + " points");
  }
  std::vector<Position> points;
  const auto count = static_cast<std::size_t>(parts);
  for (std::size_t i = 0; i <= count; ++i) {
    const CurvePoint point =
        curve.at(curve.length() * (static_cast<double>(i) / static_cast<double>(count)));
    points.push_back({point.lateral, point.height});
  }
  return points;
}

/// A text for a comment or a quoted value: one line without quotes.
std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == '\'' || c == '\x7F') {
      c = ' ';
    }
  }
  return text.substr(0, 1000);
}

std::string columns_text(const Profile& profile, const std::vector<Position>& points) {
  const bool wheel = profile.kind == ProfileKind::wheel;
  std::string text = "# " + one_line(profile.title) + "\n";
  text += wheel ? "# wheel: lateral mm, positive to the field side; height mm, positive towards "
                  "larger radius\n"
                : "# rail: lateral mm, positive to the field side; height mm, positive upwards\n";
  for (const Position& point : points) {
    text.append(text_of(point[0])).append(" ").append(text_of(point[1])).append("\n");
  }
  return text;
}

std::string simpack_text(const Profile& profile, const std::vector<Position>& points) {
  const bool wheel = profile.kind == ProfileKind::wheel;
  std::string text = "header.begin\n  version = 1\n  type = ";
  text += wheel ? "1 ! 0 rail, 1 wheel\n" : "0 ! 0 rail, 1 wheel\n";
  text += "header.end\nspline.begin\n  comment = '" + one_line(profile.title) + "'\n";
  text += "  units.len.f = 1000\n  point.begin\n";
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Position& point = points[wheel ? points.size() - 1 - i : i];
    text.append(text_of(point[0])).append(" ");
    text.append(text_of(wheel ? point[1] : -point[1])).append("\n");
  }
  text += "  point.end\nspline.end\n";
  return text;
}

std::string text_for(const Profile& profile, const std::filesystem::path& path, double spacing) {
  const std::vector<Position> points = sample(profile.curve, spacing);
  const std::string extension = path.extension().string();
  const FileType type = type_of(path);
  switch (type.format) {
  case ProfileFormat::columns:
    return columns_text(profile, points);
  case ProfileFormat::simpack:
    if (type.kind != profile.kind) {
      throw_invalid_argument("extension", extension, ".prw for wheels, .prr for rails");
    }
    return simpack_text(profile, points);
  case ProfileFormat::miniprof:
  case ProfileFormat::slices:
    break;
  }
  throw_invalid_argument("extension", extension, ".prr, .prw or two-column text");
}

} // namespace

void write_profile(const Profile& profile, const std::filesystem::path& path, double spacing) {
  write_file(path, text_for(profile, path, spacing));
}

void write_points(const Profile& profile, const std::filesystem::path& path) {
  write_file(path, columns_text(profile, profile.points));
}

} // namespace wrc
