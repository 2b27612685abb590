/// Files that are whole or not there: written aside, then renamed.
#pragma once

#include <filesystem>
#include <fstream>

namespace driver {

class OutputFile {
public:
  /// Throws Failure if the file cannot be made.
  explicit OutputFile(std::filesystem::path path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Removes what was written if commit() has not been called.
  ~OutputFile();

  [[nodiscard]] std::ofstream& stream() { return stream_; }
  /// Where the file stands until it is committed.
  [[nodiscard]] const std::filesystem::path& aside() const { return aside_; }
  /// Puts the file in its place; throws Failure if it could not be written whole.
  void commit();

private:
  std::filesystem::path path_;
  std::filesystem::path aside_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Writes a whole file by print(stream). Throws Failure if that fails.
template <class Print> void write_whole(const std::filesystem::path& path, Print print) {
  OutputFile file(path);
  print(file.stream());
  file.commit();
}

} // namespace driver
