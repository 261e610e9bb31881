#pragma once

#include <string>

namespace kerf::gpu {

/// Makes OpenGL's context one that anybody may draw or compute with, for checks at pauses. It names
/// what is bound that others take for unbound, "" for nothing: a vertex array, or a buffer that
/// pixels are written to or read from. The program, storage and uniform buffers, and textures are
/// unbound: each user binds his own, so whoever relies on those from before a pause meets none.
/// Framebuffers, viewport and the switches of drawing stay: each picture sets them first.
std::string clearBindings();

}  // namespace kerf::gpu
