#include "wrc_sweep/row.hpp"

#include <cstring>
#include <type_traits>

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

bool take_body(std::string_view body, Row& row) {
  std::uint64_t patch_count = 0;
  if (!take(body, row.scene) || !take(body, row.status) || !take_all(body, row.message) ||
      !take_all(body, row.values) || !take(body, patch_count) || patch_count > body.size()) {
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
  append_all(body, row.values);
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

} // namespace driver
