// Bytes as edits of a small table's file, whose checksum is put right: it is refused with a text,
// or read, and then steps are refused or give finite forces, derivatives and errors, and what it is
// of is text of one line each.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>

#include "base/error.hpp"
#include "table/table_file.hpp"
#include "table/table_step.hpp"
#include "table/table_text.hpp"

namespace {

void demand(bool promise) {
  if (!promise) {
    __builtin_trap();
  }
}

/// Four nodes of each variable; numbers of about the size of those of S1002 on 60E1.
wrc::ContactTable base_table() {
  using wrc::SplineAxis;
  wrc::ContactTable table;
  table.identity.wheel = "S1002";
  table.identity.rail = "60E1";
  table.identity.numbers = {460.0,    1360.0, 70.0,     1435.0, 14.0, 0.025,
                            210000.0, 0.3,    210000.0, 0.3,    0.0,  0.0};
  table.taping_line = 750.0;
  table.radius = 460.0;
  table.rail_y = 753.0;
  const SplineAxis lateral(-10.0, 10.0, 4);
  const SplineAxis roll(-0.01, 0.01, 4);
  const SplineAxis square(0.0, 4e-4, 4);
  const SplineAxis depth(0.0, 1.0, 4);
  table.shift = {{roll, square}, std::vector<double>(16)};
  std::vector<double> touch;
  for (std::size_t i = 0; i < 64; ++i) {
    touch.insert(touch.end(), {0.001 * static_cast<double>(i), -2.0}); // height, log of a depth
  }
  table.touch = {{lateral, roll, square}, touch};
  std::vector<double> contact;
  for (std::size_t i = 0; i < 256; ++i) {
    std::array<double, wrc::table_part_count> parts{};
    parts.fill(0.1);
    parts[static_cast<std::size_t>(wrc::TablePart::load)] = 800.0 * static_cast<double>(i % 4);
    parts[static_cast<std::size_t>(wrc::TablePart::arm_z)] = -460.0;
    parts[static_cast<std::size_t>(wrc::TablePart::longitudinal_law)] = -3e4;
    parts[static_cast<std::size_t>(wrc::TablePart::lateral_law)] = -3e4;
    contact.insert(contact.end(), parts.begin(), parts.end());
  }
  table.contact = {{lateral, roll, square, depth}, contact};
  table.places = {{lateral, roll, square, depth},
                  std::vector<double>(256 * wrc::place_part_count, 0.1)};
  const SplineAxis law(-1.0, 1.0, 4);
  table.law = wrc::CreepLaw({{law, law, law, law}, std::vector<double>(1024)});
  table.errors = wrc::ErrorMap({{{-10.0, 10.0}, {0.0, 1.0}}}, {2, 1});
  table.measured.states = 100;
  return table;
}

std::string with_checksum(std::string text) {
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (const char byte : text) {
    sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  }
  text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return text;
}

/// Each edit has two bytes of a place, one that says what, and one or eight that may be put there.
std::string edited(std::string text, const std::uint8_t* data, std::size_t size) {
  constexpr std::array numbers{0.0,
                               -1.0,
                               1e-310,
                               1e308,
                               -1e308,
                               1e30,
                               std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN()};
  while (size >= 4) {
    // Most of the head is in the first bytes, and numbers have their place there.
    const std::size_t place = (data[0] + std::size_t{256} * data[1]) % text.size();
    const std::uint8_t what = data[2];
    double number = numbers[data[3] % numbers.size()];
    std::size_t used = 4;
    if (what % 4 == 0 && size >= 11) {
      std::memcpy(&number, data + 3, sizeof number);
      used = 11;
    }
    if (what % 4 == 1) {
      text[place] = static_cast<char>(data[3]);
    } else if (what % 64 == 2) {
      text.resize(std::max<std::size_t>(1, place));
    } else if (place + sizeof number <= text.size()) {
      std::memcpy(text.data() + place, &number, sizeof number);
    }
    data += used;
    size -= used;
  }
  return text;
}

bool is_finite(const wrc::SixNumbers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

void take_step(const wrc::ContactTable& table, const wrc::VehicleState& state) {
  try {
    const wrc::TableStep step = wrc::step_in_table(table, state, nullptr, true);
    for (std::size_t wheel = 0; wheel < 2; ++wheel) {
      demand(is_finite(step.wheels[wheel].force) &&
             std::isfinite(step.errors[wheel][0] + step.errors[wheel][1] + step.errors[wheel][2]));
      for (std::size_t i = 0; i < wrc::output_count; ++i) {
        demand(std::isfinite(step.outputs[wheel][i]) &&
               std::isfinite(step.output_errors[wheel][i]));
      }
      for (std::size_t i = 0; i < 6; ++i) {
        demand(is_finite(step.wheels[wheel].by_position[i]) &&
               is_finite(step.wheels[wheel].by_velocity[i]));
      }
    }
  } catch (const wrc::Error& error) {
    demand(error.code() == wrc::ErrorCode::invalid_argument ||
           error.code() == wrc::ErrorCode::file_malformed);
  }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string base = [] {
    std::string text = wrc::text_of_table(base_table());
    text.resize(text.size() - sizeof(std::uint64_t));
    return text;
  }();
  try {
    const wrc::ContactTable table = wrc::table_from_text(with_checksum(edited(base, data, size)));
    for (const std::string& line : wrc::lines_of(table)) {
      demand(std::none_of(line.begin(), line.end(),
                          [](unsigned char letter) { return letter < 0x20 || letter == 0x7F; }));
    }
    for (const double lateral : {0.0, 4.0, -9.9}) {
      for (const double height : {460.0, 459.9, 459.0}) {
        wrc::VehicleState state;
        state.position = {0.0, lateral, height, 0.001, 0.0, 0.002};
        state.velocity = {2e4, 10.0, 0.0, 0.0, 43.0, 0.01};
        state.derivatives = lateral != 0.0;
        take_step(table, state);
      }
    }
  } catch (const wrc::Error& error) {
    demand(error.code() == wrc::ErrorCode::file_malformed);
    demand(std::string_view(error.what()).starts_with("table file: "));
  }
  return 0;
}
