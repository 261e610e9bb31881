#pragma once

#include <sys/types.h>

namespace kerf::gpu {

/// Processors that this process may use, ascending.
std::vector<int> processors();
/// Keeps a thread on a processor; 0: the calling one.
void moveThread(pid_t thread, int processor);

/// Puts the threads of llvmpipe on a processor each, where it has one for every processor that this
/// process may use: else two of them may share one for seconds while another idles. Without other
/// drivers' threads it does nothing.
void spreadDriverThreads();

}  // namespace kerf::gpu
