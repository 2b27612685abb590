/// What came out of one scene of a study.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "wrcontact.h"

namespace driver {

/// Fields of a patch, one value per element with the longitudinal index fastest.
struct PatchFields {
  std::int32_t side = 0;  ///< 0 left, 1 right
  std::int32_t index = 0; ///< of the patch
  std::int64_t rows = 0;  ///< elements across the rail
  std::int64_t columns = 0;
  std::vector<std::vector<double>> values; ///< in the order of Study::fields
};

inline constexpr std::array side_names{"left", "right"};

struct Row {
  std::int64_t scene = 0;
  wrc_status status = WRC_OK;
  std::string message;        ///< why, if the status is another than WRC_OK
  std::vector<double> values; ///< in the order of Study::results; NaN: there is none
  std::vector<PatchFields> patches;
};

/// A row as bytes, and back, for files and messages between processes of the same machine type.
void append_bytes(const Row& row, std::string& bytes);
/// Takes one row off the front. False if the bytes are no whole row.
bool take_row(std::string_view& bytes, Row& row);

} // namespace driver
