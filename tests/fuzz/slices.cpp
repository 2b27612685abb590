// Any text as a list of slices: it is read or refused with a text that names it, without a crash, a
// hang or memory without bound. What is accepted keeps the limits: places ascend, features ascend
// and are of one number, or there are none.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/error.hpp"
#include "measured/slices.hpp"

namespace {

void demand(bool promise) {
  if (!promise) {
    __builtin_trap();
  }
}

void check(const wrc::SliceList& list) {
  demand(!list.slices.empty() && list.slices.size() <= 4999);
  for (std::size_t i = 0; i < list.slices.size(); ++i) {
    const wrc::Slice& slice = list.slices[i];
    demand(std::isfinite(slice.place) && !slice.file.empty());
    demand(i == 0 || slice.place > list.slices[i - 1].place);
    demand(slice.features.size() <= 200 &&
           slice.features.size() == list.slices.front().features.size());
    double last = -1.0;
    for (const std::optional<double>& feature : slice.features) {
      demand(!feature || (std::isfinite(*feature) && *feature > last));
      last = feature.value_or(last);
    }
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  try {
    check(wrc::read_slice_list(text, "folder/list.slcs"));
    demand(!wrc::read_slices(text, "folder/list.slcs").empty());
  } catch (const wrc::Error& error) {
    demand(error.code() == wrc::ErrorCode::file_malformed);
    demand(std::string_view(error.what()).starts_with("folder/list.slcs"));
  }
  return 0;
}
