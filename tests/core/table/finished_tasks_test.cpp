#include "table/finished_tasks.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <gtest/gtest.h>

#include "base/file.hpp"
#include "support/errors.hpp"
#include "table/small_table.hpp"
#include "table/table_file.hpp"

namespace wrc::test {
namespace {

class FinishedTasksFile : public ::testing::Test {
protected:
  FinishedTasksFile() { std::filesystem::remove(path_); }

  template <class... Parts> void refuses(std::string_view inputs, const Parts&... parts) const {
    expect_error(
        ErrorCode::file_malformed, [&] { const FinishedTasks finished(path_, inputs); }, parts...);
  }

  const std::filesystem::path path_ = std::filesystem::path(::testing::TempDir()) / "t.unfinished";
};

TEST_F(FinishedTasksFile, KeepsWhatTasksGave) {
  const std::array<double, 3> given{1.5, -2.0, 1e-300};
  {
    FinishedTasks finished(path_, "of one");
    finished.add(2, 7, given);
    finished.write();
  }
  FinishedTasks again(path_, "of one");
  std::array<double, 3> found{};
  EXPECT_TRUE(again.find(2, 7, found));
  EXPECT_EQ(found, given);
  EXPECT_FALSE(again.find(2, 6, found));
  EXPECT_FALSE(again.find(1, 7, found));
  std::array<double, 2> fewer{};
  EXPECT_FALSE(again.find(2, 7, fewer));
}

TEST_F(FinishedTasksFile, RefusesOtherInputsAndWhatWasChanged) {
  FinishedTasks(path_, "of one").add(0, 0, {});
  refuses("of another", path_.string(), "another scene");
  const std::string whole = read_file(path_, 1000);
  for (std::size_t size = 0; size < whole.size(); ++size) {
    write_file(path_, whole.substr(0, size));
    refuses("of one", "remove it to begin again");
  }
  std::string changed = whole;
  changed.back() = static_cast<char>(changed.back() ^ 1);
  write_file(path_, changed);
  refuses("of one", "checksum");
}

/// Stopped in each of its stages, a build goes on to the same bits. The last number in the file,
/// the error returned with a state, is made 0: one state more is found beyond it.
TEST_F(FinishedTasksFile, ABuildThatWasStoppedGoesOn) {
  TableOptions options = options_of_small_table();
  options.resume_file = path_;
  for (const double until : {0.12, 0.4, 0.7, 0.95}) {
    options.progress = [until](double share) {
      if (share > until) {
        throw until;
      }
    };
    EXPECT_THROW((void)build_table(scene_of_small_table(), options, SceneSolver()), double);
    EXPECT_TRUE(std::filesystem::exists(path_));
  }
  std::string text = read_file(path_, 100000000);
  // The error of a finished state of the last stage becomes immense.
  text.resize(text.size() - 2 * sizeof(double));
  const double immense = 1e3;
  text.append(reinterpret_cast<const char*>(&immense), sizeof immense);
  const std::uint64_t sum = checksum_of(text);
  text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  write_file(path_, text);
  options.progress = {};
  const ContactTable table = build_table(scene_of_small_table(), options, SceneSolver());
  EXPECT_EQ(table.contact.coefficients(), small_table().contact.coefficients());
  EXPECT_EQ(table.errors.vertices(), small_table().errors.vertices());
  EXPECT_EQ(table.measured.worst, immense);
  EXPECT_EQ(table.measured.beyond, small_table().measured.beyond + 1);
  // The whole table is kept, of this scene alone.
  EXPECT_TRUE(std::filesystem::exists(path_));
  Scene other = scene_of_small_table();
  other.element_limit = 1e3;
  expect_error(
      ErrorCode::file_malformed, [&] { (void)build_table(other, options, SceneSolver()); },
      "another scene");
}

} // namespace
} // namespace wrc::test
