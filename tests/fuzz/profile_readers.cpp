// Any text as a profile file: it is read or refused, without a crash, a hang or memory without
// bound. The first byte selects the format, the second the options.
// Run: fuzz_profile_readers FOLDER_OF_EXAMPLES -max_len=3000 -timeout=5
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "error.hpp"
#include "profile/readers.hpp"

namespace {

wrc::ReadOptions options_from(std::uint8_t bits) {
  wrc::ReadOptions options;
  if ((bits & 1U) != 0) {
    options.kind = (bits & 2U) != 0 ? wrc::ProfileKind::rail : wrc::ProfileKind::wheel;
  }
  if ((bits & 4U) != 0) {
    options.smoothing_wavelength = 2.0; // mm
  }
  options.strict = (bits & 8U) != 0;
  return options;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t header = 2;
  constexpr std::array formats{wrc::ProfileFormat::columns, wrc::ProfileFormat::simpack,
                               wrc::ProfileFormat::miniprof};
  constexpr std::array wheel_names{"a.txt", "a.prw", "a.whl"};
  constexpr std::array rail_names{"a.txt", "a.prr", "a.ban"};
  if (size < header) {
    return 0;
  }
  const std::size_t format = data[0] % formats.size();
  const char* name = (data[1] & 16U) != 0 ? rail_names[format] : wheel_names[format];
  const std::string_view text(reinterpret_cast<const char*>(data + header), size - header);
  try {
    const wrc::Profile profile =
        wrc::read_profile_text(text, formats[format], name, options_from(data[1])).profile;
    const double length = profile.curve.length();
    for (const double share : {0.0, 0.3, 0.7, 1.0}) {
      if (!(profile.curve.at(share * length).lateral < 1e9)) {
        __builtin_trap(); // a curve that is none
      }
    }
  } catch (const wrc::Error&) {
    // Refused, with a text.
  }
  return 0;
}
