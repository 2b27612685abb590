/// Files that cannot be written whole are not there, and old ones stay as they were. Files are
/// limited to a size, beyond which writing fails as it does on a full disk.
#include <csignal>
#include <functional>
#include <pthread.h>
#include <sys/resource.h>

#include "owned_handles.hpp"

namespace full_disk_test {
namespace {

/// No file may grow beyond this while it lives.
class FileSizeLimit {
public:
  explicit FileSizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limited{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limited);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    setrlimit(RLIMIT_FSIZE, &before_);
    // The host's signals are as they were: none came, none waits, none is blocked.
    sigset_t signals{};
    sigpending(&signals);
    EXPECT_EQ(sigismember(&signals, SIGXFSZ), 0);
    pthread_sigmask(SIG_BLOCK, nullptr, &signals);
    EXPECT_EQ(sigismember(&signals, SIGXFSZ), 0);
  }

private:
  rlimit before_{};
};

class FullDisk : public WithFolder {
protected:
  [[nodiscard]] std::ptrdiff_t file_count() const {
    return std::distance(
        std::filesystem::directory_iterator(std::filesystem::path(path("a")).parent_path()), {});
  }
  void expect_nothing_written(const std::function<wrc_status(const char*)>& write_file) const {
    constexpr rlim_t small = 16;
    {
      const FileSizeLimit limit(small);
      EXPECT_EQ(write_file(path("file").c_str()), WRC_FILE_UNREADABLE);
    }
    EXPECT_EQ(file_count(), 0);
    (void)write("file", "old");
    {
      const FileSizeLimit limit(small);
      EXPECT_EQ(write_file(path("file").c_str()), WRC_FILE_UNREADABLE);
    }
    EXPECT_EQ(file_count(), 1);
    EXPECT_EQ(std::filesystem::file_size(path("file")), 3U);
    EXPECT_EQ(write_file(path("file").c_str()), WRC_OK);
    EXPECT_GT(std::filesystem::file_size(path("file")), small);
    std::filesystem::remove(path("file"));
  }
};

TEST_F(FullDisk, LinksAreFollowedAndModesKept) {
  const ScenePointer scene = make_scene();
  (void)write("real", "old");
  std::filesystem::permissions(path("real"), std::filesystem::perms::owner_read |
                                                 std::filesystem::perms::owner_write);
  std::filesystem::create_symlink("real", path("link"));
  ASSERT_EQ(wrc_scene_write(scene.get(), path("link").c_str()), WRC_OK);
  EXPECT_TRUE(std::filesystem::is_symlink(path("link")));
  EXPECT_GT(std::filesystem::file_size(path("real")), 100U);
  EXPECT_EQ(std::filesystem::status(path("real")).permissions(),
            std::filesystem::perms::owner_read | std::filesystem::perms::owner_write);
}

TEST_F(FullDisk, LeavesNoPartialScene) {
  const ScenePointer scene = make_scene();
  expect_nothing_written([&](const char* file) { return wrc_scene_write(scene.get(), file); });
  solve(scene.get());
}

TEST_F(FullDisk, LeavesNoPartialProfile) {
  const ProfilePointer profile = make_profile();
  ASSERT_EQ(wrc_profile_load_standard(profile.get(), "S1002"), WRC_OK);
  expect_nothing_written(
      [&](const char* file) { return wrc_profile_write(profile.get(), file, 1.0); });
}

TEST_F(FullDisk, LeavesNoPartialWisdom) {
  expect_nothing_written([](const char* file) { return wrc_save_wisdom(file); });
}

} // namespace
} // namespace full_disk_test
