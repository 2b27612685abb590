/// Work in a process of its own, which never outlives the one that waits for it.
#pragma once

#include <functional>
#include <string>

namespace driver {

/// Does the work in a child process; it may write to `messages`, a file descriptor, or replace the
/// process by another program. Returns the text written there, including that of an exception
/// of the work; empty if the child ended well. Never empty otherwise: it says how the child ended.
/// If this process dies, the child is killed (Linux: PR_SET_PDEATHSIG). To be called by a thread
/// that lives as long as the child. Throws Failure if no child can be made.
std::string in_own_process(const std::function<void(int messages)>& work);

} // namespace driver
