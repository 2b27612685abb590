#include "keys/removed_keys.hpp"

#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "keys/scene_keys.hpp"

namespace wrc::test::removed_keys_test {
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

TEST(RemovedKeys, NameTheirSuccessors) {
  for (const RemovedKey& removed : removed_keys) {
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
    for (std::size_t at = successor.find("load."); at != std::string::npos;
         at = successor.find("load.", at + 1)) {
      const std::string key = successor.substr(at, successor.find_first_of(" ,", at) - at);
      EXPECT_NO_THROW(key_value(Scene(), key)) << key;
    }
  }
  EXPECT_NE(refusal("load.vertica").find("unknown key load.vertica; nearest"), std::string::npos);
}

} // namespace
} // namespace wrc::test::removed_keys_test
