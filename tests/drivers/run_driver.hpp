/// Runs a command-line program as its users do, in a folder of the test's own.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <sys/wait.h>
#include <unistd.h>
#include <utility>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "extent.hpp"

using wrc::test::by_extent;
using wrc::test::some_of;

struct Outcome {
  int exit_code = -1;
  std::string out;
  std::string error;

  /// A failure as promised: non-zero, nothing on stdout, one line on stderr with these parts.
  void expect_refusal(std::initializer_list<std::string> parts) const {
    EXPECT_GT(exit_code, 0);
    EXPECT_EQ(out, "");
    EXPECT_EQ(std::count(error.begin(), error.end(), '\n'), 1) << error;
    for (const std::string& part : parts) {
      EXPECT_NE(error.find(part), std::string::npos) << '"' << part << "\" is not in: " << error;
    }
  }
};

class Driver : public ::testing::Test {
protected:
  explicit Driver(std::string program = "") : program_(std::move(program)) {}
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::path(::testing::TempDir()) /
              (std::string("wrcontact_") + test->test_suite_name() + '_' + test->name() + '_' +
               std::to_string(getpid())); // two runs of the tests may go on at once
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  /// Runs a shell command line in the test's folder: of this fixture's program, or of another.
  [[nodiscard]] Outcome run(const std::string& arguments) const { return run(program_, arguments); }
  [[nodiscard]] nlohmann::json run_json(const std::string& arguments) const {
    return run_json(program_, arguments);
  }
  [[nodiscard]] Outcome run(const std::string& program, const std::string& arguments) const {
    const std::string command = "cd '" + folder_.string() + "' && '" + program + "' " + arguments +
                                " >stdout.captured 2>stderr.captured";
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.out = read("stdout.captured");
    outcome.error = read("stderr.captured");
    return outcome;
  }
  [[nodiscard]] nlohmann::json run_json(const std::string& program,
                                        const std::string& arguments) const {
    const Outcome outcome = run(program, arguments + " --json");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return nlohmann::json::parse(outcome.out);
  }

  /// Runs a program that may write files of so many blocks of 512 bytes, and prints into a file.
  [[nodiscard]] Outcome run_limited(int blocks, const std::string& program,
                                    const std::string& arguments,
                                    const std::string& printed = "/dev/null") const {
    const std::string command = "cd '" + folder().string() + "' && (ulimit -f " +
                                std::to_string(blocks) + "; exec '" + program + "' " + arguments +
                                ") >" + printed + " 2>stderr.captured";
    const int status = std::system(command.c_str());
    Outcome outcome;
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    outcome.error = read("stderr.captured");
    std::filesystem::remove(folder() / "stderr.captured");
    return outcome;
  }

  void write(const std::string& name, const std::string& content) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << content;
  }
  [[nodiscard]] std::string read(const std::string& name) const {
    std::ifstream stream(folder_ / name, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  [[nodiscard]] bool exists(const std::string& name) const {
    return std::filesystem::exists(folder_ / name);
  }
  /// Number of entries besides what run() leaves.
  [[nodiscard]] std::ptrdiff_t file_count() const {
    return std::distance(std::filesystem::directory_iterator(folder_), {}) -
           (exists("stdout.captured") ? 2 : 0);
  }
  /// What a picture file starts with.
  [[nodiscard]] bool is_png(const std::string& name) const {
    return read(name).starts_with("\x89PNG\r\n");
  }
  [[nodiscard]] bool is_svg(const std::string& name) const {
    return read(name).find("<svg") != std::string::npos;
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

private:
  std::string program_;
  std::filesystem::path folder_;
};

inline void expect_parts(const std::string& text, std::initializer_list<const char*> parts) {
  for (const char* part : parts) {
    EXPECT_NE(text.find(part), std::string::npos) << '"' << part << "\" is not in: " << text;
  }
}

inline std::ptrdiff_t line_count(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

/// Skips a test that draws.
#define NEEDS_GNUPLOT()                                                                            \
  if (!gnuplot_is_there()) {                                                                       \
    GTEST_SKIP() << "gnuplot is not installed";                                                    \
  }

inline bool gnuplot_is_there() {
  return std::system("gnuplot --version >/dev/null 2>&1") == 0;
}
