/// Keys that scenes of earlier versions had, and what takes their place.
///
/// An error names it wherever such a key is set or read. Thread rule: constants.
#pragma once

#include <array>
#include <string_view>

namespace wrc {

struct RemovedKey {
  std::string_view name;
  std::string_view successor; ///< a sentence
};

inline constexpr std::array removed_keys{
    RemovedKey{"load.vertical", "use load.both"},
    RemovedKey{"load.normal", "use load.both with load.of = \"normal\""},
    RemovedKey{"load.total_vertical", "use load.both with load.of = \"total\""},
    RemovedKey{"load.total_left", "use load.left with load.of = \"total\""},
    RemovedKey{"load.total_right", "use load.right with load.of = \"total\""},
    RemovedKey{"track.cant", "use track.inclination, which is that of the rails"},
    RemovedKey{"track.superelevation",
               "gravity and cant deficiency belong to the vehicle's loads: use load.left and "
               "load.right"},
};

} // namespace wrc
