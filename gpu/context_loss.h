#pragma once

#include "gpu/context.h"

namespace kerf::gpu {

/// The driver has reset the GPU under a running context: all that was on it is gone. A new context
/// can be made.
class ContextLost : public ContextError {
  public:
    using ContextError::ContextError;
};

/// Throws ContextLost where the driver has reset the GPU. It costs next to nothing, and is called
/// wherever results come back, so that nothing is made of what a lost context leaves there. The
/// variable KERF_LOSE_CONTEXT=FILE, for tests, plays a reset as soon as that file is there, and
/// takes the file away.
void requireContext();

}  // namespace kerf::gpu
