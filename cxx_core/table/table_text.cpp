#include "table/table_text.hpp"

#include <string_view>

#include "base/error.hpp"
#include "keys/scene.hpp"

namespace wrc {

std::string text_of_key(const TableIdentity& identity, std::size_t key, Units units) {
  const std::string_view name = identity_keys[key].name;
  const double number = identity.numbers[key];
  if (name == "solve.method") {
    return number == static_cast<double>(SolverChoice::standard) ? "auto" : "paper";
  }
  return amount_text(number, units, identity_keys[key].dimension);
}

std::vector<std::string> lines_of(const ContactTable& table) {
  using namespace dimensions;
  const Units units = table.convention.units;
  std::vector<std::string> lines{"wheelset.wheel = " + table.identity.wheel,
                                 "track.rail = " + table.identity.rail};
  for (std::size_t key = 0; key < identity_keys.size(); ++key) {
    lines.push_back(identity_keys[key].name + std::string(" = ") +
                    text_of_key(table.identity, key, units));
  }
  constexpr Dimension speed{Quantity::length, false, "mm/s"};
  lines.push_back("friction = " + text_of(table.friction) + " unless a step has its own");
  lines.push_back("motion.standstill_speed = " + amount_text(table.standstill_speed, units, speed));
  lines.push_back("units and axes of steps: " + std::string(name_of(units)) + "; " +
                  std::string(name_of(table.convention.frame)));
  const TableRanges& ranges = table.ranges;
  lines.push_back("reaches to lateral " + amount_text(ranges.lateral, units, length) + ", roll " +
                  amount_text(ranges.roll, units, angle) + ", yaw " +
                  amount_text(ranges.yaw, units, angle) + ", load " +
                  amount_text(ranges.load, units, force));
  lines.push_back("made by version " + table.version + ", over " + axes_of_tables);
  lines.push_back("beside forces it has " + names_of_outputs());
  return lines;
}

} // namespace wrc
