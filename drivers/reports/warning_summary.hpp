/// Which warnings the scenes of a study have, and how many of them.
///
/// Warnings that differ in their numbers only are one kind, shown by the text of its first scene.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "support/scene.hpp"

namespace driver {

/// Lines for the warnings of one scene, each beginning with its grade ("Note: ", "A little over: ",
/// "Do not use: "). Of those that are a little over only the first is shown, unless the scene is
/// not to be used.
std::vector<std::string> lines_of(const std::vector<Warning>& warnings);

class WarningSummary {
public:
  /// Adds the warnings of one scene; the order in which scenes come does not matter.
  void add(std::int64_t scene, const std::vector<Warning>& warnings);
  /// Scenes of a grade that have warnings.
  [[nodiscard]] std::int64_t scenes(std::int32_t grade) const {
    return scenes_[static_cast<std::size_t>(grade)];
  }
  /// "3 of 175 scenes: do not use, shown hollow; 144 a little over the accuracy; 2 with notes",
  /// less what there is none of. `marks`: how a picture shows scenes that are not to be used.
  [[nodiscard]] std::string brief(std::int64_t all, const std::string& marks = "") const;
  /// Each kind of a grade with the number of its scenes and its first text, the most frequent one
  /// first.
  [[nodiscard]] std::vector<std::string> lines(std::int32_t grade) const;
  /// What `program` says of them: how many scenes have which grade, then the first warning of each
  /// kind that is not to be used, one line for those a little over, and notes; nothing without any.
  /// `all`: scenes there are; `where`: the file of all warnings, if there is one.
  [[nodiscard]] std::string text(const std::string& program, std::int64_t all,
                                 const std::string& where = "") const;

private:
  struct Kind {
    std::int64_t scenes = 0;
    std::int64_t first = 0; ///< scene
    std::string text;       ///< of the first one
  };
  std::array<std::int64_t, grade_names.size()> scenes_{};
  std::array<std::map<std::string, Kind>, grade_names.size()> kinds_; ///< by text without numbers
};

} // namespace driver
