#include "wrc_profile/reports.hpp"

#include <cmath>
#include <iomanip>
#include <numbers>

#include "reports/smoothing.hpp"
#include "reports/warning_summary.hpp"
#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/scene.hpp"
#include "support/text_table.hpp"

namespace driver {
namespace {

const char* mate_of(const Profile& profile) {
  return is_wheel(profile) ? "60E1" : "S1002";
}

constexpr double degrees = 180.0 / std::numbers::pi;
constexpr int label_width = 20;

/// How both profiles of a comparison lie.
constexpr const char* alignment =
    "each in its own frame as read and corrected; neither is moved to fit the other";

/// A number that stands to the right of its label.
std::string aligned(double value, int decimals) {
  const std::string text = fixed(value, decimals);
  return std::string(12 - std::min<std::size_t>(12, text.size()), ' ') + text;
}

std::ostream& label(std::ostream& out, const std::string& text) {
  return out << "  " << std::left << std::setw(label_width) << text << ' ';
}

std::ostream& place(std::ostream& out, const ProfilePoint& point) {
  return out << "at lateral " << fixed(point.lateral, 3) << ", height " << fixed(point.height, 3);
}

void print_checks(const Checks& checks, std::ostream& out) {
  out << "\nChecks\n";
  label(out, "largest kink") << aligned(1e3 * checks.largest_kink, 4) << " mrad  ";
  place(out, checks.kink_at) << '\n';
  label(out, "largest step") << aligned(1e3 * checks.largest_step, 4) << " um    ";
  place(out, checks.step_at) << '\n';
  if (checks.smallest_radius > 0.0) {
    label(out, "smallest radius") << aligned(checks.smallest_radius, 3) << " mm    ";
    place(out, checks.radius_at) << (checks.radius_at.curvature < 0.0
                                         ? " (bends towards smaller height)\n"
                                         : " (bends towards larger height)\n");
  } else {
    label(out, "smallest radius") << "        none: straight\n";
  }
  for (const SteepPart& part : checks.steep_parts) {
    label(out, part.overhangs ? "overhanging part" : "steep part")
        << aligned(part.steepest_angle * degrees, 2) << " deg   lateral "
        << fixed(part.first.lateral, 3) << " to " << fixed(part.last.lateral, 3) << ", height "
        << fixed(part.first.height, 3) << " to " << fixed(part.last.height, 3) << '\n';
  }
  if (checks.steep_parts.empty()) {
    label(out, "steep parts") << "        none above " << steep_angle << " deg\n";
  }
}

void print_dimensions(const std::vector<Dimension>& dimensions, std::ostream& out) {
  for (const Dimension& dimension : dimensions) {
    label(out, dimension.label);
    if (dimension.value) {
      out << aligned(*dimension.value, 4);
    } else {
      out << std::right << std::setw(12) << "-";
    }
    out << ' ' << std::left << std::setw(6) << dimension.unit << dimension.definition
        << (dimension.value ? "\n" : "; the profile does not reach there\n");
  }
}

void print_comparison(const Comparison& comparison, std::ostream& out) {
  label(out, "largest") << aligned(1e3 * comparison.largest, 4) << " um    ";
  place(out, comparison.largest_at) << '\n';
  label(out, "rms") << aligned(1e3 * comparison.rms, 4) << " um    over "
                    << fixed(comparison.compared, 1) << " mm of the curve\n";
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

json json_of(const std::vector<Dimension>& dimensions) {
  json object = json::object();
  for (const Dimension& dimension : dimensions) {
    object[dimension.key] = dimension.value ? json(*dimension.value) : json();
  }
  return object;
}

json json_of(const Comparison& comparison) {
  return {{"largest", comparison.largest},
          {"largest_at", json_of(comparison.largest_at)},
          {"rms", comparison.rms},
          {"compared_length", comparison.compared},
          {"missing_area", comparison.missing_area},
          {"added_area", comparison.added_area}};
}

} // namespace

void print_table(const ProfileReport& report, std::ostream& out) {
  const Profile& profile = report.profile;
  const Measures& measures = report.measures;
  out << one_line(profile.text("name")) << ", " << kind_name(profile) << ": "
      << one_line(profile.text("title")) << '\n';
  label(out, "source") << one_line(profile.text("source")) << '\n';
  label(out, "confidence") << one_line(profile.text("confidence")) << '\n';
  const auto corrections = profile.corrections();
  for (const std::string& correction : corrections) {
    label(out, "corrected") << one_line(correction) << '\n';
  }
  if (corrections.empty()) {
    label(out, "corrected") << "nothing\n";
  }
  for (const std::string& warning : profile.warnings()) {
    label(out, "warning") << one_line(warning) << '\n';
  }
  label(out, "nodes") << measures.nodes.size() << '\n';
  label(out, "length") << fixed(measures.length, 3) << " mm\n";
  label(out, "lateral") << fixed(measures.least_lateral, 3) << " to "
                        << fixed(measures.greatest_lateral, 3)
                        << " mm (positive to the field side)\n";
  label(out, "height") << fixed(measures.least_height, 3) << " to "
                       << fixed(measures.greatest_height, 3)
                       << (is_wheel(profile) ? " mm (positive towards larger radius)\n"
                                             : " mm (positive upwards)\n");
  out << "\nDimensions\n";
  print_dimensions(measures.dimensions, out);
  print_checks(measures.checks, out);
  if (report.contact) {
    out << "\nLeft contact with " << mate_of(profile) << ", centred, "
        << general(report.contact->get_number("load.left")) << " N\n";
    TextTable table("llr", {22, 4, 10});
    for (std::vector<std::string>& row : smoothing_rows(*report.contact)) {
      table.add(std::move(row));
    }
    table.print(out);
    for (const std::string& line : lines_of(spread_warnings(*report.contact))) {
      out << "  " << line << '\n';
    }
  }
  if (report.comparison) {
    out << "\nNormal distance to " << one_line(*report.other_name)
        << " (positive: that one is higher)\n";
    print_comparison(*report.comparison, out);
    label(out, "area missing") << aligned(report.comparison->missing_area, 4)
                               << " mm2   where that one is higher\n";
    label(out, "area added") << aligned(report.comparison->added_area, 4)
                             << " mm2   where that one is lower\n";
    label(out, "alignment") << "        " << alignment << '\n';
    out << "\nDimensions less those of " << one_line(*report.other_name) << '\n';
    print_dimensions(report.comparison->differences, out);
  }
  if (report.conversion) {
    out << "\nWritten " << one_line(report.conversion->path) << ", a point every "
        << report.conversion->spacing << " mm of arc; read back, it differs by\n";
    print_comparison(report.conversion->difference, out);
  }
  if (!report.points.empty()) {
    TextTable table("r", {12, 12, 12, 13, 20});
    table.add({});
    std::vector<std::string> head{"arc", "lateral", "height", "angle/mrad", "curvature, 1/mm"};
    if (report.comparison) {
      head.emplace_back("distance, mm");
    }
    table.add(head);
    for (std::size_t i = 0; i < report.points.size(); ++i) {
      const ProfilePoint& point = report.points[i];
      std::vector<std::string> row{fixed(point.arc, 4), fixed(point.lateral, 5),
                                   fixed(point.height, 5), fixed(1e3 * point.angle, 4),
                                   power(point.curvature, 6)};
      if (report.comparison) {
        const double distance = report.distances[i];
        row.push_back(std::isnan(distance) ? "-" : fixed(distance, 5));
      }
      table.add(std::move(row));
    }
    table.print(out);
  }
}

void print_json(const ProfileReport& report, std::ostream& out) {
  const Measures& measures = report.measures;
  json object;
  for (const char* text : {"name", "title", "source", "confidence"}) {
    object[text] = report.profile.text(text);
  }
  object["kind"] = kind_name(report.profile);
  object["units"] = "mm, rad";
  object["corrections"] = report.profile.corrections();
  object["warnings"] = report.profile.warnings();
  object["nodes"] = measures.nodes.size();
  object["length"] = measures.length;
  object["extents"] = {{"lateral", {measures.least_lateral, measures.greatest_lateral}},
                       {"height", {measures.least_height, measures.greatest_height}}};
  object["dimensions"] = json_of(measures.dimensions);
  object["checks"] = json_of(measures.checks);
  if (report.contact) {
    json& contact = object["contact"];
    const auto number = [&report](const std::string& name) { // not a number becomes null
      return report.contact->number_or(name, std::nan(""));
    };
    contact["with"] = mate_of(report.profile);
    for (const char* name : {"pmax", "area", "spread.pmax", "spread.area", "spread.grade"}) {
      contact[name] = number(std::string("left.") + name);
    }
    for (const char* wave : {"0", "3", "5", "8", "15"}) {
      for (const char* name : {"pmax", "area"}) {
        const std::string result = std::string("smoothed_") + wave + "mm." + name;
        contact[result] = number("left." + result);
      }
    }
  }
  if (report.comparison) {
    object["comparison"] = json_of(*report.comparison);
    object["comparison"]["other"] = *report.other_name;
    object["comparison"]["alignment"] = alignment;
    object["comparison"]["differences"] = json_of(report.comparison->differences);
  }
  if (report.conversion) {
    object["conversion"] = json_of(report.conversion->difference);
    object["conversion"]["file"] = report.conversion->path;
    object["conversion"]["spacing"] = report.conversion->spacing;
  }
  if (!report.points.empty()) {
    object["points"] = json::array();
    for (std::size_t i = 0; i < report.points.size(); ++i) {
      object["points"].push_back(json_of(report.points[i]));
      if (report.comparison) { // not a number becomes null
        object["points"].back()["distance"] = report.distances[i];
      }
    }
  }
  print_json(object, out);
}

void print_list(bool as_json, std::ostream& out) {
  json list = json::array();
  TextTable table("l");
  for (const std::int32_t kind : {WRC_WHEEL, WRC_RAIL}) {
    for (const std::string& name : wrcontact::standard_profile_names(kind)) {
      Profile profile;
      profile.load_standard(name);
      list.push_back({{"name", name}, {"kind", kind_name(profile)}});
      for (const char* text : {"title", "source", "confidence"}) {
        list.back()[text] = profile.text(text);
      }
      table.add({name, kind_name(profile), profile.text("title")});
    }
  }
  if (as_json) {
    print_json(list, out);
  } else {
    table.print(out);
  }
}

} // namespace driver
