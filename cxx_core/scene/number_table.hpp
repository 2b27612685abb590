/// One line of a table of numbers (scene/number_tables.hpp).
#pragma once

#include <limits>
#include <optional>
#include <string_view>
#include <type_traits>

#include "scene/scene_result.hpp"

namespace wrc::number_tables {

using namespace dimensions;

/// What stands for a number that is not there.
inline constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A name, and how the value is read from what it belongs to. A getter that gives a std::optional
/// is that of a number that is not always there.
template <class Owner> struct Number {
  std::string_view name;
  Dimension dimension;
  double (*value)(const Owner&);
  bool always;

  template <class Getter>
  constexpr Number(std::string_view name_, Dimension dimension_, Getter /*without a state*/)
      : name(name_), dimension(dimension_), value([](const Owner& owner) {
          return std::optional<double>(Getter{}(owner)).value_or(none);
        }),
        always(!std::is_same_v<std::invoke_result_t<Getter, const Owner&>, std::optional<double>>) {
  }
};

/// Reads a member, or a member of a member: member<&PatchResult::force, &Vector3::x>.
template <auto... path>
inline constexpr auto member = [](const auto& owner) { return (owner.*....*path); };

} // namespace wrc::number_tables
