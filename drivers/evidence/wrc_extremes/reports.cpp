#include "wrc_extremes/reports.hpp"

#include <algorithm>

#include "support/json.hpp"
#include "support/numbers.hpp"
#include "support/text_table.hpp"
#include "wrc_extremes/row.hpp"
#include "wrcontact.h"

namespace extremes {
namespace {

using driver::add_if;
using driver::json;

struct Column {
  const char* name;
  std::optional<double> Row::*member;
};
constexpr Column measured_columns[] = {{"pmax", &Row::pmax},
                                       {"approach", &Row::approach},
                                       {"fill", &Row::fill},
                                       {"load_balance", &Row::load_balance},
                                       {"overlap", &Row::overlap},
                                       {"complementarity", &Row::complementarity},
                                       {"pressure_error", &Row::pressure_error},
                                       {"error", &Row::error}};

void take_worse(std::optional<double>& worst, const std::optional<double>& value) {
  if (value) {
    worst = std::max(worst.value_or(*value), *value);
  }
}

std::string cut(const std::string& text, std::size_t length) {
  return text.size() <= length ? text : text.substr(0, length - 3) + "...";
}

/// Neighbouring points of the same kind that came out alike.
struct Range {
  std::string quantity, base;
  std::string first, last; ///< settings
  double from = 0.0;
  double to = 0.0;
  int points = 0;
  Verdict verdict = Verdict::wrong;
  std::optional<double> worst_residual; ///< of overlap and complementarity
  std::optional<double> worst_pressure_error;
  std::optional<double> worst_error;
  std::string message; ///< of its first point
};

std::vector<Range> ranges_of(const std::vector<Row>& rows) {
  std::vector<Range> ranges;
  for (const Quantity& quantity : quantities()) {
    std::vector<std::string> bases;
    for (const Row& row : rows) {
      if (row.quantity == quantity.name &&
          std::find(bases.begin(), bases.end(), row.base) == bases.end()) {
        bases.push_back(row.base);
      }
    }
    for (const std::string& base : bases) {
      bool first = true;
      for (const Row& row : rows) {
        if (row.quantity != quantity.name || row.base != base) {
          continue;
        }
        // Shapes have no order: each stands for itself.
        if (first || quantity.shapes || ranges.back().verdict != row.verdict) {
          Range& range = ranges.emplace_back();
          range.quantity = quantity.name;
          range.base = base;
          range.first = row.setting;
          range.from = row.value;
          range.verdict = row.verdict;
          range.message = row.message;
        }
        first = false;
        Range& range = ranges.back();
        range.last = row.setting;
        range.to = row.value;
        ++range.points;
        take_worse(range.worst_residual, row.overlap);
        take_worse(range.worst_residual, row.complementarity);
        take_worse(range.worst_pressure_error, row.pressure_error);
        take_worse(range.worst_error, row.error);
      }
    }
  }
  return ranges;
}

} // namespace

void print_table(const std::vector<Row>& rows, std::ostream& out) {
  out << rows.size() << " points:";
  for (const Verdict verdict : {Verdict::held, Verdict::warned, Verdict::none, Verdict::refused,
                                Verdict::faded, Verdict::wrong}) {
    out << ' '
        << std::count_if(rows.begin(), rows.end(),
                         [verdict](const Row& row) { return row.verdict == verdict; })
        << ' ' << name_of(verdict) << (verdict == Verdict::wrong ? "\n" : ",");
  }
  out << "\nresidual: largest overlap or gap under pressure over the largest displacement, "
         "recomputed\np error: error of the pressures at the smallest tolerance, against "
         "elimination in long double\nerror: error of pmax and approach, against a finer solution, "
         "a closed form, or other units\n";
  driver::TextTable table("lrrrrrl", {74, 4, 12});
  std::string quantity;
  std::string base;
  for (const Range& range : ranges_of(rows)) {
    if (range.quantity != quantity) {
      table.add({});
      table.add({range.quantity, "points", "verdict", "residual", "p error", "error", "said"});
      base.clear();
    }
    if (range.base != base) {
      table.add({"  " + range.base});
    }
    quantity = range.quantity;
    base = range.base;
    const std::string span = range.points == 1 ? range.first : range.first + "  to  " + range.last;
    table.add({"    " + cut(span, 70), std::to_string(range.points), name_of(range.verdict),
               driver::power(range.worst_residual, 0), driver::power(range.worst_pressure_error, 0),
               driver::power(range.worst_error, 0), cut(range.message, 90)});
  }
  table.print(out);
}

json json_of(const std::vector<Row>& rows, std::uint64_t seed) {
  json whole{{"version", wrc_version()}, {"seed", seed}};
  for (const Row& row : rows) {
    json made{{"quantity", row.quantity},        {"base", row.base},
              {"setting", row.setting},          {"value", row.value},
              {"verdict", name_of(row.verdict)}, {"status", row.status}};
    add_if(made, "asked", row.asked > 0.0 ? std::optional(row.asked) : std::nullopt);
    add_if(made, "truth", row.truth);
    for (const Column& column : measured_columns) {
      add_if(made, column.name, row.*column.member);
    }
    add_if(made, "message", row.message);
    whole["rows"].push_back(std::move(made));
  }
  for (const Range& range : ranges_of(rows)) {
    json made{{"quantity", range.quantity}, {"base", range.base},
              {"first", range.first},       {"last", range.last},
              {"from", range.from},         {"to", range.to},
              {"points", range.points},     {"verdict", name_of(range.verdict)}};
    add_if(made, "residual", range.worst_residual);
    add_if(made, "pressure_error", range.worst_pressure_error);
    add_if(made, "error", range.worst_error);
    whole["ranges"].push_back(std::move(made));
  }
  return whole;
}

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
      {"inclination", "Inclination of the rails", "inclination, rad", false, false},
      {"gauge", "Gauge", "gauge, mm", false, false},
      {"accuracy", "Requested accuracy", "accuracy", true, false},
      {"scene-grid", "Prescribed grid of a scene", "elements", true, false},
      {"grid", "Grid of a gap", "elements", true, false},
      {"aspect", "Aspect ratio of elements", "lateral/longitudinal", true, false},
      {"units", "Units of lengths and moduli", "factor", true, false},
      {"tolerance", "Tolerance", "tolerance", true, false},
      {"gap", "Shapes of gaps", "", false, true},
      {"points", "Points of a profile", "points", true, false},
      {"noise", "Noise on a profile", "standard deviation, mm", true, false},
      {"hollow", "Hollow wheel", "hollow, mm", true, false},
      {"conformal", "Conformal gauge corner", "relative excess width of the wheel over the rail",
       true, false},
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
  return name + ' ' + driver::general(value) + unit;
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
