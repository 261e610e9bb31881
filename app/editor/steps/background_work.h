#pragma once

#include "app/scene/editor_scene.h"
#include "gpu/program.h"
#include "sim/run/start/kernel_warm_up.h"

namespace kerf::app {

/// Compiles the kernels of the open document while idle. Keeps programs across documents.
class KernelPreparation {
  public:
    /// Does nothing unless `wanted`.
    explicit KernelPreparation(bool wanted) : wanted_(wanted) {}

    /// Another document was opened.
    void begin() { left_ = isNew_ = wanted_; }
    /// Whether something is left to do.
    bool left() const { return left_; }
    /// Waits, since there is input or motion.
    void interrupt() { quiet_ = 0; }
    /// Compiles a kernel if idle for a while; `elapsedSeconds` since the last call. Throws
    /// gpu::ShaderError, gpu::OutOfMemory.
    void advance(const EditorScene& scene, double elapsedSeconds);

  private:
    gpu::ProgramShelf programs_;
    bool wanted_;
    bool left_ = false;
    double quiet_ = 0;    ///< [s]
    bool isNew_ = false;  ///< warmUp_ is still that of the previous document
    std::unique_ptr<KernelWarmUp> warmUp_;
};

}  // namespace kerf::app
