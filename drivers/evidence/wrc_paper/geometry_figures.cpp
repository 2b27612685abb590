#include "support/csv_table.hpp"
#include "wrc_paper/claims.hpp"

namespace driver {
namespace {

namespace fs = std::filesystem;

const std::string lateral = "pose.lateral";
const std::string on_wheel = "left.rigid_contact.s_wheel";
const std::string on_rail = "left.rigid_contact.t_rail";
constexpr double milli = 1e3; // mrad in a rad

CsvTable positions(const fs::path& folder) {
  return CsvTable(folder / "fig06_07.csv");
}

CsvTable cant(const fs::path& folder, const std::string& value) {
  return CsvTable(folder / "fig09_10.csv").where("track.inclination", value);
}

/// From one end of the displacements to the other, against the printed ends.
Finding judge_range(const fs::path& folder, const std::string& column, double first, double last) {
  constexpr double reading = 1.5; // mm, of a printed curve
  const CsvTable table = positions(folder);
  const double at_first = table.at(lateral, -10.0, column);
  const double at_last = table.at(lateral, 10.0, column);
  return {verdict_of(std::abs(at_first - first) <= reading, std::abs(at_last - last) <= reading),
          fixed(at_first, 1) + " to " + fixed(at_last, 1) + " mm"};
}

Finding judge_tread_to_flange(const fs::path& folder) {
  const CsvTable table = positions(folder);
  const auto wheel = table.numbers(on_wheel);
  const bool falls = std::is_sorted(wheel.rbegin(), wheel.rend());
  constexpr double flange_angle = 0.4; // rad, steeper than any tread
  const double angle = table.at(lateral, 10.0, "left.rigid_contact.angle");
  return {verdict_of(falls && std::abs(angle) > flange_angle),
          std::string(falls ? "moves one way" : "turns back") + "; angle at 10 mm " +
              fixed(angle, 2) + " rad"};
}

Finding judge_mirror(const fs::path& folder) {
  const CsvTable table = positions(folder);
  const auto left = table.numbers(on_wheel);
  auto right = table.numbers("right.rigid_contact.s_wheel");
  std::reverse(right.begin(), right.end());
  double most = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    most = std::max(most, std::abs(left[i] - right[i]));
  }
  constexpr double rounding = 1e-3; // mm
  return {verdict_of(most < rounding),
          "left at y and right at -y differ by at most " + small(most) + " mm"};
}

Finding judge_sudden_slope(const fs::path& folder) {
  const CsvTable table = positions(folder);
  const auto slope = [&](double from, double to) {
    return std::abs(table.at(lateral, to, on_wheel) - table.at(lateral, from, on_wheel)) /
           (to - from);
  };
  constexpr double sudden = 1.5; // times
  const double before = slope(7.0, 8.0);
  const double before_left = slope(-8.0, -7.0);
  const double most = std::max(slope(8.0, 9.0), slope(9.0, 10.0));
  const double most_left = std::max(slope(-10.0, -9.0), slope(-9.0, -8.0));
  return {verdict_of(most > sudden * before, most_left > sudden * before_left),
          "from " + fixed(before, 1) + " to " + fixed(most, 1) + " mm/mm at the flange, from " +
              fixed(before_left, 1) + " to " + fixed(most_left, 1) + " at the other end"};
}

Finding judge_roll_sign(const fs::path& folder) {
  const CsvTable table = positions(folder);
  const double left = milli * table.at(lateral, -8.0, "roll");
  const double right = milli * table.at(lateral, 8.0, "roll");
  return {verdict_of(-left > 0.0 && -right < 0.0), "in the paper's sign " + fixed(-left, 3) +
                                                       " mrad at -8 mm, " + fixed(-right, 3) +
                                                       " mrad at 8 mm"};
}

/// Whether the roll's magnitude grows from the centre outwards, up to a displacement.
bool roll_grows(const CsvTable& table, double up_to) {
  double last = -1.0;
  for (double y = 0.0; y <= up_to; y += 1.0) {
    const double roll = std::abs(table.at(lateral, y, "roll"));
    if (roll <= last) {
      return false;
    }
    last = roll;
  }
  return true;
}

Finding judge_roll_grows(const fs::path& folder) {
  const CsvTable table = positions(folder);
  return {verdict_of(roll_grows(table, 10.0)),
          fixed(milli * std::abs(table.at(lateral, 2.0, "roll")), 3) + ", " +
              fixed(milli * std::abs(table.at(lateral, 6.0, "roll")), 3) + ", " +
              fixed(milli * std::abs(table.at(lateral, 10.0, "roll")), 3) + " mrad at 2, 6, 10 mm"};
}

Finding judge_roll_grows_with_cants(const fs::path& folder) {
  const bool steep = roll_grows(cant(folder, "1:20"), 10.0);
  const bool flat = roll_grows(cant(folder, "1:30"), 10.0);
  return {verdict_of(steep, flat), std::string("1:20: ") + (steep ? "grows" : "does not") +
                                       ", 1:30: " + (flat ? "grows" : "does not")};
}

Finding judge_roll_falls_with_inclination(const fs::path& folder) {
  const CsvTable steep = cant(folder, "1:20");
  const CsvTable flat = cant(folder, "1:30");
  int less = 0;
  int all = 0;
  for (double y = 1.0; y <= 10.0; y += 1.0) {
    less += std::abs(steep.at(lateral, y, "roll")) < std::abs(flat.at(lateral, y, "roll")) ? 1 : 0;
    ++all;
  }
  const auto at = [&](const CsvTable& table) {
    return fixed(milli * std::abs(table.at(lateral, 6.0, "roll")), 3);
  };
  return {graded(less == all, 2 * less >= all),
          "smaller for 1:20 at " + std::to_string(less) + " of " + std::to_string(all) +
              " displacements; at 6 mm " + at(steep) + " (1:20), " + at(flat) + " (1:30) mrad"};
}

/// Range of a result for displacements from one to another.
double range_of(const CsvTable& table, const std::string& column, double from, double to) {
  std::vector<double> values;
  for (double y = from; y <= to; y += 1.0) {
    values.push_back(table.at(lateral, y, column));
  }
  return width_of(values);
}

Finding judge_cant_range(const fs::path& folder) {
  const double steep = range_of(cant(folder, "1:20"), on_wheel, -8.0, 8.0);
  const double flat = range_of(cant(folder, "1:30"), on_wheel, -8.0, 8.0);
  constexpr double reading = 1.5; // mm
  const bool numbers = std::abs(steep - 45.0) <= reading && std::abs(flat - 40.0) <= reading;
  return {verdict_of(steep > flat, numbers),
          "on the wheel " + fixed(steep, 1) + " mm (1:20), " + fixed(flat, 1) + " mm (1:30)"};
}

Finding judge_unchanged(const fs::path& folder) {
  const CsvTable table = cant(folder, "1:30");
  constexpr double almost = 1.5; // mm
  const double width = range_of(table, on_rail, -2.0, 4.0);
  const double flat = range_of(table, on_rail, 0.0, 5.0);
  return {graded(width <= almost, flat <= almost), "moves by " + fixed(width, 1) +
                                                       " mm on the rail from -2 to 4 mm; by " +
                                                       fixed(flat, 1) + " mm from 0 to 5 mm"};
}

CsvTable yawed(const fs::path& folder, const std::string& y) {
  return CsvTable(folder / "fig12.csv").where(lateral, y);
}

Finding judge_yaw_even(const fs::path& folder) {
  double most = 0.0;
  for (const char* y : {"0", "2", "4", "6", "8"}) {
    most = std::max(most, asymmetry(yawed(folder, y).numbers("roll")));
  }
  constexpr double even = 1e-6; // rad
  return {verdict_of(most > even),
          "roll at yaw and at -yaw differ by at most " + small(milli * most) + " mrad"};
}

Finding judge_yaw_centred(const fs::path& folder) {
  double most = 0.0;
  for (const double roll : yawed(folder, "0").numbers("roll")) {
    most = std::max(most, std::abs(roll));
  }
  constexpr double none = 1e-6; // rad
  return {verdict_of(most > none), "at most " + small(milli * most) + " mrad at 50 mrad of yaw"};
}

Finding judge_yaw_effect(const fs::path& folder) {
  const auto change = [&](const char* y) {
    const CsvTable table = yawed(folder, y);
    return milli * (std::abs(table.at("pose.yaw", 0.05, "roll")) -
                    std::abs(table.at("pose.yaw", 0.0, "roll")));
  };
  const bool grows = std::abs(change("8")) > std::abs(change("6")) &&
                     std::abs(change("6")) > std::abs(change("4")) &&
                     std::abs(change("4")) > std::abs(change("2"));
  return {verdict_of(grows), "50 mrad of yaw change the roll by " + fixed(change("2"), 3) + ", " +
                                 fixed(change("4"), 3) + ", " + fixed(change("6"), 3) + ", " +
                                 fixed(change("8"), 3) + " mrad at 2, 4, 6, 8 mm"};
}

/// The yaw printed beside a thousand times as much.
Finding judge_printed_yaw(const fs::path& folder) {
  const auto most_change = [&](double yaw) {
    double most = 0.0;
    for (const char* y : {"0", "2", "4", "6", "8"}) {
      const CsvTable table = yawed(folder, y);
      most = std::max(
          most, std::abs(table.at("pose.yaw", yaw, "roll") - table.at("pose.yaw", 0.0, "roll")));
    }
    return milli * most;
  };
  constexpr double readable = 0.01; // mrad, in the paper's figure
  return {verdict_of(most_change(5e-5) > readable),
          "0.05 mrad change the roll by at most " + small(most_change(5e-5)) +
              " mrad, 50 mrad by " + fixed(most_change(0.05), 3) + " mrad"};
}

const char* const printed_yaw =
    "0.05 mrad turn the ends of a wheelset by 0.04 mm. The effects shown need about 50 mrad.";
const char* const fore_and_aft =
    "A wheelset and its mirror image in the plane x = 0 have opposite yaw and the same roll, "
    "lateral displacement and pressures. What depends on the sign of yaw therefore cannot be a "
    "property of the contact of two bodies of revolution on straight rails.";
const char* const reconstruction =
    "The paper does not print its profile. LM here is a reconstruction (see profiles/README.md), "
    "and LMA another wheel.";

} // namespace

std::vector<Figure> geometry_figures() {
  std::vector<Figure> figures;
  figures.push_back(
      {6,
       "positions of the contact, inclination 1:40",
       {"fig06.png"},
       {{"On the left wheel the contact moves from 20.0 to -37.0 mm as y goes from -10 to 10 mm",
         [](const fs::path& f) { return judge_range(f, on_wheel, 20.0, -37.0); }, reconstruction},
        {"On the left rail it moves from 1.5 to -32.5 mm",
         [](const fs::path& f) { return judge_range(f, on_rail, 1.5, -32.5); }, reconstruction},
        {"It goes from the tread to the flange, and never back", judge_tread_to_flange, ""},
        {"The right side is the mirror image of the left one", judge_mirror, ""},
        {"The slope changes suddenly between 8 and 10 mm, to both sides", judge_sudden_slope,
         "The change at LMA's flange begins before 8 mm already."}}});
  figures.push_back({7,
                     "roll, inclination 1:40",
                     {"fig07.png"},
                     {{"Roll is positive for negative y and negative for positive y (the paper's "
                       "sign, opposite to ours)",
                       judge_roll_sign, ""},
                      {"Its magnitude grows with that of y", judge_roll_grows,
                       "The magnitude falls where the other wheel runs onto a steeper part of its "
                       "profile first."}}});
  figures.push_back(
      {9,
       "roll for inclination 1:20 and 1:30",
       {"fig09.png"},
       {{"The magnitude of roll grows with that of y", judge_roll_grows_with_cants, reconstruction},
        {"The steeper the inclination, the smaller the roll", judge_roll_falls_with_inclination,
         reconstruction}}});
  figures.push_back(
      {10,
       "positions on the left side for inclination 1:20 and 1:30",
       {"fig10.png"},
       {{"From -8 to 8 mm the contact covers 45 mm for 1:20 and 40 mm for 1:30: more for the "
         "steeper cant",
         judge_cant_range, reconstruction},
        {"For 1:30 the place on the rail hardly changes from -2 to 4 mm", judge_unchanged,
         reconstruction}}});
  figures.push_back(
      {12,
       "roll over yaw, inclination 1:40 (yaw up to 50 mrad, see docs/evidence/validation.md)",
       {"fig12.png"},
       {{"Off the centre the roll depends on the sign of yaw: larger for one, smaller for the "
         "other",
         judge_yaw_even, fore_and_aft, Ground::proof},
        {"In the centre yaw makes the wheelset roll", judge_yaw_centred,
         "At y = 0 the mirror image in the plane y = 0 turns both yaw and roll round, and the one "
         "in x = 0 turns yaw back: roll equals its own opposite, zero.",
         Ground::proof},
        {"The effect of yaw grows with y", judge_yaw_effect, reconstruction},
        {"These are effects of a yaw of 0.05 mrad, as printed", judge_printed_yaw, printed_yaw,
         Ground::numbers}}});
  return figures;
}

} // namespace driver
