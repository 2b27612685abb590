/// Tables of derivatives: results by variables, as matrices, row by row.
///
/// Jacobians of a wheel (derivatives/force_jacobian.hpp) and creep forces by creepages,
/// load and friction (creep/creep_forces.hpp). As all tables of scene/number_tables.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <utility>

#include "derivatives/force_jacobian.hpp"
#include "scene/number_table.hpp"

namespace wrc::number_tables {

/// Name of a derivative, "force.y.by.yaw", or its unit.
struct RateText {
  std::array<char, 40> text{};
  std::size_t length = 0;

  constexpr RateText(std::string_view first, std::string_view between, std::string_view second) {
    for (const std::string_view part : {first, between, second}) {
      for (const char c : part) {
        text[length++] = c;
      }
    }
  }
  [[nodiscard]] constexpr std::string_view view() const { return {text.data(), length}; }
};

/// Rows and columns of a Jacobian.
struct Variable {
  std::string_view name;
  int length;            ///< its power in the unit
  bool turns;            ///< its sign with the frame
  std::string_view unit; ///< of a row; of a column what it adds to that
};
inline constexpr std::array jacobian_rows{
    Variable{"force.x", 0, false, "N"},    Variable{"force.y", 0, true, "N"},
    Variable{"force.z", 0, true, "N"},     Variable{"moment.x", 1, false, "N mm"},
    Variable{"moment.y", 1, true, "N mm"}, Variable{"moment.z", 1, true, "N mm"}};
inline constexpr std::array jacobian_columns{Variable{"lateral", 1, true, "/mm"},
                                             Variable{"vertical", 1, true, "/mm"},
                                             Variable{"roll", 0, false, "/rad"},
                                             Variable{"yaw", 0, true, "/rad"},
                                             Variable{"speed", 1, false, " s/mm"},
                                             Variable{"lateral_velocity", 1, true, " s/mm"},
                                             Variable{"vertical_velocity", 1, true, " s/mm"},
                                             Variable{"roll_rate", 0, false, " s/rad"},
                                             Variable{"pitch_rate", 0, false, " s/rad"},
                                             Variable{"yaw_rate", 0, true, " s/rad"}};
static_assert(jacobian_columns.size() == state_count);

inline constexpr std::array creep_rows{Variable{"creep_force.longitudinal", 0, false, "N"},
                                       Variable{"creep_force.lateral", 0, true, "N"},
                                       Variable{"spin_moment", 1, true, "N mm"}};
inline constexpr std::array creep_columns{
    Variable{"longitudinal", 0, false, ""}, Variable{"lateral", 0, true, ""},
    Variable{"spin", -1, true, " mm"}, Variable{"normal_force", 0, false, "/N"},
    Variable{"friction", 0, false, ""}};

/// Dimension of a force, or of a force times lengths, by a column.
constexpr Dimension rate_of(const Variable& row, const Variable& column,
                            std::string_view unit = {}) {
  constexpr std::array quantities{Quantity::stiffness, Quantity::number, Quantity::moment,
                                  Quantity::area};
  return {quantities[static_cast<std::size_t>(1 + row.length - column.length)],
          row.turns != column.turns, unit};
}

template <std::size_t entry>
inline constexpr RateText jacobian_unit{jacobian_rows[entry / state_count].unit, "",
                                        jacobian_columns[entry % state_count].unit};
template <std::size_t entry>
inline constexpr RateText jacobian_name{jacobian_rows[entry / state_count].name, ".by.",
                                        jacobian_columns[entry % state_count].name};

inline constexpr auto jacobian_numbers = []<std::size_t... entry>(std::index_sequence<entry...>) {
  return std::array{Number<ForceJacobian>{
      jacobian_name<entry>.view(),
      rate_of(jacobian_rows[entry / state_count], jacobian_columns[entry % state_count],
              jacobian_unit<entry>.view()),
      [](const ForceJacobian& j) { return j[entry / state_count][entry % state_count]; }}...};
}
(std::make_index_sequence<jacobian_rows.size() * state_count>());

template <std::size_t entry>
inline constexpr RateText creep_rate_unit{creep_rows[entry / creep_columns.size()].unit, "",
                                          creep_columns[entry % creep_columns.size()].unit};
template <std::size_t entry>
inline constexpr RateText creep_rate_name{creep_rows[entry / creep_columns.size()].name, ".by.",
                                          creep_columns[entry % creep_columns.size()].name};

constexpr double creep_rate(const CreepDerivatives& derivatives, std::size_t row,
                            std::size_t column) {
  return column < 3    ? derivatives.by_creepage[3 * row + column]
         : column == 3 ? derivatives.by_load[row]
                       : derivatives.by_friction[row];
}

inline constexpr auto creep_rate_numbers = []<std::size_t... entry>(std::index_sequence<entry...>) {
  constexpr std::size_t columns = creep_columns.size();
  return std::array{Number<CreepResult>{
      creep_rate_name<entry>.view(),
      rate_of(creep_rows[entry / columns], creep_columns[entry % columns],
              creep_rate_unit<entry>.view()),
      [](const CreepResult& c) {
        return c.derivatives
                   ? std::optional(creep_rate(*c.derivatives, entry / columns, entry % columns))
                   : std::nullopt;
      }}...};
}
(std::make_index_sequence<creep_rows.size() * creep_columns.size()>());

} // namespace wrc::number_tables
