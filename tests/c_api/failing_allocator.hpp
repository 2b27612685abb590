/// An operator new that refuses memory when told to, for the library too.
#pragma once

/// Allocations of this thread that still succeed; negative: all do.
extern constinit thread_local long allocations_left;
