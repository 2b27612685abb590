#include "wrc_sweep/journal.hpp"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <thread>
#include <type_traits>
#include <unistd.h>

#include "support/output_file.hpp"

namespace driver {
namespace {

// Each row: length and check sum of its body, then the body.
template <class Number> void append(std::string& bytes, Number number) {
  static_assert(std::is_arithmetic_v<Number>);
  std::array<char, sizeof(Number)> raw{};
  std::memcpy(raw.data(), &number, sizeof(Number));
  bytes.append(raw.data(), raw.size());
}

template <class Values> void append_all(std::string& bytes, const Values& values) {
  append(bytes, static_cast<std::uint64_t>(values.size()));
  bytes.append(reinterpret_cast<const char*>(values.data()), // bytes of plain numbers
               values.size() * sizeof(typename Values::value_type));
}

template <class Number> bool take(std::string_view& bytes, Number& number) {
  if (bytes.size() < sizeof(Number)) {
    return false;
  }
  std::memcpy(&number, bytes.data(), sizeof(Number));
  bytes.remove_prefix(sizeof(Number));
  return true;
}

template <class Values> bool take_all(std::string_view& bytes, Values& values) {
  constexpr std::size_t width = sizeof(typename Values::value_type);
  std::uint64_t count = 0;
  if (!take(bytes, count) || count > bytes.size() / width) {
    return false;
  }
  values.resize(count);
  if (count > 0) {
    std::memcpy(values.data(), bytes.data(), count * width);
  }
  bytes.remove_prefix(count * width);
  return true;
}

/// Fowler, Noll and Vo: finds a row that was not written whole.
std::uint64_t check_sum(std::string_view bytes) {
  std::uint64_t sum = 14695981039346656037U;
  for (const char byte : bytes) {
    sum = (sum ^ static_cast<unsigned char>(byte)) * 1099511628211U;
  }
  return sum;
}

bool take_warnings(std::string_view& bytes, std::vector<Warning>& warnings) {
  std::uint64_t count = 0;
  if (!take(bytes, count) || count > bytes.size()) {
    return false;
  }
  warnings.resize(count);
  return std::all_of(warnings.begin(), warnings.end(), [&bytes](Warning& warning) {
    return take_all(bytes, warning.text) && take(bytes, warning.grade) &&
           warning.grade >= WRC_FINE && warning.grade <= WRC_DO_NOT_USE;
  });
}

bool take_body(std::string_view body, Row& row) {
  std::uint64_t patch_count = 0;
  if (!take(body, row.scene) || !take(body, row.status) || !take_all(body, row.message) ||
      !take_warnings(body, row.warnings) || !take_all(body, row.values) ||
      !take_all(body, row.page) || !take(body, patch_count) || patch_count > body.size()) {
    return false;
  }
  row.patches.assign(patch_count, {});
  for (PatchFields& patch : row.patches) {
    std::uint64_t field_count = 0;
    if (!take(body, patch.side) || !take(body, patch.index) || !take(body, patch.rows) ||
        !take(body, patch.columns) || !take(body, field_count) || field_count > body.size()) {
      return false;
    }
    patch.values.resize(field_count);
    for (auto& values : patch.values) {
      if (!take_all(body, values)) {
        return false;
      }
    }
  }
  return body.empty();
}

} // namespace

void append_bytes(const Row& row, std::string& bytes) {
  std::string body;
  append(body, row.scene);
  append(body, row.status);
  append_all(body, row.message);
  append(body, static_cast<std::uint64_t>(row.warnings.size()));
  for (const Warning& warning : row.warnings) {
    append_all(body, warning.text);
    append(body, warning.grade);
  }
  append_all(body, row.values);
  append_all(body, row.page);
  append(body, static_cast<std::uint64_t>(row.patches.size()));
  for (const PatchFields& patch : row.patches) {
    append(body, patch.side);
    append(body, patch.index);
    append(body, patch.rows);
    append(body, patch.columns);
    append(body, static_cast<std::uint64_t>(patch.values.size()));
    for (const auto& values : patch.values) {
      append_all(body, values);
    }
  }
  append(bytes, static_cast<std::uint64_t>(body.size()));
  append(bytes, check_sum(body));
  bytes += body;
}

bool take_row(std::string_view& bytes, Row& row) {
  std::string_view rest = bytes;
  std::uint64_t size = 0;
  std::uint64_t sum = 0;
  if (!take(rest, size) || !take(rest, sum) || size > rest.size()) {
    return false;
  }
  const std::string_view body = rest.substr(0, size);
  if (check_sum(body) != sum || !take_body(body, row)) {
    return false;
  }
  bytes = rest.substr(size);
  return true;
}

namespace fs = std::filesystem;

namespace {

std::string header_of(const Study& study) {
  const std::string text = study.fingerprint();
  return "wrc_sweep rows 4\n" + std::to_string(text.size()) + '\n' + text + '\n';
}

} // namespace

Journal::Journal(fs::path path, const Study& study, Old old) : path_(target_of(std::move(path))) {
  places_.assign(static_cast<std::size_t>(study.scene_count()), -1);
  lengths_.assign(places_.size(), 0);
  grades_.assign(places_.size(), {});
  const bool there = fs::exists(path_) && fs::file_size(path_) > 0;
  lock();
  if (there && old != Old::restart) {
    if (old == Old::refuse) {
      throw Failure(path_.string() + " holds rows of an interrupted run: --resume goes on, "
                                     "--restart begins again");
    }
    open_old(study);
  } else {
    start(study);
  }
}

Journal::~Journal() {
  give_up_lock();
}

void Journal::give_up_lock() {
  if (locked_ >= 0) {
    close(locked_);
    locked_ = -1;
  }
}

void Journal::lock() {
  constexpr mode_t everybody = 0666; // less the user's mask
  locked_ = open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, everybody);
  if (locked_ < 0) {
    throw Failure("cannot write " + path_.string() +
                  ": does the folder exist, and is it writable?");
  }
  // Two runs that write the same results would damage them. File systems without locks do not
  // report this. A run that was killed may take a moment to die.
  constexpr std::chrono::milliseconds pause{20};
  constexpr int tries = 50;
  for (int i = 0; flock(locked_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK; ++i) {
    if (i == tries) {
      throw Failure(path_.string() + " is being written by another run: use another --out");
    }
    std::this_thread::sleep_for(pause);
  }
}

void Journal::start(const Study& study) {
  file_.open(path_, std::ios::in | std::ios::out | std::ios::binary | std::ios::trunc);
  const std::string header = header_of(study);
  file_ << header << std::flush;
  if (!file_) {
    throw Failure("cannot write " + path_.string() +
                  ": does the folder exist, and is it writable?");
  }
  end_ = static_cast<std::int64_t>(header.size());
}

void Journal::open_old(const Study& study) {
  std::ifstream in(path_, std::ios::binary);
  const std::string header = header_of(study);
  std::string found(header.size(), '\0');
  in.read(found.data(), static_cast<std::streamsize>(found.size()));
  if (!in || found != header) {
    throw Failure(
        "--resume: " + path_.string() +
        " holds rows of another study (keys, values, results, fields, content of input files or "
        "version differ): "
        "--restart begins again");
  }
  end_ = static_cast<std::int64_t>(header.size());
  // A row at a time: with fields the file may be larger than the memory.
  constexpr std::size_t head = 2 * sizeof(std::uint64_t);
  std::string bytes;
  while (true) {
    bytes.resize(head);
    if (!in.read(bytes.data(), head)) {
      break;
    }
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof(size));
    const auto left = fs::file_size(path_) - static_cast<std::uintmax_t>(in.tellg());
    if (size > left) {
      break;
    }
    bytes.resize(head + size);
    in.read(bytes.data() + head, static_cast<std::streamsize>(size));
    std::string_view view = bytes;
    Row row;
    if (!in || !take_row(view, row) || row.scene < 0 || row.scene >= study.scene_count() ||
        row.values.size() != study.results.size() || has(row.scene)) {
      break;
    }
    note(row, bytes.size());
  }
  in.close();
  fs::resize_file(path_, static_cast<std::uintmax_t>(end_));
  file_.open(path_, std::ios::in | std::ios::out | std::ios::binary);
}

void Journal::note(const Row& row, std::size_t length) {
  const auto scene = static_cast<std::size_t>(row.scene);
  places_[scene] = end_;
  lengths_[scene] = static_cast<std::int64_t>(length);
  end_ += lengths_[scene];
  grades_[scene] = {grade_of(row.warnings), grade_of(row.warnings, "left"),
                    grade_of(row.warnings, "right")};
  warnings_.add(row.scene, row.warnings);
  ++count_;
  failed_ += row.status == WRC_OK ? 0 : 1;
}

void Journal::add(const std::vector<Row>& rows) {
  file_.seekp(end_);
  for (const Row& row : rows) {
    std::string bytes;
    append_bytes(row, bytes);
    file_ << bytes;
    note(row, bytes.size());
  }
  file_ << std::flush;
  if (!file_) {
    throw Failure("cannot write " + path_.string() + ": " + is_disk_full);
  }
}

Row Journal::read(std::int64_t scene) {
  std::string bytes(static_cast<std::size_t>(lengths_[static_cast<std::size_t>(scene)]), '\0');
  file_.seekg(place(scene));
  file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  std::string_view view = bytes;
  Row row;
  if (!file_ || !take_row(view, row)) {
    throw Failure("cannot read " + path_.string() + ": has it been changed meanwhile?");
  }
  return row;
}

void Journal::remove() {
  file_.close();
  std::error_code ignored;
  fs::remove(path_, ignored);
}

} // namespace driver
