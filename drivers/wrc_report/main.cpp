// wrc_report: one page about a wheel on a rail: dimensions, conicity, contact band, pressures,
// warnings.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>

#include "reports/profile_picture.hpp"
#include "reports/scene_picture.hpp"
#include "reports/smoothing.hpp"
#include "reports/warning_summary.hpp"
#include "support/gnuplot.hpp"
#include "support/html.hpp"
#include "support/numbers.hpp"
#include "support/output_file.hpp"
#include "support/program.hpp"
#include "support/scene_file.hpp"
#include "wrc_report/limits.hpp"
#include "wrc_report/origin.hpp"
#include "wrc_report/pair.hpp"

namespace driver {
namespace {

struct Options {
  std::string wheel;
  std::string rail;
  std::string nominal_wheel;
  std::string nominal_rail;
  std::string limits;
  std::string page = "report.html";
  std::string command;
  std::vector<std::string> assignments;
  int threads = 1;
  bool quiet = false;

  [[nodiscard]] std::string wheel_name() const { return profile_name("wheelset.wheel", wheel); }
  [[nodiscard]] std::string rail_name() const { return profile_name("track.rail", rail); }
};

/// A folder for pictures on their way into the page.
class PictureFolder {
public:
  PictureFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "wrc_report.XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
      throw Failure("cannot make a folder " + name);
    }
    path_ = name;
  }
  PictureFolder(const PictureFolder&) = delete;
  PictureFolder& operator=(const PictureFolder&) = delete;
  ~PictureFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  [[nodiscard]] std::filesystem::path operator/(const char* name) const { return path_ / name; }

private:
  std::filesystem::path path_;
};

std::string file_name(const std::string& profile) {
  return is_standard(profile) ? profile : std::filesystem::path(profile).filename().string();
}

/// Texts that quote the profiles' files, without their folders.
class Shortener {
public:
  explicit Shortener(const Options& options)
      : names_{options.wheel_name(), options.rail_name(), options.nominal_wheel,
               options.nominal_rail, options.limits,      options.page} {}

  [[nodiscard]] std::string operator()(std::string text) const {
    for (const std::string& name : names_) {
      const std::string shown = file_name(name);
      for (std::size_t at = 0; shown != name && (at = text.find(name, at)) != std::string::npos;
           at += shown.size()) {
        text.replace(at, name.size(), shown);
      }
    }
    return text;
  }
  [[nodiscard]] std::vector<std::string> operator()(std::vector<std::string> texts) const {
    std::transform(texts.begin(), texts.end(), texts.begin(), *this);
    return texts;
  }

private:
  std::array<std::string, 6> names_;
};

std::string shown(const Value& value) {
  const double* const number = std::get_if<double>(&value);
  return number == nullptr ? text_of(value) : general(*number);
}

std::string number(double value, int decimals) {
  return std::isnan(value) ? "-" : fixed(value, decimals);
}

/// "-12.3 to 4.5 mm", of the bands of all positions.
std::string extent_text(const std::vector<Position>& positions, double PressedBand::*from,
                        double PressedBand::*to) {
  Range range;
  for (const Position& position : positions) {
    for (const PressedBand& band : position.bands) {
      range.include(band.*from);
      range.include(band.*to);
    }
  }
  return range.empty() ? "nowhere"
                       : fixed(range.least, 1) + " to " + fixed(range.greatest, 1) + " mm";
}

/// The findings, each in a sentence.
std::vector<std::string> in_brief(const Scene& centre, const std::vector<Position>& positions,
                                  const ConicityCurve& conicity) {
  std::vector<std::string> brief{conicity.in_words("Without roll, after EN 15302") + '.'};
  const double spread = centre.number_or("left.spread.pmax", 0.0);
  std::string pressure =
      "Largest pressure centred: " + number(centre.number_or("left.pmax", std::nan("")), 0);
  pressure += spread > 0.0
                  ? " ± " + fixed(spread, 0) +
                        " MPa, in 95 of 100 cases because of noise and short waves of the profiles"
                  : " MPa";
  brief.push_back(pressure + '.');
  const auto less = [](const Position& one, const Position& other) {
    return std::isnan(one.pmax) || one.pmax < other.pmax;
  };
  const auto most = std::max_element(positions.begin(), positions.end(), less);
  if (!std::isnan(most->pmax)) {
    brief.push_back("Largest pressure between y = " + general(positions.front().lateral) + " and " +
                    general(positions.back().lateral) + " mm: " + fixed(most->pmax, 0) +
                    " MPa, at y = " + general(most->lateral) + " mm.");
  }
  const auto unbounded = std::ranges::count_if(
      positions, [](const Position& one) { return std::isnan(one.pmax) && !one.bands.empty(); });
  if (unbounded > 0) {
    brief.push_back("Positions where pressures have no bound, or none that the elements show: " +
                    std::to_string(unbounded) + '.');
  }
  brief.push_back("Contact band on the wheel: s = " +
                  extent_text(positions, &PressedBand::s_from, &PressedBand::s_to) +
                  " from the taping line, positive to the field side.");
  brief.push_back("Contact band on the rail: t = " +
                  extent_text(positions, &PressedBand::t_from, &PressedBand::t_to) +
                  " from the axis, positive to the field side.");
  const auto failed = std::count_if(positions.begin(), positions.end(),
                                    [](const Position& one) { return !one.trouble.empty(); });
  if (failed > 0) {
    brief.push_back(std::to_string(failed) + " of " + std::to_string(positions.size()) +
                    " positions have no result, or one that is not converged.");
  }
  return brief;
}

void add_warnings(HtmlPage& page, const std::vector<Position>& positions,
                  const Shortener& shorten) {
  WarningSummary summary;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    summary.add(static_cast<std::int64_t>(i), positions[i].warnings);
    if (!positions[i].trouble.empty()) {
      lines.push_back("y = " + general(positions[i].lateral) + " mm: " + positions[i].trouble);
    }
  }
  for (std::size_t grade = grade_names.size(); grade-- > 0;) {
    for (const std::string& line : summary.lines(static_cast<std::int32_t>(grade))) {
      lines.push_back(grade == WRC_FINE ? line : grade_names[grade] + (": " + line));
      if (grade == WRC_SLIGHTLY_OVER) {
        break; // one line says it
      }
    }
  }
  page.heading("Warnings");
  if (lines.empty()) {
    page.paragraph("None.");
  } else {
    page.list(shorten(lines));
  }
}

/// `nominal` may be null.
void add_profile(HtmlPage& page, const PictureFolder& folder, const Profile& profile,
                 const Profile* nominal, const std::string& shown, double flange_back,
                 const Shortener& shorten) {
  const Measures measures = measure(profile, flange_back);
  page.heading((is_wheel(profile) ? "Wheel " : "Rail ") + shown);
  page.paragraph(shorten(profile.text("title") + ". Source: " + profile.text("source") + '.'));
  std::vector<std::vector<std::string>> rows{{"dimension", "value", "unit", "definition"}};
  std::vector<Dimension> less;
  if (nominal != nullptr) {
    less = differences(measures, measure(*nominal, flange_back));
    rows.front().insert(rows.front().begin() + 2, {"nominal", "difference"});
  }
  const auto three = [](const std::optional<double>& value) {
    return value ? fixed(*value, 3) : "-";
  };
  for (std::size_t i = 0; i < measures.dimensions.size(); ++i) {
    const Dimension& dimension = measures.dimensions[i];
    const std::string symbol = dimension.key == "flange_height"      ? " (Sh)"
                               : dimension.key == "flange_thickness" ? " (Sd)"
                                                                     : "";
    rows.push_back(
        {dimension.label + symbol, three(dimension.value), dimension.unit, dimension.definition});
    if (nominal != nullptr) {
      const std::optional<double> difference = less[i].value;
      rows.back().insert(
          rows.back().begin() + 2,
          {three(difference ? std::optional(*dimension.value - *difference) : std::nullopt),
           three(difference)});
    }
  }
  page.table(rows);
  if (nominal != nullptr) {
    const Comparison found = compare(profile, *nominal);
    page.paragraph(shorten("Nominal: " + nominal->text("name") + ", at most " +
                           fixed(found.largest, 3) + " mm away, at lateral " +
                           fixed(found.largest_at.lateral, 1) + " mm; " +
                           fixed(found.missing_area, 1) + " mm² are missing, " +
                           fixed(found.added_area, 1) + " mm² are added."));
  }
  if (const auto corrections = profile.corrections(); !corrections.empty()) {
    page.paragraph("Corrected on reading:");
    page.list(shorten(corrections));
  }
  const auto picture = folder / (is_wheel(profile) ? "wheel.png" : "rail.png");
  draw_profile(profile, measures, nominal, picture);
  page.picture(picture, nominal == nullptr ? "shape and curvature of " + shown
                                           : "shape of " + shown + " and distance to the nominal");
}

/// What limits can be set to.
Quantities quantities_of(const Pair& pair, const Scene& centre,
                         const std::vector<Position>& positions, const ConicityCurve& conicity,
                         double flange_back) {
  Quantities all;
  for (const Profile* profile : {&pair.wheel, &pair.rail}) {
    for (const Dimension& one : measure(*profile, flange_back).dimensions) {
      all[one.key] = {one.value.value_or(std::nan("")), 0.0, one.unit,
                      one.label + ": " + one.definition};
    }
  }
  all["equivalent_conicity"] = {conicity.standard(), conicity.standard_spread(), "",
                                "equivalent conicity at an amplitude of " +
                                    general(standard_amplitude) + " mm"};
  all["pmax_centred"] = {centre.number_or("left.pmax", std::nan("")),
                         centre.number_or("left.spread.pmax", 0.0), "MPa",
                         "largest pressure, centred"};
  Quantity& pmax = all["pmax"] = {std::nan(""), 0.0, "MPa", "largest pressure at any position"};
  for (const Position& one : positions) {
    pmax.value = std::fmax(pmax.value, one.pmax);
  }
  return all;
}

/// Script lines of a panel over the lateral position.
void label_panel(Gnuplot& gnuplot, const std::string& label, const Range& range) {
  const double side = position_reach + position_step;
  gnuplot.script() << "set xlabel 'lateral displacement, mm (to the left)'\nset xrange [" << -side
                   << ':' << side << "]\nset ylabel " << gnuplot_text(label, Markup::subscripts)
                   << '\n'
                   << range.command("y");
}

std::string line_over(Gnuplot& gnuplot, const std::vector<Position>& positions,
                      double Position::*value, Range& range) {
  std::vector<double> x;
  std::vector<double> y;
  for (const Position& position : positions) {
    if (!std::isnan(position.*value)) {
      x.push_back(position.lateral);
      y.push_back(position.*value);
      range.include(y.back());
    }
  }
  return x.empty() ? "" : gnuplot.block(x, y);
}

/// Where patches press, a stroke each, and where the profiles touch first.
void plot_bands(Gnuplot& gnuplot, const std::vector<Position>& positions, double PressedBand::*from,
                double PressedBand::*to, double Position::*touch, const std::string& label) {
  Range range;
  std::ostringstream strokes;
  for (const Position& position : positions) {
    for (const PressedBand& band : position.bands) {
      strokes << position.lateral << ' ' << band.*from << " 0 " << band.*to - band.*from << '\n';
      range.include(band.*from);
      range.include(band.*to);
    }
  }
  std::vector<std::string> items;
  if (!strokes.str().empty()) {
    items.push_back(gnuplot.block(strokes.str()) + " with vectors nohead lw 7 lc rgb '" +
                    colour::band + "' title 'pressed'");
  }
  if (const std::string block = line_over(gnuplot, positions, touch, range); !block.empty()) {
    items.push_back(block + " with points pt 7 ps 0.6 lc rgb '" + colour::marked +
                    "' title 'first touch'");
  }
  label_panel(gnuplot, label, range);
  gnuplot.plot(items);
}

void draw_positions(const std::vector<Position>& positions, const std::filesystem::path& path) {
  Gnuplot gnuplot;
  gnuplot.begin_multiplot(4, 1);
  gnuplot.script() << line_style(2);
  const auto plot_line = [&](double Position::*value, const std::string& label,
                             std::size_t colour) {
    Range range;
    std::vector<std::string> items;
    if (const std::string block = line_over(gnuplot, positions, value, range); !block.empty()) {
      items.push_back(block + " with linespoints lw 2 pt 5 ps 0.7 lc rgb '" + line_colour(colour) +
                      "' notitle");
    }
    label_panel(gnuplot, label, range);
    gnuplot.plot(items);
  };
  plot_line(&Position::pmax, "p_{max}, MPa", 0);
  plot_line(&Position::area, "contact area, mm^2", 1);
  plot_bands(gnuplot, positions, &PressedBand::s_from, &PressedBand::s_to, &Position::s_wheel,
             "wheel: s, mm (to the field side)");
  plot_bands(gnuplot, positions, &PressedBand::t_from, &PressedBand::t_to, &Position::t_rail,
             "rail: t, mm (to the field side)");
  gnuplot.draw(path, 860, 1300);
}

void add_conicity(HtmlPage& page, const PictureFolder& folder, ConicityCurve conicity) {
  page.heading("Equivalent conicity");
  std::vector<std::vector<std::string>> rows{{"amplitude, mm", "equivalent conicity", "±", ""}};
  for (std::size_t i = 0; i < conicity.amplitude.size(); ++i) {
    if (conicity.amplitude[i] == std::floor(conicity.amplitude[i]) &&
        (!std::isnan(conicity.conicity[i]) || conicity.amplitude[i] == standard_amplitude)) {
      rows.push_back({fixed(conicity.amplitude[i], 0), number(conicity.conicity[i], 4),
                      number(conicity.spread[i], 4), conicity.no_conicity[i]});
    }
  }
  page.table(rows);
  draw_conicity_curves({std::move(conicity)}, "", folder / "conicity.svg");
  page.picture(folder / "conicity.svg",
               "rolling radius difference, contact angle difference, equivalent conicity");
}

void add_positions(HtmlPage& page, const PictureFolder& folder,
                   const std::vector<Position>& positions) {
  page.heading("Pressures and contact band of the left wheel");
  draw_positions(positions, folder / "positions.svg");
  page.picture(folder / "positions.svg", "largest pressure, area and contact band over y");
  std::vector<std::vector<std::string>> rows{{"y, mm", "pmax, MPa", "area, mm²",
                                              "contact angle, rad", "rolling radius, mm",
                                              "s on the wheel, mm", "t on the rail, mm"}};
  for (const Position& one : positions) {
    const std::string elastic =
        one.elastic > one.pmax ? " (elastic " + number(one.elastic, 0) + ')' : std::string();
    rows.push_back({general(one.lateral), number(one.pmax, 0) + elastic, number(one.area, 1),
                    number(one.angle, 4), number(one.radius, 3), number(one.s_wheel, 2),
                    number(one.t_rail, 2)});
  }
  page.table(rows);
}

std::string report(const Options& options) {
  for (const std::string& text : options.assignments) {
    if (const std::string key = split_assignment(text).key;
        key.ends_with(".wheel") || key.ends_with(".rail")) {
      throw Failure("--set " + text + ": must be a key other than " + key +
                    "; the arguments WHEEL and RAIL name the profiles");
    }
  }
  const Pair pair(options.wheel, options.rail, options.assignments);
  refuse_varying(pair.scene(), "in a report");
  std::vector<Limit> limits;
  if (!options.limits.empty()) {
    limits = read_limits(options.limits);
  }
  const auto nominal = [&pair](std::int32_t kind, const std::string& name) {
    return name.empty() ? std::nullopt : std::optional(load_profile(pair.scene(), kind, name));
  };
  const std::optional<Profile> new_wheel = nominal(WRC_WHEEL, options.nominal_wheel);
  const std::optional<Profile> new_rail = nominal(WRC_RAIL, options.nominal_rail);
  const std::vector<Position> positions = positions_of(pair, options.threads);
  const ConicityCurve conicity = conicity_of(pair);
  Scene centre = pair.scene();
  const Scene plain = pair.scene();
  std::string trouble;
  try {
    centre.solve();
  } catch (const std::exception& error) {
    trouble = error.what();
  }

  const Shortener shorten(options);
  HtmlPage page(file_name(options.wheel_name()) + " on " + file_name(options.rail_name()));
  std::string conditions;
  const auto values = values_in_force(plain);
  const bool one_load = values.contains("load.both");
  for (const std::string key :
       {"track.gauge", "track.inclination", "wheelset.back_to_back", "wheelset.radius", "load.both",
        "load.left", "load.right", "load.of", "solve.accuracy"}) {
    const auto found = values.find(key);
    const bool said = one_load && (key == "load.left" || key == "load.right");
    const bool usual = key == "load.of" && shown(found->second) == "pressures";
    if (found != values.end() && !said && !usual) {
      conditions += (conditions.empty() ? "" : ", ") + key + " = " + shown(found->second);
    }
  }
  page.paragraph(date_text() + ", wrcontact " + std::string(wrc_version()) + "; mm, N, MPa, rad. " +
                 conditions + '.');
  page.list({shorten("command: " + options.command), origin_text("wheel", options.wheel_name()),
             origin_text("rail", options.rail_name())});
  page.heading("In brief");
  page.list(in_brief(centre, positions, conicity));
  const double flange_back = -plain.get_number("wheelset.tape_offset");
  if (!limits.empty()) {
    page.heading("Limits");
    page.table(limit_rows(limits, quantities_of(pair, centre, positions, conicity, flange_back)));
  }
  add_warnings(page, positions, shorten);
  const PictureFolder folder;
  page.heading("Centred on the track");
  if (trouble.empty()) {
    draw_scene(centre, folder / "centre.png", {}); // they stand above
    page.picture(folder / "centre.png", "profiles in contact and pressures of both wheels");
    if (const auto rows = smoothing_rows(centre); !rows.empty()) {
      page.paragraph("What waves that are noise or shape make of it, by the smoothing:");
      draw_smoothing(centre, folder / "smoothing.svg");
      page.picture(folder / "smoothing.svg", "largest pressure over the smoothing wavelength");
      page.table(rows);
      page.list(lines_of(spread_warnings(centre)));
    }
  } else {
    page.paragraph(shorten("Not solved: " + trouble));
  }
  add_positions(page, folder, positions);
  add_conicity(page, folder, conicity);
  add_profile(page, folder, pair.wheel, new_wheel ? &*new_wheel : nullptr,
              file_name(options.wheel_name()), flange_back, shorten);
  add_profile(page, folder, pair.rail, new_rail ? &*new_rail : nullptr,
              file_name(options.rail_name()), 0.0, shorten);
  return page.text();
}

} // namespace
} // namespace driver

int main(int argc, char** argv) {
  using namespace driver;
  Program app(
      "wrc_report",
      "Makes one page about a wheel on a rail, to be opened in a browser or sent to others: "
      "dimensions, equivalent conicity, pressures and contact band over the lateral "
      "position, limits, warnings. It loads no other file, and prints on A4.");
  Options options;
  app.add("WHEEL", options.wheel, "wheel, built-in name or file").type("NAME|FILE").required();
  app.add("RAIL", options.rail, "rail, built-in name or file").type("NAME|FILE").required();
  app.add("--nominal-wheel", options.nominal_wheel, "new wheel to compare with").type("NAME|FILE");
  app.add("--nominal-rail", options.nominal_rail, "new rail to compare with").type("NAME|FILE");
  app.add("--limits", options.limits,
          "limits to check: columns quantity, least, greatest, source; quantities are dimensions "
          "as wrc_profile --json names them, equivalent_conicity, pmax_centred, pmax")
      .type("FILE.csv");
  app.add("--page", options.page, "the page to write").type("FILE.html").show_default();
  app.add("--threads", options.threads, "number of threads; results do not depend on it")
      .within(1, 256)
      .show_default();
  app.add("--set", options.assignments,
          "set a key of all scenes, such as load.both=100000; may be repeated")
      .type("KEY=VALUE")
      .one_value_each();
  app.flag("--quiet", options.quiet, "do not print the name of the page");
  app.footer("\n" + standard_names_text() +
             "\nExamples:\n"
             "  wrc_report S1002 60E1\n"
             "  wrc_report worn.prw 54E3 --page worn.html --set load.both=100000\n"
             "  wrc_report worn.prw 60E1 --nominal-wheel S1002 --limits limits.csv\n");
  return app.run(argc, argv, [&] {
    auto inputs = files_of(options.wheel, options.rail);
    inputs.emplace_back(options.limits);
    refuse_overwriting({options.page}, inputs);
    options.command = command_text(argc, argv);
    require_gnuplot();
    const std::string page = report(options);
    write_whole(options.page, [&](std::ostream& out) { out << page; });
    if (!options.quiet) {
      std::cout << options.page << '\n';
    }
    return 0;
  });
}
