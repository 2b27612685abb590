#include "wrc_report/origin.hpp"

#include <charconv>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <iomanip>
#include <sstream>
#include <string_view>

#include "support/checksum.hpp"
#include "support/input_file.hpp"
#include "support/scene_file.hpp"

namespace driver {
namespace {

constexpr std::size_t largest_file = std::size_t{64} << 20; // of a profile (docs/profiles.md)

} // namespace

std::string date_text() {
  std::time_t now = std::time(nullptr);
  if (const char* const given = std::getenv("SOURCE_DATE_EPOCH")) {
    const std::string_view text = given;
    std::from_chars(text.data(), text.data() + text.size(), now);
  }
  std::ostringstream out;
  out << std::put_time(std::gmtime(&now), "%Y-%m-%d %H:%M UTC");
  return out.str();
}

std::string command_text(int argc, char** argv) {
  std::string text = std::filesystem::path(argv[0]).filename().string();
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789"
                                  "-_=./,:+@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) {
      text += ' ' + word;
      continue;
    }
    text += " '";
    for (const char letter : word) {
      text += letter == '\'' ? "'\\''" : std::string(1, letter);
    }
    text += '\'';
  }
  return text;
}

std::string origin_text(const std::string& subject, const std::string& name) {
  if (is_standard(name)) {
    return subject + ": " + name + ", built in";
  }
  return subject + ": " + std::filesystem::path(name).filename().string() + ", SHA-256 " +
         sha256_of(name, read_file("file", name, largest_file));
}

} // namespace driver
