#include "support/input_file.hpp"

#include <array>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "support/scene.hpp"

namespace driver {

std::string read_file(const std::string& what, const std::string& path, std::size_t most) {
  const auto refuse = [&](const std::string& why) {
    throw Failure(what + ' ' + path + ": " + why);
  };
  // Not blocking: a pipe without writer would not even open.
  const int file = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC | O_NOCTTY);
  if (file < 0) {
    refuse(std::strerror(errno));
  }
  struct stat status {};
  std::string text;
  const bool regular = fstat(file, &status) == 0 && S_ISREG(status.st_mode);
  ssize_t count = 0;
  std::array<char, 1 << 16> part{};
  while (regular && text.size() <= most && (count = read(file, part.data(), part.size())) > 0) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  const int trouble = count < 0 ? errno : 0;
  close(file);
  if (!regular) { // devices and pipes could deliver without end
    refuse("is not a regular file");
  }
  if (trouble == EAGAIN) {
    refuse("is a device or pipe without an end, not a file");
  }
  if (trouble != 0) {
    refuse(std::strerror(trouble));
  }
  if (text.size() > most) {
    refuse("larger than " + std::to_string(most) + " bytes, the most allowed");
  }
  return text;
}

} // namespace driver
