#pragma once

#include <memory>

#include "app/scene/editor_scene.h"
#include "gpu/program.h"
#include "sim/run/start/kernel_warm_up.h"

namespace kerf::app {

/// Compiles what the open document will need while nobody does anything. Keeps programs from one
/// document to the next.
class KernelPreparation {
  public:
    /// Where it is not `wanted` it does nothing.
    explicit KernelPreparation(bool wanted) : wanted_(wanted) {}

    /// Another document was opened.
    void begin() { left_ = isNew_ = wanted_; }
    /// Whether something is left to do.
    bool left() const { return left_; }
    /// Somebody does something, or something moves: it waits.
    void interrupt() { quiet_ = 0; }
    /// Goes on by a kernel where nobody has done anything for a while; `elapsedSeconds` since the
    /// last call. Throws gpu::ShaderError, gpu::OutOfMemory.
    void advance(const EditorScene& scene, double elapsedSeconds);

  private:
    gpu::ProgramShelf programs_;
    bool wanted_;
    bool left_ = false;
    double quiet_ = 0;    ///< [s]
    bool isNew_ = false;  ///< warmUp_ is still that of the document before
    std::unique_ptr<KernelWarmUp> warmUp_;
};

}  // namespace kerf::app
