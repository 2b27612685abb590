#include "wrc_regression/checks.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "support/numbers.hpp"
#include "support/text_table.hpp"

namespace driver {
namespace {

std::string percent(double share) {
  return (share < 0.0 ? "" : "+") + fixed(100.0 * share, std::abs(share) < 1e-4 ? 5 : 2) + " %";
}

std::string verdict(const Check& check) {
  if (!check.trouble.empty()) {
    return "FAILED: " + check.trouble;
  }
  if (std::isnan(check.expected)) {
    return "FAILED: no stored result yet (--update writes one)";
  }
  return check.passed() ? "ok" : "FAILED";
}

} // namespace

void print_checks(const std::vector<Check>& checks, std::ostream& out) {
  TextTable table("lllrrrl");
  table.add({"group", "case", "result", "expected", "is", "deviation", "allowed"});
  std::map<std::string, Tolerance> tolerances;
  for (const Check& check : checks) {
    tolerances[check.tolerance.name] = check.tolerance;
    table.add({check.group, check.name, check.result, general(check.expected, 7),
               general(check.actual, 7), check.trouble.empty() ? percent(check.deviation()) : "-",
               check.tolerance.name, verdict(check)});
  }
  table.print(out);
  TextTable reasons("l");
  for (const auto& [name, tolerance] : tolerances) {
    reasons.add({"  " + name, general(tolerance.relative), tolerance.reason});
  }
  out << "\nTolerances, relative:\n";
  reasons.print(out);
  const auto failed = std::count_if(checks.begin(), checks.end(),
                                    [](const Check& check) { return !check.passed(); });
  out << '\n' << checks.size() << " checks, " << failed << " failed\n";
}

} // namespace driver
