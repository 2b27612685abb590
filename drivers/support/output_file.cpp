#include "support/output_file.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <fcntl.h>
#include <limits>
#include <unistd.h>

#include "support/scene.hpp"

namespace driver {

namespace fs = std::filesystem;

namespace {

constexpr const char* aside_mark = ".part"; // then the number of the process

bool is_same_file(const fs::path& one, const fs::path& other) {
  std::error_code unknown;
  const fs::path whole = fs::weakly_canonical(fs::absolute(target_of(one), unknown), unknown);
  return fs::equivalent(one, other, unknown) ||
         (!whole.empty() &&
          whole == fs::weakly_canonical(fs::absolute(target_of(other), unknown), unknown));
}

void require_writable(const fs::path& path) {
  std::error_code unknown;
  const fs::file_status old = fs::status(path, unknown);
  if (fs::exists(old) && !fs::is_regular_file(old)) {
    throw Failure("cannot write " + path.string() + ": exists and is not a regular file");
  }
  if (fs::exists(old) && access(path.c_str(), W_OK) != 0) { // renaming would not ask
    throw Failure("cannot write " + path.string() + ": it may not be written");
  }
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  if (access(folder.c_str(), W_OK | X_OK) != 0) {
    throw Failure("cannot write " + path.string() + ": does the folder exist, and is it writable?");
  }
}

/// Creates a new file, replacing any link of this name.
void make_file(const fs::path& path) {
  std::error_code ignored;
  fs::remove(path, ignored);         // of a process that had our number
  constexpr mode_t everybody = 0666; // less the user's mask
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, everybody);
  if (file >= 0) {
    close(file);
  }
}

} // namespace

fs::path target_of(fs::path path) {
  constexpr int most_links = 40; // the number that Linux follows
  const fs::path asked = path;
  std::error_code none;
  for (int link = 0; fs::is_symlink(path, none); ++link) {
    if (link == most_links) {
      throw Failure("cannot write " + asked.string() + ": its symbolic links form a circle");
    }
    path = path.parent_path() / fs::read_symlink(path, none);
  }
  return path;
}

OutputFile::OutputFile(const fs::path& path) : path_(target_of(path)), aside_(path_) {
  require_writable(path_);
  remove_leftovers(path_, Runs::dead);
  aside_ += aside_mark + std::to_string(getpid()) + path_.extension().string();
  make_file(aside_);
  stream_.open(aside_, std::ios::in | std::ios::out); // makes none
  if (!stream_) {
    throw Failure("cannot write " + path_.string() +
                  ": does the folder exist, and is it writable?");
  }
  std::error_code unknown;
  if (const fs::file_status old = fs::status(path_, unknown); fs::exists(old)) {
    fs::permissions(aside_, old.permissions() | fs::perms::owner_write, unknown);
  }
  stream_.precision(std::numeric_limits<double>::max_digits10);
}

OutputFile::~OutputFile() {
  if (!committed_) {
    stream_.close();
    std::error_code ignored;
    fs::remove(aside_, ignored);
  }
}

void OutputFile::commit() {
  stream_.close();
  if (!stream_) {
    throw Failure("cannot write " + path_.string() + " completely: " + is_disk_full);
  }
  std::error_code trouble;
  fs::rename(aside_, path_, trouble);
  if (trouble) {
    throw Failure("cannot write " + path_.string() + ": " + trouble.message());
  }
  committed_ = true;
}

void remove_leftovers(const fs::path& path, Runs runs) {
  const std::string start = path.filename().string() + aside_mark;
  const std::string end = path.extension().string();
  const fs::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (!name.starts_with(start) || !name.ends_with(end) ||
        name.size() <= start.size() + end.size()) {
      continue;
    }
    pid_t process = 0;
    const char* last = name.data() + name.size() - end.size();
    const auto parsed = std::from_chars(name.data() + start.size(), last, process);
    const bool is_ours = parsed.ec == std::errc() && parsed.ptr == last && process > 0;
    if (is_ours && (runs == Runs::all || (kill(process, 0) != 0 && errno == ESRCH))) {
      fs::remove(entry.path(), ignored);
    }
  }
}

void refuse_overwriting(const std::vector<fs::path>& outputs, const std::vector<fs::path>& inputs) {
  for (auto output = outputs.begin(); output != outputs.end(); ++output) {
    if (output->empty()) {
      continue;
    }
    const auto same = [&](const fs::path& other) {
      return !other.empty() && is_same_file(*output, other);
    };
    if (std::any_of(inputs.begin(), inputs.end(), same)) {
      throw Failure("cannot write " + output->string() +
                    ": this run reads it; must be another file");
    }
    if (std::any_of(outputs.begin(), output, same)) {
      throw Failure("cannot write " + output->string() +
                    " twice; each file must have a name of its own");
    }
    require_writable(target_of(*output));
  }
}

} // namespace driver
