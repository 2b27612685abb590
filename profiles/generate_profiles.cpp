/// Build step: turns segment files (TOML) into a C++ source with constant tables.
///
/// Usage: wrcontact_generate_profiles OUTPUT.cpp PROFILE.toml ...
/// Checks everything a table relies on: keys and types, the frame, that the segments make a curve
/// and that the largest junction gap is the one the file states. A fault ends the build with one
/// line that names file, place and what is allowed. Units mm; frames as in profile.hpp.
#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>
#include <optional>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "base/error.hpp"
#include "profile/segments.hpp"
#include "profile/standard_table.hpp"

namespace {

using wrc::Position;
using wrc::Segment;
using wrc::text_of;

struct Entry {
  std::string name;
  std::string kind;
  std::string title;
  std::string source;
  std::string confidence;
  std::vector<Segment> segments;
};

/// A table of a file with its place, so that every fault can name it.
class Section {
public:
  Section(const toml::table& table, std::string place) : table_(table), place_(std::move(place)) {}

  [[noreturn]] void refuse(const std::string& text) const {
    throw std::runtime_error(place_ + ": " + text);
  }
  void allow_only(const std::set<std::string>& keys) const {
    for (const auto& [key, value] : table_)
      if (!keys.contains(std::string(key.str())))
        refuse("unknown key '" + std::string(key.str()) + "'");
  }
  [[nodiscard]] bool has(const std::string& key) const { return table_.contains(key); }
  [[nodiscard]] std::string text(const std::string& key) const {
    const auto value = table_[key].value<std::string>();
    if (!value || value->empty())
      refuse("'" + key + "' must be a text that is not empty");
    return *value;
  }
  [[nodiscard]] std::string choice(const std::string& key,
                                   const std::set<std::string>& allowed) const {
    const std::string value = text(key);
    if (!allowed.contains(value)) {
      std::string list;
      for (const std::string& one : allowed)
        list += " " + one;
      refuse("'" + key + "' = '" + value + "', allowed:" + list);
    }
    return value;
  }
  [[nodiscard]] bool flag(const std::string& key) const {
    const auto value = table_[key].value<bool>();
    if (!value)
      refuse("'" + key + "' must be true or false");
    return *value;
  }
  [[nodiscard]] double number(const std::string& key) const {
    return checked(table_[key].value<double>(), key);
  }
  [[nodiscard]] std::vector<double> numbers(const std::string& key) const {
    const toml::array* array = table_[key].as_array();
    if (array == nullptr || array->empty())
      refuse("'" + key + "' must be an array of numbers");
    std::vector<double> values;
    for (const toml::node& node : *array)
      values.push_back(checked(node.value<double>(), key));
    return values;
  }
  [[nodiscard]] Position position(const std::string& key) const {
    const std::vector<double> values = numbers(key);
    if (values.size() != 2)
      refuse("'" + key + "' must be [lateral, height]");
    return {values[0], values[1]};
  }

private:
  [[nodiscard]] double checked(std::optional<double> value, const std::string& key) const {
    if (!value || !std::isfinite(*value))
      refuse("'" + key + "' must be a finite number");
    return *value;
  }

  const toml::table& table_;
  std::string place_;
};

/// A segment of a file in the frame of the library; `up` is +1 or -1.
Segment read_segment(const Section& section, double up) {
  const auto raised = [up](Position position) { return Position{position[0], up * position[1]}; };
  const std::string type = section.choice("type", {"line", "arc", "polynomial"});
  const std::string label = section.text("label");
  if (type == "line") {
    section.allow_only({"type", "label", "start", "end"});
    return {label,
            wrc::LineSegment{raised(section.position("start")), raised(section.position("end"))}};
  }
  if (type == "arc") {
    section.allow_only({"type", "label", "centre", "radius", "start", "end"});
    return {label,
            wrc::ArcSegment{raised(section.position("centre")), section.number("radius"),
                            raised(section.position("start")), raised(section.position("end"))}};
  }
  section.allow_only({"type", "label", "coefficients", "expansion_point", "from", "to"});
  wrc::PolynomialSegment polynomial{
      section.numbers("coefficients"),
      section.has("expansion_point") ? section.number("expansion_point") : 0.0,
      section.number("from"), section.number("to")};
  if (polynomial.coefficients.size() > wrc::TableSegment::max_coefficients)
    section.refuse("more than " + std::to_string(wrc::TableSegment::max_coefficients) +
                   " coefficients");
  for (double& coefficient : polynomial.coefficients)
    coefficient *= up;
  return {label, polynomial};
}

void check_curve(const Section& section, const std::vector<Segment>& segments, double stated_gap) {
  (void)wrc::curve_of(segments);
  double largest = 0.0;
  for (const wrc::Junction& junction : wrc::junctions_of(segments))
    largest = std::max(largest, junction.gap);
  if (largest > stated_gap)
    section.refuse("largest junction gap is " + text_of(largest) + " mm, the file states " +
                   text_of(stated_gap));
}

Entry read_entry(const std::string& path) {
  const toml::table root = toml::parse_file(path);
  const Section file(root, path);
  file.allow_only({"name", "kind", "title", "standard", "source", "confidence", "units", "frame",
                   "height_axis", "mirror", "largest_gap", "segment", "construction", "checks",
                   "notes"});
  (void)file.choice("units", {"mm"});
  (void)file.text("frame");
  (void)file.text("standard");
  const double up = file.choice("height_axis", {"up", "down"}) == "up" ? 1.0 : -1.0;
  Entry entry{file.text("name"),       file.choice("kind", {"wheel", "rail"}),
              file.text("title"),      file.text("source"),
              file.text("confidence"), {}};
  const toml::array* array = root["segment"].as_array();
  if (array == nullptr || array->empty())
    file.refuse("no [[segment]]");
  for (const toml::node& node : *array) {
    const std::string place = path + ": segment " + std::to_string(entry.segments.size() + 1);
    const toml::table* table = node.as_table();
    if (table == nullptr)
      throw std::runtime_error(place + ": must be a table");
    entry.segments.push_back(read_segment(Section(*table, place), up));
  }
  if (file.flag("mirror"))
    entry.segments = wrc::with_mirrored_half(entry.segments);
  try {
    check_curve(file, entry.segments, file.number("largest_gap"));
  } catch (const wrc::Error& error) {
    file.refuse(error.what());
  }
  return entry;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      result += '\\';
    if (c == '\n')
      result += "\\n";
    else
      result += c;
  }
  return result + "\"";
}

std::string list_of(const Position& position) {
  std::string result = "{";
  result += text_of(position[0]);
  result += ", ";
  result += text_of(position[1]);
  return result += "}";
}

void write_segment(std::ostream& out, const Segment& segment) {
  out << "    {" << quoted(segment.label) << ", TableSegment::Type::";
  if (const auto* line = std::get_if<wrc::LineSegment>(&segment.shape)) {
    out << "line, " << list_of(line->start) << ", " << list_of(line->end)
        << ", {0, 0}, 0, 0, 0, {}";
  } else if (const auto* arc = std::get_if<wrc::ArcSegment>(&segment.shape)) {
    out << "arc, " << list_of(arc->start) << ", " << list_of(arc->end) << ", "
        << list_of(arc->centre) << ", " << text_of(arc->radius) << ", 0, 0, {}";
  } else {
    const auto& polynomial = std::get<wrc::PolynomialSegment>(segment.shape);
    out << "polynomial, " << list_of({polynomial.lateral_start, 0.0}) << ", "
        << list_of({polynomial.lateral_end, 0.0}) << ", {0, 0}, 0, "
        << text_of(polynomial.expansion_point) << ", " << polynomial.coefficients.size() << ", {";
    for (std::size_t i = 0; i < polynomial.coefficients.size(); ++i)
      out << (i > 0 ? ", " : "") << text_of(polynomial.coefficients[i]);
    out << "}";
  }
  out << "},\n";
}

std::string source_of(const std::vector<Entry>& entries) {
  std::ostringstream out;
  out << "// Generated from profiles/*.toml when the library is built; edit those instead.\n"
         "#include \"profile/standard_table.hpp\"\n\nnamespace wrc {\nnamespace {\n\n";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    out << "constexpr TableSegment segments_" << i << "[] = {\n";
    for (const Segment& segment : entries[i].segments)
      write_segment(out, segment);
    out << "};\n\n";
  }
  out << "constexpr TableProfile profiles[] = {\n";
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const Entry& entry = entries[i];
    out << "    {" << quoted(entry.name) << ", ProfileKind::" << entry.kind << ", "
        << quoted(entry.title) << ", " << quoted(entry.source) << ", " << quoted(entry.confidence)
        << ", segments_" << i << "},\n";
  }
  out << "};\n\n} // namespace\n\n"
         "std::span<const TableProfile> standard_table() { return profiles; }\n\n"
         "} // namespace wrc\n";
  return out.str();
}

void generate(const std::string& output, const std::vector<std::string>& files) {
  std::vector<Entry> entries;
  std::set<std::string> names;
  for (const std::string& file : files) {
    entries.push_back(read_entry(file));
    if (!names.insert(entries.back().name).second)
      throw std::runtime_error(file + ": the name '" + entries.back().name + "' is taken");
  }
  std::ofstream stream(output);
  stream << source_of(entries);
  if (!stream.flush())
    throw std::runtime_error(output + ": cannot be written");
}

} // namespace

int main(int argc, char** argv) {
  try {
    const std::vector<std::string> arguments(argv + 1, argv + argc);
    if (arguments.size() < 2)
      throw std::runtime_error("usage: wrcontact_generate_profiles OUTPUT.cpp PROFILE.toml ...");
    generate(arguments.front(), {arguments.begin() + 1, arguments.end()});
    return 0;
  } catch (const toml::parse_error& error) {
    const toml::source_region& where = error.source();
    std::cerr << (where.path ? *where.path : std::string("segment file")) << ":" << where.begin.line
              << ": " << error.description() << "\n";
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
  }
  return 1;
}
