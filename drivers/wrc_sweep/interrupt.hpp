/// Ctrl-C and SIGTERM: the study ends after the scenes being solved.
#pragma once

namespace driver {

void catch_interrupts();
/// Whether one has come. The second one ends the program at once.
bool interrupted();

} // namespace driver
