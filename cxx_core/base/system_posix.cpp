// The only file that needs POSIX, except tests and programs. system_windows.cpp replaces it on
// Windows.
#include "base/file.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <fcntl.h>
#include <new>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>
#include <vector>

#include "base/error.hpp"
#include "base/fork.hpp"

namespace wrc {

namespace {

/// `reason` is a value of errno.
[[noreturn]] void refuse(const std::filesystem::path& path, const char* what, int reason) {
  if (reason == ENOMEM) {
    throw std::bad_alloc();
  }
  const bool full = reason == ENOSPC || reason == EFBIG || reason == EDQUOT;
  throw Error(ErrorCode::file_unreadable,
              path.string() + ": " + what + ": " +
                  (full ? "is the disk full, or a limit set?" : std::strerror(reason)));
}

class Descriptor {
public:
  Descriptor(const std::filesystem::path& path, int flags, mode_t mode = 0)
      : number_(open(path.c_str(), flags | O_CLOEXEC, mode)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { close(); }

  [[nodiscard]] int number() const { return number_; }
  bool close() {
    const int number = number_;
    number_ = -1;
    return number < 0 || ::close(number) == 0;
  }

private:
  int number_;
};

/// While it lives, SIGXFSZ does not reach this thread; a limit shows by EFBIG. The host's handlers
/// stay.
class NoSizeSignal {
public:
  NoSizeSignal() {
    sigemptyset(&signal_);
    sigaddset(&signal_, SIGXFSZ);
    sigset_t pending{};
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGXFSZ) == 1;
    pthread_sigmask(SIG_BLOCK, &signal_, &before_);
  }
  NoSizeSignal(const NoSizeSignal&) = delete;
  NoSizeSignal& operator=(const NoSizeSignal&) = delete;
  ~NoSizeSignal() {
    const int reason = errno;
    const timespec now{};
    while (!was_pending_ && sigtimedwait(&signal_, nullptr, &now) < 0 && errno == EINTR) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
    errno = reason;
  }

private:
  sigset_t signal_{};
  sigset_t before_{};
  bool was_pending_ = false;
};

bool write_all(int file, const std::string& content) {
  const NoSizeSignal no_signal;
  for (std::size_t done = 0; done < content.size();) {
    const ssize_t count = write(file, content.data() + done, content.size() - done);
    if (count < 0 && errno != EINTR) {
      return false;
    }
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  return true;
}

/// Where a file stands that may be a link, or a link to one that is not there yet.
std::filesystem::path target_of(std::filesystem::path path) {
  constexpr int most_links = 40; // origin: convention: the limit of Linux
  std::array<char, 4096> target{};
  const std::filesystem::path asked = path;
  for (int link = 0; link <= most_links; ++link) {
    const ssize_t length = readlink(path.c_str(), target.data(), target.size());
    if (length <= 0 || length == static_cast<ssize_t>(target.size())) {
      return path;
    }
    path = path.parent_path() / std::string(target.data(), static_cast<std::size_t>(length));
  }
  refuse(asked, "cannot be written", ELOOP); // in a circle
}

} // namespace

std::string read_file(const std::filesystem::path& path, std::size_t most) {
  // Not blocking: a pipe without writer would not even open.
  const Descriptor file(path, O_RDONLY | O_NONBLOCK | O_NOCTTY);
  struct stat status {};
  if (file.number() < 0 || fstat(file.number(), &status) != 0) {
    refuse(path, "cannot be opened", errno);
  }
  if (!S_ISREG(status.st_mode)) { // devices and pipes could deliver without end
    throw Error(ErrorCode::file_unreadable, path.string() + ": is not a regular file");
  }
  // The file may be longer than it says: those of the system have no size, others still grow.
  std::string content;
  std::vector<char> part(std::size_t{1} << 16U); // threads of callers may have small stacks
  ssize_t count = 1;
  while (count > 0 && content.size() <= most) {
    count = read(file.number(), part.data(), part.size());
    if (count < 0 && errno == EAGAIN) {
      throw Error(ErrorCode::file_unreadable,
                  path.string() + ": is a device or pipe without an end, not a file");
    }
    if (count < 0) {
      refuse(path, "cannot be read", errno);
    }
    content.append(part.data(), static_cast<std::size_t>(count));
  }
  if (content.size() > most) {
    throw Error(ErrorCode::file_unreadable, path.string() + ": is larger than " +
                                                std::to_string(most) +
                                                " bytes, the maximum allowed");
  }
  return content;
}

void write_file(const std::filesystem::path& path, const std::string& content) {
  constexpr const char* fault = "cannot be written";
  const std::filesystem::path target = target_of(path);
  std::filesystem::path aside = target;
  aside += ".partial";
  struct stat old {};
  const bool replaces = stat(target.c_str(), &old) == 0;
  if (replaces && !S_ISREG(old.st_mode)) { // a device would become a file
    throw Error(ErrorCode::file_unreadable, path.string() + ": exists and is not a regular file");
  }
  if (replaces && access(target.c_str(), W_OK) != 0) { // renaming would not ask
    refuse(path, fault, errno);
  }
  constexpr mode_t everybody = 0666; // origin: convention: less the user's mask
  Descriptor file(aside, O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, everybody);
  if (file.number() < 0) {
    refuse(path, fault, errno);
  }
  if ((replaces && fchmod(file.number(), old.st_mode & 07777U) != 0) ||
      !write_all(file.number(), content) || !file.close() ||
      std::rename(aside.c_str(), target.c_str()) != 0) {
    const int reason = errno;
    unlink(aside.c_str());
    refuse(path, fault, reason);
  }
}

bool call_around_forks(void (*before)(), void (*in_parent)(), void (*in_child)()) {
  return pthread_atfork(before, in_parent, in_child) == 0;
}

} // namespace wrc
