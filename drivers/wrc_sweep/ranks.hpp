/// Processes that share a study: those that mpirun has started, or this one alone.
///
/// Rank 0 hands out scenes and keeps the rows; the others send finished rows and get new scenes in
/// return, one message each way. ranks_mpi.cpp has this with MPI, ranks_none.cpp without.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace driver {

class Ranks {
public:
  /// Joins the other processes if a launcher of MPI programs has started this one.
  Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  ~Ranks();

  /// What the program is called: wrc_sweep, or with MPI wrc_sweep_mpi.
  static const char* program();
  [[nodiscard]] int rank() const { return rank_; }
  [[nodiscard]] int size() const { return size_; }

  /// All ranks call this once: true if rank 0 says so.
  [[nodiscard]] bool agree(bool go_on) const;

  struct Message {
    int from = 0;
    std::int64_t wanted = 0; ///< scenes it could begin
    std::string rows;        ///< finished, as of append_bytes
  };
  struct Answer {
    std::vector<std::int64_t> scenes;
    bool last = false; ///< there are no more
  };
  /// Rank 0: a message if one has come, which has to be answered.
  [[nodiscard]] std::optional<Message> poll() const;
  void answer(int to, const Answer& answer) const;
  /// Other ranks: sends a message to rank 0 and waits for the answer.
  [[nodiscard]] Answer exchange(const Message& message) const;

  /// Ends all processes at once, after a failure.
  [[noreturn]] void abort(int exit_code) const;

private:
  int rank_ = 0;
  int size_ = 1;
};

} // namespace driver
