/// What is finished of a table, in a file from which a build that was stopped goes on.
///
/// The file has the numbers that each task gave and is written whole, at most every 20 s and when a
/// build is stopped. It is of one set of inputs: another is refused, and so is a file that was
/// changed. Thread rule: `find` and `add` from several threads.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace wrc {

class FinishedTasks {
public:
  /// `inputs`: what decides on the numbers, as bytes. Reads the file, or makes it. Throws
  /// Error(file_malformed) for a file of other inputs, Error(file_unreadable) where there can be
  /// none.
  FinishedTasks(std::filesystem::path path, std::string_view inputs);

  /// Fills in the numbers of a finished task; false if it is not.
  bool find(std::uint32_t stage, std::size_t task, std::span<double> numbers) const;
  void add(std::uint32_t stage, std::size_t task, std::span<const double> numbers);

  void write();

private:
  using Key = std::pair<std::uint64_t, std::uint64_t>; // stage and task

  void read(std::string_view text);
  void write_locked();

  const std::filesystem::path path_;
  std::string head_; ///< of the file: a line and the checksum of the inputs
  mutable std::mutex mutex_;
  std::map<Key, std::vector<double>> numbers_;
  std::chrono::steady_clock::time_point written_;
};

} // namespace wrc
