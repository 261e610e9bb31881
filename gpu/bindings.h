#pragma once

namespace kerf::gpu {

/// Prepares the OpenGL context for other users, for checks at pauses. Returns what is still bound
/// but must not be, "" for nothing: a vertex array, or a pixel buffer. Unbinds the program, storage
/// and uniform buffers, and textures, so that code relying on bindings from before a pause fails.
/// Framebuffers, viewport and drawing state stay: each frame sets them first.
std::string clearBindings();

}  // namespace kerf::gpu
