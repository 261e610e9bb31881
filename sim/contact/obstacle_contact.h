#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "gpu/read_back.h"
#include "sim/base/math.h"
#include "sim/contact/blade_load.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/obstacles.h"

namespace kerf {

/// The place and the greatest speed of a body, which decide what obstacles it can reach.
struct BodyReach {
    Bounds bounds;            ///< [m]
    double speed = 0;         ///< no vertex is faster [m/s]
    double margin = 0;        ///< what it may move besides in a time step [m]
    double floor = kNoFloor;  ///< height, below which nothing leaves an obstacle [m]
    static constexpr double kNoFloor = -1e30;
};

/// Contact of a body with obstacles of one kind, on the GPU, with the same bits for any number of
/// threads: their corners and edges against triangles first, then vertices against them, which have
/// the last word. Obstacles that the body cannot reach in a time step cost nothing.
class ObstacleContact {
  public:
    explicit ObstacleContact(ObstacleKind kind) : kind_(std::move(kind)) {}

    /// All there are, of the kind; null: none. Compiles the kernels with the first: throws
    /// gpu::ShaderError.
    void setObstacles(std::unique_ptr<const Obstacles> obstacles);
    /// A new body, or one that has more vertices or triangles. `edgeLength`: see
    /// contactEdgeLength() [m].
    void setBody(const ContactBody& body, double edgeLength);
    void setSettings(const ContactSettings& settings) { settings_ = settings; }

    /// Measures from now on what the body does to obstacles of a kind with a kernel for that;
    /// changes nothing else.
    void measureLoad(bool wanted) { measuresLoad_ = wanted; }
    /// Asks for what it did to them in the last time step, as far as it was measured.
    void askForLoad(gpu::ReadBack& back);
    /// Takes up what was sent; waits for the GPU.
    void takeLoad(const gpu::ReadBack& back);
    /// What was taken up last; nothing where it was not measured.
    const BladeLoad& load() const { return load_; }

    /// Begins a time step, before its first substep. Compiles what the first thin obstacle in reach
    /// needs. Throws gpu::ShaderError, gpu::OutOfMemory.
    void beginStep(const BodyReach& reach);
    /// Whether an obstacle is in reach in this step.
    bool mayTouch() const { return reached_; }
    /// Begins a substep, before anything moves X: triangles are kept on the side of thin obstacles
    /// where they are now.
    void beginSubstep();
    /// Changes d where it leads into an obstacle, and moves X out of where one is inside the body.
    void respond(int substep);

  private:
    struct Kernels {
        gpu::Program triangles, respond, apply, vertices;
        std::optional<gpu::Program> pieces, planes, sides, load;
    };
    void makeRoom();
    void boundPieces();
    void beginLoad();
    void addLoad(int substep);
    void bind() const;

    ObstacleKind kind_;
    std::unique_ptr<const Obstacles> obstacles_;
    std::optional<Kernels> kernels_;
    ContactBody body_;
    ContactSettings settings_;
    double edgeLength_ = 0;  ///< [m]
    bool reached_ = false;   ///< in this step
    bool keepsSides_ = false;
    bool measuresLoad_ = false;
    gpu::Buffer uniforms_, records_;
    gpu::Buffer touches_, shares_, sums_;
    gpu::Buffer pieceBounds_;  ///< at the beginning of the step
    gpu::Buffer start_;        ///< X at the beginning of the substep
    gpu::Buffer around_;       ///< X before an obstacle moves any vertex
    gpu::Buffer before_;       ///< d before obstacles change it, where the load is measured
    gpu::Buffer loads_;        ///< VertexLoad
    std::optional<std::size_t> place_;  ///< of the loads that were asked for
    BladeLoad load_;
};

}  // namespace kerf
