// wrc_profile: shows, converts, checks and draws a wheel or rail profile.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <numbers>

#include "reports/profile_picture.hpp"
#include "reports/smoothing.hpp"
#include "support/output_file.hpp"
#include "support/program.hpp"
#include "support/scene.hpp"
#include "support/scene_file.hpp"
#include "wrc_profile/reports.hpp"

namespace {

using namespace driver;

/// The number that a profile file may have.
constexpr double most_points = 200000.0;

struct Arguments {
  std::string name;
  std::string kind;
  std::string mirror_lateral;
  std::string mirror_height;
  double scale = 0.0;
  std::string smoothing;
  bool strict = false;
  std::string origin;
  double shift = 0.0;
  std::int32_t slice = 0;
  double smoothing_along = -1.0; ///< as the file says
  double rotation = 0.0;         ///< degrees
  std::string align_to;
  std::string convert;
  double spacing = 0.25;
  std::string plot;
  std::string compare;
  double tape_offset = 70.0;
  bool points = false;
  bool json = false;
  bool list = false;
};

Profile load_standard(const std::string& name) {
  Profile profile;
  profile.load_standard(name);
  return profile;
}

Profile load_file(const std::string& argument, const std::string& path,
                  const wrc_read_options& options) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    std::string names = standard_names_text();
    names.pop_back();
    std::replace(names.begin(), names.end(), '\n', ' ');
    throw Failure(argument + ' ' + path + ": no such file; must be a file or a built-in name. " +
                  names);
  }
  Profile profile;
  profile.load_file(path, &options);
  return profile;
}

double smoothing_from(const std::string& word) {
  if (word.empty()) {
    return 0.0; // not stated
  }
  if (word == "auto") {
    return WRC_SMOOTHING_AUTO;
  }
  const double length = number_in(word).value_or(0.0);
  return length > 0.0 ? length : WRC_SMOOTHING_NONE;
}

wrc_read_options options_from(const Program& app, const Arguments& arguments) {
  const auto choice = [](const std::string& word) {
    return word.empty() ? 0 : word == "yes" ? 1 : -1;
  };
  wrc_read_options options{};
  options.struct_size = sizeof options;
  options.kind_given = arguments.kind.empty() ? 0 : 1;
  options.kind = arguments.kind == "rail" ? WRC_RAIL : WRC_WHEEL;
  options.mirror_lateral = choice(arguments.mirror_lateral);
  options.mirror_height = choice(arguments.mirror_height);
  options.strict = arguments.strict ? 1 : 0;
  options.scale = arguments.scale;
  options.smoothing_wavelength = smoothing_from(arguments.smoothing);
  options.origin = arguments.origin.empty()     ? 0
                   : arguments.origin == "tape" ? WRC_ORIGIN_TAPE
                                                : WRC_ORIGIN_FLANGE_BACK;
  options.slice = arguments.slice;
  options.tape_offset = app.has("--tape-offset") ? arguments.tape_offset : 0.0;
  options.lateral_shift = arguments.shift;
  options.rotation_given = app.has("--rotate") ? 1 : 0;
  options.rotation = arguments.rotation * std::numbers::pi / 180.0;
  options.align_to = arguments.align_to.c_str();
  return options;
}

Profile load_asked(const Program& app, const Arguments& arguments) {
  if (!is_standard(arguments.name)) {
    return load_file("NAME|FILE", arguments.name, options_from(app, arguments));
  }
  for (const char* option : {"--kind", "--mirror-lateral", "--mirror-height", "--scale", "--smooth",
                             "--strict", "--origin", "--shift", "--rotate", "--align", "--slice"}) {
    if (app.has(option)) {
      throw Failure(std::string(option) + ": allowed only with a file; " + arguments.name +
                    " is built in and exact");
    }
  }
  return load_standard(arguments.name);
}

wrc_read_options options_of_kind(std::int32_t kind) {
  wrc_read_options options{};
  options.struct_size = sizeof options;
  options.kind_given = 1;
  options.kind = kind;
  return options;
}

std::string lower_extension(const std::string& name) {
  std::string extension = std::filesystem::path(name).extension().string();
  for (char& letter : extension) {
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  }
  return extension;
}

/// All slices of a file, as a surface.
int run_surface(const Program& app, const Arguments& arguments) {
  for (const char* option : {"--points", "--compare", "--convert", "--tape-offset", "--strict",
                             "--origin", "--shift", "--rotate", "--align"}) {
    if (app.has(option)) {
      throw Failure(std::string(option) + ": allowed with one slice of " + arguments.name +
                    " (--slice N)");
    }
  }
  Profile profile;
  const wrc_read_options options = options_from(app, arguments);
  std::int64_t sheets = 0;
  try {
    sheets = profile.load_surface(arguments.name, &options, arguments.smoothing_along);
  } catch (const wrcontact::Error& error) {
    throw Failure(error.what() + std::string(error.status() == WRC_FILE_UNREADABLE
                                                 ? ""
                                                 : "; --slice N shows one slice alone"));
  }
  if (!arguments.plot.empty()) {
    draw_surface(profile, sheets, std::filesystem::path(arguments.name).filename().string(),
                 options.kind_given != 0 ? options.kind == WRC_WHEEL
                                         : lower_extension(arguments.name) == ".slcw",
                 arguments.plot);
  }
  print_surface(profile, arguments.json, std::cout);
  return 0;
}

/// The second profile: as the file says, but of the same kind.
Profile load_other(const std::string& name, const Profile& profile) {
  return is_standard(name) ? load_standard(name)
                           : load_file("--compare", name, options_of_kind(profile.kind()));
}

/// Writes the file and reads it back, as a check of both spacing and format.
Conversion convert(const Profile& profile, const std::string& path, double spacing) {
  try {
    profile.write(path, spacing);
  } catch (const wrcontact::Error& error) {
    throw Failure("--convert " + path + ": " + error.what());
  }
  wrc_read_options options = options_of_kind(profile.kind());
  options.mirror_lateral = options.mirror_height = -1;
  options.origin = WRC_ORIGIN_TAPE;
  return {path, spacing, compare(profile, load_file("--convert", path, options))};
}

/// On a built-in rail or under a built-in wheel; none where they do not touch.
std::optional<Scene> contact_of(const Profile& profile) {
  Scene scene;
  scene.set("solve.side", "left");
  scene.set("solve.accuracy", 1e-2);
  scene.set(is_wheel(profile) ? "wheelset.wheel" : "track.rail", profile);
  try {
    scene.solve();
  } catch (const wrcontact::Error&) {
    return std::nullopt;
  }
  return scene.has_number("left.smoothed_0mm.pmax") ? std::optional(std::move(scene))
                                                    : std::nullopt;
}

std::string unless_positive(const std::string& text) {
  const std::optional<double> value = number_in(text);
  return value && *value > 0.0 && std::isfinite(*value)
             ? ""
             : text + " given, must be a positive number";
}

std::string unless_smoothing(const std::string& text) {
  const std::optional<double> value = number_in(text);
  return text == "auto" || (value && *value >= 0.0 && std::isfinite(*value))
             ? ""
             : text + " given, must be auto or a number of mm, not negative";
}

void add_reading_options(Program& app, Arguments& arguments) {
  app.group("How to read a file");
  app.add("--kind", arguments.kind, "wheel or rail; default: from the file")
      .type("KIND")
      .one_of({"wheel", "rail"});
  app.add("--mirror-lateral", arguments.mirror_lateral,
          "mirror lateral values: yes or no; default: from the shape")
      .type("YES|NO")
      .one_of({"yes", "no"});
  app.add("--mirror-height", arguments.mirror_height,
          "mirror heights: yes or no; default: from the shape")
      .type("YES|NO")
      .one_of({"yes", "no"});
  app.add("--scale", arguments.scale, "mm per unit of the file; default: from the size")
      .type("MM")
      .check(unless_positive);
  app.add("--smooth", arguments.smoothing,
          "smooth: waves of this length in mm are halved, shorter ones vanish; 0: none; auto: as "
          "the noise of the points needs, which is the default and refused with --strict if "
          "there is noise")
      .type("MM|auto")
      .check(unless_smoothing);
  app.add("--origin", arguments.origin,
          "position of lateral 0 of a wheel: tape or flange-back; default: from the file")
      .type("PLACE")
      .one_of({"tape", "flange-back"});
  app.add("--shift", arguments.shift,
          "instead of --origin: shift added to lateral, so that the taping line is at 0")
      .type("MM")
      .within(-500.0, 500.0);
  app.add("--rotate", arguments.rotation,
          "turn by this angle, anticlockwise in the picture, about the taping line or the "
          "rail's origin; 0: as measured, without a search for a tilt")
      .type("DEGREES")
      .within(-25.0, 25.0);
  app.add("--align", arguments.align_to,
          "move and turn the points so that they lie on this profile where they are not worn")
      .type("NAME|FILE");
  app.add("--slice", arguments.slice,
          "number of a profile, from 1, in a slices file (.slcs, .slcw) or a project file of "
          "MiniProf; without it all slices are shown as a surface, a project file is listed")
      .type("N")
      .positive();
  app.add("--smooth-along", arguments.smoothing_along,
          "of all slices: waves of this length along the track, mm, or around the wheel, rad, are "
          "halved; 0: the surface passes through the slices; default: as the file says")
      .type("LENGTH")
      .not_negative();
  app.flag("--strict", arguments.strict, "refuse a file that needs a guess or causes a warning");
}

void add_options(Program& app, Arguments& arguments) {
  app.add("PROFILE", arguments.name, "built-in name or file").type("NAME|FILE");
  app.group("What to show");
  app.flag("--list", arguments.list, "list the built-in profiles");
  app.flag("--points", arguments.points,
           "add points of the curve: arc, lateral, height, angle, curvature");
  app.add("--compare", arguments.compare,
          "compare with another profile in the same frame: normal distance, area between "
          "both, differences of dimensions; --plot draws the distance over the curve")
      .type("NAME|FILE");
  app.add("--tape-offset", arguments.tape_offset, "flange back to taping line of a wheel")
      .type("MM")
      .show_default()
      .check(unless_positive);
  app.flag("--json", arguments.json, "print one JSON object instead of the table");
  app.group("What to write");
  app.add("--plot", arguments.plot, "draw the profile to scale and its curvature")
      .type("FILE.png|svg");
  app.add("--convert", arguments.convert,
          "write the profile: Simpack for the extensions .prr (rail) and .prw (wheel), "
          "otherwise two columns")
      .type("OUT.txt|prr|prw");
  app.add("--spacing", arguments.spacing, "arc length between points, for --convert and --points")
      .type("MM")
      .show_default()
      .check(unless_positive);
  add_reading_options(app, arguments);
  app.group("Options");
  app.footer(
      "\nProfiles are in mm: lateral from the taping line (wheel) or the axis (rail), positive to\n"
      "the field side; height of a wheel towards larger radius, of a rail upwards. Each\n"
      "correction is reported on its own line; --strict refuses instead.\n\n" +
      standard_names_text() +
      "\nExamples:\n"
      "  wrc_profile S1002\n"
      "      dimensions and checks of a built-in wheel\n"
      "  wrc_profile measured.txt --kind rail --smooth 3 --plot rail.png\n"
      "      a measurement in two columns, smoothed and drawn\n"
      "  wrc_profile wheel.csv --kind wheel --origin flange-back --tape-offset 70\n"
      "      a wheel measured from its flange back\n"
      "  wrc_profile tilted.csv --kind wheel --align S1002 --convert straight.prw\n"
      "      a wheel that was measured with a tilt, laid on the new one where it is not worn\n"
      "  wrc_profile worn.prw --compare S1002 --plot wear.svg\n"
      "      how far a worn wheel is from the new one: distance, worn area, change of Sh, Sd, qR\n"
      "  wrc_profile 60E1 --convert 60E1.prr --spacing 0.1\n"
      "      a file for other programs; it is read back, and the difference reported\n"
      "  wrc_profile crossing.slcs --plot crossing.png\n"
      "      the surface that the slices of a crossing make: its parts, and a picture\n"
      "  wrc_profile LMA --points --spacing 1 --json\n"
      "      points, angles and curvature for a script\n");
}

int run(const Program& app, const Arguments& arguments) {
  if (arguments.list) {
    print_list(arguments.json, std::cout);
    return 0;
  }
  if (arguments.name.empty()) {
    throw Failure("no profile given: must be a built-in name or a file (see --help, --list)");
  }
  const auto file = [](const std::string& name) { return is_standard(name) ? "" : name; };
  refuse_overwriting({arguments.convert, arguments.plot},
                     {file(arguments.name), file(arguments.compare), file(arguments.align_to)});
  if (is_slices_file(arguments.name) && arguments.slice == 0) {
    return run_surface(app, arguments);
  }
  if (app.has("--smooth-along")) {
    throw Failure("--smooth-along: allowed with all slices of a .slcs or .slcw file");
  }
  Profile profile = load_asked(app, arguments);
  const Measures measures = measure(profile, -arguments.tape_offset);
  ProfileReport report{std::move(profile), measures, {}, {}, {}, {}, {}};
  std::optional<Profile> other;
  if (!arguments.compare.empty()) {
    other = load_other(arguments.compare, report.profile);
    report.other_name = other->text("name");
    report.comparison = compare(report.profile, *other);
    report.comparison->differences = differences(measures, measure(*other, -arguments.tape_offset));
  }
  if (!arguments.convert.empty()) {
    report.conversion = convert(report.profile, arguments.convert, arguments.spacing);
  }
  if (!is_standard(arguments.name)) {
    report.contact = contact_of(report.profile);
    if (report.contact && arguments.strict && !app.has("--smooth")) {
      for (const Warning& warning : spread_warnings(*report.contact)) {
        if (warning.grade == WRC_DO_NOT_USE) {
          throw Failure(arguments.name + ": strict reading refuses it: " + warning.text +
                        "; state the smoothing: --smooth auto, a wavelength in mm or 0");
        }
      }
    }
  }
  if (arguments.points) {
    const double least_spacing = measures.length / most_points;
    if (arguments.spacing < least_spacing) {
      throw Failure("--spacing " + general(arguments.spacing) + ": must be at least " +
                    general(least_spacing) + " mm with --points for this profile");
    }
    report.points = equal_points(report.profile, arguments.spacing);
    if (other) {
      report.distances = distances_to(*other, report.points);
    }
  }
  if (!arguments.plot.empty()) {
    draw_profile(report.profile, measures, other ? &*other : nullptr, arguments.plot);
  }
  if (arguments.json) {
    print_json(report, std::cout);
  } else {
    print_table(report, std::cout);
  }
  return 0;
}

} // namespace

int main(int argc, char** argv) {
  Program app("wrc_profile", "Shows, checks, converts and draws a wheel or rail profile.");
  Arguments arguments;
  add_options(app, arguments);
  return app.run(argc, argv, [&] { return run(app, arguments); });
}
