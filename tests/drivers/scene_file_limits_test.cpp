/// Scene and study files that are far too large or far too deep: refused in one line.
#include "run_driver.hpp"

namespace scene_file_limits_test {
namespace {

class SceneFileLimits : public Driver {
protected:
  /// As a scene file and as a study file.
  void expect_refused(std::initializer_list<std::string> parts) const {
    for (const char* program : {WRC_CASE_PROGRAM, WRC_SWEEP_PROGRAM}) {
      run(program, "s.toml").expect_refusal(parts);
    }
  }
  static std::string repeated(const std::string& text, int times, std::string all = {}) {
    for (int i = 0; i < times; ++i) {
      all += text;
    }
    return all;
  }
};

TEST_F(SceneFileLimits, RefuseAGigabyteAndSpecialFiles) {
  write("s.toml", "[pose]\n");
  std::filesystem::resize_file(folder() / "s.toml", std::uintmax_t{1} << 30U); // sparse
  expect_refused({"s.toml", "larger than 1048576 bytes"});
  std::filesystem::remove(folder() / "s.toml");
  std::filesystem::create_directory(folder() / "s.toml");
  expect_refused({"s.toml", "not a regular file"});
  run(WRC_CASE_PROGRAM, "/dev/zero").expect_refusal({"/dev/zero", "not a regular file"});
}

TEST_F(SceneFileLimits, RefuseDeeplyNestedKeys) {
  constexpr int many = 400000;
  write("s.toml", repeated(".a", many, "a") + " = 1\n");
  expect_refused({"s.toml", "more than 64 parts"});
  write("s.toml", repeated(" . a", many / 2, "[a") + "]\n");
  expect_refused({"s.toml", "more than 64 parts"});
  write("s.toml", repeated(".a", many, "a = {a") + " = 1}\n");
  expect_refused({"s.toml", "more than 64 parts"});
  write("s.toml", repeated("{a=", many / 2, "a = "));
  expect_refused({"s.toml", "nested"});
  write("s.toml", repeated("[", many, "a = "));
  expect_refused({"s.toml", "nested"});
  const std::string long_key = repeated(".a", 60, "a") + " = ";
  write("s.toml", repeated("}", 200, repeated('{' + long_key, 200, "a = ") + '1'));
  expect_refused({"longer than 256 bytes"});
}

TEST_F(SceneFileLimits, LongCommentsAndListsDoNotCountAsKeys) {
  write("s.toml", "# " + repeated(".", 300) + "\n# " + repeated(". ", 300) +
                      "\n[pose]\nlateral = 3 # " + repeated("..", 100) + "\n");
  EXPECT_EQ(run(WRC_CASE_PROGRAM, "s.toml --set solve.until=geometry").exit_code, 0);
  write("s.toml",
        "[pose]\nlateral = [" + repeated("0.5, ", 200) + "]\n[solve]\nuntil = \"geometry\"\n");
  EXPECT_EQ(run(WRC_SWEEP_PROGRAM, "s.toml --out o --no-pictures").exit_code, 0);
}

TEST_F(SceneFileLimits, RefuseStudiesThatDoNotFitIntoMemory) {
  write("s.toml", "[pose]\nlateral = {from = 0, to = 1, count = 100000000}\n");
  run(WRC_SWEEP_PROGRAM, "s.toml").expect_refusal({"pose.lateral", "2 to 1e6"});
  write("s.toml", "[pose]\nlateral = {from = 0, to = 1, step = 1e-8}\n");
  run(WRC_SWEEP_PROGRAM, "s.toml").expect_refusal({"pose.lateral", "less than 1e6 steps"});
}

TEST_F(SceneFileLimits, AnErrorTextStaysOnOneLine) {
  write("s.toml", "track.rail = \"\"\"a\nb\"\"\"\n");
  run(WRC_CASE_PROGRAM, "s.toml").expect_refusal({"track.rail", "a b"});
  write("s.toml", "solve.grid = tru\nepose.roll");
  expect_refused({"s.toml", "line 1"});
}

TEST_F(SceneFileLimits, AFileInUtf16IsNamedSo) {
  write("s.toml", std::string("\xFF\xFEp\0=\0", 6));
  expect_refused({"s.toml", "line 1", "UTF-16"});
  write("s.toml", std::string("# a\np\0=\0", 8));
  expect_refused({"s.toml", "line 2", "UTF-16"});
}

} // namespace
} // namespace scene_file_limits_test
