// wrc_paper: judges the paper's statements by the results of its studies; used by scripts/paper.sh.
#include <iostream>

#include "support/output_file.hpp"
#include "support/program.hpp"
#include "support/scene.hpp"
#include "wrc_paper/claims.hpp"

int main(int argc, char** argv) {
  driver::Program app(
      "wrc_paper",
      "Compares results of studies with the paper's statements, figure by figure, and writes a "
      "page of verdicts.\nscripts/paper.sh computes the results and then runs this program.");
  std::string folder;
  app.add("DIR", folder,
          "folder with the results S1002/, LM/ and LMA/ of scripts/paper.sh; report.md is "
          "written there")
      .required();
  return app.run(argc, argv, [&] {
    const std::filesystem::path page = std::filesystem::path(folder) / "report.md";
    driver::write_whole(page, [&](std::ostream& out) { driver::write_report(folder, out); });
    std::cout << page.string() << '\n';
    return 0;
  });
}
