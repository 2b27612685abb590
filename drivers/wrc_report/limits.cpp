#include "wrc_report/limits.hpp"

#include <cmath>

#include "support/csv_table.hpp"
#include "support/numbers.hpp"
#include "support/program.hpp"
#include "support/scene.hpp"

namespace driver {
namespace {

double limit_in(const std::string& path, const std::string& text, double none) {
  if (text.empty()) {
    return none;
  }
  const std::optional<double> number = number_in(text);
  if (!number || !std::isfinite(*number)) {
    throw Failure(path + ": a limit is " + text + "; must be a finite number, or nothing");
  }
  return *number;
}

std::string shown(double value, const std::string& unit) {
  return std::isfinite(value) ? fixed(value, unit == "MPa" ? 0 : unit == "mm" ? 2 : 4) : "-";
}

} // namespace

std::vector<Limit> read_limits(const std::string& path) {
  const CsvTable table(path);
  const auto names = table.texts("quantity");
  const auto least = table.texts("least");
  const auto greatest = table.texts("greatest");
  const auto source = table.texts("source");
  std::vector<Limit> limits;
  for (std::size_t i = 0; i < names.size(); ++i) {
    Limit limit{names[i], 0.0, 0.0, source[i]};
    limit.least = limit_in(path, least[i], -std::numeric_limits<double>::infinity());
    limit.greatest = limit_in(path, greatest[i], std::numeric_limits<double>::infinity());
    if (!(limit.least <= limit.greatest) || (least[i].empty() && greatest[i].empty())) {
      throw Failure(path + ": the limits of " + names[i] + " are '" + least[i] + "' and '" +
                    greatest[i] + "'; must be one or two numbers, the least one first");
    }
    limits.push_back(limit);
  }
  if (limits.empty()) {
    throw Failure(path + " has no limits; must have one or more");
  }
  return limits;
}

std::string verdict(const Quantity& quantity, const Limit& limit) {
  const auto keeps = [&](double value) { return limit.least <= value && value <= limit.greatest; };
  if (std::isnan(quantity.value)) {
    return "not known";
  }
  if (!keeps(quantity.value)) {
    return "fail";
  }
  if (std::isnan(quantity.spread)) {
    return "pass, spread unknown";
  }
  return keeps(quantity.value - quantity.spread) && keeps(quantity.value + quantity.spread)
             ? "pass"
             : "pass, within its spread of the limit";
}

std::vector<std::vector<std::string>> limit_rows(const std::vector<Limit>& limits,
                                                 const Quantities& quantities) {
  std::vector<std::vector<std::string>> rows{
      {"quantity", "verdict", "value", "least", "greatest", "unit", "source"}};
  for (const Limit& limit : limits) {
    const auto found = quantities.find(limit.quantity);
    if (found == quantities.end()) {
      std::string all;
      for (const auto& [name, quantity] : quantities) {
        all += (all.empty() ? "" : ", ") + name;
      }
      throw Failure("--limits: " + limit.quantity +
                    " is no quantity of this report; must be one of " + all);
    }
    const Quantity& quantity = found->second;
    rows.push_back({quantity.meaning, verdict(quantity, limit),
                    shown(quantity.value, quantity.unit), shown(limit.least, quantity.unit),
                    shown(limit.greatest, quantity.unit), quantity.unit, limit.source});
  }
  return rows;
}

} // namespace driver
