#include "base/written_file.hpp"

#include <fstream>
#include <system_error>

#include "base/error.hpp"

namespace wrc {

void write_file(const std::filesystem::path& path, const std::string& content) {
  std::error_code unknown;
  if (std::filesystem::exists(path, unknown) &&
      !std::filesystem::is_regular_file(path, unknown)) { // a device would become a file
    throw Error(ErrorCode::file_unreadable, path.string() + ": is there and is no regular file");
  }
  std::filesystem::path aside = path;
  aside += ".partial";
  std::ofstream stream(aside, std::ios::binary | std::ios::trunc);
  stream << content;
  stream.close();
  std::error_code fault;
  if (stream) {
    std::filesystem::rename(aside, path, fault);
  }
  if (!stream || fault) {
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    throw Error(ErrorCode::file_unreadable, path.string() + ": cannot be written");
  }
}

} // namespace wrc
