#include "geometry/contact_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error.hpp"

namespace wrc {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// A node of the scan can lie this much above the least place next to it: nodes are at most 0.5 mm
/// apart, and relative curvatures up to 1 / (4 mm) are covered.
constexpr double scan_slack = 0.01;

/// Wheel and rail at one place of the wheel profile.
struct Meeting {
  LocusPoint wheel;
  CurvePoint rail;
  double rail_arc = 0.0;
  double distance = infinity;
  bool exists = false;

  /// Sine of the angle from the rail's to the wheel's tangent; its rising root is a least distance.
  [[nodiscard]] double sine() const {
    return rail.tangent_lateral * wheel.tangent_z - rail.tangent_height * wheel.tangent_y;
  }
};

class Search {
public:
  Search(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose)
      : wheel_(wheel), rail_(rail.graph()), pose_(pose), rotation_(pose) {}

  [[nodiscard]] Meeting at(double arc) const { return meet(wheel_.graph().curve().at(arc)); }

  [[nodiscard]] Meeting meet(const CurvePoint& profile_point) const {
    Meeting meeting;
    const auto locus = wheel_.locus(profile_point, pose_, rotation_);
    if (!locus || !rail_.covers(locus->position.y)) {
      return meeting;
    }
    meeting.wheel = *locus;
    meeting.rail = rail_.at_lateral(locus->position.y, meeting.rail_arc);
    meeting.distance = locus->position.z - meeting.rail.height;
    meeting.exists = true;
    return meeting;
  }

  /// The last place towards `outside` at which wheel and rail still face each other.
  [[nodiscard]] double edge_between(double inside, double outside) const {
    while (true) {
      const double middle = 0.5 * (inside + outside);
      if (middle == inside || middle == outside) {
        return inside;
      }
      (at(middle).exists ? inside : outside) = middle;
    }
  }

  /// Least distance between two places that both exist, around a node that is lower than either.
  [[nodiscard]] ContactCandidate refine(double low, double high) const {
    Meeting at_low = at(low);
    Meeting at_high = at(high);
    if (at_low.sine() >= 0.0) {
      return candidate(low, at_low);
    }
    if (at_high.sine() <= 0.0) {
      return candidate(high, at_high);
    }
    // The Illinois rule with a bisection now and then; both keep the bracket, so kinks are found.
    double sine_low = at_low.sine();
    double sine_high = at_high.sine();
    int kept = 0;
    for (int iteration = 0; iteration < 200 && high - low > 1e-13 * (1.0 + high); ++iteration) {
      const bool bisect = iteration % 8 == 7;
      const double place =
          bisect
              ? 0.5 * (low + high)
              : std::clamp((low * sine_high - high * sine_low) / (sine_high - sine_low), low, high);
      const Meeting meeting = at(place);
      if (!meeting.exists) {
        break;
      }
      const double sine = meeting.sine();
      if (sine == 0.0) {
        return candidate(place, meeting);
      }
      if (sine < 0.0) {
        low = place;
        at_low = meeting;
        sine_low = sine;
        sine_high = kept == -1 ? 0.5 * sine_high : at_high.sine();
        kept = -1;
      } else {
        high = place;
        at_high = meeting;
        sine_high = sine;
        sine_low = kept == 1 ? 0.5 * sine_low : at_low.sine();
        kept = 1;
      }
    }
    return at_low.distance <= at_high.distance ? candidate(low, at_low) : candidate(high, at_high);
  }

  [[nodiscard]] ContactCandidate candidate(double arc, const Meeting& meeting) const {
    ContactCandidate result;
    result.wheel = meeting.wheel;
    result.distance = meeting.distance;
    result.rail_angle = std::atan2(meeting.rail.tangent_height, meeting.rail.tangent_lateral);
    constexpr double end_tolerance = 1e-6;
    const auto& graph = wheel_.graph();
    result.at_profile_end = arc <= graph.arc_begin() + end_tolerance ||
                            arc >= graph.arc_end() - end_tolerance ||
                            meeting.rail_arc <= rail_.arc_begin() + end_tolerance ||
                            meeting.rail_arc >= rail_.arc_end() - end_tolerance;
    return result;
  }

private:
  const WheelSurface& wheel_;
  const CurveGraph& rail_;
  const Pose pose_;
  const Rotation rotation_;
};

} // namespace

ContactScan search_contacts(const WheelSurface& wheel, const RailSurface& rail, const Pose& pose,
                            double near_tolerance, bool with_samples) {
  const Search search(wheel, rail, pose);
  const CurveGraph& graph = wheel.graph();
  const auto starts = graph.curve().starts();
  // Wheel and rail at all nodes of the wheel profile, and where the rail begins and ends below it.
  std::vector<double> arcs;
  std::vector<Meeting> meetings;
  double least = infinity;
  const auto add = [&](double arc, const Meeting& meeting) {
    arcs.push_back(arc);
    meetings.push_back(meeting);
    least = std::min(least, meeting.distance);
  };
  for (const double arc : starts) {
    if (arc < graph.arc_begin() || arc > graph.arc_end()) {
      continue;
    }
    const Meeting here = search.at(arc);
    if (!meetings.empty() && meetings.back().exists != here.exists) {
      const double edge = here.exists ? search.edge_between(arc, arcs.back())
                                      : search.edge_between(arcs.back(), arc);
      add(edge, search.at(edge));
    }
    add(arc, here);
  }
  if (!(least < infinity)) {
    throw Error(
        ErrorCode::no_contact,
        "wheel off the rail: no part of the wheel profile lies over the rail at pose.lateral = " +
            text_of(pose.lateral) + " mm (left side; mirrored for the right)");
  }

  ContactScan scan;
  const std::size_t count = arcs.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Meeting& here = meetings[i];
    if (!here.exists) {
      continue;
    }
    if (with_samples) {
      scan.samples.push_back({here.wheel, here.distance,
                              std::atan2(here.rail.tangent_height, here.rail.tangent_lateral)});
    }
    const double before = i > 0 ? meetings[i - 1].distance : infinity;
    const double after = i + 1 < count ? meetings[i + 1].distance : infinity;
    if (here.distance > before || here.distance >= after ||
        here.distance > least + near_tolerance + scan_slack) {
      continue;
    }
    const double low = i > 0 && meetings[i - 1].exists ? arcs[i - 1] : arcs[i];
    const double high = i + 1 < count && meetings[i + 1].exists ? arcs[i + 1] : arcs[i];
    scan.candidates.push_back(search.refine(low, high));
  }
  std::stable_sort(scan.candidates.begin(), scan.candidates.end(),
                   [](const auto& a, const auto& b) { return a.distance < b.distance; });
  const double limit = scan.candidates.front().distance + near_tolerance;
  std::erase_if(scan.candidates, [limit](const auto& c) { return c.distance > limit; });
  return scan;
}

} // namespace wrc
