/// Built-in profiles: from the generated tables to curves. Frame and units of profile.hpp.
#include "profile/standard_profiles.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>
#include <system_error>

#include "base/error.hpp"
#include "base/lower_case.hpp"
#include "profile/standard_table.hpp"

namespace wrc {
namespace {

struct OldName {
  std::string_view old;
  std::string_view name;
};
/// EN 13674-1, Annex A (a table of names, not a tuning constant).
constexpr std::array<OldName, 7> old_names{{{"uic60", "60E1"},
                                            {"uic54", "54E1"},
                                            {"uic54e", "54E2"},
                                            {"s54", "54E3"},
                                            {"s49", "49E1"},
                                            {"bs113a", "56E1"},
                                            {"u50", "50E6"}}};

const TableProfile& entry_of(std::string_view name) {
  for (const TableProfile& entry : standard_table()) {
    if (entry.name == name || entry.name == standard_name(name, entry.kind)) {
      return entry;
    }
  }
  std::string names;
  for (const ProfileKind kind : {ProfileKind::wheel, ProfileKind::rail}) {
    names += kind == ProfileKind::wheel ? "a wheel:" : "; or a rail:";
    for (const std::string_view known : standard_profile_names(kind)) {
      names.append(" ").append(known);
    }
  }
  throw Error(ErrorCode::unknown_name, "profile = '" + std::string(name) + "': " + names);
}

Segment segment_of(const TableSegment& row) {
  const std::string label(row.label);
  switch (row.type) {
  case TableSegment::Type::line:
    return {label, LineSegment{row.start, row.end}};
  case TableSegment::Type::arc:
    return {label, ArcSegment{row.centre, row.radius, row.start, row.end}};
  case TableSegment::Type::polynomial:
    break;
  }
  const auto first = row.coefficients.begin();
  return {label,
          PolynomialSegment{{first, first + static_cast<std::ptrdiff_t>(row.coefficient_count)},
                            row.expansion_point,
                            row.start[0],
                            row.end[0]}};
}

std::vector<Segment> segments_of(const TableProfile& entry) {
  std::vector<Segment> segments;
  for (const TableSegment& row : entry.segments) {
    segments.push_back(segment_of(row));
  }
  return segments;
}

} // namespace

std::vector<std::string_view> standard_profile_names(ProfileKind kind) {
  std::vector<std::string_view> names;
  for (const TableProfile& entry : standard_table()) {
    if (entry.kind == kind) {
      names.push_back(entry.name);
    }
  }
  return names;
}

std::string_view standard_name(std::string_view name, ProfileKind kind) {
  const std::vector<std::string_view> names = standard_profile_names(kind);
  if (const auto exact = std::find(names.begin(), names.end(), name); exact != names.end()) {
    return *exact;
  }
  const std::string wanted = lower_case(name);
  const auto* const old = std::find_if(old_names.begin(), old_names.end(),
                                       [&](const OldName& each) { return each.old == wanted; });
  for (const std::string_view known : names) {
    if (old != old_names.end() ? known == old->name : lower_case(known) == wanted) {
      std::error_code unseen;
      return std::filesystem::exists(name, unseen) ? std::string_view() : known;
    }
  }
  return {};
}

Profile standard_profile(std::string_view name) {
  const TableProfile& entry = entry_of(name);
  return {std::string(entry.name),       entry.kind,
          std::string(entry.title),      std::string(entry.source),
          std::string(entry.confidence), curve_of(segments_of(entry))};
}

std::vector<Segment> standard_profile_segments(std::string_view name) {
  return segments_of(entry_of(name));
}

} // namespace wrc
