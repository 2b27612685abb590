#include "variants.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "variant_parts.hpp"

namespace wrc {
namespace {

using namespace variant_parts;

void add_signs_and_orders(std::vector<Variant>& all) {
  for (const ProfileKind kind : kinds)
    for (const double lateral : {1.0, -1.0})
      for (const double height : {1.0, -1.0})
        for (const bool backwards : {false, true}) {
          std::vector<Position> points = scaled(standard_points(kind), lateral, height);
          if (backwards)
            points = reversed(points);
          std::string name = "signs";
          name += lateral > 0.0 ? "_field" : "_gauge";
          name += height > 0.0 ? "_up" : "_down";
          name += backwards ? "_backwards" : "";
          Variant variant = columns(kind, name, rows(points));
          variant.is_plain = height > 0.0 && (lateral > 0.0 || kind == ProfileKind::rail);
          if (height < 0.0)
            variant.corrections.emplace_back("height mirrored");
          if (lateral < 0.0 && kind == ProfileKind::wheel)
            variant.corrections.emplace_back("lateral mirrored");
          all.push_back(variant);
        }
  for (const ProfileKind kind : kinds) {
    Variant variant = columns(kind, "kind_by_shape", rows(standard_points(kind)));
    variant.options.kind.reset();
    variant.corrections = {kind == ProfileKind::wheel ? "treated as a wheel" : "treated as a rail"};
    all.push_back(variant);
  }
}

void add_units(std::vector<Variant>& all) {
  struct Unit {
    const char* name;
    double millimetres;
  };
  for (const ProfileKind kind : kinds) {
    const std::vector<Position> points = standard_points(kind);
    for (const Unit& unit : {Unit{"m", 1000.0}, {"cm", 10.0}, {"inch", 25.4}, {"um", 0.001}}) {
      const std::vector<Position> written =
          scaled(points, 1.0 / unit.millimetres, 1.0 / unit.millimetres);
      Variant silent = columns(kind, std::string("in_") + unit.name, rows(written));
      silent.corrections = {"multiplied by"};
      silent.tolerance = 1e-5; // nine digits of a metre
      all.push_back(silent);
      Variant stated = columns(kind, std::string("heading_") + unit.name,
                               std::string("y [") + unit.name + "]; z [" + unit.name + "]\n" +
                                   rows(written, {.between = ";"}));
      stated.corrections = {std::string("from ") + unit.name};
      stated.tolerance = 1e-5;
      stated.is_plain = true;
      all.push_back(stated);
    }
    Variant comment =
        columns(kind, "heading_in_comment",
                "# lateral (in)  height (in)\n" + rows(scaled(points, 1.0 / 25.4, 1.0 / 25.4)));
    comment.is_plain = true;
    all.push_back(comment);
    Variant lines = columns(kind, "heading_of_two_lines",
                            "y;z\ncm;cm\n" + rows(scaled(points, 0.1, 0.1), {.between = ";"}));
    lines.is_plain = true;
    all.push_back(lines);
    struct Words {
      const char* name;
      const char* text;
      double millimetres;
    };
    for (const Words& words :
         {Words{"heading_y_in_cm", "y in cm, z in cm\n", 10.0},
          {"heading_unit_in_words", "Lateral position (metres)  Height (metres)\n", 1000.0},
          {"heading_in_german", "Querlage [cm]; H\xC3\xB6he [cm]\n", 10.0}}) {
      Variant variant = columns(
          kind, words.name,
          words.text + rows(scaled(points, 1.0 / words.millimetres, 1.0 / words.millimetres)));
      variant.tolerance = 1e-5;
      variant.is_plain = true;
      all.push_back(variant);
    }
    Variant two = columns(kind, "two_units", "y [mm] z [in]\n" + rows(points));
    two.refusal = "two units, mm and in";
    all.push_back(two);
    Variant option = columns(kind, "scale_by_option", rows(scaled(points, 0.5, 0.5)));
    option.options.scale = 2.0;
    option.is_plain = true;
    all.push_back(option);
  }
}

void add_separators(std::vector<Variant>& all) {
  struct Style {
    const char* name;
    RowStyle style;
  };
  const Style styles[] = {
      {"blanks", {.between = "   ", .before = "  "}},
      {"tabs", {.between = "\t"}},
      {"commas", {.between = ","}},
      {"commas_and_blanks", {.between = ", "}},
      {"semicolons", {.between = ";", .after = "\r\n"}},
      {"carriage_returns", {.after = "\r"}},
      {"semicolons_and_decimal_commas", {.between = ";", .after = "\r\n", .decimal = ','}},
      {"tabs_and_decimal_commas", {.between = "\t", .decimal = ','}},
      {"blanks_and_decimal_commas", {.decimal = ','}},
      {"quotes", {.between = "\",\"", .before = "\"", .after = "\"\n"}},
      {"quotes_and_decimal_commas",
       {.between = "\",\"", .before = "\"", .after = "\"\n", .decimal = ','}},
      {"fortran_exponents", {.exponent = 'D'}},
  };
  for (const ProfileKind kind : kinds) {
    for (const Style& style : styles) {
      Variant variant = columns(kind, style.name, rows(standard_points(kind), style.style));
      variant.is_plain = true;
      if (style.style.decimal == ',')
        variant.corrections = {"rows with decimal commas"};
      all.push_back(variant);
    }
    Variant ambiguous = columns(kind, "commas_and_decimal_commas",
                                rows(standard_points(kind), {.between = ",", .decimal = ','}));
    ambiguous.refusal = "commas between the numbers and perhaps in them";
    all.push_back(ambiguous);
  }
}

void add_encodings(std::vector<Variant>& all) {
  for (const ProfileKind kind : kinds) {
    const std::string text =
        "y;z\r\n" + rows(standard_points(kind), {.between = ";", .after = "\r\n"});
    const auto add = [&](const char* name, const std::string& bytes) {
      Variant variant = columns(kind, name, bytes);
      variant.is_plain = true;
      all.push_back(variant);
    };
    add("utf8_mark", "\xEF\xBB\xBF" + text);
    add("utf16_little", utf16(text, true, true));
    add("utf16_big", utf16(text, false, true));
    add("utf16_without_mark", utf16(text, true, false));
    add("utf16_big_without_mark", utf16(text, false, false));
    // A heading with the euro's sign and a character of two halves.
    add("utf16_heading",
        std::string("\xFE\xFF\0#\x20\xAC\xD8\x3D\xDE\x83\0\n", 12) + utf16(text, false, false));
    add("typographic_minus", replaced(text, "-", "\xE2\x88\x92"));
    add("hard_spaces", replaced(rows(standard_points(kind)), " ", "\xC2\xA0"));
    add("end_mark", text + "\x1A");
    add("latin1_heading", "# H\xF6he in mm\n" + text);
    Variant workbook = columns(kind, "workbook", std::string("PK\x03\x04", 4) + text);
    workbook.refusal = "save the sheet with the points as CSV";
    all.push_back(workbook);
  }
}

/// Rows of more columns, each a function of the row.
std::string table(const std::vector<Position>& points,
                  const std::function<std::vector<double>(std::size_t, Position)>& row) {
  std::string text;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (const double value : row(i, points[i]))
      text += number_text(value) + ' ';
    text += '\n';
  }
  return text;
}

void add_columns(std::vector<Variant>& all) {
  for (const ProfileKind kind : kinds) {
    const std::vector<Position> points = standard_points(kind);
    const auto add = [&](const char* name, const std::string& text, const char* correction,
                         bool is_plain) {
      Variant variant = columns(kind, name, text);
      variant.corrections = {correction};
      variant.is_plain = is_plain;
      all.push_back(variant);
    };
    const auto counted = [](std::size_t i, Position p) {
      return std::vector<double>{static_cast<double>(i + 1), p[0], p[1]};
    };
    const auto in_space = [](std::size_t, Position p) {
      return std::vector<double>{1250.0, p[0], p[1]};
    };
    add("numbered_rows", table(points, counted), "counts the rows", false);
    add("numbered_in_tens",
        table(points,
              [](std::size_t i, Position p) {
                return std::vector<double>{10.0 * static_cast<double>(i + 1), p[0], p[1]};
              }),
        "counts the rows", false);
    add("weights",
        table(points,
              [](std::size_t, Position p) {
                return std::vector<double>{p[0], p[1], 1.0};
              }),
        "column 3 ignored, since it is constant", false);
    add("numbered_rows_with_heading", "no y z\n" + table(points, counted),
        "lateral is column 2, height column 3", true);
    add("constant_column", table(points, in_space), "is constant", false);
    add("x_y_z_of_a_section", "x y z\n" + table(points, in_space),
        "lateral is column 2, height column 3", true);
    add("further_column",
        table(points,
              [](std::size_t, Position p) {
                return std::vector<double>{p[0], p[1], std::sin(p[0])};
              }),
        "columns 3 ignored", false);
    const std::vector<Position> swapped = changed(points, [](Position p) {
      return Position{p[1], p[0]};
    });
    add("swapped", rows(swapped), "columns swapped", false);
    add("swapped_by_heading", "z y\n" + rows(swapped), "lateral is column 2, height column 1",
        true);
    Variant one =
        columns(kind, "one_column",
                table(points, [](std::size_t, Position p) { return std::vector<double>{p[1]}; }));
    one.refusal = "no row of two numbers; the last line is '";
    all.push_back(one);
    Variant count = columns(kind, "number_of_points_first",
                            std::to_string(points.size()) + "\n" + rows(points));
    count.is_plain = true;
    all.push_back(count);
    Variant counts = columns(kind, "numbers_of_points_and_columns_first",
                             std::to_string(points.size()) + " 2\n" + rows(points));
    counts.is_plain = true;
    all.push_back(counts);
    std::string labelled;
    for (const Position& point : points)
      labelled += "P: " + number_text(point[0]) + ' ' + number_text(point[1]) + '\n';
    Variant labels = columns(kind, "labelled_rows", labelled);
    labels.refusal = "no row of two numbers; the last line is 'P: ";
    all.push_back(labels);
  }
}

/// Height as Simpack has it.
std::vector<Position> simpack_points(ProfileKind kind) {
  return scaled(standard_points(kind), 1.0, kind == ProfileKind::wheel ? 1.0 : -1.0);
}

std::string simpack(ProfileKind kind, const std::vector<Position>& points,
                    const std::string& keys) {
  return std::string("header.begin\n version = 1\n type = ") +
         (kind == ProfileKind::wheel ? "1" : "0") + "\nheader.end\nspline.begin\n" + keys +
         "\n point.begin\n" + rows(points) + " point.end\nspline.end\n";
}

void add_simpack(std::vector<Variant>& all) {
  const std::string unit = " units.len.f = 1000.\n";
  for (const ProfileKind kind : kinds) {
    const std::vector<Position> points = simpack_points(kind);
    const auto add = [&](const char* name, const std::string& text) -> Variant& {
      Variant variant = columns(kind, name, text);
      variant.name = prefix(kind) + name + (kind == ProfileKind::wheel ? ".prw" : ".prr");
      variant.options = {};
      variant.is_plain = true;
      all.push_back(variant);
      return all.back();
    };
    add("simpack", simpack(kind, points, unit));
    add("simpack_metres", simpack(kind, scaled(points, 1e-3, 1e-3), "")).tolerance = 1e-5;
    add("simpack_keys", simpack(kind,
                                reversed(changed(points,
                                                 [](Position p) {
                                                   return Position{-p[0] - 3.0, -p[1] + 2.0};
                                                 })),
                                unit + " shift.y = 3\n shift.z = -2\n mirror.y = 1\n mirror.z = 1\n"
                                       " inversion = 1\n approx.smooth = 0\n"));
    Variant& upside_down =
        add("simpack_upside_down", simpack(kind, scaled(points, 1.0, -1.0), unit));
    upside_down.is_plain = false;
    upside_down.tolerance = 0.0; // as the file states it
    upside_down.warnings = {kind == ProfileKind::wheel ? "the flange points to smaller radius"
                                                       : "the head points down"};
    Variant& renamed = add("simpack_as_text", simpack(kind, points, unit));
    renamed.name = prefix(kind) + "simpack_as_text.dat";
    Variant& rotated = add("simpack_rotated", simpack(kind, points, unit + " rotate = 1e-9\n"));
    rotated.corrections = {"from y towards z"};
    rotated.is_plain = false;
  }
}

/// Points as MiniProf has them: a wheel from its flange back, a rail to the gauge side.
std::vector<Position> miniprof_points(ProfileKind kind) {
  return changed(standard_points(kind), [kind](Position p) {
    return kind == ProfileKind::wheel ? Position{p[0] + tape, p[1]} : Position{-p[0], p[1]};
  });
}

/// A wheel's height becomes 0 at the taping line, between two points by a chord.
constexpr double height_at_tape = 1e-4;

void add_miniprof(std::vector<Variant>& all) {
  for (const ProfileKind kind : kinds) {
    const std::vector<Position> points = miniprof_points(kind);
    const auto add = [&](const char* name, const std::string& text) -> Variant& {
      Variant variant = columns(kind, name, text);
      variant.name = prefix(kind) + name + (kind == ProfileKind::wheel ? ".whl" : ".ban");
      variant.options = {};
      variant.is_plain = true;
      variant.tolerance = kind == ProfileKind::wheel ? height_at_tape : 1e-6;
      all.push_back(variant);
      return all.back();
    };
    const std::string header = "ProgramName=\nXoffset=0.0000\nColumnDef=X,Y\n";
    add("miniprof", header + "\n" + rows(points));
    add("miniprof_without_blank_line", header + rows(points));
    add("miniprof_quoted_header",
        "\"ColumnDef=X,Y,A\"\n\"Xoffset=7\"\n" + header + "\n" + rows(points));
    add("miniprof_old", "MINIPROF 101 148 1994 3 24\nStock.......:\n\" 32.58 37.11 14.71\n"
                        "32.58 37.11 14.71  (Sd/Sh/qR)\n\n" +
                            rows(points));
    add("miniprof_columns", "ColumnDef=Y,A,X\n\n" + table(points, [](std::size_t, Position p) {
                              return std::vector<double>{p[1], 0.1, p[0]};
                            }));
    add("miniprof_offsets",
        "Xoffset=5\nYOffset=-1\nColumnDef=X,Y\n\n" + rows(changed(points, [](Position p) {
          return Position{p[0] - 5.0, p[1] + 1.0};
        })));
    add("miniprof_decimal_commas", header + "\n" + rows(points, {.between = "\t", .decimal = ','}));
    add("miniprof_fewer_points", "XYPoints=7\n" + header + "\n" + rows(points)).corrections = {
        "XYPoints in the header differs"};
    Variant& renamed = add("miniprof_as_text", header + "\n" + rows(points));
    renamed.name = prefix(kind) + "miniprof_as_text.dat";
    renamed.options.kind = kind;
    if (kind == ProfileKind::wheel) { // as the format counts it, whatever the shape shows
      Variant& part =
          add("miniprof_of_the_tread", header + "\n" + rows({points.begin() + 90, points.end()}));
      part.tolerance = 0.0;
      part.corrections = {"lateral counted from the flange back, where it begins at 29"};
      part.warnings = {"no flange found"};
      part.is_plain = false;
    }
    Variant& down = add("miniprof_upside_down", header + "\n" + rows(scaled(points, 1.0, -1.0)));
    down.is_plain = false;
    down.corrections = {"height mirrored"};
  }
  Variant instrument =
      columns(ProfileKind::rail, "miniprof_of_the_instrument",
              "ProgramName=MiniProf for Windows\nProgramVer=2.43.73\nColumnDef=X,Y\nGrade=38.6\n" +
                  rows(scaled(standard_points(ProfileKind::rail), 1.0, -1.0)));
  instrument.name = "60E1_miniprof_of_the_instrument.ban";
  instrument.corrections = {"Grade=38.6"};
  instrument.is_plain = true;
  all.push_back(instrument);
}

void add_origins(std::vector<Variant>& all) {
  const ProfileKind kind = ProfileKind::wheel;
  const auto moved = [](double lateral, double height) {
    return changed(standard_points(ProfileKind::wheel), [=](Position p) {
      return Position{p[0] + lateral, p[1] + height};
    });
  };
  Variant shape = columns(kind, "origin_by_shape", rows(moved(tape, 0.0)));
  shape.corrections = {"lateral counted from the flange back"};
  shape.tolerance = height_at_tape;
  all.push_back(shape);
  Variant height = columns(kind, "origin_and_height", rows(moved(tape, -28.0)));
  height.corrections = {"to 0 at the taping line"};
  height.tolerance = height_at_tape;
  all.push_back(height);
  Variant radius = columns(kind, "heights_are_radii", rows(moved(0.0, 460.0)));
  radius.corrections = {"height shifted by -460"};
  radius.tolerance = height_at_tape;
  all.push_back(radius);
  Variant kept = radius;
  kept.name = "S1002_heights_are_radii_from_the_taping_line.txt";
  kept.options.origin = WheelOrigin::tape;
  kept.corrections = {};
  kept.warnings = {"height 460.00 mm at the taping line, expected 0"};
  kept.tolerance = 0.0;
  all.push_back(kept);
  Variant stated = columns(kind, "origin_stated", rows(moved(tape, 0.0)));
  stated.options.origin = WheelOrigin::flange_back;
  stated.is_plain = true;
  stated.tolerance = height_at_tape;
  all.push_back(stated);
  Variant other_tape = columns(kind, "origin_with_distance", rows(moved(66.0, 0.0)));
  other_tape.options.origin = WheelOrigin::flange_back;
  other_tape.options.tape_offset = 66.0;
  other_tape.is_plain = true;
  other_tape.tolerance = height_at_tape;
  all.push_back(other_tape);
  Variant shift = columns(kind, "origin_by_shift", rows(moved(31.0, 4.0)));
  shift.options.lateral_shift = -31.0;
  shift.is_plain = true;
  shift.tolerance = height_at_tape;
  all.push_back(shift);
  Variant from_rim = columns(kind, "origin_at_the_rim", rows(moved(-65.0, 0.0)));
  from_rim.tolerance = 0.0;
  from_rim.warnings = {"the taping line, at 0, is not inside"};
  all.push_back(from_rim);
  Variant middle = columns(kind, "origin_in_the_middle", rows(moved(20.0, 0.0)));
  middle.tolerance = 0.0;
  middle.warnings = {"the flange tip's distance from the flange back"};
  all.push_back(middle);
  Variant gauge = columns(kind, "origin_turned_round", rows(scaled(moved(tape, 0.0), -1.0, 1.0)));
  gauge.corrections = {"lateral mirrored", "lateral counted from the flange back"};
  gauge.tolerance = height_at_tape;
  all.push_back(gauge);
  Variant foot = columns(ProfileKind::rail, "origin_at_the_foot",
                         rows(changed(standard_points(ProfileKind::rail), [](Position p) {
                           return Position{p[0], p[1] + 172.0};
                         })));
  foot.tolerance = 0.0;
  foot.warnings = {"the crown is at height 172.00"};
  all.push_back(foot);
}

} // namespace

std::vector<Position> standard_points(ProfileKind kind) {
  const Curve curve = standard_profile(kind == ProfileKind::wheel ? "S1002" : "60E1").curve;
  std::vector<Position> points;
  const double parts = std::ceil(curve.length() / 0.5);
  for (double i = 0.0; i <= parts; i += 1.0) {
    const CurvePoint point = curve.at(curve.length() * i / parts);
    points.push_back({point.lateral, point.height});
  }
  return points;
}

std::vector<Variant> all_variants() {
  std::vector<Variant> all;
  add_signs_and_orders(all);
  add_units(all);
  add_separators(all);
  add_encodings(all);
  add_columns(all);
  add_simpack(all);
  add_miniprof(all);
  add_origins(all);
  add_faults(all);
  add_whole_rails(all);
  return all;
}

} // namespace wrc
