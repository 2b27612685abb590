#include "wrc_regression/checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "support/output_file.hpp"
#include "support/scene_file.hpp"
#include "support/toml.hpp"

namespace driver {
namespace {

namespace fs = std::filesystem;

std::map<std::string, Tolerance> read_tolerances(const toml::table& file, const fs::path& path) {
  std::map<std::string, Tolerance> tolerances;
  const toml::table* all = file["tolerance"].as_table();
  if (all == nullptr) {
    throw Failure(path.string() + ": there are no tables [tolerance.NAME]");
  }
  for (const auto& [key, node] : *all) {
    const toml::table* table = node.as_table();
    const std::string name(key.str());
    const auto relative = table == nullptr ? std::nullopt : (*table)["relative"].value<double>();
    const auto reason = table == nullptr ? std::nullopt : (*table)["reason"].value<std::string>();
    if (!relative || !reason) {
      throw Failure(path.string() + ": tolerance." + name + " needs `relative` and `reason`");
    }
    tolerances[name] = {name, *relative, *reason};
  }
  return tolerances;
}

std::string baseline_name(const Check& check) {
  return check.name + ": " + check.result;
}

std::map<std::string, double> read_baselines(const fs::path& path) {
  std::map<std::string, double> values;
  if (!fs::exists(path)) {
    return values;
  }
  for (const auto& [key, node] : read_toml("baseline file", path.string())) {
    const auto number = number_of(node);
    if (!number) {
      throw Failure(path.string() + ": " + std::string(key.str()) + ": must be a number");
    }
    values.emplace(key.str(), *number);
  }
  return values;
}

/// What a case wants to know: results with values, or names alone for own baselines.
std::vector<Check> expectations(const toml::table& entry, const Check& model) {
  std::vector<Check> checks;
  if (const toml::table* expected = entry["expect"].as_table()) {
    for (const auto& [key, node] : *expected) {
      const auto number = number_of(node);
      if (!number) {
        throw Failure("case " + model.name + ": expect." + std::string(key.str()) + " = " +
                      text_of(node) + ": must be a number");
      }
      Check& check = checks.emplace_back(model);
      check.result = key.str();
      check.expected = *number;
    }
  } else if (const toml::array* names = entry["results"].as_array()) {
    for (const toml::node& node : *names) {
      Check& check = checks.emplace_back(model);
      check.result = node.value_or(std::string());
    }
  }
  if (checks.empty()) {
    throw Failure("case " + model.name + " needs `expect` or `results`");
  }
  return checks;
}

void solve(const toml::table& entry, std::vector<Check>& checks) {
  try {
    Values values;
    if (const toml::table* keys = entry["scene"].as_table()) {
      flatten(*keys, "", values);
    }
    Scene scene;
    set_values(scene, values);
    scene.solve();
    for (Check& check : checks) {
      check.actual = scene.number(check.result);
    }
  } catch (const std::runtime_error& failure) {
    for (Check& check : checks) {
      check.trouble = failure.what();
    }
  }
}

} // namespace

std::vector<Check> run_stored_cases(const fs::path& cases, const fs::path& baselines) {
  const toml::table file = read_toml("case file", cases.string());
  const auto tolerances = read_tolerances(file, cases);
  const auto stored = read_baselines(baselines);
  std::vector<Check> all;
  const toml::array* entries = file["case"].as_array();
  if (entries == nullptr) {
    throw Failure(cases.string() + ": there are no cases [[case]]");
  }
  for (const toml::node& node : *entries) {
    const toml::table& entry = *node.as_table();
    Check model;
    model.name = entry["name"].value_or(std::string());
    model.group = entry["group"].value_or(std::string());
    const auto tolerance = tolerances.find(entry["tolerance"].value_or(std::string()));
    if (tolerance == tolerances.end()) {
      throw Failure(cases.string() + ": case " + model.name + " names no known tolerance");
    }
    model.tolerance = tolerance->second;
    std::vector<Check> checks = expectations(entry, model);
    solve(entry, checks);
    for (Check& check : checks) {
      if (check.group == "own") {
        const auto found = stored.find(baseline_name(check));
        check.expected =
            found == stored.end() ? std::numeric_limits<double>::quiet_NaN() : found->second;
      }
      all.push_back(std::move(check));
    }
  }
  return all;
}

std::vector<std::string> update_baselines(const std::vector<Check>& checks, const fs::path& path) {
  const auto before = read_baselines(path);
  std::vector<std::string> changes;
  OutputFile file(path);
  file.stream() << "# Own baselines, written by wrc_regression --update: only to notice changes.\n";
  for (const Check& check : checks) {
    if (check.group != "own") {
      continue;
    }
    if (!check.trouble.empty()) {
      throw Failure("--update: " + baseline_name(check) + " has no value: " + check.trouble);
    }
    file.stream() << '"' << baseline_name(check) << "\" = " << check.actual
                  << (check.actual == std::floor(check.actual) ? ".0\n" : "\n");
    const auto old = before.find(baseline_name(check));
    if (old == before.end() || old->second != check.actual) {
      changes.push_back(baseline_name(check) + ": " +
                        (old == before.end() ? "new" : "was " + general(old->second, 12)) +
                        ", is " + general(check.actual, 12));
    }
  }
  file.commit();
  return changes;
}

} // namespace driver
