/// Output through symbolic links: it goes to the file that the link names, and the link stays.
#include <filesystem>
#include <vector>

#include "run_driver.hpp"

namespace output_links_test {
namespace {

namespace fs = std::filesystem;

/// A program and where one of its files goes.
struct Writer {
  const char* program;
  std::string before; ///< arguments in front of the name of the file
  std::string file;
};

const std::string geometry = "[pose]\nlateral = [-1, 0, 1]\n[load]\nboth = 0\n[study]\nresults "
                             "= [\"rolling_radius_difference\", \"left.rigid_contact.angle\", "
                             "\"right.rigid_contact.angle\"]\n[[picture]]\nkind = \"conicity\"\n"
                             "file = \"c.png\"\n[[picture]]\nfile = \"l.svg\"\npanels = [{lines = "
                             "[{result = \"rolling_radius_difference\"}]}]\n";

std::vector<Writer> writers() {
  const std::string scene = "--set solve.accuracy=1e-2 solve.results=stress "
                            "creepage.left=[0.001,0,0] ";
  std::vector<Writer> all{{WRC_CASE_PROGRAM, scene + "--field", "f.csv"},
                          {WRC_CASE_PROGRAM, scene + "--creep-field", "c.csv"},
                          {WRC_CASE_PROGRAM, scene + "--vtk", "p.vtk"},
                          {WRC_CASE_PROGRAM, scene + "--stress", "s.vtk"},
                          {WRC_CASE_PROGRAM, scene + "--save", "s.toml"},
                          {WRC_PROFILE_PROGRAM, "S1002 --convert", "w.prw"},
                          {WRC_SWEEP_PROGRAM, "../study.toml --page", "p.html"},
                          {WRC_SWEEP_PROGRAM, "../study.toml --no-pictures --out .", "study.csv"},
                          {WRC_SWEEP_PROGRAM, "../study.toml --no-pictures --out .", "study.nc"}};
  if (gnuplot_is_there()) {
    all.push_back({WRC_CASE_PROGRAM, scene + "--plot", "p.png"});
    all.push_back({WRC_PROFILE_PROGRAM, "S1002 --plot", "p.svg"});
    for (const char* file : {"c.png", "c_by_amplitude.csv", "l.svg"}) {
      all.push_back({WRC_SWEEP_PROGRAM, "../study.toml --out .", file});
    }
  }
  return all;
}

class OutputLinks : public Driver {
protected:
  void SetUp() override {
    Driver::SetUp();
    write("study.toml", geometry);
  }
  /// In a new folder `at`, with a link to `target` under the name of the file.
  [[nodiscard]] Outcome run_with_link(const Writer& writer, const fs::path& target) const {
    fs::remove_all(folder() / "at");
    fs::create_directories(folder() / "at/deep");
    fs::create_symlink(target, folder() / "at" / writer.file);
    const bool named = !writer.before.ends_with('.'); // on the command line
    return run("env", "-C at '" + std::string(writer.program) + "' " + writer.before +
                          (named ? ' ' + writer.file : ""));
  }
};

TEST_F(OutputLinks, AreFollowedByEveryWriter) {
  for (const Writer& writer : some_of(writers(), 5)) {
    SCOPED_TRACE(writer.before + ' ' + writer.file);
    const std::string target = "deep/real" + fs::path(writer.file).extension().string();
    const Outcome made = run_with_link(writer, target);
    ASSERT_EQ(made.exit_code, 0) << made.error;
    EXPECT_TRUE(fs::is_symlink(folder() / "at" / writer.file));
    const std::string content = read("at/" + target);
    EXPECT_NE(content, "");
    // And replaced.
    write("at/" + target, "old");
    const bool named = !writer.before.ends_with('.');
    const Outcome replaced = run("env", "-C at '" + std::string(writer.program) + "' " +
                                            writer.before + (named ? ' ' + writer.file : ""));
    ASSERT_EQ(replaced.exit_code, 0) << replaced.error;
    EXPECT_TRUE(fs::is_symlink(folder() / "at" / writer.file));
    EXPECT_EQ(read("at/" + target).size(), content.size());
  }
}

TEST_F(OutputLinks, ThatFormACircleAreRefused) {
  for (const Writer& writer : writers()) {
    SCOPED_TRACE(writer.before + ' ' + writer.file);
    const Outcome outcome = run_with_link(writer, writer.file);
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_NE(outcome.error.find(writer.file), std::string::npos) << outcome.error;
    EXPECT_TRUE(fs::is_symlink(folder() / "at" / writer.file)) << "the link was replaced";
  }
}

TEST_F(OutputLinks, RowsOfAStudyAreKeptAtTheTargetOfALink) {
  fs::create_directories(folder() / "o");
  fs::create_directories(folder() / "large");
  fs::create_symlink("../large/rows", folder() / "o/s.rows");
  write("s.toml", "[pose]\nlateral = [0, 1]\n[load]\nboth = 0\n");
  // The NetCDF file is larger than a file may be, so rows are left.
  EXPECT_EQ(run_limited(16, WRC_SWEEP_PROGRAM, "s.toml --out o").exit_code, 1);
  EXPECT_TRUE(read("large/rows").starts_with("wrc_sweep rows"));
  EXPECT_EQ(run(WRC_SWEEP_PROGRAM, "s.toml --out o --resume").exit_code, 0);
  EXPECT_FALSE(exists("large/rows")) << "what is not needed any more is left";
  EXPECT_TRUE(fs::is_symlink(folder() / "o/s.rows"));
}

TEST_F(OutputLinks, OfTemporaryFilesAreNotFollowed) {
  write("victim", "mine");
  // The shell has the process number that the program will have.
  const std::string program = WRC_CASE_PROGRAM;
  const Outcome outcome =
      run("sh", "-c \"ln -s victim f.csv.part\\$\\$.csv; exec '" + program + "' --field f.csv\"");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  EXPECT_EQ(read("victim"), "mine");
  EXPECT_TRUE(read("f.csv").starts_with("side,patch,"));
  EXPECT_FALSE(fs::is_symlink(folder() / "f.csv"));
  fs::create_symlink("victim", folder() / "s.toml.partial");
  EXPECT_EQ(run(WRC_CASE_PROGRAM, "--save s.toml").exit_code, 1);
  EXPECT_EQ(read("victim"), "mine");
}

} // namespace
} // namespace output_links_test
