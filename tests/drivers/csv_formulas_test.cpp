/// No cell of a table begins with what a spreadsheet runs as a formula.
#include <filesystem>
#include <sstream>

#include "run_driver.hpp"
#include "support/csv_table.hpp"

namespace csv_formulas_test {
namespace {

TEST(CsvFormulas, TextsAreMarkedAndNumbersAreNot) {
  for (const char* number : {"-1", "-2.5e-3", "0", "-inf", "3", ""}) {
    EXPECT_EQ(driver::csv_entry(number), number);
  }
  EXPECT_EQ(driver::csv_entry("=1+1"), "'=1+1");
  EXPECT_EQ(driver::csv_entry("+1"), "'+1");
  EXPECT_EQ(driver::csv_entry("-"), "'-");
  EXPECT_EQ(driver::csv_entry("-1+cmd"), "'-1+cmd");
  EXPECT_EQ(driver::csv_entry("@sum"), "'@sum");
  EXPECT_EQ(driver::csv_entry("'=1"), "''=1");
  EXPECT_EQ(driver::csv_entry("\t=1"), "\"'\t=1\"");
  EXPECT_EQ(driver::csv_entry("\r=1"), "\"'\r=1\"");
  EXPECT_EQ(driver::csv_entry("=\"a\",b"), "\"'=\"\"a\"\",b\"");
  EXPECT_EQ(driver::csv_entry("a=b"), "a=b");
}

TEST(CsvFormulas, ATableReadsBackUnchanged) {
  const auto path = std::filesystem::path(::testing::TempDir()) /
                    ("wrcontact_csv_formulas_" + std::to_string(getpid()) + ".csv");
  const std::vector<std::string> texts{"=1+1", "+1",  "-1", "-x", "@a", "'", "''=1", "'a",
                                       "a",    "\t1", "\"", ",",  "=,", "",  "'",    "O'Neill"};
  std::ofstream file(path);
  driver::CsvLine(file) << "text"
                        << "number";
  for (const std::string& text : texts) {
    driver::CsvLine(file) << text << -1.5;
  }
  file.close();
  const driver::CsvTable table(path);
  EXPECT_EQ(table.texts("text"), texts);
  EXPECT_EQ(table.numbers("number"), std::vector<double>(texts.size(), -1.5));
  std::filesystem::remove(path);
}

class CsvFormulasOfAStudy : public Driver {
protected:
  CsvFormulasOfAStudy() : Driver(WRC_SWEEP_PROGRAM) {}
};

TEST_F(CsvFormulasOfAStudy, AreAbsentFromItsTableAndTheConicityTable) {
  const std::vector<std::string> names{"=cmd|x!A1.txt", "+1.txt", "-1+1.txt", "@x.txt", "\tx.txt"};
  std::string list;
  for (const std::string& name : names) {
    ASSERT_EQ(run(WRC_PROFILE_PROGRAM, "S1002 --convert '" + name + "'").exit_code, 0);
    list += (list.empty() ? "" : ", ") + ('"' + name + '"');
  }
  list.replace(list.find('\t'), 1, "\\t");
  write("s.toml", "[wheelset]\nwheel = {origin = \"tape\", file = [" + list +
                      ", \"=missing\"]}\n[pose]\nlateral = [-1, 0, 1]\n[load]\nboth = 0\n"
                      "[study]\nresults = [\"rolling_radius_difference\", "
                      "\"left.rigid_contact.angle\", \"right.rigid_contact.angle\"]\n" +
                      (gnuplot_is_there() ? "[[picture]]\nkind = \"conicity\"\nfile = \"c.svg\"\n"
                                            "series = \"wheelset.wheel\"\nseries_label = \"=\"\n"
                                          : ""));
  // Its rows are kept once, and taken up again.
  std::filesystem::create_directories(folder() / "o/s.csv");
  ASSERT_EQ(run("s.toml --out o").exit_code, 1);
  std::filesystem::remove(folder() / "o/s.csv");
  const Outcome outcome = run("s.toml --out o --resume");
  ASSERT_EQ(outcome.exit_code, 0) << outcome.error;
  for (const char* file : {"o/s.csv", "o/c_by_amplitude.csv"}) {
    std::istringstream lines(read(file));
    for (std::string line; std::getline(lines, line);) {
      std::istringstream cells(line);
      for (std::string cell; std::getline(cells, cell, ',');) {
        const std::string text = cell.starts_with('"') ? cell.substr(1) : cell;
        std::istringstream in(text);
        double number = 0.0;
        const bool is_number = in >> number && in.peek() == std::istringstream::traits_type::eof();
        EXPECT_TRUE(text.empty() || is_number ||
                    std::string("=+-@\t").find(text[0]) == std::string::npos)
            << file << ": " << line;
      }
    }
  }
  const driver::CsvTable table(folder() / "o/s.csv");
  ASSERT_EQ(table.row_count(), 18U);
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto found = table.where("wheelset.wheel", names[i]);
    ASSERT_EQ(found.row_count(), 3U) << names[i];
    EXPECT_EQ(found.texts("status"), std::vector<std::string>(3, "ok"));
    EXPECT_EQ(found.numbers("pose.lateral"), (std::vector<double>{-1.0, 0.0, 1.0}));
  }
}

} // namespace
} // namespace csv_formulas_test
