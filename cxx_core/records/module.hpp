/// The three modules of the method, in their order.
#pragma once

namespace wrc {

enum class Module { geometry, remesh, mechanics };

} // namespace wrc
