/// The rows of a study on their way to its results: a file that outlives an interruption.
///
/// Rows are in the order in which they were finished. A row that was not written whole is dropped
/// when the file is opened again.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include "reports/warning_summary.hpp"
#include "support/scene.hpp"
#include "wrc_sweep/study.hpp"

namespace driver {

/// Fields of a patch, one value per element with the longitudinal index fastest.
struct PatchFields {
  std::int32_t side = 0;  ///< 0 left, 1 right
  std::int32_t index = 0; ///< of the patch
  std::int64_t rows = 0;  ///< elements across the rail
  std::int64_t columns = 0;
  std::vector<std::vector<double>> values; ///< in the order of Study::fields
};

struct Row {
  std::int64_t scene = 0;
  wrc_status status = WRC_OK;
  std::string message; ///< why, if the status is another than WRC_OK
  std::vector<Warning> warnings;
  std::vector<double> values; ///< in the order of Study::results; NaN: there is none
  std::vector<PatchFields> patches;
  std::string page; ///< what a page shows of the scene; empty without one
};

/// Grades of all warnings of a scene, and of those that concern each wheel.
struct SceneGrades {
  std::int32_t all = WRC_FINE;
  std::int32_t left = WRC_FINE;
  std::int32_t right = WRC_FINE;
  /// Of a result such as "left.pmax".
  [[nodiscard]] std::int32_t of(const std::string& result) const {
    return result.starts_with("left.") ? left : result.starts_with("right.") ? right : all;
  }
};

/// A row as bytes, and back, for files and messages between processes of the same machine type.
void append_bytes(const Row& row, std::string& bytes);
/// Takes one row off the front. False if the bytes are no whole row.
bool take_row(std::string_view& bytes, Row& row);

class Journal {
public:
  /// What to do with a file that is there already.
  enum class Old { refuse, resume, restart };

  /// Throws Failure for a file of another study, for one that another run is writing, or if there
  /// is one and it is refused.
  Journal(std::filesystem::path path, const Study& study, Old old);
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;
  ~Journal();

  void add(const std::vector<Row>& rows);
  [[nodiscard]] bool has(std::int64_t scene) const { return place(scene) >= 0; }
  [[nodiscard]] std::int64_t count() const { return count_; }
  /// Rows whose status is another than WRC_OK.
  [[nodiscard]] std::int64_t failed() const { return failed_; }
  /// Warnings of the rows, and the grades of one scene that it has.
  [[nodiscard]] const WarningSummary& warnings() const { return warnings_; }
  [[nodiscard]] const SceneGrades& grades_of(std::int64_t scene) const {
    return grades_[static_cast<std::size_t>(scene)];
  }
  /// The row of a scene that it has.
  [[nodiscard]] Row read(std::int64_t scene);
  /// The results have been written: the file is not needed any more.
  void remove();
  /// Lets go of the lock, in a child process that inherited it: it belongs to this run alone.
  void give_up_lock();

private:
  [[nodiscard]] std::int64_t place(std::int64_t scene) const {
    return places_[static_cast<std::size_t>(scene)];
  }
  void lock();
  void open_old(const Study& study);
  void start(const Study& study);
  void note(const Row& row, std::size_t length);

  std::filesystem::path path_;
  int locked_ = -1; ///< descriptor; the system drops the lock with the process
  std::fstream file_;
  std::vector<std::int64_t> places_;  ///< in the file, by scene; -1: not there
  std::vector<std::int64_t> lengths_; ///< in bytes
  std::vector<SceneGrades> grades_;   ///< by scene
  WarningSummary warnings_;
  std::int64_t count_ = 0;
  std::int64_t failed_ = 0;
  std::int64_t end_ = 0;
};

} // namespace driver
