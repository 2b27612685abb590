#include "table/table_file.hpp"

#include <cstring>
#include <filesystem>
#include <string>

#include <unistd.h>

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "support/errors.hpp"
#include "table/small_table.hpp"

namespace wrc::test {
namespace {

std::uint64_t checksum_of(const std::string& text) {
  std::uint64_t sum = 0xcbf29ce484222325ULL;
  for (const char byte : text) {
    sum = (sum ^ static_cast<unsigned char>(byte)) * 0x100000001b3ULL;
  }
  return sum;
}

/// A file whose checksum is right, whatever else is wrong.
std::string with_checksum(std::string text) {
  const std::uint64_t sum = checksum_of(text);
  text.append(reinterpret_cast<const char*>(&sum), sizeof sum);
  return text;
}

bool is_refused(const std::string& text) {
  try {
    table_from_text(text);
    return false;
  } catch (const Error& error) {
    return error.code() == ErrorCode::file_malformed;
  }
}

TEST(TableFile, BringsBackTheSameBits) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() /
      ("wrcontact_table_file_test_" + std::to_string(getpid()) + ".bin");
  write_table(small_table(), path);
  const ContactTable read = read_table(path);
  std::filesystem::remove(path);
  EXPECT_EQ(text_of_table(read), text_of_table(small_table()));
  const TableState state = random_state(small_table(), 3, 4);
  EXPECT_EQ(contact_in_table(read, state, true).rates,
            contact_in_table(small_table(), state, true).rates);
}

/// Names reach terminals.
TEST(TableFile, RefusesNamesThatAreNotText) {
  ContactTable table = small_table();
  for (const char* name : {"S1002\x1b[31m", "S1002\nsolve.accuracy = 1", "\x7f"}) {
    table.identity.wheel = name;
    EXPECT_TRUE(is_refused(text_of_table(table))) << name;
  }
  table.identity.wheel = "R\xc3\xa4"
                         "der.prw";
  EXPECT_FALSE(is_refused(text_of_table(table)));
}

TEST(TableFile, SaysThatAFileIsOfAnotherVersion) {
  std::string text = text_of_table(small_table());
  text.resize(text.size() - sizeof(std::uint64_t));
  expect_error(
      ErrorCode::file_malformed, [&] { (void)table_from_text(with_checksum(text + "more")); },
      "its checksum is right, so it may be of another version of the library");
  const std::size_t number = text.find("format 3") + 7;
  text[number] = '9';
  expect_error(
      ErrorCode::file_malformed, [&] { (void)table_from_text(with_checksum(text)); },
      "its format is 9", "this one reads format 3: make the table again");
}

/// Of later versions: it says which variables or outputs they have.
TEST(TableFile, RefusesOtherAxesAndOutputs) {
  std::string text = text_of_table(small_table());
  text.resize(text.size() - sizeof(std::uint64_t));
  for (const char* word : {"yaw^2", "centroid.t_rail"}) {
    std::string changed = text;
    changed[changed.find(word)] = 'x';
    expect_error(
        ErrorCode::file_malformed, [&] { (void)table_from_text(with_checksum(changed)); }, "its ",
        std::string("x") + (word + 1));
  }
}

TEST(TableFile, RefusesWhatWasCutOrChanged) {
  const std::string whole = text_of_table(small_table());
  EXPECT_TRUE(is_refused(""));
  EXPECT_TRUE(is_refused("a table"));
  for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 97) {
    EXPECT_TRUE(is_refused(whole.substr(0, size))) << size;
    std::string changed = whole;
    changed[size] = static_cast<char>(changed[size] ^ 4);
    EXPECT_TRUE(is_refused(changed)) << size;
  }
}

/// Whoever makes a file makes its checksum as well.
TEST(TableFile, RefusesOrReadsEveryFileWithARightChecksum) {
  std::string text = text_of_table(small_table());
  text.resize(text.size() - sizeof(std::uint64_t));
  std::size_t refused = 0;
  std::size_t tried = 0;
  const auto attempt = [&](const std::string& changed) {
    ++tried;
    try {
      const ContactTable table = table_from_text(with_checksum(changed));
      const TableContact found = contact_in_table(table, random_state(small_table(), 1, 1), true);
      EXPECT_TRUE(found.inside || !found.inside); // it ends
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::file_malformed);
      ++refused;
    }
  };
  for (std::size_t at = 0; at < 1200; at += 11) { // names, ranges, axes
    for (const int byte : {0x00, 0x7f, 0xff}) {
      std::string changed = text;
      changed[at] = static_cast<char>(byte);
      attempt(changed);
    }
    std::string huge = text;
    const std::uint64_t count = ~0ULL >> (at % 60);
    std::memcpy(huge.data() + at, &count, sizeof count);
    attempt(huge);
    attempt(text.substr(0, at));
  }
  EXPECT_GT(refused, tried / 4);
}

} // namespace
} // namespace wrc::test
