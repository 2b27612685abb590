#include "steps.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace smoothness {
namespace {

/// Elements that change by more than this in a step were chosen anew.
constexpr double same_size = 1e-4;

std::string grid_of(const wrcontact::Scene& scene, const std::string& patch) {
  std::string text;
  for (const char* name : {".grid.lateral", ".grid.longitudinal"}) {
    if (scene.has_number(patch + name)) {
      text.append(text.empty() ? "" : "x");
      text.append(std::to_string(static_cast<long>(scene.number(patch + name))));
    }
  }
  return text;
}

/// Facts of the list's entries, `patches` or the `parts` of one.
void add_entries(const wrcontact::Scene& scene, const std::string& list, const std::string& told,
                 Facts& facts) {
  long count = 0;
  for (;; ++count) {
    const std::string entry = list + '.' + std::to_string(count);
    if (!scene.has_number(entry + ".pmax")) {
      break;
    }
    const std::string name = told + ' ' + std::to_string(count);
    facts[name + " grid"] = grid_of(scene, entry);
    facts[name + " lobes"] = std::to_string(static_cast<long>(scene.number(entry + ".lobes")));
    for (const char* direction : {"lateral", "longitudinal"}) {
      const std::string size = entry + ".element_size." + direction;
      if (scene.has_number(size)) {
        facts[name + " element " + direction] = std::to_string(scene.number(size));
      }
    }
    if (told == "patch") {
      add_entries(scene, entry + ".parts", name + " part", facts);
    }
  }
  facts[told == "patch" ? "patches" : told + "s"] = std::to_string(count);
}

std::string without_digits(std::string text) {
  std::erase_if(text, [](char c) { return std::string("0123456789.e-+").find(c) < 14; });
  return text;
}

bool same(const std::string& name, const std::string& one, const std::string& other) {
  if (name == "warnings") {
    return without_digits(one) == without_digits(other);
  }
  if (name.find(" element ") == std::string::npos) {
    return one == other;
  }
  const double size = std::stod(one);
  return std::abs(std::stod(other) - size) <= same_size * size;
}

} // namespace

std::vector<double> deviations(const std::vector<double>& values) {
  std::vector<double> made;
  std::array<double, 2 * window + 1> near{};
  for (std::size_t i = window; i + window + 1 < values.size(); ++i) {
    for (std::size_t k = 0; k < near.size(); ++k) {
      near[k] = values[i - window + k + 1] - values[i - window + k];
    }
    const double step = near[window];
    std::nth_element(near.begin(), near.begin() + window, near.end());
    made.push_back(std::abs(step - near[window]));
  }
  return made;
}

Facts facts_of(const wrcontact::Scene& scene, const std::string& side) {
  Facts facts;
  add_entries(scene, side + ".patches", "patch", facts);
  const std::string solutions = side + ".solutions";
  if (scene.has_number(solutions)) {
    facts["solutions"] = std::to_string(static_cast<long>(scene.number(solutions)));
  }
  for (const std::string& name : scene.text_names()) {
    if (name.starts_with(side + ".warnings.")) {
      facts["warnings"] += (facts["warnings"].empty() ? "" : "; ") + scene.text(name);
    }
  }
  return facts;
}

std::string changes(const Facts& before, const Facts& after) {
  std::string line;
  const auto add = [&line](const std::string& name, const std::string& from,
                           const std::string& to) {
    line += (line.empty() ? "" : ", ") + name + ' ' + from + " -> " + to;
  };
  for (const auto& [name, value] : before) {
    const auto found = after.find(name);
    if (found == after.end()) {
      add(name, value, "none");
    } else if (!same(name, value, found->second)) {
      add(name, value, found->second);
    }
  }
  for (const auto& [name, value] : after) {
    if (!before.contains(name)) {
      add(name, "none", value);
    }
  }
  return line.empty() ? "nothing told" : line;
}

Line::Line(std::string side, std::vector<std::string> judged, std::vector<std::string> others)
    : side_(std::move(side)), judged_(std::move(judged)) {
  for (const auto* list : {&judged_, &others}) {
    for (const std::string& quantity : *list) {
      values_[quantity] = {};
    }
  }
}

void Line::add(const wrcontact::Scene& scene) {
  for (auto& [quantity, values] : values_) {
    values.push_back(scene.number(side_ + '.' + quantity));
  }
  facts_.push_back(facts_of(scene, side_));
}

double Line::scale(const std::string& quantity, double force) const {
  const std::vector<double>& values = values_.at(quantity);
  return quantity.ends_with("_force") ? force : std::abs(values[values.size() / 2]);
}

std::map<std::string, double> Line::worst(double force) const {
  std::map<std::string, double> made;
  for (const auto& [quantity, values] : values_) {
    const std::vector<double> all = deviations(values);
    made[quantity] = *std::max_element(all.begin(), all.end()) / scale(quantity, force);
  }
  return made;
}

std::vector<Flag> Line::flags(double force, double limit, const std::string& place) const {
  std::map<std::size_t, Flag> found;
  for (const std::string& quantity : judged_) {
    const std::vector<double> all = deviations(values_.at(quantity));
    for (std::size_t i = 0; i < all.size(); ++i) {
      const double deviation = all[i] / scale(quantity, force);
      if (deviation > limit && deviation > found[i].deviation) {
        found[i].quantity = quantity;
        found[i].deviation = deviation;
      }
    }
  }
  std::vector<Flag> made;
  for (auto& [step, flag] : found) {
    if (flag.deviation > 0.0) {
      flag.where = side_ + ", " + place + ", step " + std::to_string(step);
      flag.changed = changes(facts_[step + window], facts_[step + window + 1]);
      made.push_back(flag);
    }
  }
  return made;
}

} // namespace smoothness
