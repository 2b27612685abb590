#include "table/finished_tasks.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <system_error>

#include "base/error.hpp"
#include "base/file.hpp"
#include "table/constants.hpp"
#include "table/table_file.hpp"

namespace wrc {
namespace {

constexpr std::string_view first_of_unfinished = "wrcontact unfinished table, format 1\n";

void append(std::string& text, std::uint64_t number) {
  text.append(reinterpret_cast<const char*>(&number), sizeof number);
}

std::uint64_t taken_from(std::string_view& text) {
  std::uint64_t number = 0;
  if (text.size() < sizeof number) {
    throw Error(ErrorCode::file_malformed, "it ends too early");
  }
  std::memcpy(&number, text.data(), sizeof number);
  text.remove_prefix(sizeof number);
  return number;
}

} // namespace

FinishedTasks::FinishedTasks(std::filesystem::path path, std::string_view inputs)
    : path_(std::move(path)), head_(first_of_unfinished) {
  append(head_, checksum_of(inputs));
  std::error_code none;
  if (std::filesystem::exists(path_, none)) {
    try {
      read(read_file(path_, largest_unfinished_file));
    } catch (const Error& error) {
      throw Error(error.code(), "resume_file = " + path_.string() + ": " + error.what() +
                                    "; name another file, or remove it to begin again");
    }
  }
  write();
}

void FinishedTasks::read(std::string_view text) {
  if (!text.starts_with(first_of_unfinished)) {
    throw Error(ErrorCode::file_malformed, "is no file of an unfinished table");
  }
  if (!text.starts_with(head_)) {
    throw Error(
        ErrorCode::file_malformed,
        "is of a table of another scene or with other options, or of another version of the "
        "library");
  }
  std::string_view end = text.substr(text.size() - sizeof(std::uint64_t));
  text.remove_suffix(end.size());
  if (text.size() < head_.size() || taken_from(end) != checksum_of(text)) {
    throw Error(ErrorCode::file_malformed,
                "its checksum is another: it was changed or is not whole");
  }
  text.remove_prefix(head_.size());
  while (!text.empty()) {
    const std::uint64_t stage = taken_from(text);
    const std::uint64_t task = taken_from(text);
    const std::uint64_t count = taken_from(text);
    if (count > text.size() / sizeof(double)) {
      throw Error(ErrorCode::file_malformed, "it ends too early");
    }
    std::vector<double> numbers(count);
    std::memcpy(numbers.data(), text.data(), count * sizeof(double));
    text.remove_prefix(count * sizeof(double));
    numbers_.insert_or_assign({stage, task}, std::move(numbers));
  }
}

bool FinishedTasks::find(std::uint32_t stage, std::size_t task, std::span<double> numbers) const {
  const std::lock_guard guard(mutex_);
  const auto found = numbers_.find({stage, task});
  if (found == numbers_.end() || found->second.size() != numbers.size() ||
      !std::ranges::all_of(found->second, [](double number) { return std::isfinite(number); })) {
    return false;
  }
  std::ranges::copy(found->second, numbers.begin());
  return true;
}

void FinishedTasks::add(std::uint32_t stage, std::size_t task, std::span<const double> numbers) {
  const std::lock_guard guard(mutex_);
  numbers_.insert_or_assign({stage, task}, std::vector<double>(numbers.begin(), numbers.end()));
  if (std::chrono::steady_clock::now() - written_ > least_time_between_writes) {
    write_locked();
  }
}

void FinishedTasks::write() {
  const std::lock_guard guard(mutex_);
  write_locked();
}

void FinishedTasks::write_locked() {
  std::string text = head_;
  for (const auto& [key, numbers] : numbers_) {
    append(text, key.first);
    append(text, key.second);
    append(text, numbers.size());
    text.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(double));
  }
  append(text, checksum_of(text));
  write_file(path_, text);
  written_ = std::chrono::steady_clock::now();
}

} // namespace wrc
