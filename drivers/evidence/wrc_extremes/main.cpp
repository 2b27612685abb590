// wrc_extremes: every quantity to its limits, one at a time: what holds where, and what is said
// where it does not.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <set>

#include "support/json.hpp"
#include "support/output_file.hpp"
#include "support/parallel.hpp"
#include "support/program.hpp"
#include "support/scene.hpp"
#include "wrc_extremes/measure.hpp"
#include "wrc_extremes/reports.hpp"

namespace {

using extremes::Point;
using extremes::Row;

/// A seed for each point that does not depend on which others are measured.
std::uint64_t seed_of(const Point& point, std::uint64_t seed) {
  std::uint64_t mixed = 14695981039346656037U ^ seed; // FNV-1a
  for (const char letter : point.quantity + '/' + point.base + '/' + point.setting) {
    mixed = (mixed ^ static_cast<unsigned char>(letter)) * 1099511628211U;
  }
  return mixed;
}

std::vector<Row> measure_all(const std::vector<Point>& points, int threads, std::uint64_t seed) {
  std::vector<Row> rows(points.size());
  driver::ProgressLines progress(points.size());
  driver::for_each_index(points.size(), threads, [&](std::size_t i) {
    const Point& point = points[i];
    Row& row = rows[i];
    row.quantity = point.quantity;
    row.base = point.base;
    row.setting = point.setting;
    row.value = point.value;
    extremes::measure(point.measure, row, seed_of(point, seed));
    progress.one_done([&](std::size_t done, double seconds) {
      std::fprintf(stderr, "wrc_extremes: %zu of %zu points, %.0f s, last %s: %s\n", done,
                   points.size(), seconds, row.quantity.c_str(), row.setting.c_str());
    });
  });
  return rows;
}

std::vector<std::string> quantity_names() {
  std::vector<std::string> names;
  for (const extremes::Quantity& quantity : extremes::quantities()) {
    names.push_back(quantity.name);
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string explanation() {
  std::string text =
      "\nEach point is solved through the public interface. Verdicts:\n"
      "  held        solved; recomputed residuals and errors are as requested\n"
      "  warned      solved; a warning or the status says what is wrong\n"
      "  no contact  no forces; the status or a warning says so\n"
      "  refused     not solved; the error names argument, value and allowed range\n"
      "  faded       solved, but less accurately than requested and without a warning\n"
      "  wrong       residuals beyond all bounds, or an internal fault of the library\n"
      "Exit code: 3 if a point is wrong, otherwise 0.\n\nQuantities:\n";
  for (const extremes::Quantity& quantity : extremes::quantities()) {
    text +=
        "  " + quantity.name + std::string(16 - quantity.name.size(), ' ') + quantity.title + '\n';
  }
  return text +
         "\nExamples:\n"
         "  wrc_extremes --threads 2 --out extremes     # all quantities, takes minutes\n"
         "  wrc_extremes --only load --only tolerance   # two quantities, prints the table only\n";
}

} // namespace

int main(int argc, char** argv) {
  driver::Program app(
      "wrc_extremes",
      "Varies each quantity to its limits and reports, for each point, whether the "
      "solution holds: status, recomputed residuals, digits lost against elimination in "
      "extended precision, and errors beyond the requested accuracy.");
  bool quick = false;
  std::vector<std::string> only;
  std::string folder;
  std::uint64_t seed = 1;
  int threads = 1;
  app.flag("--quick", quick, "a few points of each quantity; takes seconds");
  app.add("--only", only, "measure only this quantity; may be repeated")
      .type("QUANTITY")
      .one_of(quantity_names());
  app.add("--out", folder,
          "write extremes.json and extremes_<quantity>.png into this folder, which is "
          "created if it does not exist")
      .type("FOLDER");
  app.add("--seed", seed, "seed of random noise and of the elements sampled on large grids")
      .show_default();
  app.add("--threads", threads, "number of threads; results do not depend on it")
      .within(1, 1024)
      .show_default();
  app.footer(explanation());
  return app.run(argc, argv, [&] {
    std::vector<Point> points = extremes::all_points();
    const std::set<std::string> chosen(only.begin(), only.end());
    std::erase_if(points, [&](const Point& point) {
      return (quick && !point.quick) || (!chosen.empty() && !chosen.contains(point.quantity));
    });
    if (!folder.empty()) {
      driver::make_folder("--out", folder);
    }
    const std::vector<Row> rows = measure_all(points, threads, seed);
    extremes::print_table(rows, std::cout);
    if (!folder.empty()) {
      const std::filesystem::path out(folder);
      driver::write_whole(out / "extremes.json", [&](std::ostream& s) {
        driver::print_json(extremes::json_of(rows, seed), s, 1);
      });
      extremes::draw_pictures(rows, out);
    }
    const bool any_wrong = std::any_of(rows.begin(), rows.end(), [](const Row& row) {
      return row.verdict == extremes::Verdict::wrong;
    });
    return any_wrong ? 3 : 0;
  });
}
