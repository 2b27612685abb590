// wrc_paper: judges the paper's statements by the results of its studies; used by scripts/paper.sh.
#include <iostream>

#include "support/output_file.hpp"
#include "support/program.hpp"
#include "support/scene.hpp"
#include "wrc_paper/claims.hpp"

int main(int argc, char** argv) {
  CLI::App app("Writes a page that says, figure by figure, which statements of the paper the "
               "results confirm.\nscripts/paper.sh computes the results and calls this.",
               "wrc_paper");
  std::string folder;
  app.add_option("DIR", folder, "folder with the results S1002/, LM/, LMA/; report.md goes there")
      ->required();
  return driver::run_program(app, argc, argv, [&] {
    const std::filesystem::path page = std::filesystem::path(folder) / "report.md";
    driver::write_whole(page, [&](std::ostream& out) { driver::write_report(folder, out); });
    std::cout << page.string() << '\n';
    return 0;
  });
}
