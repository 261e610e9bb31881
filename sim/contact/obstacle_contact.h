#pragma once

#include "gpu/buffer.h"
#include "gpu/kernel_way.h"
#include "gpu/program.h"
#include "gpu/read_back.h"
#include "sim/base/math.h"
#include "sim/contact/blade_body.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/obstacles.h"

namespace kerf {

/// The bounds and the greatest speed of a body, which determine the obstacles in reach.
struct BodyReach {
    Bounds bounds;            ///< [m]
    double speed = 0;         ///< no vertex is faster [m/s]
    double margin = 0;        ///< further motion in a time step [m]
    double floor = kNoFloor;  ///< height, below which nothing leaves an obstacle [m]
    static constexpr double kNoFloor = -1e30;
};

/// Contact of a body with obstacles of one kind, on the GPU, with the same bits for any number of
/// threads: their corners and edges against triangles first, then vertices against them. Obstacles
/// that the body cannot reach in a time step cost nothing.
class ObstacleContact {
  public:
    explicit ObstacleContact(ObstacleKind kind) : kind_(std::move(kind)) {}

    /// All obstacles of the kind; null for none. The first compiles the kernels: throws
    /// gpu::ShaderError.
    void setObstacles(std::unique_ptr<const Obstacles> obstacles);
    /// A new body, or one that has more vertices or triangles. `edgeLength`: see
    /// contactEdgeLength() [m].
    void setBody(const ContactBody& body, double edgeLength);
    void setSettings(const ContactSettings& settings) { settings_ = settings; }

    /// Measures from now on the load on obstacles of a kind that has a kernel for it; changes
    /// nothing else.
    void measureLoad(bool wanted) { measuresLoad_ = wanted; }
    /// Requests the load of the last time step, if it was measured.
    void askForLoad(gpu::ReadBack& back);
    /// Reads the requested load; waits for the GPU.
    void takeLoad(const gpu::ReadBack& back);
    /// The load read last; zero if it was not measured.
    const BladeLoad& load() const { return load_; }

    /// Begins a time step, before its first substep. Compiles what the first thin obstacle in reach
    /// needs. Throws gpu::ShaderError, gpu::OutOfMemory.
    void beginStep(const BodyReach& reach);
    /// Whether an obstacle is in reach in this step.
    bool mayTouch() const { return reached_ > 0; }
    /// Binds what kernels of implicit steps have of obstacles (implicit_records.h).
    void bindMeetings(gpu::KernelWay way) const;
    /// Binds the loads of vertices, if they are measured in this step, and returns whether they
    /// are.
    bool bindLoads() const;

    /// Begins a step that is not divided, before anything moves X: triangles stay on their present
    /// side of thin obstacles.
    void beginSubstep();
    /// In a sweep of plain PBD: limits d where it enters an obstacle, and moves X out of obstacles
    /// inside the body.
    void respond();
    /// After an implicit step of X that lasted `h` [s]: keeps triangles on their side of thin
    /// obstacles, where `velocities` change too.
    void keepSides(const gpu::Buffer& velocities, double h);

  private:
    struct Kernels {
        gpu::Program triangles, respond, apply, vertices;
        std::optional<gpu::Program> pieces, planes, sides, load;
        std::optional<gpu::Program> planesOfStep, sidesOfStep;  ///< of implicit steps
    };
    void makeRoom();
    void boundPieces();
    void beginLoad();
    void addLoad();
    void bind() const;

    ObstacleKind kind_;
    std::unique_ptr<const Obstacles> obstacles_;
    std::optional<Kernels> kernels_;
    ContactBody body_;
    ContactSettings settings_;
    double edgeLength_ = 0;      ///< [m]
    std::uint32_t reached_ = 0;  ///< how many in this step
    bool keepsSides_ = false;
    bool measuresLoad_ = false;
    gpu::Buffer uniforms_, records_;
    gpu::Buffer touches_, shares_, sums_;
    gpu::Buffer pieceBounds_;  ///< at the beginning of the step
    gpu::Buffer start_;        ///< X at the beginning of the substep
    gpu::Buffer around_;       ///< X before an obstacle moves any vertex
    gpu::Buffer before_;       ///< d before obstacles change it, where the load is measured
    gpu::Buffer loads_;        ///< VertexLoad
    std::optional<std::size_t> place_;  ///< of the requested loads
    BladeLoad load_;
};

}  // namespace kerf
