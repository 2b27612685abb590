#include "wrc_regression/reports.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>

#include "support/output_file.hpp"

namespace driver {
namespace {

std::string escaped(const std::string& text) {
  std::string out;
  for (const char letter : text) {
    switch (letter) {
    case '&':
      out += "&amp;";
      break;
    case '<':
      out += "&lt;";
      break;
    case '>':
      out += "&gt;";
      break;
    case '"':
      out += "&quot;";
      break;
    default:
      out += letter;
    }
  }
  return out;
}

std::string percent(double share) {
  std::ostringstream text;
  text << std::fixed << std::setprecision(std::abs(share) < 1e-4 ? 5 : 2) << std::showpos
       << 100.0 * share << " %";
  return text.str();
}

std::string verdict(const Check& check) {
  if (!check.trouble.empty()) {
    return "FAILED: " + check.trouble;
  }
  if (std::isnan(check.expected)) {
    return "FAILED: no baseline yet (--update writes one)";
  }
  return check.passed() ? "ok" : "FAILED";
}

} // namespace

void print_checks(const std::vector<Check>& checks, std::ostream& out) {
  out << std::left << std::setw(9) << "group" << std::setw(26) << "case" << std::setw(32)
      << "result" << std::right << std::setw(14) << "expected" << std::setw(14) << "is"
      << std::setw(13) << "deviation"
      << "  allowed\n";
  std::map<std::string, Tolerance> tolerances;
  for (const Check& check : checks) {
    tolerances[check.tolerance.name] = check.tolerance;
    out << std::left << std::setw(9) << check.group << std::setw(26) << check.name << std::setw(32)
        << check.result << std::right << std::setprecision(7) << std::setw(14) << check.expected
        << std::setw(14) << check.actual << std::setw(13)
        << (check.trouble.empty() ? percent(check.deviation()) : "-") << "  "
        << check.tolerance.name << "  " << verdict(check) << '\n';
  }
  out << "\nTolerances, relative:\n";
  for (const auto& [name, tolerance] : tolerances) {
    out << "  " << std::left << std::setw(20) << name << std::setw(9) << tolerance.relative
        << tolerance.reason << '\n';
  }
  const auto failed = std::count_if(checks.begin(), checks.end(),
                                    [](const Check& check) { return !check.passed(); });
  out << '\n' << checks.size() << " checks, " << failed << " failed\n";
}

void write_junit(const std::vector<Check>& checks, const std::filesystem::path& path) {
  OutputFile file(path);
  std::ostream& out = file.stream();
  const auto failed = std::count_if(checks.begin(), checks.end(),
                                    [](const Check& check) { return !check.passed(); });
  out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuite name=\"wrc_regression\" tests=\""
      << checks.size() << "\" failures=\"" << failed << "\">\n";
  for (const Check& check : checks) {
    out << "  <testcase classname=\"" << escaped(check.group) << "\" name=\""
        << escaped(check.name + ": " + check.result) << "\"";
    if (check.passed()) {
      out << "/>\n";
    } else {
      out << ">\n    <failure message=\"expected " << check.expected << ", is " << check.actual
          << ", allowed " << check.tolerance.relative << " (" << escaped(check.tolerance.reason)
          << ")\">" << escaped(check.trouble) << "</failure>\n  </testcase>\n";
    }
  }
  out << "</testsuite>\n";
  file.commit();
}

} // namespace driver
