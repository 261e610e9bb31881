#pragma once

#include "gpu/context.h"

namespace kerf::gpu {

/// The driver has reset the GPU under a running context: all its data is lost. A new context can be
/// made.
class ContextLost : public ContextError {
  public:
    using ContextError::ContextError;
};

/// Throws ContextLost where the driver has reset the GPU. It costs almost nothing, and is called
/// wherever results are read, so that those of a lost context are not used. The variable
/// KERF_LOSE_CONTEXT=FILE, for tests, simulates a reset as soon as that file exists, and removes
/// it.
void requireContext();

}  // namespace kerf::gpu
