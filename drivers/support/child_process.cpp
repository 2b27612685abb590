#include "support/child_process.hpp"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "support/scene.hpp"

namespace driver {
namespace {

[[noreturn]] void work_and_end(const std::function<void(int)>& work, int messages, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) { // it died before it could be bound
    _exit(1);
  }
  std::string text;
  try {
    work(messages);
  } catch (const std::exception& error) {
    text = error.what();
  }
  const bool sent = write(messages, text.data(), text.size()) >= 0;
  _exit(sent && text.empty() ? 0 : 1); // nothing of the parent's is ended or written here
}

} // namespace

std::string in_own_process(const std::function<void(int messages)>& work) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) {
    throw Failure(std::string("no pipe to another process: ") + std::strerror(errno));
  }
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    work_and_end(work, ends[1], parent);
  }
  const int trouble = errno;
  close(ends[1]);
  std::string text;
  std::array<char, 256> part{};
  for (ssize_t count = 0; (count = read(ends[0], part.data(), part.size())) > 0;) {
    text.append(part.data(), static_cast<std::size_t>(count));
  }
  close(ends[0]);
  if (child < 0) {
    throw Failure(std::string("no other process: ") + std::strerror(trouble));
  }
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  if (status == 0) {
    return "";
  }
  return !text.empty()         ? text
         : WIFSIGNALED(status) ? "ended by signal " + std::to_string(WTERMSIG(status))
                               : "ended with code " + std::to_string(WEXITSTATUS(status));
}

} // namespace driver
