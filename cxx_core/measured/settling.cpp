#include "measured/settling.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.hpp"
#include "measured/alignment.hpp"
#include "measured/constants.hpp"
#include "measured/plausibility.hpp"
#include "measured/plausible_shapes.hpp"
#include "measured/profile_cleaning.hpp"
#include "measured/profile_shape.hpp"
#include "measured/tilt.hpp"
#include "profile/file_type.hpp"
#include "profile/limits.hpp"

namespace wrc::reading {
namespace {

std::string_view name_of(ProfileKind kind) {
  return kind == ProfileKind::wheel ? "wheel" : "rail";
}

/// Options, then content, then extension; a file of columns may say nothing.
std::optional<ProfileKind> stated_kind(const RawProfile& raw, const ReadOptions& options,
                                       Log& log) {
  const std::optional<ProfileKind> by_name = type_of(log.name()).kind;
  const std::optional<ProfileKind> by_content = raw.kind ? raw.kind : by_name;
  if (raw.kind && by_name && *raw.kind != *by_name) {
    log.note("the header says " + std::string(name_of(*raw.kind)) + ", the extension " +
             std::string(name_of(*by_name)) + "; the header is used");
  }
  if (options.kind && by_content && *options.kind != *by_content) {
    log.note("read as a " + std::string(name_of(*options.kind)) + " as requested; the file says " +
             std::string(name_of(*by_content)));
  }
  return options.kind ? options.kind : by_content;
}

void check_length(const RawProfile& raw, double most, const Log& log) {
  const std::vector<Position>& points = raw.points;
  const double length = chord_length(points);
  if (length >= ReadLimits::min_length && length <= most) {
    return;
  }
  std::size_t end = 1; // of the longest chord
  for (std::size_t i = 2; i < points.size(); ++i) {
    if (distance_between(points[i - 1], points[i]) >
        distance_between(points[end - 1], points[end])) {
      end = i;
    }
  }
  const auto point_text = [&raw](std::size_t i) {
    return place_text(raw.points[i]) + (raw.lines.size() == raw.points.size()
                                            ? " in line " + std::to_string(raw.lines[i])
                                            : std::string());
  };
  log.refuse("the points are " + short_text_of(length) + " mm long in total, must be between " +
             text_of(ReadLimits::min_length) + " and " + text_of(most) +
             " mm; the longest chord is " +
             short_text_of(distance_between(points[end - 1], points[end])) + " mm, from " +
             point_text(end - 1) + " to " + point_text(end) +
             "; state the scale, order the points, or remove what is no point");
}

/// Factor to mm that the extent shows; 1 if it shows none.
double unit_by_extent(double width, std::optional<ProfileKind> kind) {
  const auto is_near = [width](double factor, double usual) {
    const double ratio = factor * width / usual;
    return ratio < plausible::near_width && ratio > 1.0 / plausible::near_width;
  };
  if (width >= plausible::thinkable_width[0] && width <= plausible::thinkable_width[1]) {
    return 1.0;
  }
  for (const double factor : {10.0, 25.4}) {
    if ((kind != ProfileKind::rail && is_near(factor, plausible::usual_wheel_width)) ||
        (kind != ProfileKind::wheel && is_near(factor, plausible::usual_head_width))) {
      return factor;
    }
  }
  for (const double factor : {1000.0, 0.001}) {
    if (factor * width >= plausible::thinkable_width[0] &&
        factor * width <= plausible::thinkable_width[1]) {
      return factor;
    }
  }
  return 1.0;
}

void settle_units(RawProfile& raw, std::optional<ProfileKind> kind, const ReadOptions& options,
                  Log& log) {
  const std::vector<Position>& points = raw.points;
  if (options.scale && *options.scale != 1.0) {
    scale_points(raw, *options.scale, *options.scale);
    log.note("multiplied by " + text_of(*options.scale) + " to mm as requested");
  } else if (!options.scale && !raw.unit_is_stated) {
    const Position lateral = extent_of(points, 0);
    const Position height = extent_of(points, 1);
    const double extent = std::max(lateral[1] - lateral[0], height[1] - height[0]);
    const double factor = unit_by_extent(extent, kind);
    if (factor != 1.0) {
      log.guess("multiplied by " + text_of(factor) + ", since the points extend over " +
                    short_text_of(extent) + " and so over " + short_text_of(factor * extent) +
                    " mm",
                "state the scale");
      scale_points(raw, factor, factor);
    }
  }
  check_length(raw, plausible::longest_outline, log);
  for (const Position& point : points) {
    if (!(std::max(std::abs(point[0]), std::abs(point[1])) <= ReadLimits::max_coordinate)) {
      log.refuse("point (" + text_of(point[0]) + ", " + text_of(point[1]) + "), at most " +
                 text_of(ReadLimits::max_coordinate) + " mm are allowed");
    }
  }
}

/// Whether points are a wheel once their columns are swapped: it stands off its tread at one end, a
/// half rail off its web at head and foot.
bool is_swapped_wheel(const std::vector<Position>& points) {
  std::vector<Position> swapped;
  swapped.reserve(points.size());
  for (const Position& point : points) {
    swapped.push_back({point[1], point[0]});
  }
  const std::optional<Flange> flange = flange_of(swapped);
  if (!flange) {
    return false;
  }
  const double side = flange->is_down ? -1.0 : 1.0;
  const double tread = flange->tip[1] - side * flange->height;
  const Position lateral = extent_of(swapped, 0);
  const double middle = 0.5 * (lateral[0] + lateral[1]);
  return std::none_of(swapped.begin(), swapped.end(), [&](const Position& point) {
    return (point[0] > middle) != flange->is_outside &&
           side * (point[1] - tread) > plausible::off_tread;
  });
}

void settle_columns(RawProfile& raw, std::optional<ProfileKind> kind, Log& log) {
  if (raw.signs != Signs::silent || raw.columns_are_named) {
    return;
  }
  const Position first = extent_of(raw.points, 0);
  const Position second = extent_of(raw.points, 1);
  const double width = first[1] - first[0];
  const double height = second[1] - second[0];
  if (!(width < plausible::swapped_ratio * height) || !(height >= plausible::thinkable_width[0]) ||
      (kind != ProfileKind::wheel && height > plausible::greatest_head_height &&
       (kind || !is_swapped_wheel(raw.points)))) {
    return;
  }
  log.guess("columns swapped, since the first extends over " + fixed_text(width) +
                " mm and the second over " + fixed_text(height) + " mm",
            "name them in a heading, \"z y\"");
  change_points(raw, [](const Position& p) { return Position{p[1], p[0]}; });
}

/// A wheel has a flange. A rail's ends are both on one side of its middle.
ProfileKind kind_by_shape(const std::vector<Position>& points) {
  if (flange_of(points)) {
    return ProfileKind::wheel;
  }
  const double middle = points[points.size() / 2][1];
  return (points.front()[1] - middle) * (points.back()[1] - middle) > 0.0 ? ProfileKind::rail
                                                                          : ProfileKind::wheel;
}

/// What the format defines.
void turn_to_frame(RawProfile& raw, ProfileKind kind, Log& log) {
  if (kind == ProfileKind::rail && raw.lateral_towards_gauge) {
    scale_points(raw, -1.0, 1.0);
    log.note("lateral mirrored, the format counts it towards the gauge side");
  }
  if (kind == ProfileKind::rail && raw.rail_height_down) {
    scale_points(raw, 1.0, -1.0);
    log.note("height mirrored: in this format a rail's height is positive downwards");
  }
}

void orient_height(RawProfile& raw, ProfileKind kind, Log& log) {
  std::string evidence;
  if (kind == ProfileKind::rail) {
    const std::optional<Head> head = head_of(raw.points);
    if (!head || !head->is_down) {
      return;
    }
    evidence = "the rail head bulged down: it is " + fixed_text(head->top_width) +
               " mm wide at its lower end, " + fixed_text(head->bottom_width) + " at its upper one";
  } else {
    const std::optional<Flange> flange = flange_of(raw.points);
    if (!flange || !flange->is_down) {
      return;
    }
    evidence = "the flange pointed down: " + fixed_text(flange->width) + " mm wide " +
               fixed_text(plausible::off_tread, 0) + " mm below the tread, above it are " +
               fixed_text(flange->other_width);
  }
  const bool half_turn = kind == ProfileKind::rail && raw.rail_height_down;
  scale_points(raw, half_turn ? -1.0 : 1.0, -1.0);
  log.guess((half_turn ? "height and lateral mirrored, since " : "height mirrored, since ") +
                evidence,
            "state mirror_height");
}

/// The signs that were requested, or else those that the shape shows where the format has none.
void orient(RawProfile& raw, ProfileKind kind, const ReadOptions& options, Log& log) {
  if (options.mirror_height) {
    if (*options.mirror_height) {
      scale_points(raw, 1.0, -1.0);
      log.note("height mirrored as requested");
    }
  } else if (raw.signs != Signs::stated) {
    orient_height(raw, kind, log);
  }
  if (options.mirror_lateral) {
    if (*options.mirror_lateral) {
      scale_points(raw, -1.0, 1.0);
      log.note("lateral mirrored as requested");
    }
  } else if (raw.signs != Signs::stated && kind == ProfileKind::wheel) {
    const std::optional<Flange> flange = flange_of(raw.points);
    if (flange && flange->is_outside) {
      scale_points(raw, -1.0, 1.0);
      log.guess("lateral mirrored, since the flange was on the positive side, its tip at " +
                    fixed_text(flange->tip[0]),
                "state mirror_lateral");
    }
  }
}

void shift(RawProfile& raw, const Position& by) {
  change_points(raw, [&by](const Position& p) { return Position{p[0] + by[0], p[1] + by[1]}; });
}

bool counts_from_flange_back(const RawProfile& raw) {
  const double least = extent_of(raw.points, 0)[0];
  if (raw.counts_from_flange_back) { // unless an offset moved it
    return least >= plausible::begin_from_back[0];
  }
  const std::optional<Flange> flange = flange_of(raw.points);
  return flange && !flange->is_outside && !flange->is_down &&
         least >= plausible::begin_from_back[0] && least <= plausible::begin_from_back[1] &&
         flange->tip[0] >= plausible::tip_from_back[0] &&
         flange->tip[0] <= plausible::tip_from_back[1];
}

/// What is to be added to a wheel's lateral, so that its taping line is at 0; none if it is there.
std::optional<double> shift_to_taping_line(const RawProfile& raw, double tape_offset,
                                           const ReadOptions& options, Log& log) {
  if (options.lateral_shift) {
    log.note("lateral shifted by " + text_of(*options.lateral_shift) + " mm as requested");
    return *options.lateral_shift;
  }
  const std::string shifted = ": shifted by " + text_of(-tape_offset) + " mm to the taping line";
  if (options.origin == WheelOrigin::flange_back) {
    log.note("lateral counted from the flange back, as stated" + shifted);
    return -tape_offset;
  }
  if (options.origin == WheelOrigin::tape || !counts_from_flange_back(raw)) {
    return std::nullopt;
  }
  const std::string text = "lateral counted from the flange back, where it begins at " +
                           fixed_text(extent_of(raw.points, 0)[0]) + " mm" + shifted;
  if (raw.counts_from_flange_back) {
    log.note(text);
  } else {
    log.guess(text, "state origin");
  }
  return -tape_offset;
}

/// Puts the taping line of a wheel to lateral 0, and the height there to 0.
void settle_origin(RawProfile& raw, double tape_offset, const ReadOptions& options, Log& log) {
  const std::optional<double> by = shift_to_taping_line(raw, tape_offset, options, log);
  if (by) {
    shift(raw, {*by, 0.0});
  }
  const std::optional<double> height = height_at_taping_line(raw.points);
  const bool is_off = height && !plausible::tape_height.holds(*height);
  if (!height || (!by && (!is_off || options.origin == WheelOrigin::tape))) {
    return;
  }
  shift(raw, {0.0, -*height});
  const std::string text =
      "height shifted by " + fixed_text(-*height, 4) + " mm, to 0 at the taping line";
  if (by) {
    log.note(text);
  } else {
    log.guess(text, "state origin");
  }
}

/// About the taping line of a wheel, whose height stays, or the origin of a rail.
void turn_points(RawProfile& raw, ProfileKind kind, double angle) {
  const double height =
      kind == ProfileKind::wheel ? height_at_taping_line(raw.points).value_or(0.0) : 0.0;
  const RigidMotion motion{angle, {0.0, 0.0}};
  shift(raw, {0.0, -height});
  change_points(raw, [&motion](const Position& point) { return motion.of(point); });
  shift(raw, {0.0, height});
}

void align_points(RawProfile& raw, ProfileKind kind, const Profile& nominal, Log& log) {
  if (nominal.kind != kind) {
    log.refuse("align_to: " + nominal.name + " is a " + std::string(name_of(nominal.kind)) +
               ", must be a " + std::string(name_of(kind)));
  }
  std::optional<Alignment> found = alignment_to(nominal.curve, raw.points);
  if (!found || found->bound > usual_bound) {
    const std::optional<Alignment> far = alignment_from_afar(nominal.curve, raw.points);
    found = far && (!found || far->bound < found->bound) ? far : found;
  }
  if (!found) {
    log.refuse("cannot be aligned to " + nominal.name +
               ": too few points beside it, or a shape that shows no rotation");
  }
  change_points(raw, [&](const Position& point) { return found->motion.of(point); });
  if (found->bound > usual_bound) {
    log.warn(WarningClass::profile_tilt, "aligned to " + nominal.name + ", but only within " +
                                             fixed_text(found->bound, 1) +
                                             " mm: is it the nominal profile of this one?");
  }
  log.note("aligned to " + nominal.name + ": turned by " +
           fixed_text(found->motion.rotation * 180.0 / std::numbers::pi, 3) +
           " degrees, moved by " + fixed_text(found->motion.shift[0], 3) + " mm in lateral and " +
           fixed_text(found->motion.shift[1], 3) + " mm in height; " +
           fixed_text(100.0 * found->share, 0) + " % of the points are within " +
           fixed_text(found->bound, 1) + " mm of it and count, " + fixed_text(found->deviation, 3) +
           " mm (rms) off");
}

/// As stated, or as a wheel's faces ask for.
void settle_rotation(RawProfile& raw, ProfileKind kind, const ReadOptions& options,
                     const Profile* nominal, Log& log) {
  if (options.rotation && *options.rotation != 0.0) {
    turn_points(raw, kind, *options.rotation);
    log.note("turned by " + short_text_of(*options.rotation * 180.0 / std::numbers::pi) +
             " degrees as requested");
  }
  if (nominal != nullptr) {
    align_points(raw, kind, *nominal, log);
  } else if (!options.rotation && kind == ProfileKind::wheel) {
    if (const double rotation = untilting_rotation(raw.points, log); rotation != 0.0) {
      turn_points(raw, kind, rotation);
    }
  }
}

} // namespace

Settled settle(RawProfile& raw, const ReadOptions& options, Log& log, const Profile* nominal) {
  const std::optional<ProfileKind> stated = stated_kind(raw, options, log);
  std::vector<Position>& points = raw.points;
  if (points.size() < ReadLimits::min_points) {
    log.refuse(
        std::to_string(points.size()) + " points" +
        (raw.lines.empty() ? "" : ", the last in line " + std::to_string(raw.lines.back())) +
        ", at least " + std::to_string(ReadLimits::min_points) +
        " are needed; the file must have two columns or be of Simpack (.prr/.prw) or MiniProf "
        "(.ban/.whl)");
  }
  settle_units(raw, stated, options, log);
  open_outline(raw, stated, log);
  remove_doubles(raw, options.least_point_distance, log);
  order_points(raw, log);
  remove_outliers(raw, log);
  remove_doubles(raw, options.least_point_distance, log); // that outliers were between
  if (points.size() < ReadLimits::min_points) {
    log.refuse(std::to_string(points.size()) + " different points, at least " +
               std::to_string(ReadLimits::min_points) + " are needed");
  }
  settle_columns(raw, stated, log);
  const ProfileKind kind = stated ? *stated : kind_by_shape(points);
  if (!stated) {
    log.guess("treated as a " + std::string(name_of(kind)) + " by its shape", "state the kind");
  }
  turn_to_frame(raw, kind, log);
  orient(raw, kind, options, log);
  if (points.front()[0] > points.back()[0]) {
    std::reverse(points.begin(), points.end());
    log.note("order reversed, to run from the flange or gauge side to the field side");
  }
  cut_ends(raw, kind, log);
  const double tape_offset = options.tape_offset
                                 ? *options.tape_offset
                                 : raw.tape_offset.value_or(plausible::usual_tape_offset);
  if (kind == ProfileKind::wheel) {
    settle_origin(raw, tape_offset, options, log);
  }
  settle_rotation(raw, kind, options, nominal, log);
  check_points(points, kind, tape_offset, log, nominal != nullptr);
  return {kind, std::move(raw.points), std::move(raw.dropped)};
}

} // namespace wrc::reading
