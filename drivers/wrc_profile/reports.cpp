#include "wrc_profile/reports.hpp"

#include <cmath>
#include <iomanip>
#include <numbers>

#include <nlohmann/json.hpp>

namespace driver {
namespace {

using nlohmann::json;

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr int label_width = 20;

/// A number with fixed decimals, aligned for a table.
class Fixed {
public:
  Fixed(double value, int decimals, int width = 0)
      : value_(value), decimals_(decimals), width_(width) {}
  friend std::ostream& operator<<(std::ostream& out, const Fixed& number) {
    // Adding zero turns -0 into 0.
    const double unit = std::pow(10.0, number.decimals_);
    const double rounded = std::round(number.value_ * unit) / unit + 0.0;
    return out << std::right << std::fixed << std::setprecision(number.decimals_)
               << std::setw(number.width_) << rounded << std::defaultfloat << std::setprecision(6);
  }

private:
  double value_;
  int decimals_;
  int width_;
};

std::ostream& label(std::ostream& out, const std::string& text) {
  return out << "  " << std::left << std::setw(label_width) << text << ' ';
}

std::ostream& place(std::ostream& out, const ProfilePoint& point) {
  return out << "at lateral " << Fixed(point.lateral, 3) << ", height " << Fixed(point.height, 3);
}

void print_checks(const Checks& checks, std::ostream& out) {
  out << "\nChecks\n";
  label(out, "largest kink") << Fixed(1e3 * checks.largest_kink, 4, 12) << " mrad  ";
  place(out, checks.kink_at) << '\n';
  label(out, "largest step") << Fixed(1e3 * checks.largest_step, 4, 12) << " um    ";
  place(out, checks.step_at) << '\n';
  if (checks.smallest_radius > 0.0) {
    label(out, "smallest radius") << Fixed(checks.smallest_radius, 3, 12) << " mm    ";
    place(out, checks.radius_at) << (checks.radius_at.curvature < 0.0
                                         ? " (bends towards smaller height)\n"
                                         : " (bends towards larger height)\n");
  } else {
    label(out, "smallest radius") << "        none: straight\n";
  }
  for (const SteepPart& part : checks.steep_parts) {
    label(out, part.overhangs ? "overhanging part" : "steep part")
        << Fixed(part.steepest_angle * degrees, 2, 12) << " deg   lateral "
        << Fixed(part.first.lateral, 3) << " to " << Fixed(part.last.lateral, 3) << ", height "
        << Fixed(part.first.height, 3) << " to " << Fixed(part.last.height, 3) << '\n';
  }
  if (checks.steep_parts.empty()) {
    label(out, "steep parts") << "        none above " << steep_angle << " deg\n";
  }
}

void print_comparison(const Comparison& comparison, std::ostream& out) {
  label(out, "largest") << Fixed(1e3 * comparison.largest, 4, 12) << " um    ";
  place(out, comparison.largest_at) << '\n';
  label(out, "rms") << Fixed(1e3 * comparison.rms, 4, 12) << " um    over "
                    << Fixed(comparison.compared, 1) << " mm of the curve\n";
}

json json_of(const ProfilePoint& point) {
  return {{"arc", point.arc},
          {"lateral", point.lateral},
          {"height", point.height},
          {"angle", point.angle},
          {"curvature", point.curvature}};
}

json json_of(const Checks& checks) {
  json object;
  object["largest_kink"] = checks.largest_kink;
  object["largest_kink_at"] = json_of(checks.kink_at);
  object["largest_step"] = checks.largest_step;
  object["largest_step_at"] = json_of(checks.step_at);
  const bool is_curved = checks.smallest_radius > 0.0;
  object["smallest_radius"] = is_curved ? json(checks.smallest_radius) : json();
  object["smallest_radius_at"] = is_curved ? json_of(checks.radius_at) : json();
  object["steep_parts"] = json::array();
  for (const SteepPart& part : checks.steep_parts) {
    object["steep_parts"].push_back({{"first", json_of(part.first)},
                                     {"last", json_of(part.last)},
                                     {"steepest_angle", part.steepest_angle},
                                     {"overhangs", part.overhangs}});
  }
  return object;
}

json json_of(const Comparison& comparison) {
  return {{"largest", comparison.largest},
          {"largest_at", json_of(comparison.largest_at)},
          {"rms", comparison.rms},
          {"compared_length", comparison.compared}};
}

} // namespace

void print_table(const ProfileReport& report, std::ostream& out) {
  const Profile& profile = report.profile;
  const Measures& measures = report.measures;
  out << profile.text("name") << ", " << profile.kind_name() << ": " << profile.text("title")
      << '\n';
  label(out, "source") << profile.text("source") << '\n';
  label(out, "confidence") << profile.text("confidence") << '\n';
  const auto corrections = profile.corrections();
  for (const std::string& correction : corrections) {
    label(out, "corrected") << correction << '\n';
  }
  if (corrections.empty()) {
    label(out, "corrected") << "nothing\n";
  }
  label(out, "nodes") << measures.nodes.size() << '\n';
  label(out, "length") << Fixed(measures.length, 3) << " mm\n";
  label(out, "lateral") << Fixed(measures.least_lateral, 3) << " to "
                        << Fixed(measures.greatest_lateral, 3)
                        << " mm (positive to the field side)\n";
  label(out, "height") << Fixed(measures.least_height, 3) << " to "
                       << Fixed(measures.greatest_height, 3)
                       << (profile.is_wheel() ? " mm (positive towards larger radius)\n"
                                              : " mm (positive upwards)\n");
  out << "\nDimensions\n";
  for (const Dimension& dimension : measures.dimensions) {
    label(out, dimension.label);
    if (dimension.value) {
      out << Fixed(*dimension.value, 4, 12);
    } else {
      out << std::right << std::setw(12) << "-";
    }
    out << ' ' << std::left << std::setw(6) << dimension.unit << dimension.definition
        << (dimension.value ? "\n" : "; the profile does not reach there\n");
  }
  print_checks(measures.checks, out);
  if (report.comparison) {
    out << "\nNormal distance to " << *report.other_name << " (positive: that one is higher)\n";
    print_comparison(*report.comparison, out);
  }
  if (report.conversion) {
    out << "\nWritten " << report.conversion->path << ", a point every "
        << report.conversion->spacing << " mm of arc; read back, it differs by\n";
    print_comparison(report.conversion->difference, out);
  }
  if (!report.points.empty()) {
    out << "\n         arc     lateral      height   angle/mrad     curvature, 1/mm\n";
    for (const ProfilePoint& point : report.points) {
      out << Fixed(point.arc, 4, 12) << Fixed(point.lateral, 5, 12) << Fixed(point.height, 5, 12)
          << Fixed(1e3 * point.angle, 4, 13) << std::scientific << std::setprecision(6)
          << std::setw(20) << point.curvature << std::defaultfloat << '\n';
    }
  }
}

void print_json(const ProfileReport& report, std::ostream& out) {
  const Measures& measures = report.measures;
  json object;
  for (const char* text : {"name", "title", "source", "confidence"}) {
    object[text] = report.profile.text(text);
  }
  object["kind"] = report.profile.kind_name();
  object["units"] = "mm, rad";
  object["corrections"] = report.profile.corrections();
  object["nodes"] = measures.nodes.size();
  object["length"] = measures.length;
  object["extents"] = {{"lateral", {measures.least_lateral, measures.greatest_lateral}},
                       {"height", {measures.least_height, measures.greatest_height}}};
  object["dimensions"] = json::object();
  for (const Dimension& dimension : measures.dimensions) {
    object["dimensions"][dimension.key] = dimension.value ? json(*dimension.value) : json();
  }
  object["checks"] = json_of(measures.checks);
  if (report.comparison) {
    object["comparison"] = json_of(*report.comparison);
    object["comparison"]["other"] = *report.other_name;
  }
  if (report.conversion) {
    object["conversion"] = json_of(report.conversion->difference);
    object["conversion"]["file"] = report.conversion->path;
    object["conversion"]["spacing"] = report.conversion->spacing;
  }
  if (!report.points.empty()) {
    object["points"] = json::array();
    for (const ProfilePoint& point : report.points) {
      object["points"].push_back(json_of(point));
    }
  }
  out << object.dump(2) << '\n';
}

void print_list(bool as_json, std::ostream& out) {
  json list = json::array();
  for (const std::int32_t kind : {WRC_WHEEL, WRC_RAIL}) {
    for (const std::string& name : standard_profile_names(kind)) {
      const Profile profile = Profile::standard(name);
      if (as_json) {
        list.push_back({{"name", name},
                        {"kind", profile.kind_name()},
                        {"title", profile.text("title")},
                        {"source", profile.text("source")},
                        {"confidence", profile.text("confidence")}});
      } else {
        out << std::left << std::setw(18) << name << std::setw(7) << profile.kind_name()
            << profile.text("title") << '\n';
      }
    }
  }
  if (as_json) {
    out << list.dump(2) << '\n';
  }
}

} // namespace driver
