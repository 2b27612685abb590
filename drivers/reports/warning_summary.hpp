/// Which warnings the scenes of a study have, and how many of them.
///
/// Warnings that differ in their numbers only are one kind, shown by the text of its first scene.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace driver {

/// What the warnings of a scene are of, as bits.
enum WarningsOf : unsigned { of_profiles = 1, of_left_wheel = 2, of_right_wheel = 4 };
unsigned warnings_of(const std::vector<std::string>& warnings);
/// Which of them concern a result such as "left.pmax".
unsigned warnings_that_concern(const std::string& result);

class WarningSummary {
public:
  /// Adds the warnings of one scene; the order in which scenes come does not matter.
  void add(std::int64_t scene, const std::vector<std::string>& warnings);
  /// Scenes with warnings.
  [[nodiscard]] std::int64_t scenes() const { return scenes_; }
  /// Each kind with the number of its scenes and its first text, the most frequent one first.
  [[nodiscard]] std::vector<std::string> lines() const;
  /// What `program` says of them: the first warning of each kind with the number of its scenes, the
  /// most frequent kind first; nothing if there is none. `all`: scenes there are; `where`: the file
  /// of all warnings.
  [[nodiscard]] std::string text(const std::string& program, std::int64_t all,
                                 const std::string& where) const;

private:
  struct Kind {
    std::int64_t scenes = 0;
    std::int64_t first = 0; ///< scene
    std::string text;       ///< of the first one
  };
  std::int64_t scenes_ = 0;
  std::map<std::string, Kind> kinds_; ///< by the text without its numbers
};

} // namespace driver
