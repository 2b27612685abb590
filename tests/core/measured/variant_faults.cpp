/// Files with faults, and outlines of whole rails.
#include <algorithm>
#include <cmath>
#include <random>

#include "variant_parts.hpp"

namespace wrc {
namespace {

using namespace variant_parts;

/// Points without those in a range of lateral.
std::vector<Position> without(std::vector<Position> points, double from, double to) {
  std::erase_if(points, [=](const Position& p) { return p[0] > from && p[0] < to && p[1] > -8.0; });
  return points;
}

std::vector<Position> with_spike(std::vector<Position> points, double lateral, double by,
                                 std::size_t count = 1) {
  auto at = std::find_if(points.begin(), points.end(), [=](const Position& p) {
    return p[0] >= lateral && p[1] > -8.0 && p[1] < 5.0;
  });
  for (std::size_t i = 0; i < count; ++i, ++at)
    (*at)[1] += by;
  return points;
}

std::vector<Position> noisy(std::vector<Position> points, double amplitude) {
  std::mt19937 random(1955);
  for (Position& point : points)
    for (double& coordinate : point)
      coordinate += amplitude * (static_cast<double>(random() % 2001) / 1000.0 - 1.0);
  return points;
}

void add_gaps_and_spikes(std::vector<Variant>& all, ProfileKind kind) {
  const std::vector<Position> points = standard_points(kind);
  const auto add = [&](const char* name, const std::vector<Position>& written) -> Variant& {
    all.push_back(columns(kind, name, rows(written)));
    return all.back();
  };
  add("gap", without(points, 3.0, 16.0)).warnings = {"gap of 13."};
  add("gap_of_5_mm", without(points, 3.0, 8.0)).warnings = {"gap of 5."};
  std::vector<Position> coarse;
  for (std::size_t i = 0; i < points.size(); i += 4)
    if (std::abs(points[i][0] - 10.0) > 1.0)
      coarse.push_back(points[i]);
  Variant& missing = add("missing_among_points_2_mm_apart", coarse);
  missing.warnings = {"gap of "};
  missing.tolerance = 0.5; // of the ends
  for (const double height : {30.0, -30.0, 3.0, 1.5}) {
    Variant& spike = add("", with_spike(points, 12.0, height));
    spike.name = prefix(kind) + "spike_of_" + std::to_string(static_cast<int>(height)) + "_mm.txt";
    spike.corrections = {"outlier removed: point (12."};
  }
  add("spike_of_two_points", with_spike(points, 12.0, 6.0, 2)).corrections = {
      "outlier removed: 2 points from (12."};
  Variant& small_spike = add("spike_of_a_third_of_a_mm", with_spike(points, 12.0, 0.35));
  small_spike.corrections = {"outlier removed: point (12."};
  small_spike.is_plain = true;
  Variant& step = add("step", changed(points, [](Position p) {
                        return Position{p[0], p[1] + (p[0] > 5.0 ? 2.0 : 0.0)};
                      }));
  step.tolerance = 0.0;
  step.warnings = {"step of 2.0"};
  std::vector<Position> coarse_step;
  for (std::size_t i = 0; i < points.size(); i += 4)
    coarse_step.push_back({points[i][0], points[i][1] + (points[i][0] > 5.0 ? 1.5 : 0.0)});
  Variant& low_step = add("step_among_points_2_mm_apart", coarse_step);
  low_step.tolerance = 0.0;
  low_step.warnings = {"step of 1."};
}

void add_other_lines(std::vector<Variant>& all, ProfileKind kind) {
  const std::vector<Position> points = standard_points(kind);
  const auto add = [&](const char* name, const std::vector<Position>& written) -> Variant& {
    all.push_back(columns(kind, name, rows(written)));
    return all.back();
  };
  std::vector<Position> zeros = points;
  zeros.push_back({0.0, 0.0});
  add("row_of_zeros", zeros).corrections = {"outlier removed: the last point (0.000, 0.000)"};
  std::vector<Position> doubled;
  for (const Position& point : points)
    doubled.insert(doubled.end(), 2, point);
  Variant& twice = add("doubled", doubled);
  twice.corrections = {"points closer than 0.01 mm to the previous one dropped"};
  twice.is_plain = true;
  std::vector<Position> closed = points;
  closed.push_back(points.front());
  add("closed", closed).corrections = {"closed outline opened at its longest side"};
  std::vector<Position> middle(points.begin() + 100, points.end());
  middle.insert(middle.end(), points.begin(), points.begin() + 101);
  add("closed_from_the_middle", middle).corrections = {"closed outline opened"};
  Variant& noise = add("noise", noisy(points, 0.05));
  noise.warnings = {"the points scatter by 0.0"};
  noise.tolerance = 0.1;
  std::vector<Position> there_and_back = points;
  const std::vector<Position> back = reversed(noisy(points, 0.01));
  there_and_back.insert(there_and_back.end(), back.begin() + 1, back.end());
  Variant& again = add("there_and_back", there_and_back);
  again.refusal = "a closed outline";
  std::vector<Position> mixed_up(points.begin(), points.begin() + 100);
  mixed_up.insert(mixed_up.end(), points.begin(), points.end());
  Variant& begun_twice = add("begun_twice", mixed_up);
  begun_twice.corrections = {"points put in order"};
  if (kind == ProfileKind::wheel) {
    std::vector<Position> spoke = points;
    for (int i = 0; i < 5; ++i)
      spoke.insert(spoke.begin() + 10, {-69.0 - 0.1 * i, -65.0 + i});
    Variant& deep = add("points_deep_within", spoke);
    deep.warnings = {"more than 75 mm below the highest one, is between others"};
    deep.tolerance = 0.0;
  }
}

void add_wrong_points(std::vector<Variant>& all, ProfileKind kind) {
  const std::vector<Position> points = standard_points(kind);
  const auto add = [&](const char* name, const std::vector<Position>& written) -> Variant& {
    all.push_back(columns(kind, name, rows(written)));
    return all.back();
  };
  std::vector<Position> marked = points;
  marked[200][1] = -9999.0; // no value
  add("no_value_as_9999", marked).refusal = " in line 200 to (";
  std::vector<Position> shuffled = points;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(7));
  Variant& mixed = add("shuffled", shuffled);
  mixed.refusal = "mm long in total";
  Variant& other = add("of_the_other_kind", points);
  other.options.kind = kind == ProfileKind::wheel ? ProfileKind::rail : ProfileKind::wheel;
  other.tolerance = 0.0;
  other.warnings = {kind == ProfileKind::wheel ? "the crown is at height" : "no flange found"};
  const double large = kind == ProfileKind::wheel ? 1.8 : 3.0;
  Variant& twofold = add("too_large", scaled(points, large, large));
  twofold.tolerance = 0.0;
  twofold.warnings = {"expected 50 to 200"};
  Variant& small = add("too_small", scaled(points, 0.3, 0.3));
  small.tolerance = 0.0;
  small.warnings = {"expected 50 to 200"};
  std::vector<Position> thin = {{0, 0}, {1, 0}, {2, 0}};
  add("three_points", thin).refusal = "3 points, the last in line 3, at least 5 are needed";
}

} // namespace

void add_faults(std::vector<Variant>& all) {
  for (const ProfileKind kind : kinds) {
    add_gaps_and_spikes(all, kind);
    add_other_lines(all, kind);
    add_wrong_points(all, kind);
  }
}

void add_whole_rails(std::vector<Variant>& all) {
  // The head of 60E1, then web and foot in straight lines, 1 mm apart.
  std::vector<Position> half = {{36.0, -39.0},  {10.0, -50.0},  {8.25, -60.0},  {8.25, -140.0},
                                {30.0, -155.0}, {75.0, -161.0}, {75.0, -172.0}, {0.0, -172.0}};
  std::vector<Position> right;
  for (std::size_t i = 1; i < half.size(); ++i) {
    const double length = std::hypot(half[i][0] - half[i - 1][0], half[i][1] - half[i - 1][1]);
    const int parts = static_cast<int>(std::ceil(length));
    for (int k = 0; k < parts; ++k)
      right.push_back({half[i - 1][0] + (half[i][0] - half[i - 1][0]) * k / parts,
                       half[i - 1][1] + (half[i][1] - half[i - 1][1]) * k / parts});
  }
  std::vector<Position> whole = reversed(scaled(right, -1.0, 1.0));
  const std::vector<Position> head = standard_points(ProfileKind::rail);
  whole.insert(whole.end(), head.begin(), head.end());
  whole.insert(whole.end(), right.begin(), right.end());
  for (const bool down : {false, true}) {
    Variant open = columns(ProfileKind::rail, down ? "whole_rail_down" : "whole_rail",
                           rows(scaled(whole, 1.0, down ? -1.0 : 1.0)));
    open.corrections = {"ends cut"};
    open.tolerance = 5.0; // of the first points below the head
    all.push_back(open);
    std::vector<Position> closed(whole.begin() + 300, whole.end());
    closed.insert(closed.end(), whole.begin(), whole.begin() + 301);
    Variant outline =
        columns(ProfileKind::rail, down ? "whole_rail_closed_down" : "whole_rail_closed",
                rows(scaled(closed, 1.0, down ? -1.0 : 1.0)));
    outline.corrections = {"closed outline opened at the foot", "ends cut"};
    outline.tolerance = 5.0;
    all.push_back(outline);
  }
}

} // namespace wrc
