#include "scene/patch_summary.hpp"

#include <algorithm>
#include <cstddef>

#include "creep/rolling_frame.hpp"
#include "scene/number_tables.hpp"

namespace wrc {
namespace {

using namespace number_tables;

using OfFound = Number<FoundPatch>;

Vector3 normal_of(const FoundPatch& found) {
  return RollingFrame(found.wheel->details.mirror).mirrored(found.patch->frame.normal);
}

/// Those that are no results by name.
constexpr std::array own_numbers{
    OfFound{"wheel", pure,
            [](const FoundPatch& f) { return f.wheel->details.mirror < 0.0 ? 1.0 : 0.0; }},
    OfFound{"normal.x", pure, [](const FoundPatch& f) { return normal_of(f).x; }},
    OfFound{"normal.y", turning, [](const FoundPatch& f) { return normal_of(f).y; }},
    OfFound{"normal.z", turning, [](const FoundPatch& f) { return normal_of(f).z; }},
};

template <class Table> constexpr auto find_in(const Table& table, std::string_view name) {
  for (const auto& number : table) {
    if (number.name == name) {
      return &number;
    }
  }
  return static_cast<decltype(&table.front())>(nullptr);
}

/// The line of a table that a member is read by.
struct Member {
  const OfFound* own = nullptr;
  const OfPatch* of_patch = nullptr;
  const OfPoint* of_reference = nullptr;
  const OfCreep* of_creep = nullptr;

  constexpr Member() = default;
  explicit constexpr Member(std::string_view name)
      : own(find_in(own_numbers, name)), of_patch(find_in(patch_numbers, name)),
        of_reference(find_in(place_numbers, name)), of_creep(find_in(creep_numbers, name)) {}

  [[nodiscard]] constexpr bool is_one_number() const {
    return (own != nullptr) + (of_patch != nullptr) + (of_reference != nullptr) +
               (of_creep != nullptr) ==
           1;
  }

  [[nodiscard]] double read(const FoundPatch& found, const Convention& convention) const {
    const auto from = [&convention](const auto& number, const auto& owner) {
      return to_caller(number.value(owner), convention, number.dimension);
    };
    if (own != nullptr) {
      return from(*own, found);
    }
    if (of_patch != nullptr) {
      return from(*of_patch, *found.patch);
    }
    if (of_reference != nullptr) {
      return from(*of_reference, found.patch->reference);
    }
    return found.patch->creep ? from(*of_creep, *found.patch->creep) : 0.0;
  }
};

constexpr auto members = [] {
  std::array<Member, patch_summary_names.size()> all;
  std::transform(patch_summary_names.begin(), patch_summary_names.end(), all.begin(),
                 [](std::string_view name) { return Member(name); });
  return all;
}();
static_assert(std::all_of(members.begin(), members.end(),
                          [](const Member& member) { return member.is_one_number(); }),
              "a name of patch_summary_names is in no table, or in two");

} // namespace

std::vector<FoundPatch> ordered_patches(const SceneResult& result) {
  std::vector<FoundPatch> found;
  for (const std::optional<SceneWheel>* wheel : {&result.left, &result.right}) {
    const auto first = static_cast<std::ptrdiff_t>(found.size());
    if (*wheel) {
      for (const PatchResult& patch : (*wheel)->patches) {
        found.push_back({&**wheel, &patch});
      }
    }
    std::sort(found.begin() + first, found.end(), [](const auto& one, const auto& other) {
      return one.patch->reference.s_wheel < other.patch->reference.s_wheel;
    });
  }
  return found;
}

std::vector<PatchSummary> patch_summaries(const SceneResult& result, const Convention& convention) {
  std::vector<PatchSummary> summaries;
  for (const FoundPatch& found : ordered_patches(result)) {
    PatchSummary& summary = summaries.emplace_back();
    std::transform(members.begin(), members.end(), summary.begin(),
                   [&](const Member& member) { return member.read(found, convention); });
  }
  return summaries;
}

} // namespace wrc
