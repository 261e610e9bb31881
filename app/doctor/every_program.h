#pragma once

#include <vector>

#include "gpu/program_record.h"

namespace kerf::app {

/// Links every program that Kerf can come to need on the driver of the current context, of both
/// tiers of quality, which takes seconds, and runs none. Throws gpu::ShaderError for the first that
/// does not compile or link, gpu::OutOfMemory.
std::vector<gpu::LinkedProgram> everyProgram();

}  // namespace kerf::app
