#include "wrc_paper/timing.hpp"

#include <fstream>
#include <vector>

#include <nlohmann/json.hpp>

#include "support/gnuplot.hpp"
#include "support/scene.hpp"
#include "wrc_paper/numbers.hpp"

namespace driver {
namespace {

using nlohmann::json;

constexpr double milliseconds = 1e3; // in a second

std::string label_of(const json& row) {
  return (row.at("method") == "paper" ? "paper's method" : "default") + std::string(", ") +
         row.at("state").get<std::string>();
}

/// Logarithmic bars: the times lie three orders of magnitude apart.
void draw(const std::filesystem::path& path, const std::vector<json>& rows, double paper) {
  Gnuplot gnuplot;
  std::ostream& out = gnuplot.script();
  out << "$bars << EOD\n0 " << paper << " \"the paper's program and machine\"\n";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    out << i + 1 << ' ' << rows[i].at("total_ms") << " \"" << label_of(rows[i]) << "\"\n";
  }
  out << "EOD\nset title 'Table 1 scene, 256 x 128 elements, one wheel, one thread: whole time' "
         "font ',12'\nset logscale x\nset xrange [1:50000]\nset yrange ["
      << static_cast<double>(rows.size()) + 0.6
      << ":-0.6]\nset xlabel 'ms (logarithmic)'\nset grid x lt 1 lw 1 lc rgb '#d8d8d8'\n"
      << "set tics out nomirror\nset style fill solid 0.7\nunset key\n"
      << "plot $bars using 2:1:(1):2:($1-0.35):($1+0.35):ytic(3) with boxxyerror lc rgb '#0060ad', "
         "$bars using ($2*1.15):1:(sprintf('%.4g ms', $2)) with labels left\n";
  gnuplot.draw(path, 860, 60 * static_cast<int>(rows.size() + 1) + 110);
}

} // namespace

void write_timing(const std::filesystem::path& folder, std::ostream& out) {
  const std::filesystem::path path = folder / "timing.json";
  std::ifstream file(path);
  try {
    const json all = json::parse(file);
    const double paper = all.at("paper_total_ms");
    std::vector<json> rows;
    for (const json& row : all.at("rows")) {
      if (row.at("wheels") == 1) {
        rows.push_back(row);
      }
    }
    draw(folder / "timing.png", rows, paper);
    const json& machine = all.at("machine");
    out << "## Time: " << fixed(paper / milliseconds, 2)
        << " s in the paper for 256 x 128 elements\n\n![times](timing.png)\n\nThis machine: "
        << machine.at("cpu").get<std::string>() << ", " << machine.at("compiler").get<std::string>()
        << ", one thread; the paper's: Intel Core i5-3230 at 2.60 GHz. Medians in ms; `paper` is "
           "the "
           "paper's method (Polonsky & Keer with DC-FFT, double precision) in this library, so "
           "that "
           "its ratio to `default` is of methods, not of machines. docs/performance.md explains "
           "the "
           "columns.\n\n| method | state | set-up | geometry | remesh | mechanics | total | "
           "iterations | error of p | error of pmax | of 8.25 s |\n"
           "|---|---|---|---|---|---|---|---|---|---|---|\n";
    for (const json& row : rows) {
      out << "| " << row.at("method").get<std::string>() << " | "
          << row.at("state").get<std::string>();
      for (const char* stage :
           {"setup_ms", "geometry_ms", "remesh_ms", "mechanics_ms", "total_ms"}) {
        out << " | " << fixed(row.at(stage), 2);
      }
      out << " | " << fixed(row.at("iterations"), 0) << " | " << small(row.at("error_p")) << " | "
          << small(row.at("error_pmax")) << " | 1/"
          << fixed(paper / row.at("total_ms").get<double>(), 0) << " |\n";
    }
    out << '\n';
  } catch (const json::exception& error) {
    throw Failure(path.string() + ": " + error.what() + "; run scripts/paper.sh");
  }
}

} // namespace driver
