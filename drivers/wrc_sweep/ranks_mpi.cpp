// The C interface of MPI; its messages are bytes, since all ranks run the same program.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <thread>

#include <mpi.h>

#include "support/scene.hpp"
#include "wrc_sweep/ranks.hpp"

namespace driver {
namespace {

constexpr int to_first = 1; ///< tags of messages
constexpr int from_first = 2;

/// MPI is started for programs of a launcher only: alone, it costs 0.1 s and gains nothing.
bool launched() {
  constexpr std::array variables{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMI_RANK", "PMIX_RANK"};
  return std::any_of(variables.begin(), variables.end(),
                     [](const char* name) { return std::getenv(name) != nullptr; });
}

bool active() {
  int started = 0;
  MPI_Initialized(&started);
  return started != 0;
}

void send(int to, int tag, const std::string& bytes) {
  if (bytes.size() > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    throw Failure("the fields of a scene are too large for a message of MPI (2 GB)");
  }
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, to, tag, MPI_COMM_WORLD);
}

std::string receive(MPI_Status status) {
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  std::string bytes(static_cast<std::size_t>(size), '\0');
  MPI_Recv(bytes.data(), size, MPI_BYTE, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return bytes;
}

} // namespace

Ranks::Ranks() {
  if (!launched()) {
    return;
  }
  int provided = 0;
  MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
}

Ranks::~Ranks() {
  if (active()) {
    MPI_Finalize();
  }
}

const char* Ranks::program() {
  return "wrc_sweep_mpi";
}

bool Ranks::agree(bool go_on) const {
  int word = go_on ? 1 : 0;
  if (size_ > 1) {
    MPI_Bcast(&word, 1, MPI_INT, 0, MPI_COMM_WORLD);
  }
  return word != 0;
}

std::optional<Ranks::Message> Ranks::poll() const {
  if (size_ == 1) {
    return std::nullopt;
  }
  int there = 0;
  MPI_Status status{};
  MPI_Iprobe(MPI_ANY_SOURCE, to_first, MPI_COMM_WORLD, &there, &status);
  if (there == 0) {
    return std::nullopt;
  }
  Message message;
  message.from = status.MPI_SOURCE;
  message.rows = receive(status);
  std::memcpy(&message.wanted, message.rows.data(), sizeof(message.wanted));
  message.rows.erase(0, sizeof(message.wanted));
  return message;
}

void Ranks::answer(int to, const Answer& answer) const {
  std::vector<std::int64_t> numbers = answer.scenes;
  numbers.push_back(answer.last ? 1 : 0);
  std::string bytes(numbers.size() * sizeof(std::int64_t), '\0');
  std::memcpy(bytes.data(), numbers.data(), bytes.size());
  send(to, from_first, bytes);
}

Ranks::Answer Ranks::exchange(const Message& message) const {
  std::string bytes(sizeof(message.wanted), '\0');
  std::memcpy(bytes.data(), &message.wanted, sizeof(message.wanted));
  send(0, to_first, bytes + message.rows);
  // Waiting in MPI_Recv would keep a core busy that a thread of this process needs.
  constexpr std::chrono::microseconds pause{100};
  int there = 0;
  MPI_Status status{};
  while (true) {
    MPI_Iprobe(0, from_first, MPI_COMM_WORLD, &there, &status);
    if (there != 0) {
      break;
    }
    std::this_thread::sleep_for(pause);
  }
  const std::string reply = receive(status);
  Answer answer;
  answer.scenes.resize(reply.size() / sizeof(std::int64_t));
  std::memcpy(answer.scenes.data(), reply.data(), reply.size());
  answer.last = answer.scenes.back() != 0;
  answer.scenes.pop_back();
  return answer;
}

void Ranks::abort(int exit_code) const {
  if (size_ > 1) {
    MPI_Abort(MPI_COMM_WORLD, exit_code);
  }
  std::exit(exit_code);
}

} // namespace driver
