#include "scene/number_ids.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

#include "keys/removed_names.hpp"
#include "scene/number_tables.hpp"
#include "scene/result_names.hpp"

namespace wrc {
namespace {

using number_tables::with_table;

/// Names that begin with a text are those of a group. Names of groups without one do not collide.
struct Prefix {
  std::string_view text;
  NumberGroup group;
};

constexpr std::array scene_prefixes{
    Prefix{"time_ms.", NumberGroup::time}, Prefix{"wheelset.", NumberGroup::wheelset},
    Prefix{"spread.", NumberGroup::scene_spread}, Prefix{"", NumberGroup::scene}};
constexpr std::array side_prefixes{Prefix{"total.", NumberGroup::total},
                                   Prefix{"rigid_contact.", NumberGroup::rigid_contact},
                                   Prefix{"centroid.", NumberGroup::centroid},
                                   Prefix{"residuals.", NumberGroup::residuals},
                                   Prefix{"spread.", NumberGroup::spread},
                                   Prefix{"smoothed_", NumberGroup::smoothed},
                                   Prefix{"sensitivities.at_load.", NumberGroup::at_load},
                                   Prefix{"sensitivities.", NumberGroup::sensitivities},
                                   Prefix{"jacobian.", NumberGroup::jacobian},
                                   Prefix{"", NumberGroup::side},
                                   Prefix{"", NumberGroup::side_damage}};
constexpr std::array near_contact_prefixes{Prefix{"", NumberGroup::near_contact}};
constexpr std::array patch_prefixes{Prefix{"centroid.", NumberGroup::patch_centroid},
                                    Prefix{"", NumberGroup::patch}, Prefix{"", NumberGroup::creep},
                                    Prefix{"", NumberGroup::reference},
                                    Prefix{"", NumberGroup::damage}};

/// Sets group and entry; false if there is no such name.
bool find_entry(std::span<const Prefix> prefixes, std::string_view name, NumberId& id) {
  return std::any_of(prefixes.begin(), prefixes.end(), [name, &id](const Prefix& prefix) {
    std::string_view rest = name;
    return strip_prefix(rest, prefix.text) && with_table(prefix.group, [&](const auto& table) {
             const auto found =
                 std::find_if(table.begin(), table.end(),
                              [rest](const auto& number) { return number.name == rest; });
             id.group = prefix.group;
             id.entry = static_cast<std::size_t>(found - table.begin());
             return found != table.end();
           });
  });
}

/// Some bits of a packed id.
struct Bits {
  int first;
  int count;

  [[nodiscard]] constexpr bool hold(std::size_t value) const { return value >> count == 0; }
  [[nodiscard]] constexpr std::uint32_t put(std::size_t value) const {
    return static_cast<std::uint32_t>(value) << first;
  }
  [[nodiscard]] constexpr std::size_t take(std::uint32_t packed) const {
    return packed >> first & ((std::uint32_t{1} << count) - 1);
  }
};

// not a tuning constant: the sign stays 0, and the bit after it says that it is no key
constexpr Bits entry_bits{0, 6};
constexpr Bits group_bits{6, 5};
constexpr Bits side_bits{11, 1};
constexpr Bits index_bits{12, 10};
constexpr Bits part_bits{22, 8};
constexpr Bits mark_bits{30, 2};
static_assert(index_bits.hold(max_packed_index) && part_bits.hold(max_packed_part + 1));

constexpr std::size_t size_of(NumberGroup group) {
  return with_table(group, [](const auto& table) { return table.size(); });
}

/// Whether an id names nothing that its group lacks.
bool is_consistent(const NumberId& id) {
  return id.group <= NumberGroup::damage && id.entry < size_of(id.group) &&
         (!id.right || id.group >= NumberGroup::side) &&
         (id.index == 0 || id.group >= NumberGroup::near_contact) &&
         (id.part == 0 || id.group >= NumberGroup::patch);
}

constexpr bool every_table_fits() {
  for (auto group = std::uint8_t{0}; group <= static_cast<std::uint8_t>(NumberGroup::damage);
       ++group) {
    if (!entry_bits.hold(size_of(static_cast<NumberGroup>(group))) || !group_bits.hold(group)) {
      return false;
    }
  }
  return true;
}
static_assert(every_table_fits());

} // namespace

std::optional<NumberId> number_id(std::string_view name) {
  constexpr std::size_t any = std::numeric_limits<std::size_t>::max();
  NumberId id;
  id.right = strip_prefix(name, "right.");
  bool found = false;
  if (!id.right && !strip_prefix(name, "left.")) {
    found = find_entry(scene_prefixes, name, id);
  } else if (strip_prefix(name, "near_contacts.")) {
    found = strip_index(name, any, id.index) && find_entry(near_contact_prefixes, name, id);
  } else if (strip_prefix(name, "patches.")) {
    found = strip_index(name, any, id.index);
    if (found && strip_prefix(name, "parts.")) {
      found = strip_index(name, any, id.part);
      ++id.part;
    }
    found = found && find_entry(patch_prefixes, name, id);
  } else {
    found = find_entry(side_prefixes, name, id);
  }
  return found ? std::optional(id) : std::nullopt;
}

std::optional<std::string> removed_number(std::string_view name) {
  std::string_view rest = name;
  std::size_t index = 0;
  if (!strip_prefix(rest, "left.") && !strip_prefix(rest, "right.")) {
    return std::nullopt;
  }
  for (const std::string_view list : {"patches.", "parts."}) {
    if (strip_prefix(rest, list) &&
        !strip_index(rest, std::numeric_limits<std::size_t>::max(), index)) {
      return std::nullopt;
    }
  }
  return removed_result(NameOf::result, name.substr(0, name.size() - rest.size()), rest);
}

std::vector<std::string> possible_number_names() {
  std::vector<std::string> names;
  const auto add = [&names](const std::string& group, std::span<const Prefix> prefixes) {
    for (const Prefix& prefix : prefixes) {
      with_table(prefix.group, [&](const auto& table) {
        for (const auto& number : table) {
          names.push_back(group + std::string(prefix.text) + std::string(number.name));
        }
        return true;
      });
    }
  };
  add("", scene_prefixes);
  for (const std::string side : {"left.", "right."}) {
    add(side, side_prefixes);
    add(side + "near_contacts.0.", near_contact_prefixes);
    add(side + "patches.0.", patch_prefixes);
    add(side + "patches.0.parts.0.", patch_prefixes);
  }
  return names;
}

std::optional<std::int32_t> pack(const NumberId& id) {
  if (id.index > max_packed_index || id.part > max_packed_part + 1) {
    return std::nullopt;
  }
  return static_cast<std::int32_t>(entry_bits.put(id.entry) |
                                   group_bits.put(static_cast<std::size_t>(id.group)) |
                                   side_bits.put(id.right ? 1 : 0) | index_bits.put(id.index) |
                                   part_bits.put(id.part) | mark_bits.put(1));
}

std::optional<NumberId> unpack(std::int32_t packed) {
  const auto bits = static_cast<std::uint32_t>(packed);
  const NumberId id{static_cast<NumberGroup>(group_bits.take(bits)), entry_bits.take(bits),
                    side_bits.take(bits) != 0, index_bits.take(bits), part_bits.take(bits)};
  return mark_bits.take(bits) == 1 && is_consistent(id) ? std::optional(id) : std::nullopt;
}

} // namespace wrc
