// Without MPI there is this process only.
#include <cstdlib>

#include "support/scene.hpp"
#include "wrc_sweep/ranks.hpp"

namespace driver {

Ranks::Ranks() = default;

Ranks::~Ranks() = default;

const char* Ranks::program() {
  return "wrc_sweep";
}

bool Ranks::agree(bool go_on) const {
  return go_on;
}

std::optional<Ranks::Message> Ranks::poll() const {
  return std::nullopt;
}

void Ranks::answer(int /*to*/, const Answer& /*answer*/) const {}

Ranks::Answer Ranks::exchange(const Message& /*message*/) const {
  throw Failure("there is no other process");
}

void Ranks::abort(int exit_code) const {
  std::exit(exit_code);
}

} // namespace driver
