#pragma once

namespace kerf::gpu {

/// Puts the threads of llvmpipe on a processor each, where it has one for every processor that this
/// process may use: else two of them may share one for seconds while another idles. Without other
/// drivers' threads it does nothing.
void spreadDriverThreads();

}  // namespace kerf::gpu
