// The table of keys: each can be read, and set to what was read.
#include "keys/scene_key_table.hpp"

#include <algorithm>
#include <set>

#include <gtest/gtest.h>

#include "keys/scene_key.hpp"

namespace wrc::test::scene_key_table_test {
namespace {

TEST(SceneKeyTable, NamesAreDistinctAndGrouped) {
  std::set<std::string_view> names;
  for (const Key& key : make_scene_keys()) {
    EXPECT_TRUE(names.insert(key.description.name).second) << key.description.name;
    EXPECT_NE(key.description.name.find('.'), std::string_view::npos) << key.description.name;
    EXPECT_FALSE(key.description.meaning.empty()) << key.description.name;
  }
  for (const auto& make : {make_load_keys, make_rolling_keys, make_damage_keys}) {
    for (const Key& key : make()) {
      EXPECT_TRUE(names.contains(key.description.name)) << key.description.name;
    }
  }
}

/// Setting a key to its own value leaves a scene as it is, number or word.
TEST(SceneKeyTable, SettingWhatIsReadChangesNothing) {
  const std::vector<Key> keys = make_scene_keys();
  const Scene scene;
  std::size_t numbers = 0;
  std::size_t words = 0;
  for (const Key& key : keys) {
    Scene other = scene;
    const KeyValue value = key.get(scene);
    if (const double* number = std::get_if<double>(&value)) {
      ASSERT_TRUE(key.set_number) << key.description.name;
      EXPECT_GE(*number, key.min) << key.description.name;
      EXPECT_LE(*number, key.max) << key.description.name;
      key.set_number(other, *number);
      ++numbers;
    } else if (const std::string* word = std::get_if<std::string>(&value); word && key.set_text) {
      EXPECT_TRUE(key.set_text(other, *word)) << key.description.name << ' ' << *word;
      ++words;
    }
    EXPECT_EQ(key.get(other), value) << key.description.name;
  }
  EXPECT_GT(numbers, 30U);
  EXPECT_GT(words, 10U);
}

/// A number that is set is read again, and no key writes where another one reads.
TEST(SceneKeyTable, NumbersOfOneSideLeaveTheOtherAlone) {
  const std::vector<Key> keys = make_scene_keys();
  const auto named = [&](std::string_view name) -> const Key& {
    return *std::find_if(keys.begin(), keys.end(),
                         [name](const Key& key) { return key.description.name == name; });
  };
  Scene scene;
  named("load.left").set_number(scene, 5e4);
  EXPECT_EQ(std::get<double>(named("load.left").get(scene)), 5e4);
  EXPECT_EQ(std::get<double>(named("load.right").get(scene)), 8e4);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(named("load.both").get(scene)));
}

} // namespace
} // namespace wrc::test::scene_key_table_test
