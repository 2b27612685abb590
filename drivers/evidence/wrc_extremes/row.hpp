/// One point of the study: what was set, what came out, and how far it can be trusted.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace extremes {

enum class Verdict {
  held,    ///< solved, residuals and errors within what was requested, no warning
  warned,  ///< solved, with a warning or as not converged: which says what is wrong
  none,    ///< no contact or no load: reported so, with no forces
  refused, ///< a status and a text, no result
  faded,   ///< solved, and worse than requested without a warning
  wrong    ///< residuals beyond all bounds, a fault of the library, or a refusal without a text
};
const char* name_of(Verdict verdict);

struct Row {
  std::string quantity;
  std::string base;    ///< what is held while the quantity varies
  std::string setting; ///< in words
  double value = 0.0;  ///< of the quantity; of shapes a number in their order

  Verdict verdict = Verdict::wrong;
  std::string status;             ///< of the library
  std::string message;            ///< its error text, or its warnings
  std::optional<double> pmax;     ///< MPa
  std::optional<double> approach; ///< mm; of a scene the vertical one
  std::optional<double> fill;     ///< fraction of elements under pressure
  /// Recomputed by this program (gap_problem.hpp).
  std::optional<double> load_balance;
  std::optional<double> overlap;
  std::optional<double> complementarity;
  /// Largest error of the pressures over the largest pressure, at the floor of the tolerance,
  /// against elimination in extended precision on the same distances.
  std::optional<double> pressure_error;
  /// Error of pmax and approach, against `truth`.
  std::optional<double> error;
  std::string truth;  ///< "finer", "closed form", "unscaled"
  double asked = 0.0; ///< accuracy or tolerance
};

/// A setting or base in words, for example "load 5 N".
std::string in_words(const std::string& name, double value, const std::string& unit = "");

using Measurement = std::function<void(Row& row, std::uint64_t seed)>;

/// A point before it is measured.
struct Point {
  std::string quantity;
  std::string base;
  std::string setting;
  double value = 0.0;
  bool quick = false; ///< part of the short study
  Measurement measure;
};

/// How a quantity is shown.
struct Quantity {
  std::string name;  ///< of files and of --only
  std::string title; ///< of the picture
  std::string label; ///< of its axis
  bool logarithmic = false;
  bool shapes = false; ///< no numbers but names
};

/// All quantities, and all points in their order.
const std::vector<Quantity>& quantities();
std::vector<Point> all_points();

/// Points of each kind.
void add_normal_points(std::vector<Point>& points);
void add_scene_points(std::vector<Point>& points);
void add_profile_points(std::vector<Point>& points);
void add_state_points(std::vector<Point>& points);

} // namespace extremes
