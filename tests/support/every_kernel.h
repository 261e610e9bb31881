#pragma once

namespace kerf {

/// Links every kernel that a simulation may need on the driver of the current context, as chosen by
/// gpu::kernelWay(), and dispatches most. Throws gpu::ShaderError, gpu::OutOfMemory.
void linkEveryKernel();

}  // namespace kerf
