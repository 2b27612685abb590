#include "support/output_file.hpp"

#include <limits>
#include <unistd.h>

#include "support/scene.hpp"

namespace driver {

namespace fs = std::filesystem;

OutputFile::OutputFile(fs::path path) : path_(std::move(path)), aside_(path_) {
  std::error_code unknown;
  if (fs::exists(path_, unknown) && !fs::is_regular_file(path_, unknown)) {
    throw Failure("cannot write " + path_.string() + ": exists and is not a regular file");
  }
  aside_ += ".part" + std::to_string(getpid()) + path_.extension().string();
  stream_.open(aside_);
  if (!stream_) {
    throw Failure("cannot write " + path_.string() +
                  ": does the folder exist, and is it writable?");
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
    throw Failure("cannot write " + path_.string() + " completely: is the disk full?");
  }
  std::error_code trouble;
  fs::rename(aside_, path_, trouble);
  if (trouble) {
    throw Failure("cannot write " + path_.string() + ": " + trouble.message());
  }
  committed_ = true;
}

} // namespace driver
