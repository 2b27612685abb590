#include "wrc_extremes/reports.hpp"

#include <algorithm>
#include <iomanip>
#include <sstream>

#include <nlohmann/json.hpp>

#include "support/csv_table.hpp"
#include "wrcontact.h"

namespace extremes {
namespace {

using nlohmann::json;

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

/// A range's points are shapes without an order: each stands for itself.
bool stands_alone(const std::string& quantity) {
  const auto& all = quantities();
  const auto found = std::find_if(
      all.begin(), all.end(), [&quantity](const Quantity& one) { return one.name == quantity; });
  return found != all.end() && found->shapes;
}

std::string short_number(const std::optional<double>& value) {
  if (!value) {
    return "-";
  }
  std::ostringstream out;
  out << std::scientific << std::setprecision(0) << *value;
  return out.str();
}

std::string cut(const std::string& text, std::size_t length) {
  return text.size() <= length ? text : text.substr(0, length - 3) + "...";
}

} // namespace

std::vector<Range> ranges_of(const std::vector<Row>& rows) {
  std::vector<Range> ranges;
  std::vector<std::pair<std::string, std::string>> kinds;
  for (const Quantity& quantity : quantities()) {
    for (const Row& row : rows) {
      const std::pair kind{row.quantity, row.base};
      if (row.quantity == quantity.name &&
          std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) {
        kinds.push_back(kind);
      }
    }
  }
  for (const auto& [quantity, base] : kinds) {
    bool first = true;
    for (const Row& row : rows) {
      if (row.quantity != quantity || row.base != base) {
        continue;
      }
      if (first || stands_alone(quantity) || ranges.back().verdict != row.verdict) {
        ranges.push_back({quantity,
                          base,
                          row.setting,
                          "",
                          row.value,
                          0.0,
                          0,
                          row.verdict,
                          {},
                          {},
                          {},
                          row.message});
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
  return ranges;
}

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
         "recomputed\np error: of the pressures at the floor of the tolerance, against "
         "elimination in long double\nerror: of pmax and approach, against a finer solution, a "
         "closed form, or other units\n";
  std::string quantity;
  std::string base;
  for (const Range& range : ranges_of(rows)) {
    if (range.quantity != quantity || range.base != base) {
      if (range.quantity != quantity) {
        out << '\n'
            << std::left << std::setw(72) << range.quantity << std::right
            << "points     verdict residual  p error    error  said\n";
      }
      quantity = range.quantity;
      base = range.base;
      out << "  " << base << '\n';
    }
    const std::string span = range.points == 1 ? range.first : range.first + "  to  " + range.last;
    out << "    " << std::left << std::setw(70) << cut(span, 70) << std::right << std::setw(4)
        << range.points << std::setw(12) << name_of(range.verdict) << std::setw(9)
        << short_number(range.worst_residual) << std::setw(9)
        << short_number(range.worst_pressure_error) << std::setw(9)
        << short_number(range.worst_error) << "  " << cut(range.message, 90) << '\n';
  }
}

void print_csv(const std::vector<Row>& rows, std::ostream& out) {
  out << "quantity,base,setting,value,verdict,status,asked,truth";
  for (const Column& column : measured_columns) {
    out << ',' << column.name;
  }
  out << ",message\n" << std::setprecision(17);
  for (const Row& row : rows) {
    out << row.quantity << ',' << driver::csv_quoted(row.base) << ','
        << driver::csv_quoted(row.setting) << ',' << row.value << ',' << name_of(row.verdict) << ','
        << row.status << ',' << row.asked << ',' << row.truth;
    for (const Column& column : measured_columns) {
      out << ',';
      if (row.*column.member) {
        out << *(row.*column.member);
      }
    }
    out << ',' << driver::csv_quoted(row.message) << '\n';
  }
}

void print_json(const std::vector<Row>& rows, std::uint64_t seed, std::ostream& out) {
  json whole{{"version", wrc_version()}, {"seed", seed}};
  for (const Row& row : rows) {
    json made{{"quantity", row.quantity},        {"base", row.base},
              {"setting", row.setting},          {"value", row.value},
              {"verdict", name_of(row.verdict)}, {"status", row.status}};
    if (row.asked > 0.0) {
      made["asked"] = row.asked;
    }
    if (!row.truth.empty()) {
      made["truth"] = row.truth;
    }
    for (const Column& column : measured_columns) {
      if (row.*column.member) {
        made[column.name] = *(row.*column.member);
      }
    }
    if (!row.message.empty()) {
      made["message"] = row.message;
    }
    whole["rows"].push_back(std::move(made));
  }
  for (const Range& range : ranges_of(rows)) {
    json made{{"quantity", range.quantity}, {"base", range.base},
              {"first", range.first},       {"last", range.last},
              {"from", range.from},         {"to", range.to},
              {"points", range.points},     {"verdict", name_of(range.verdict)}};
    for (const auto& [name, value] : {std::pair("residual", range.worst_residual),
                                      std::pair("pressure_error", range.worst_pressure_error),
                                      std::pair("error", range.worst_error)}) {
      if (value) {
        made[name] = *value;
      }
    }
    whole["ranges"].push_back(std::move(made));
  }
  out << whole.dump(1) << '\n';
}

} // namespace extremes
