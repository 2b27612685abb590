/// Errors of the core: one exception type with a code and a text.
///
/// The text names the argument, its value and the permitted range. The C interface turns the code
/// into a status and keeps the text on the handle. Thread rule: no state, safe everywhere.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

namespace wrc {

/// What went wrong. The numbers are the status codes of the C interface and are never reused.
enum class ErrorCode : std::int32_t {
  invalid_argument = 1, ///< a value outside its permitted range
  unknown_name = 2,     ///< a key, profile or quantity that does not exist
  file_unreadable = 3,  ///< a file that cannot be opened or read
  file_malformed = 4,   ///< a file whose content cannot be understood
  no_contact = 5,       ///< wheel and rail do not meet in the scene as posed
  out_of_memory = 6,    ///< memory could not be allocated
  internal = 7,         ///< a fault of the library itself
};

class Error : public std::runtime_error {
public:
  Error(ErrorCode code, const std::string& text) : std::runtime_error(text), code_(code) {}
  [[nodiscard]] ErrorCode code() const noexcept { return code_; }

private:
  ErrorCode code_;
};

/// Throws `invalid_argument`: "<argument> = <value>: <allowed>".
[[noreturn]] void throw_invalid_argument(const std::string& argument, double value,
                                         const std::string& allowed);
[[noreturn]] void throw_invalid_argument(const std::string& argument, const std::string& value,
                                         const std::string& allowed);

/// What a value must be, for such a text: of "1 to 30 mm" it is "must be between 1 and 30 mm".
std::string must_be(std::string_view permitted);

/// Shortest text that reads back as the same double.
std::string text_of(double value);
/// Four digits, for what was measured.
std::string short_text_of(double value);

} // namespace wrc
