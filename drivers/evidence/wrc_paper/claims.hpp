/// What the paper says about its figures, and how the results of a run compare with it.
///
/// Numbers come from the tables of the studies in drivers/studies; nothing is compared by eye.
/// Lateral displacement is positive to the left; roll and yaw have our sign unless a text says
/// otherwise.
#pragma once

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <ostream>
#include <string>
#include <vector>

#include "support/numbers.hpp"

namespace driver {

enum class Verdict { confirmed, partly, not_confirmed };

struct Finding {
  Verdict verdict = Verdict::not_confirmed;
  std::string numbers; ///< what the verdict rests on
};

/// What decides a statement that the results do not confirm.
enum class Ground {
  profile, ///< the wheel, which the paper does not print: it may hold with the paper's own
  proof,   ///< a symmetry of the contact: it holds with no profile
  numbers  ///< what any profile shows
};

/// One statement of the paper, in our words.
struct Claim {
  std::string text;
  /// Compares it with the results in a folder.
  std::function<Finding(const std::filesystem::path& folder)> judge;
  std::string why_not; ///< the reason, if it is not confirmed for a wheel
  Ground ground = Ground::profile;
};

struct Figure {
  int number = 0; ///< 0: the paper's conclusions
  std::string title;
  std::vector<std::string> pictures;
  std::vector<Claim> claims;
};

/// Figures 6, 7, 9, 10 and 12: contact geometry.
std::vector<Figure> geometry_figures();
/// Figures 8, 11 and 13: pressures.
std::vector<Figure> pressure_figures();
/// The paper's conclusions, each judged by the statements of figures that it sums up.
Figure conclusions(const std::vector<Figure>& figures);

/// A number of which only the size matters.
inline std::string small(double value) {
  return general(value, 1);
}

inline Verdict verdict_of(bool holds) {
  return holds ? Verdict::confirmed : Verdict::not_confirmed;
}

inline Verdict graded(bool confirmed, bool partly) {
  return confirmed ? Verdict::confirmed : partly ? Verdict::partly : Verdict::not_confirmed;
}

/// Confirmed if both hold, partly if one does.
inline Verdict verdict_of(bool one, bool other) {
  return graded(one && other, one || other);
}

inline double width_of(const std::vector<double>& values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  return *most - *least;
}

/// Largest difference between the values at x and at -x, for curves over positions symmetric to
/// zero.
inline double asymmetry(const std::vector<double>& values) {
  double most = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    most = std::max(most, std::abs(values[i] - values[values.size() - 1 - i]));
  }
  return most;
}

/// Writes the page from the results below a folder: S1002/, LM/ and LMA/ as scripts/paper.sh makes
/// them. Pictures are linked beside it. Throws Failure for a result that is missing.
void write_report(const std::filesystem::path& folder, std::ostream& out);

} // namespace driver
