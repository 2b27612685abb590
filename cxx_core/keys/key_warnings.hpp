/// Keys that were set but have no effect, since another one takes their place, and keys with values
/// in other units, by all appearances.
///
/// One table says which key leaves which others without effect: a prescribed height the loads,
/// creepages the motion; and which values no wheel on a rail has. It counts what a scene holds, so
/// the order of keys matters where setting one resets another. A key that is set to its default
/// sets nothing. A check costs some bits, and texts are put together when they are read. Thread
/// rule: plain values.
///
/// Not found here: a key of both sides that those of each side overrule, and one that has an effect
/// only with certain values of others, such as solve.tolerance; creepages, which are those of
/// patches (creep/creep_warnings.cpp).
#pragma once

#include <bitset>
#include <cstddef>
#include <cstdint>

#include "base/warning.hpp"
#include "keys/scene.hpp"

namespace wrc {

class KeyWarnings {
public:
  KeyWarnings() = default;
  explicit KeyWarnings(const Scene& scene);

  [[nodiscard]] std::size_t count() const { return found_.count(); }
  /// Appends a warning for each: "load.left is not used: pose.vertical is set".
  void append_to(Warnings& all) const;

private:
  std::bitset<64> found_; ///< by rows of the table
  KeySet given_;
};

/// Those that every step of a vehicle code overrules, which is no contradiction: loads and torque.
const KeySet& keys_overruled_by_steps();

} // namespace wrc
