/// Files that are whole or not there: written aside, then renamed. Output through a symbolic link
/// goes to the file that the link names, which is replaced or created; the link stays. The file
/// aside is always a new one. A file that is replaced leaves its permissions to the new one.
#pragma once

#include <filesystem>
#include <fstream>
#include <vector>

namespace driver {

/// What to ask when a file cannot be written whole.
inline constexpr const char* is_disk_full = "is the disk full, or a limit set?";

class OutputFile {
public:
  /// Throws Failure if the file cannot be made. Removes what runs that have died left aside.
  explicit OutputFile(const std::filesystem::path& path);
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  /// Removes what was written if commit() has not been called.
  ~OutputFile();

  [[nodiscard]] std::ofstream& stream() { return stream_; }
  /// Where the file stands until it is committed.
  [[nodiscard]] const std::filesystem::path& aside() const { return aside_; }
  /// Renames the file to its final name; throws Failure if it could not be written whole.
  void commit();

private:
  std::filesystem::path path_;
  std::filesystem::path aside_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Follows symbolic links to the file that they name, which need not exist. Throws Failure for
/// links that form a circle.
std::filesystem::path target_of(std::filesystem::path path);

/// Removes what is aside of a file: of runs that have died, or of all, if others cannot be.
enum class Runs { dead, all };
void remove_leftovers(const std::filesystem::path& path, Runs runs);

/// Before work begins: throws Failure if one of the files to be written is one that is read, is
/// named twice, or cannot be written. Empty paths do not count.
void refuse_overwriting(const std::vector<std::filesystem::path>& outputs,
                        const std::vector<std::filesystem::path>& inputs);

/// Writes a whole file by print(stream). Throws Failure if that fails.
template <class Print> void write_whole(const std::filesystem::path& path, Print print) {
  OutputFile file(path);
  print(file.stream());
  file.commit();
}

} // namespace driver
