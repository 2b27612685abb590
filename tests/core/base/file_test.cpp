// Files read and written whole: bytes, limits, links and permissions.
#include "base/file.hpp"

#include <filesystem>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "support/errors.hpp"

namespace wrc::test::file_test {
namespace {

constexpr std::size_t plenty = 1000;

class File : public testing::Test {
protected:
  void SetUp() override {
    folder_ = std::filesystem::path(testing::TempDir()) /
              ("wrcontact_file_test_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::filesystem::path path(const char* name) const { return folder_ / name; }
  [[nodiscard]] std::size_t entries() const {
    return static_cast<std::size_t>(
        std::distance(std::filesystem::directory_iterator(folder_), {}));
  }

  std::filesystem::path folder_;
};

TEST_F(File, KeepsEveryByte) {
  std::string content = "line\r\nline\n\xEF\xBB\xBF";
  content.push_back('\0');
  content += "behind";
  write_file(path("bytes"), content);
  EXPECT_EQ(read_file(path("bytes"), plenty), content);
  EXPECT_EQ(entries(), 1U) << "an auxiliary file is left";
}

TEST_F(File, IsReplacedWhole) {
  write_file(path("file"), std::string(500, 'a'));
  write_file(path("file"), "b");
  EXPECT_EQ(read_file(path("file"), plenty), "b");
}

TEST_F(File, MayReachTheLimitButNotExceedIt) {
  write_file(path("file"), std::string(100, 'a'));
  EXPECT_EQ(read_file(path("file"), 100).size(), 100U);
  expect_error(
      ErrorCode::file_unreadable, [&] { read_file(path("file"), 99); }, "file");
}

TEST_F(File, KeepsItsPermissions) {
  using std::filesystem::perms;
  write_file(path("file"), "a");
  std::filesystem::permissions(path("file"), perms::owner_read | perms::owner_write);
  write_file(path("file"), "b");
  EXPECT_EQ(std::filesystem::status(path("file")).permissions(),
            perms::owner_read | perms::owner_write);
}

TEST_F(File, IsWrittenToTheTargetOfALink) {
  write_file(path("target"), "a");
  std::filesystem::create_symlink(path("target"), path("link"));
  write_file(path("link"), "b");
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_EQ(read_file(path("target"), plenty), "b");
}

TEST_F(File, MustBeARegularFile) {
  expect_error(
      ErrorCode::file_unreadable, [&] { read_file(path("missing"), plenty); }, "missing");
  expect_error(ErrorCode::file_unreadable, [&] { read_file(folder_, plenty); });
  expect_error(ErrorCode::file_unreadable, [&] { write_file(path("missing") / "file", "a"); });
  expect_error(ErrorCode::file_unreadable, [&] { write_file(folder_, "a"); });
  EXPECT_EQ(entries(), 0U);
}

} // namespace
} // namespace wrc::test::file_test
