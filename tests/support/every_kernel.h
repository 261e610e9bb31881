#pragma once

namespace kerf {

/// Links every kernel that a simulation can come to need on the driver of the current context, the
/// way that gpu::kernelWay() gives, and runs none. Throws gpu::ShaderError, gpu::OutOfMemory.
void linkEveryKernel();

}  // namespace kerf
