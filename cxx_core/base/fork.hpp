/// Functions called around every fork of the process: before it, then in the parent and in the
/// child.
///
/// Returns whether they will be called. Where processes do not fork, as on Windows, nothing is to
/// be called: true. Thread rule: call it once, while the library is loaded.
#pragma once

namespace wrc {

bool call_around_forks(void (*before)(), void (*in_parent)(), void (*in_child)());

} // namespace wrc
