/// Disks that are full: no program leaves half of a file, spoils an old one or says nothing. Files
/// are limited to a size (ulimit -f), beyond which writing fails as it does on a full disk.
#include <array>

#include "run_driver.hpp"

namespace full_disk_test {
namespace {

/// A program, what it is told to do, and the file that it cannot write.
struct Writer {
  const char* program;
  const char* arguments;
  const char* file;
};

class FullDisk : public Driver {};

TEST_F(FullDisk, NoDriverLeavesAPartialFileOrDamagesAnOldOne) {
  const std::array writers{Writer{WRC_CASE_PROGRAM, "--vtk a.vtk", "a.vtk"},
                           Writer{WRC_CASE_PROGRAM, "--field a.csv", "a.csv"},
                           Writer{WRC_CASE_PROGRAM, "--save a.toml", "a.toml"},
                           Writer{WRC_CASE_PROGRAM, "--plot a.png", "a.png"},
                           Writer{WRC_CASE_PROGRAM, "--plot a.svg", "a.svg"},
                           Writer{WRC_PROFILE_PROGRAM, "S1002 --convert a.txt", "a.txt"},
                           Writer{WRC_PROFILE_PROGRAM, "S1002 --convert a.prw", "a.prw"},
                           Writer{WRC_PROFILE_PROGRAM, "S1002 --plot b.png", "b.png"}};
  bool is_there = false; // an old file: in turn
  for (const Writer& writer : writers) {
    SCOPED_TRACE(writer.arguments);
    const std::string file = writer.file;
    if ((file.ends_with(".png") || file.ends_with(".svg")) && !gnuplot_is_there()) {
      continue;
    }
    is_there = !is_there;
    if (is_there) {
      write(file, "old");
    }
    const Outcome outcome = run_limited(1, writer.program, writer.arguments);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.error.find(file), std::string::npos) << outcome.error;
    EXPECT_EQ(file_count(), is_there ? 1 : 0);
    EXPECT_EQ(read(file), is_there ? "old" : "");
    std::filesystem::remove(folder() / file);
  }
}

TEST_F(FullDisk, FailingToPrintResultsIsAnError) {
  for (const auto& [program, arguments] : {std::pair{WRC_CASE_PROGRAM, ""},
                                           {WRC_CASE_PROGRAM, "--json"},
                                           {WRC_CASE_PROGRAM, "--help"},
                                           {WRC_PROFILE_PROGRAM, "--list"},
                                           {WRC_SWEEP_PROGRAM, "--list-results"}}) {
    run_limited(9, program, arguments, "/dev/full")
        .expect_refusal({"cannot write to the standard output"});
  }
}

TEST_F(FullDisk, ASweepKeepsFinishedRowsAndResumes) {
  write("s.toml", "[pose]\nlateral = {from = -3, to = 3, count = 31}\n[solve]\ngrid = [12, 10]\n");
  ASSERT_EQ(run(WRC_SWEEP_PROGRAM, "s.toml --digits 17 --out whole").exit_code, 0);
  const auto size = [this](const std::string& file) {
    return static_cast<int>(std::filesystem::file_size(folder() / file) / 512);
  };
  const auto entries = [this] {
    return std::distance(std::filesystem::directory_iterator(folder() / "o"), {});
  };
  // With all digits a table is longer than the rows. First the rows do not fit, then one table,
  // then both; each time the rows are kept.
  for (const auto& [blocks, file] : {std::pair{8, "s.rows"},
                                     {size("whole/s.csv") - 1, "s.csv"},
                                     {size("whole/s.nc") - 1, "s.nc"},
                                     {size("whole/s.nc") - 10, "s.nc"}}) {
    SCOPED_TRACE(blocks);
    const Outcome outcome =
        run_limited(blocks, WRC_SWEEP_PROGRAM, "s.toml --digits 17 --out o --resume");
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.error.find(std::string("cannot write o/") + file), std::string::npos)
        << outcome.error;
    EXPECT_TRUE(exists("o/s.rows"));
    EXPECT_FALSE(exists("o/s.nc"));
    EXPECT_EQ(entries(), exists("o/s.csv") ? 2 : 1);
  }
  EXPECT_EQ(run(WRC_SWEEP_PROGRAM, "s.toml --digits 17 --out o --resume").exit_code, 0);
  EXPECT_EQ(read("o/s.csv"), read("whole/s.csv"));
  EXPECT_EQ(read("o/s.nc"), read("whole/s.nc"));
  EXPECT_FALSE(exists("o/s.rows"));
}

/// As NFS and Lustre may be.
TEST_F(FullDisk, OrOneWithoutLocksIsEnoughForAStudy) {
  write("s.toml", "[pose]\nlateral = [-1.0, 2.0]\n[solve]\nuntil = \"geometry\"\n");
  const Outcome outcome =
      run("env", std::string("LD_PRELOAD='" WRC_NO_LOCKS "' '") + WRC_SWEEP_PROGRAM + "' s.toml");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_TRUE(std::filesystem::exists(folder() / "s.nc"));
}

} // namespace
} // namespace full_disk_test
