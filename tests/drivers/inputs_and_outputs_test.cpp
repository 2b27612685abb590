/// What programs read and write: no input is overwritten, rows of two studies are not mixed, and a
/// run that was killed leaves nothing behind.
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <sys/stat.h>
#include <thread>

#include "run_driver.hpp"

namespace inputs_and_outputs_test {
namespace {

class InputsAndOutputs : public Driver {
protected:
  /// A built-in profile as a file.
  void write_profile(const std::string& name, const std::string& file) const {
    ASSERT_EQ(run(WRC_PROFILE_PROGRAM, name + " --convert " + file).exit_code, 0);
  }
  /// A refusal after which a file is as it was.
  void expect_kept(const char* program, const std::string& arguments,
                   const std::string& file) const {
    SCOPED_TRACE(arguments);
    const std::string before = read(file);
    ASSERT_NE(before, "");
    run(program, arguments).expect_refusal({"cannot write", "this run reads it"});
    EXPECT_EQ(read(file), before);
  }
};

TEST_F(InputsAndOutputs, NoInputIsOverwritten) {
  const std::string study = "[pose]\nlateral = [0, 1]\n[load]\nboth = 0\n";
  for (const char* name : {"s.csv", "s.nc", "s.rows"}) {
    write(name, study);
    expect_kept(WRC_SWEEP_PROGRAM, name, name);
  }
  write_profile("54E3", "t.csv");
  write("t.toml", study + "[track]\nrail = \"t.csv\"\n");
  expect_kept(WRC_SWEEP_PROGRAM, "t.toml", "t.csv");
  std::filesystem::create_symlink("t.csv", folder() / "link");
  for (const char* output : {"t.csv", "./t.csv", "link", "../t.csv/../t.csv"}) {
    if (exists(output)) {
      expect_kept(WRC_PROFILE_PROGRAM, std::string("t.csv --convert ") + output, "t.csv");
    }
  }
  expect_kept(WRC_PROFILE_PROGRAM, "60E1 --compare t.csv --convert t.csv", "t.csv");
  write("c.toml", "[track]\nrail = \"t.csv\"\n");
  for (const char* option : {"--field", "--vtk", "--save", "--creep-field"}) {
    for (const char* file : {"c.toml", "t.csv"}) {
      expect_kept(WRC_CASE_PROGRAM, std::string("c.toml ") + option + ' ' + file, file);
    }
  }
  run(WRC_CASE_PROGRAM, "--field a --vtk ./a").expect_refusal({"./a", "twice"});
  // A built-in name is no file.
  EXPECT_EQ(run(WRC_PROFILE_PROGRAM, "60E1 --convert 60E1").exit_code, 0);
}

TEST_F(InputsAndOutputs, LinksAreFollowedAndModesKept) {
  write("deep/real.csv", "old");
  ASSERT_EQ(chmod((folder() / "deep/real.csv").c_str(), 0640), 0);
  std::filesystem::create_symlink("deep/real.csv", folder() / "link.csv");
  std::filesystem::create_symlink("deep/new.toml", folder() / "link.toml");
  ASSERT_EQ(run(WRC_CASE_PROGRAM, "--field link.csv --save link.toml").exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(folder() / "link.csv"));
  EXPECT_TRUE(read("deep/real.csv").starts_with("side,patch,"));
  struct stat status {};
  ASSERT_EQ(stat((folder() / "deep/real.csv").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0640U);
  EXPECT_TRUE(std::filesystem::is_symlink(folder() / "link.toml"));
  EXPECT_NE(read("deep/new.toml").find("lateral"), std::string::npos);
  ASSERT_EQ(chmod((folder() / "deep/new.toml").c_str(), 0600), 0);
  ASSERT_EQ(run(WRC_CASE_PROGRAM, "--save link.toml").exit_code, 0);
  ASSERT_EQ(stat((folder() / "deep/new.toml").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777U, 0600U);
}

TEST_F(InputsAndOutputs, ReplacingTheRailFileMakesAnotherStudy) {
  write_profile("60E1", "rail.dat");
  write("s.toml", "[track]\nrail = \"rail.dat\"\n[pose]\nlateral = [0, 1]\n[load]\nboth = 0\n");
  std::filesystem::create_directories(folder() / "o/s.csv"); // cannot be written
  run(WRC_SWEEP_PROGRAM, "s.toml --out o").expect_refusal({"cannot write o/s.csv"});
  EXPECT_FALSE(exists("o/s.rows")) << "it says so before it solves";
  std::filesystem::remove(folder() / "o/s.csv");
  ASSERT_EQ(run_limited(16, WRC_SWEEP_PROGRAM, "s.toml --out o").exit_code, 1);
  ASSERT_TRUE(exists("o/s.rows")) << "they fit on the disk, the NetCDF file does not";
  const std::string old_rail = read("rail.dat");
  write_profile("54E3", "rail.dat");
  run(WRC_SWEEP_PROGRAM, "s.toml --out o --resume")
      .expect_refusal({"another study", "content of input files"});
  write("rail.dat", old_rail);
  EXPECT_EQ(run(WRC_SWEEP_PROGRAM, "s.toml --out o --resume").exit_code, 0);
  // What the results come from stands with them.
  const std::string results = read("o/s.nc");
  const Outcome sums = run("sha256sum", "s.toml rail.dat");
  ASSERT_EQ(sums.exit_code, 0);
  EXPECT_NE(results.find(sums.out.substr(0, 64)), std::string::npos);
  EXPECT_NE(results.find(sums.out.substr(sums.out.find('\n') + 1, 64)), std::string::npos);
  for (const char* part : {"input_content", "material.poisson", "wheelset.wheel", "S1002",
                           "displacement of the wheelset's centre", "left, rigid contact, y"}) {
    EXPECT_NE(results.find(part), std::string::npos) << part;
  }
}

TEST_F(InputsAndOutputs, KilledWhileNetcdfIsWrittenItResumesAtOnce) {
  // Large fields, so that writing them takes a while.
  write("s.toml", "[pose]\nlateral = [0, 1]\n[solve]\ngrid = [400, 400]\n[study]\nfields = [\"x\", "
                  "\"y\", \"z\", \"pressure\"]\n");
  ASSERT_EQ(run(WRC_SWEEP_PROGRAM, "s.toml --out whole").exit_code, 0);
  const auto others = [this] { // than tables and rows
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder() / "o")) {
      names.push_back(entry.path().filename().string());
      if (names.back() == "s.rows" || names.back() == "s.csv" || names.back() == "s.nc") {
        names.pop_back();
      }
    }
    return names;
  };
  std::vector<pid_t> killed; // and not waited for before the last resume
  for (int i = 0; i < 2; ++i) {
    std::filesystem::create_directories(folder() / "o");
    const pid_t child = fork();
    if (child == 0) {
      const int nowhere = open("/dev/null", O_WRONLY);
      dup2(nowhere, STDOUT_FILENO);
      if (chdir(folder().c_str()) == 0) {
        execl(WRC_SWEEP_PROGRAM, WRC_SWEEP_PROGRAM, "s.toml", "--out", "o", "--resume",
              static_cast<char*>(nullptr));
      }
      _exit(127);
    }
    const std::string part = "o/s.nc.part" + std::to_string(child) + ".nc";
    int status = 0;
    while (!exists(part) && waitpid(child, &status, WNOHANG) == 0) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    kill(child, SIGKILL);
    killed.push_back(child);
    EXPECT_TRUE(exists("o/s.rows"));
  }
  EXPECT_GE(others().size(), 1U) << "nothing was left to be swept";
  const Outcome resumed = run(WRC_SWEEP_PROGRAM, "s.toml --out o --resume");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.error;
  for (const pid_t child : killed) {
    int status = 0;
    EXPECT_TRUE(waitpid(child, &status, 0) == child && WIFSIGNALED(status))
        << "it ended before it was killed";
  }
  EXPECT_EQ(others(), std::vector<std::string>{});
  EXPECT_EQ(read("o/s.nc"), read("whole/s.nc"));
  EXPECT_EQ(read("o/s.csv"), read("whole/s.csv"));
}

TEST_F(InputsAndOutputs, AFailureOfGnuplotIsReportedWithItsCause) {
  NEEDS_GNUPLOT();
  const auto run_with = [this](const std::string& before, const std::string& program,
                               const std::string& arguments) {
    return run("env", before + " '" + program + "' " + arguments);
  };
  run_with("PATH=/nowhere", WRC_PROFILE_PROGRAM, "S1002 --plot a.png")
      .expect_refusal({"a.png", "gnuplot", "not installed"});
  write("bin/gnuplot", "#!/bin/sh\necho 'line 7: no such terminal' >&2\nexit 1\n");
  std::filesystem::permissions(folder() / "bin/gnuplot", std::filesystem::perms::owner_all);
  run_with("PATH=bin:$PATH", WRC_PROFILE_PROGRAM, "S1002 --plot a.png")
      .expect_refusal({"a.png", "line 7: no such terminal"});
  // As many file handles as standard ones and one more.
  const Outcome few =
      run("sh", std::string("-c \"exec 3>&- 4>&- 5>&- 6>&- 7>&- 8>&- 9>&-; ulimit -n 4; exec '") +
                    WRC_PROFILE_PROGRAM + "' S1002 --plot a.png\"");
  few.expect_refusal({"a.png", "Too many open files"});
  EXPECT_FALSE(exists("a.png"));
  // A study says so before its first scene.
  write("s.toml", "[pose]\nlateral = [0, 1]\n[[picture]]\npanels = [{lines = [{result = "
                  "\"left.pmax\"}]}]\n");
  run_with("PATH=/nowhere", WRC_SWEEP_PROGRAM, "s.toml --out o").expect_refusal({"not installed"});
  EXPECT_FALSE(exists("o"));
  EXPECT_EQ(run_with("PATH=/nowhere", WRC_SWEEP_PROGRAM, "s.toml --no-pictures").exit_code, 0);
}

TEST_F(InputsAndOutputs, ANameWithAZeroByteIsRefused) {
  write("c.toml", "[track]\nrail = \"60E1\\u0000x\"\n");
  run(WRC_CASE_PROGRAM, "c.toml").expect_refusal({"track.rail", "zero byte"});
  run(WRC_SWEEP_PROGRAM, "c.toml").expect_refusal({"track.rail", "zero byte"});
}

TEST_F(InputsAndOutputs, AFileWithoutEndIsRefused) {
  const std::string endless = "/proc/kmsg";
  if (access(endless.c_str(), R_OK) != 0) {
    GTEST_SKIP() << "no file whose reading waits";
  }
  const auto limited = [this](const std::string& program, const std::string& arguments) {
    return run("timeout", "5 '" + program + "' " + arguments);
  };
  limited(WRC_PROFILE_PROGRAM, endless + " --kind rail").expect_refusal({endless});
  limited(WRC_CASE_PROGRAM, endless).expect_refusal({endless});
  limited(WRC_CASE_PROGRAM, "--set track.rail=" + endless).expect_refusal({endless});
  for (const Outcome& outcome : {limited(WRC_CASE_PROGRAM, endless)}) {
    EXPECT_LT(outcome.exit_code, 100) << "timeout ended it";
  }
}

} // namespace
} // namespace inputs_and_outputs_test
