// What a report says of its origin, of limits and of nominal profiles; tests/drivers/jobs_test.cpp
// has the rest.
#include <gtest/gtest.h>

#include "run_driver.hpp"

namespace wrc_report_test {
namespace {

const std::string wheel = std::string(WRCONTACT_REFERENCE_DIR) + "/profiles/Car7216_0001r.txt";

class WrcReport : public Driver {
protected:
  WrcReport() : Driver(WRC_REPORT_PROGRAM) {}

  void SetUp() override {
    Driver::SetUp();
    std::filesystem::copy_file(wheel, folder() / "worn one.txt");
  }
  /// The page of that wheel on 60E1.
  [[nodiscard]] std::string page_of(const std::string& options) const {
    const Outcome outcome =
        run("'worn one.txt' 60E1 --quiet --set solve.accuracy=0.1 --threads 2 " + options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.error;
    return read("report.html");
  }
  static void expect_part(const std::string& page, const std::string& part) {
    EXPECT_NE(page.find(part), std::string::npos) << part << " is not in the page";
  }
};

TEST_F(WrcReport, SaysWhenHowAndOfWhichFilesItIs) {
  NEEDS_GNUPLOT();
  ASSERT_EQ(setenv("SOURCE_DATE_EPOCH", "1767225600", 1), 0);
  const std::string page = page_of("");
  ASSERT_EQ(unsetenv("SOURCE_DATE_EPOCH"), 0);
  expect_part(page,
              std::string("<p>2026-01-01 00:00 UTC, wrcontact ") + WRCONTACT_EXPECTED_VERSION);
  expect_part(page, "<li>command: wrc_report &#39;worn one.txt&#39; 60E1 --quiet --set "
                    "solve.accuracy=0.1 --threads 2</li>");
  expect_part(page, "<li>rail: 60E1, built in</li>");
  ASSERT_EQ(run("sha256sum", "'worn one.txt'").exit_code, 0);
  expect_part(page, "<li>wheel: worn one.txt, SHA-256 " + read("stdout.captured").substr(0, 64));
}

TEST_F(WrcReport, ChecksTheLimitsOfTheUser) {
  NEEDS_GNUPLOT();
  write("limits.csv",
        "quantity,least,greatest,source\nflange_height,27,36,here\n"
        "qr,20,,\"there, or not\"\nequivalent_conicity,,0.08,x\nhead_width_14,,99,x\n");
  const std::string page = page_of("--limits limits.csv");
  expect_part(page, "flange height: tip above the taping line</td><td>pass</td>"
                    "<td class=\"number\">27.72</td><td class=\"number\">27.00</td>");
  expect_part(page, "<td class=\"fail\">fail</td>");
  expect_part(page, "there, or not");
  expect_part(page, "equivalent conicity at an amplitude of 3 mm</td>"
                    "<td>pass, within its spread of the limit</td>");
  write("limits.csv", "quantity,least,greatest,source\npmx,,36,here\n");
  run("S1002 60E1 --limits limits.csv")
      .expect_refusal({"pmx is no quantity of this report; must be one of conicity, crown_radius"});
  write("limits.csv", "quantity,least,greatest,source\npmax,,much,here\n");
  run("S1002 60E1 --limits limits.csv").expect_refusal({"limits.csv: a limit is much"});
  write("limits.csv", "quantity,most\npmax,3\n");
  run("S1002 60E1 --limits limits.csv").expect_refusal({"limits.csv has no column least"});
  const std::string head = "quantity,least,greatest,source\n";
  for (const auto& [text, trouble] :
       {std::pair(head + "qr,nan,,x\n", "a limit is nan; must be a finite number"),
        {head + "qr,20,5,x\n", "the limits of qr are '20' and '5'"},
        {head + "qr,,,\n", "the limits of qr are '' and ''"},
        {head, "has no limits"},
        {"quantity,least,least,greatest,source\nqr,1,2,3,x\n", "has the column least twice"},
        {"\xEF\xBB\xBFquantity,least,greatest,source\r\nqr,5,1,x\r\n", "the limits of qr"}}) {
    write("limits.csv", text);
    run("S1002 60E1 --limits limits.csv").expect_refusal({"limits.csv", trouble});
  }
  run("S1002 60E1 --limits limits.csv --page limits.csv").expect_refusal({"limits.csv"});
}

TEST_F(WrcReport, SaysThatASpreadIsUnknown) {
  NEEDS_GNUPLOT();
  ASSERT_EQ(run(WRC_PROFILE_PROGRAM, "S1002 --convert sparse.txt --spacing 6").exit_code, 0);
  write("limits.csv", "quantity,least,greatest,source\npmax_centred,,9000,x\n");
  ASSERT_EQ(run("sparse.txt 60E1 --quiet --set solve.accuracy=0.1 --limits limits.csv").exit_code,
            0);
  expect_part(read("report.html"), "<td>pass, spread unknown</td>");
}

TEST_F(WrcReport, HasNominalDimensionsBesideThoseOfAWornWheel) {
  NEEDS_GNUPLOT();
  const auto own = run_json(WRC_PROFILE_PROGRAM, "'worn one.txt'");
  const std::string page = page_of("--nominal-wheel S1002");
  std::string row = "flange height (Sh)</td>";
  const double height = own.at("dimensions").at("flange_height").get<double>();
  for (const double value : {height, 28.0, height - 28.0}) {
    std::array<char, 32> text{};
    (void)std::snprintf(text.data(), text.size(), "%.3f", value);
    row += "<td class=\"number\">" + std::string(text.data()) + "</td>";
  }
  expect_part(page, row);
  expect_part(page, "Nominal: S1002, at most ");
  expect_part(page, "largest pressure over the smoothing wavelength");
  run("S1002 60E1 --set solve.until=geometry").expect_refusal({"the report sets solve.until"});
  run("S1002 60E1 --nominal-rail LM").expect_refusal({"LM"});
}

TEST_F(WrcReport, TheExampleOfLimitsNamesItsSources) {
  NEEDS_GNUPLOT();
  const std::string page = page_of("--limits '" WRC_LIMITS_EXAMPLE "'");
  expect_part(page, "Bane NOR");
  expect_part(page, "an example of wrcontact, of no standard");
}

} // namespace
} // namespace wrc_report_test
