// Bytes as a sequence of calls of the C interface with their arguments (tests/c_api). Each sequence
// begins with new handles and ends when the bytes do. Files are written into the working folder.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>

#include "call_sequences.hpp"

namespace {

class ChoicesOfBytes : public Choices {
public:
  explicit ChoicesOfBytes(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint64_t below(std::uint64_t end) override {
    std::uint64_t number = 0;
    for (std::uint64_t largest = end - 1; largest > 0 && !bytes_.empty(); largest >>= 8U) {
      number = number << 8U | bytes_.front();
      bytes_ = bytes_.subspan(1);
    }
    return number % end;
  }
  [[nodiscard]] bool ended() const override { return bytes_.empty(); }

private:
  std::span<const std::uint8_t> bytes_;
};

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr long most_calls = 20;
  ChoicesOfBytes choices({data, size});
  make_handles();
  const auto status = unheard_of_status(choices, most_calls);
  destroy_handles();
  if (status) {
    __builtin_trap();
  }
  return 0;
}
