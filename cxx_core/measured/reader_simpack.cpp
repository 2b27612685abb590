/// Simpack .prr/.prw: nested sections of key = value, points in spline/point.
///
/// Order of processing, as the files number it: 1 least point distance, 2 shifts, 3 rotation about
/// the origin (its sense is not documented: from y towards z is a guess), 4 bounds (lateral: points
/// dropped, height: clipped), 5 mirrors, 6 inversion of the order, 7 units (value / units.len.f is
/// metres, so without the key values are metres). Height is positive downwards in the track: larger
/// radius for a wheel, into the rail for a rail.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/error.hpp"
#include "measured/profile_shape.hpp"
#include "measured/reader_formats.hpp"

namespace wrc::reading {
namespace {

/// A limit of the format (not a tuning constant).
constexpr std::size_t max_nesting = 8;

std::string_view without_comment(std::string_view line) {
  bool quoted = false;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\'') {
      quoted = !quoted;
    } else if (!quoted && (line[i] == '!' || line[i] == '%')) {
      return trimmed(line.substr(0, i));
    }
  }
  return line;
}

struct Content {
  RawProfile raw;
  std::map<std::string, double, std::less<>> number; ///< of the spline section
  std::string unit; ///< units.len of old files, where units.len.f is absent
  bool has_spline = false;
  int point_sections = 0;
  LineCount unknown_keys;
  LineCount weights;
  LineCount gaps;
};

class Parser {
public:
  Parser(std::string_view text, Log& log) : lines_(text, log), log_(log) {}

  Content parse() {
    while (lines_.next() && !done_) {
      const std::string_view line = without_comment(lines_.text());
      if (line.empty()) {
        continue;
      }
      if (in("point") && !line.ends_with(".end") && !line.ends_with(".begin")) {
        read_row(line);
      } else if (const std::size_t equals = line.find('='); equals != std::string_view::npos) {
        read_key(trimmed(line.substr(0, equals)), trimmed(line.substr(equals + 1)));
      } else {
        read_section(line);
      }
    }
    if (!sections_.empty()) {
      log_.refuse("section '" + sections_.back() + "' is not ended");
    }
    if (!content_.has_spline) {
      log_.refuse("no section 'spline' found");
    }
    return std::move(content_);
  }

private:
  [[nodiscard]] bool in(std::string_view section) const {
    return !sections_.empty() && sections_.back() == section;
  }

  void read_section(std::string_view line) {
    constexpr std::string_view begin = ".begin";
    constexpr std::string_view end = ".end";
    if (line.ends_with(begin)) {
      if (sections_.size() >= max_nesting) {
        log_.refuse(lines_.number(), "sections nested deeper than " + std::to_string(max_nesting));
      }
      if (in("spline") && line == "point.begin" && ++content_.point_sections == 2) {
        log_.guess("points of several sections joined, the second begins in line " +
                       std::to_string(lines_.number()),
                   "leave one section point");
      }
      sections_.push_back(printable(line.substr(0, line.size() - begin.size())));
    } else if (line.ends_with(end)) {
      const std::string section = printable(line.substr(0, line.size() - end.size()));
      if (!in(section)) {
        log_.refuse(lines_.number(),
                    "'" + section + "' ends, but " +
                        (sections_.empty() ? "no section is" : "'" + sections_.back() + "' is") +
                        " open");
      }
      sections_.pop_back();
      if (section == "spline" && content_.raw.points.empty()) {
        log_.refuse(lines_.number(), "'spline' ends without a point");
      }
      if (section == "spline" && sections_.empty()) {
        content_.has_spline = done_ = true;
      }
    } else {
      log_.refuse(lines_.number(),
                  quoted(line) + " is neither a section, nor key = value, nor a point");
    }
  }

  void read_key(std::string_view key, std::string_view value) {
    static const std::set<std::string_view> informative = {"file", "file.mtime", "type",
                                                           "units.ang", "version"};
    static const std::set<std::string_view> numeric = {
        "approx.smooth", "point.dist.min", "shift.y",     "shift.z",     "rotate",
        "bound.y.min",   "bound.y.max",    "bound.z.min", "bound.z.max", "mirror.y",
        "mirror.z",      "inversion",      "units.len.f", "units.ang.f"};
    if (in("header") && key == "type") {
      const double type = finite_number(value, lines_.number(), log_);
      if (type != 0.0 && type != 1.0) {
        log_.refuse(lines_.number(),
                    "type = " + printable(value) + ", must be 0 (rail) or 1 (wheel)");
      }
      content_.raw.kind = type == 0.0 ? ProfileKind::rail : ProfileKind::wheel;
    } else if (in("spline") && key == "comment") {
      const std::size_t first = value.find('\'');
      const std::size_t last = value.rfind('\'');
      if (last != std::string_view::npos && last > first) {
        content_.raw.title = std::string(value.substr(first + 1, last - first - 1));
      }
    } else if (in("spline") && key == "units.len") {
      content_.unit = std::string(words_of(value, " \t'\"[]").word[0]);
    } else if (in("spline") && numeric.contains(key)) {
      const double number = finite_number(value, lines_.number(), log_);
      const auto [entry, is_new] = content_.number.emplace(key, number);
      if (!is_new && entry->second != number) {
        log_.guess(std::string(key) + " occurs again in line " + std::to_string(lines_.number()) +
                       " with another value, the last one is used",
                   "remove the others");
      }
      entry->second = number;
    } else if (!informative.contains(key)) {
      content_.unknown_keys.add(lines_.number());
    }
  }

  void read_row(std::string_view line) {
    const Words words = words_of(line, " \t");
    if (words.count < 2 || words.count > 3) {
      log_.refuse(lines_.number(),
                  std::to_string(words.count) + " columns, a point has y, z and perhaps a weight");
    }
    if (is_missing(words.word[0]) || is_missing(words.word[1])) {
      content_.gaps.add(lines_.number());
      return;
    }
    const double y = finite_number(words.word[0], lines_.number(), log_);
    const double z = finite_number(words.word[1], lines_.number(), log_);
    if (words.count == 3 && finite_number(words.word[2], lines_.number(), log_) != 1.0) {
      content_.weights.add(lines_.number());
    }
    add_point(content_.raw, {y, z}, lines_.number(), log_);
  }

  Lines lines_;
  Log& log_;
  Content content_;
  std::vector<std::string> sections_;
  bool done_ = false;
};

/// Steps 1 to 7 of the format.
class Processing {
public:
  Processing(Content& content, Log& log)
      : raw_(content.raw), points_(content.raw.points), number_(content.number),
        unit_(content.unit), log_(log) {}

  void apply() {
    if (const double least = value("point.dist.min"); least > 0.0) {
      report(drop_close_points(points_, least), "points closer than point.dist.min dropped");
    }
    shift();
    rotate();
    bound();
    mirror("mirror.y", 0, "lateral");
    mirror("mirror.z", 1, "height");
    if (flag("inversion")) {
      std::reverse(points_.begin(), points_.end());
      std::reverse(raw_.lines.begin(), raw_.lines.end());
      log_.note("order reversed as inversion = 1 requests");
    }
    to_millimetres();
  }

private:
  [[nodiscard]] double value(std::string_view key, double absent = 0.0) const {
    const auto found = number_.find(key);
    return found == number_.end() ? absent : found->second;
  }
  [[nodiscard]] bool flag(std::string_view key) const {
    const double number = value(key);
    if (number != 0.0 && number != 1.0) {
      log_.refuse(std::string(key) + " = " + text_of(number) + ", must be 0 or 1");
    }
    return number == 1.0;
  }
  void report(std::size_t count, const std::string& what) {
    if (count > 0) {
      log_.note(std::to_string(count) + " " + what);
    }
  }
  void shift() {
    const Position by = {value("shift.y"), value("shift.z")};
    if (by[0] == 0.0 && by[1] == 0.0) {
      return;
    }
    for (Position& point : points_) {
      point = {point[0] + by[0], point[1] + by[1]};
    }
    log_.note("shifted by shift.y = " + text_of(by[0]) + ", shift.z = " + text_of(by[1]));
  }
  void rotate() {
    const double per_radian = value("units.ang.f", 1.0);
    if (!(per_radian > 0.0)) {
      log_.refuse("units.ang.f = " + text_of(per_radian) + ", must be positive");
    }
    const double angle = value("rotate") / per_radian;
    if (angle == 0.0) {
      return;
    }
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    for (Position& point : points_) {
      point = {cosine * point[0] - sine * point[1], sine * point[0] + cosine * point[1]};
    }
    log_.guess("rotated by " + text_of(angle) + " rad about the origin, from y towards z",
               "give the points as they are rotated, and rotate = 0");
  }
  void bound() {
    const Position y = {value("bound.y.min"), value("bound.y.max")};
    if (y[0] < y[1]) {
      report(std::erase_if(points_, [&](const Position& p) { return p[0] < y[0] || p[0] > y[1]; }),
             "points outside bound.y dropped");
    }
    const Position z = {value("bound.z.min"), value("bound.z.max")};
    if (!(z[0] < z[1])) {
      return;
    }
    std::size_t count = 0;
    for (Position& point : points_) {
      const double clipped = std::clamp(point[1], z[0], z[1]);
      count += clipped != point[1] ? 1U : 0U;
      point[1] = clipped;
    }
    report(count, "points clipped to bound.z");
  }
  void mirror(const std::string& key, std::size_t coordinate, const std::string& name) {
    if (!flag(key)) {
      return;
    }
    for (Position& point : points_) {
      point[coordinate] = -point[coordinate];
    }
    log_.note(name + " mirrored as " + key + " = 1 requests");
  }
  void to_millimetres() {
    const bool by_factor = number_.contains("units.len.f");
    const bool by_name = !by_factor && !unit_.empty();
    if (by_name && unit_ != "mm" && unit_ != "m" && unit_ != "cm") {
      log_.refuse("units.len = " + printable(unit_) + ", must be m, cm or mm");
    }
    const double named = unit_ == "mm" ? 1000.0 : unit_ == "cm" ? 100.0 : 1.0;
    const double per_metre = by_name ? named : value("units.len.f", 1.0);
    if (!(per_metre > 0.0)) {
      log_.refuse("units.len.f = " + text_of(per_metre) + ", must be positive");
    }
    raw_.unit_is_stated = by_factor || by_name;
    const double scale = 1000.0 / per_metre;
    if (scale == 1.0) {
      return;
    }
    for (Position& point : points_) {
      point = {point[0] * scale, point[1] * scale};
    }
    log_.note("multiplied by " + text_of(scale) + " to mm, from " +
              (by_name ? "units.len = " + unit_ : "units.len.f = " + text_of(per_metre)) +
              (raw_.unit_is_stated ? "" : " (absent: metres)"));
  }

  RawProfile& raw_;
  std::vector<Position>& points_;
  const std::map<std::string, double, std::less<>>& number_;
  const std::string& unit_;
  Log& log_;
};

} // namespace

RawProfile read_simpack(std::string_view text, Log& log) {
  Content content = Parser(text, log).parse();
  if (content.unknown_keys.count > 0) {
    log.note(content.unknown_keys.text("unknown keys ignored"));
  }
  note_gaps(content.gaps, log);
  if (content.weights.count > 0) {
    log.note(content.weights.text("weights other than 1 ignored"));
  }
  if (const auto smooth = content.number.find("approx.smooth");
      smooth != content.number.end() && smooth->second != 0.0) {
    log.note("approx.smooth = " + text_of(smooth->second) + " ignored");
  }
  Processing(content, log).apply();
  content.raw.signs = Signs::stated;
  content.raw.rail_height_down = true;
  return std::move(content.raw);
}

} // namespace wrc::reading
