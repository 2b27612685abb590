// What base/system_posix.cpp does on POSIX, by the standard library alone. It is compiled, but has
// never been run.
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>
#include <vector>

#include "base/error.hpp"
#include "base/file.hpp"
#include "base/fork.hpp"

namespace wrc {

namespace {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what) {
  throw Error(ErrorCode::file_unreadable, path.string() + ": " + what);
}

[[noreturn]] void refuse(const std::filesystem::path& path, const char* what, int reason) {
  refuse(path, std::string(what) + ": " + std::strerror(reason));
}

} // namespace

std::string read_file(const std::filesystem::path& path, std::size_t most) {
  std::error_code fault;
  if (std::filesystem::exists(path, fault) && !std::filesystem::is_regular_file(path, fault)) {
    refuse(path, "is not a regular file");
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    refuse(path, "cannot be opened", errno);
  }
  std::string content;
  std::vector<char> part(std::size_t{1} << 16U); // threads of callers may have small stacks
  while (file && content.size() <= most) {
    file.read(part.data(), static_cast<std::streamsize>(part.size()));
    content.append(part.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) {
    refuse(path, "cannot be read", errno);
  }
  if (content.size() > most) {
    refuse(path, "is larger than " + std::to_string(most) + " bytes, the maximum allowed");
  }
  return content;
}

void write_file(const std::filesystem::path& path, const std::string& content) {
  std::error_code fault;
  std::filesystem::path target = path;
  if (std::filesystem::is_symlink(target, fault)) {
    target = std::filesystem::weakly_canonical(target, fault);
  }
  if (!fault && std::filesystem::exists(target, fault) &&
      !std::filesystem::is_regular_file(target, fault)) {
    refuse(path, "exists and is not a regular file");
  }
  std::filesystem::path aside = target;
  aside += ".partial";
  errno = 0;
  std::ofstream file(aside, std::ios::binary | std::ios::trunc);
  file.write(content.data(), static_cast<std::streamsize>(content.size()));
  file.close();
  if (!file) {
    const int reason = errno;
    std::filesystem::remove(aside, fault);
    refuse(path, "cannot be written", reason);
  }
  std::filesystem::rename(aside, target, fault); // replaces a file that is there
  if (fault) {
    const std::string reason = fault.message();
    std::filesystem::remove(aside, fault);
    refuse(path, "cannot be written: " + reason);
  }
}

bool call_around_forks(void (*)(), void (*)(), void (*)()) {
  return true;
}

} // namespace wrc
