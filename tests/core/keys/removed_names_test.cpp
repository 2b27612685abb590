#include "keys/removed_names.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "keys/scene_keys.hpp"
#include "scene/number_ids.hpp"
#include "scene/patch_summary.hpp"

namespace wrc::test::removed_names_test {
namespace {

std::string refusal(const std::string& name) {
  Scene scene;
  try {
    set_number(scene, name, 0.0);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unknown_name) << name;
    return error.what();
  }
  ADD_FAILURE() << name << " was accepted";
  return "";
}

TEST(RemovedNames, OfKeysNameTheirSuccessors) {
  for (const RemovedName& removed : removed_names) {
    if (removed.kind != NameOf::key) {
      continue;
    }
    const std::string name(removed.name);
    const std::string expected = name + " is not a key any more: " + std::string(removed.successor);
    EXPECT_EQ(refusal(name), expected);
    EXPECT_THROW(key_value(Scene(), name), Error);
    std::string written = name; // as Python does
    std::ranges::replace(written, '.', '_');
    EXPECT_EQ(refusal(written), expected);
    EXPECT_EQ(refusal(name.substr(name.find('.') + 1)), expected);
    // The keys that it names exist.
    const std::string successor(removed.successor);
    for (const std::string table : {"load.", "solve.", "track.", "wheelset."}) {
      for (std::size_t at = successor.find(table); at != std::string::npos;
           at = successor.find(table, at + 1)) {
        const std::string key = successor.substr(at, successor.find_first_of(" ,", at) - at);
        EXPECT_NO_THROW(key_value(Scene(), key)) << key;
      }
    }
  }
  EXPECT_NE(refusal("load.vertica").find("unknown key load.vertica; nearest"), std::string::npos);
}

/// Each of a wheel or a patch, alone or with an end behind it.
TEST(RemovedNames, OfResultsNameTheirSuccessors) {
  const std::vector<std::string> possible = possible_number_names();
  for (const RemovedName& removed : removed_names) {
    if (removed.kind != NameOf::result) {
      continue;
    }
    const std::string old(removed.name);
    const std::string successor(removed.successor);
    const bool is_name = successor.find(' ') == std::string::npos;
    bool found = !is_name;
    for (const std::string before : {"left.", "right.patches.0.", "left.patches.0.parts.0."}) {
      const std::string now = before + successor;
      EXPECT_EQ(removed_number(before + old), before + old + " is not a result any more: " +
                                                  (is_name ? "use " + now : successor));
      EXPECT_FALSE(number_id(before + old));
      for (const std::string& name : possible) {
        found = found || name == now || name.starts_with(now + '.');
      }
    }
    EXPECT_TRUE(found) << successor << " is no result";
  }
  EXPECT_EQ(removed_number("right.patches.12.moment.x"),
            "right.patches.12.moment.x is not a result any more: use "
            "right.patches.12.pressure_moment.x");
  for (const char* other :
       {"left.pmax", "left.grid.2", "left.moments", "moment.x", "left.patches.x.moment"}) {
    EXPECT_FALSE(removed_number(other)) << other;
  }
}

TEST(RemovedNames, OfMembersHaveSuccessors) {
  for (const RemovedName& removed : removed_names) {
    const auto is_member = [](std::string_view member) {
      return std::ranges::any_of(patch_summary_names, [member](std::string_view name) {
        std::string written(name);
        std::ranges::replace(written, '.', '_');
        return written == member;
      });
    };
    if (removed.kind == NameOf::member) {
      EXPECT_TRUE(is_member(removed.successor)) << removed.successor;
      EXPECT_FALSE(is_member(removed.name)) << removed.name;
    }
  }
}

} // namespace
} // namespace wrc::test::removed_names_test
