#include "handles.hpp"

#include <algorithm>
#include <exception>

namespace wrc {

void keep_text(std::string& error, const char* text) noexcept {
  try {
    error = text;
  } catch (...) {
    error.clear();
  }
}

wrc_status status_of_current_exception(std::string& error) noexcept {
  try {
    throw;
  } catch (const Error& failure) {
    keep_text(error, failure.what());
    return static_cast<wrc_status>(failure.code());
  } catch (const std::bad_alloc&) {
    keep_text(error, "out of memory");
    return WRC_OUT_OF_MEMORY;
  } catch (const std::exception& failure) {
    keep_text(error, failure.what());
    return WRC_INTERNAL;
  } catch (...) {
    keep_text(error, "unknown failure");
    return WRC_INTERNAL;
  }
}

void require_pointer(const void* pointer, const char* name) {
  if (pointer == nullptr) {
    throw_invalid_argument(name, "NULL", "a pointer must be given");
  }
}

wrc_status copy_values(const double* from, std::size_t length, double* values,
                       std::int64_t capacity, std::int64_t* count, std::string& error) {
  require_pointer(count, "count");
  *count = static_cast<std::int64_t>(length);
  if (capacity <= 0) {
    return WRC_OK;
  }
  require_pointer(values, "values");
  if (*count > capacity) {
    error = "capacity = " + std::to_string(capacity) + ": needed is " + std::to_string(*count);
    return WRC_TOO_SMALL;
  }
  std::copy_n(from, length, values);
  return WRC_OK;
}

} // namespace wrc
