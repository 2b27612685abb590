/// What the paper says about its figures, and how the results of a run are judged by it.
///
/// Numbers come from the tables of the studies in drivers/studies; nothing is judged by eye.
/// Lateral displacement is positive to the left; roll and yaw have our sign unless a text says
/// otherwise.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace driver {

enum class Verdict { confirmed, partly, not_confirmed };

struct Finding {
  Verdict verdict = Verdict::not_confirmed;
  std::string numbers; ///< what the verdict rests on
};

/// One statement of the paper, in our words.
struct Claim {
  std::string text;
  /// Judges it by the results in a folder.
  std::function<Finding(const std::filesystem::path& folder)> judge;
  std::string why_not; ///< the reason, if it is not confirmed for a wheel
};

struct Figure {
  int number = 0;
  std::string title;
  std::vector<std::string> pictures;
  std::vector<Claim> claims;
};

/// Figures 6, 7, 9, 10 and 12: contact geometry.
std::vector<Figure> geometry_figures();
/// Figures 8, 11 and 13: pressures.
std::vector<Figure> pressure_figures();

} // namespace driver
