#include "support/csv_table.hpp"
#include "wrc_paper/claims.hpp"

namespace driver {
namespace {

namespace fs = std::filesystem;

const std::string lateral_position = "pose.lateral";
const std::string pmax = "left.pmax";

CsvTable pressures(const fs::path& folder) {
  return CsvTable(folder / "fig08.csv");
}

Finding judge_three_parts(const fs::path& folder) {
  const CsvTable table = pressures(folder);
  const auto at = [&](double y) { return table.at(lateral_position, y, pmax); };
  const bool rises = at(0.0) > at(-8.0);
  double least = at(1.0);
  double where = 1.0;
  for (double y = 1.0; y <= 9.0; y += 1.0) {
    if (at(y) < least) {
      least = at(y);
      where = y;
    }
  }
  const bool falls = least < at(0.0);
  const bool rises_again = at(10.0) > 2.0 * least || at(8.0) > 2.0 * least;
  return {graded(rises && falls && rises_again, rises_again && (rises || falls)),
          fixed(at(-8.0), 0) + " at -8, " + fixed(at(0.0), 0) + " at 0, least " + fixed(least, 0) +
              " at " + fixed(where, 0) + ", " + fixed(at(8.0), 0) + " at 8, " + fixed(at(10.0), 0) +
              " MPa at 10 mm"};
}

Finding judge_flange(const fs::path& folder) {
  const CsvTable table = pressures(folder);
  const double before = table.at(lateral_position, 6.0, pmax);
  const double most =
      std::max({table.at(lateral_position, 8.0, pmax), table.at(lateral_position, 9.0, pmax),
                table.at(lateral_position, 10.0, pmax)});
  constexpr double sharp = 2.0; // times
  return {verdict_of(most > sharp * before),
          "from " + fixed(before, 0) + " MPa at 6 mm to " + fixed(most, 0) + " MPa within 4 mm"};
}

Finding judge_strong(const fs::path& folder) {
  const auto values = pressures(folder).numbers(pmax);
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  constexpr double strong = 1.5; // times
  return {verdict_of(*most > strong * *least),
          fixed(*least, 0) + " to " + fixed(*most, 0) + " MPa"};
}

Finding judge_opposite(const fs::path& folder) {
  const CsvTable table = pressures(folder);
  const auto left = table.numbers(pmax);
  const auto right = table.numbers("right.pmax");
  double most = 0.0;
  for (std::size_t i = 0; i < left.size(); ++i) {
    most = std::max(most, std::abs(left[i] / right[left.size() - 1 - i] - 1.0));
  }
  constexpr double rounding = 1e-6;
  return {verdict_of(most < rounding),
          "left at y and right at -y differ by at most " + small(100.0 * most) + " %"};
}

/// Pressures of both cants over the displacement, or over its opposite.
struct CantOrder {
  int as_said = 0; ///< displacements at which the paper's order holds
  int all = 0;
  std::string crossings; ///< where the order changes, mm
};

CantOrder order_of(const CsvTable& steep, const CsvTable& flat, double sign) {
  constexpr double same = 2e-3;      // of the pressure: twice the requested accuracy
  constexpr double said_place = 3.0; // mm
  CantOrder order;
  double last = 0.0;
  for (double y = -8.0; y <= 8.0; y += 1.0) {
    const double one = steep.at(lateral_position, sign * y, pmax);
    const double other = flat.at(lateral_position, sign * y, pmax);
    const double difference = std::abs(one / other - 1.0) < same ? 0.0 : one - other;
    if (y != said_place) {
      order.as_said += (y < said_place ? difference < 0.0 : difference > 0.0) ? 1 : 0;
      ++order.all;
    }
    if (difference * last < 0.0) {
      order.crossings += (order.crossings.empty() ? "" : ", ") + fixed(y - 0.5, 1);
    }
    last = difference == 0.0 ? last : difference;
  }
  return order;
}

std::string text_of(const CantOrder& order) {
  return "holds at " + std::to_string(order.as_said) + " of " + std::to_string(order.all) +
         " displacements; the order " +
         (order.crossings.empty() ? "never changes" : "changes near " + order.crossings + " mm");
}

Finding judge_cants(const fs::path& folder) {
  const CsvTable table(folder / "fig11.csv");
  const CsvTable steep = table.where("track.inclination", "1:20");
  const CsvTable flat = table.where("track.inclination", "1:30");
  const CantOrder order = order_of(steep, flat, 1.0);
  return {graded(order.as_said == order.all, 3 * order.as_said >= 2 * order.all),
          text_of(order) + "; at 0 mm " + fixed(steep.at(lateral_position, 0.0, pmax), 0) +
              " (1:20), " + fixed(flat.at(lateral_position, 0.0, pmax), 0) +
              " (1:30) MPa. With y turned round, as on the right wheel: " +
              text_of(order_of(steep, flat, -1.0))};
}

CsvTable yawed(const fs::path& folder) {
  return CsvTable(folder / "fig13.csv");
}

Finding judge_yaw_raises(const fs::path& folder) {
  const CsvTable table = yawed(folder);
  std::string numbers;
  bool holds[2]{};
  for (const int side : {0, 1}) {
    const std::string name = side == 0 ? pmax : "right.pmax";
    const double without = table.at("pose.yaw", 0.0, name);
    const auto values = table.numbers(name);
    const double least = *std::min_element(values.begin(), values.end());
    const double most = *std::max_element(values.begin(), values.end());
    holds[side] = least >= without;
    numbers += std::string(side == 0 ? "left " : "; right ") + fixed(without, 0) +
               " MPa without yaw, " + fixed(least, 0) + " to " + fixed(most, 0) + " with";
  }
  return {verdict_of(holds[0], holds[1]), numbers};
}

Finding judge_yaw_sign(const fs::path& folder) {
  const CsvTable table = yawed(folder);
  double most = 0.0;
  for (const std::string& name : {pmax, std::string("right.pmax")}) {
    const auto values = table.numbers(name);
    most = std::max(most, asymmetry(values) / table.at("pose.yaw", 0.0, name));
  }
  constexpr double even = 2e-3; // twice the requested accuracy
  return {verdict_of(most > even),
          "pressures at yaw and at -yaw differ by at most " + small(100.0 * most) + " %"};
}

Finding judge_yaw_shape(const fs::path& folder) {
  const CsvTable table = yawed(folder);
  const auto change = [&](const char* name) {
    return 100.0 * (table.at("pose.yaw", 0.05, name) / table.at("pose.yaw", 0.0, name) - 1.0);
  };
  constexpr double visible = 3.0; // percent of the area
  const double left = change("left.area");
  const double right = change("right.area");
  return {verdict_of(std::abs(left) > visible, std::abs(right) > visible),
          "the area changes by " + fixed(left, 1) + " % (left), " + fixed(right, 1) +
              " % (right) at 50 mrad"};
}

/// The yaw printed beside a thousand times as much.
Finding judge_pressures_of_printed_yaw(const fs::path& folder) {
  const CsvTable table = yawed(folder);
  const auto most_change = [&](double yaw) {
    double most = 0.0;
    for (const char* name : {"left.pmax", "right.pmax"}) {
      most = std::max(
          most, std::abs(table.at("pose.yaw", yaw, name) / table.at("pose.yaw", 0.0, name) - 1.0));
    }
    return 100.0 * most;
  };
  constexpr double readable = 1.0; // percent, in the paper's figure
  return {verdict_of(most_change(5e-5) > readable),
          "0.05 mrad change the largest pressure by at most " + small(most_change(5e-5)) +
              " %, 50 mrad by " + fixed(most_change(0.05), 1) + " %"};
}

const char* const fitted_profile =
    "The paper does not print its profile. LM here is a reconstruction, fitted to the paper's "
    "contact positions and not to its pressures, and LMA is another wheel.";

} // namespace

std::vector<Figure> pressure_figures() {
  std::vector<Figure> figures;
  figures.push_back(
      {8,
       "patches and largest pressures, inclination 1:40",
       {"fig08_patches.png", "fig08_pmax.png"},
       {{"The lateral displacement has a strong influence on the pressure", judge_strong, ""},
        {"Left wheel: a mild increase up to y = 0, then a sharp decrease, then a sharp increase",
         judge_three_parts, fitted_profile},
        {"The last increase is the flange on the gauge corner", judge_flange, ""},
        {"The right wheel behaves in the opposite way", judge_opposite, ""}}});
  figures.push_back(
      {11,
       "left wheel, inclination 1:20 and 1:30",
       {"fig11_patches.png", "fig11_pmax.png"},
       {{"Below y = 3 mm pressures are lower for 1:20, above they are lower for 1:30", judge_cants,
         "The paper does not print its profile, and LM here is a reconstruction. Where the "
         "statement "
         "holds with y turned round, the paper may show the other side, or the other sign, than in "
         "its figure 6."}}});
  figures.push_back(
      {13,
       "over yaw, y = 6 mm, inclination 1:40 (yaw up to 50 mrad, see docs/evidence/validation.md)",
       {"fig13_patches.png", "fig13_pmax.png"},
       {{"Any yaw raises the largest pressure of both wheels", judge_yaw_raises,
         "Yaw moves both contacts along their profiles; whether the pressure rises depends on the "
         "radii found there. The paper's own profile is not printed."},
        {"Negative yaw (the paper's sign) raises it sharply on the left wheel, positive yaw mildly "
         "on the right one: the sign matters",
         judge_yaw_sign,
         "A wheelset and its mirror image in the plane x = 0 have opposite yaw and the same "
         "pressures: the sign of yaw cannot matter for bodies of revolution on straight rails.",
         Ground::proof},
        {"Yaw changes the shape of the patches", judge_yaw_shape, ""},
        {"These are effects of a yaw of 0.05 mrad, as printed", judge_pressures_of_printed_yaw,
         "0.05 mrad turn the ends of a wheelset by 0.04 mm. The effects shown need about 50 mrad.",
         Ground::numbers}}});
  return figures;
}

namespace {

/// Holds if all the statements do; their numbers one after the other.
Claim all_of(const std::string& text, const std::vector<Claim>& claims, Ground ground) {
  std::string why;
  for (const Claim& claim : claims) {
    why += (why.empty() || claim.why_not.empty() ? "" : " ") + claim.why_not;
  }
  return {text,
          [claims](const fs::path& folder) {
            Finding whole{Verdict::confirmed, ""};
            int confirmed = 0;
            for (const Claim& claim : claims) {
              const Finding one = claim.judge(folder);
              confirmed += one.verdict == Verdict::confirmed ? 1 : 0;
              whole.numbers += (whole.numbers.empty() ? "" : "; ") + one.numbers;
            }
            whole.verdict = graded(confirmed == static_cast<int>(claims.size()), confirmed > 0);
            return whole;
          },
          why, ground};
}

} // namespace

Figure conclusions(const std::vector<Figure>& figures) {
  const auto claim = [&](int number, std::size_t index) -> const Claim& {
    const auto found = std::find_if(figures.begin(), figures.end(),
                                    [&](const Figure& one) { return one.number == number; });
    return found->claims.at(index);
  };
  return {
      0,
      "The paper's conclusions",
      {},
      {all_of("(a) From -9 to 9 mm the contact of the left wheel goes from tread to flange, and "
              "pressures rise sharply when the flange touches the gauge corner",
              {claim(6, 2), claim(8, 2)}, Ground::profile),
       all_of("(b) Below 3 mm a cant of 1:20 is better, above it 1:30", {claim(11, 0)},
              Ground::profile),
       all_of("(c) Yaw changes shape and pressure sharply; mild yaw with a mild displacement "
              "makes the contact much worse",
              {claim(13, 0), claim(13, 2)}, Ground::profile)}};
}

} // namespace driver
