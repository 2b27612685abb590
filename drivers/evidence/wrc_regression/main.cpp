// wrc_regression: stored cases against what they should be.
#include <algorithm>
#include <iostream>

#include "support/program.hpp"
#include "support/scene.hpp"
#include "wrc_regression/checks.hpp"

int main(int argc, char** argv) {
  driver::Program app(
      "wrc_regression",
      "Solves stored cases and compares the results with the paper's Table 2, with the "
      "program CONTACT and with stored results of this library.\nExit code: 0 if all are "
      "within their tolerances, 4 if not.");
  std::string folder = WRC_REGRESSION_FOLDER;
  std::string contact;
  bool update = false;
  app.add("--cases", folder,
          "folder with cases.toml and baselines.toml; default: "
          "drivers/evidence/wrc_regression in the source tree of this build")
      .type("DIR");
  app.add("--contact", contact,
          "JSON file with results of CONTACT, such as tests/reference/contact_cases.json; without "
          "it they are not compared")
      .type("FILE");
  app.flag("--update", update,
           "replace the stored results by those of this build and list what has changed");
  return app.run(argc, argv, [&] {
    const std::filesystem::path cases = folder;
    const std::filesystem::path baselines = cases / "baselines.toml";
    std::vector<driver::Check> checks = driver::run_stored_cases(cases / "cases.toml", baselines);
    if (update) {
      const auto changes = driver::update_baselines(checks, baselines);
      for (const std::string& line : changes) {
        std::cout << line << '\n';
      }
      std::cout << changes.size() << " values of " << baselines.string() << " have changed\n";
      return 0;
    }
    if (contact.empty()) {
      std::cerr << "wrc_regression: not compared with CONTACT (give --contact FILE)\n";
    } else {
      for (driver::Check& check : driver::run_contact_cases(contact)) {
        checks.push_back(std::move(check));
      }
    }
    driver::print_checks(checks, std::cout);
    const bool passed = std::all_of(checks.begin(), checks.end(),
                                    [](const driver::Check& check) { return check.passed(); });
    constexpr int deviates = 4;
    return passed ? 0 : deviates;
  });
}
