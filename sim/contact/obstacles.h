#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "shaders/shared/box_records.h"
#include "sim/base/math.h"
#include "sim/contact/blade_body.h"
#include "sim/contact/contact_solver.h"
#include "sim/contact/static_box.h"

namespace kerf {

/// What differs between the kernels of two kinds of obstacles.
struct ObstacleKind {
    gpu::Defines triangles;  ///< for contact with triangles
    std::string vertices;    ///< path of the kernel that keeps vertices out of them
    std::string load;        ///< path of the kernel that measures the load on them; may be empty
    bool movesPiecesOut = false;  ///< as a whole: it wants the boxes of pieces
    bool keepsSides = false;      ///< no triangle crosses them: it wants X as the substep began
    bool seesAround = false;      ///< vertices see others: it wants X before any has been moved
};

/// The distances of contact with obstacles [m].
struct TouchDistances {
    float thickness = 0;  ///< distance kept from them
    float depth = 0;      ///< depth behind a triangle at which contact ends
};

/// Rigid obstacles of one kind: boxes, or what the kernels treat as such.
class Obstacles {
  public:
    virtual ~Obstacles() = default;
    /// Writes the records of those that reach into `bounds` in the coming time step [m], for all of
    /// its substeps. Returns the number in a substep; if 0, nothing was written. Throws
    /// gpu::OutOfMemory.
    virtual std::size_t write(const Bounds& bounds, gpu::Buffer& records) const = 0;
    /// Whether one that reaches into `bounds` is so thin that skin with edges of `edgeLength` may
    /// bend sharply around it: then triangles must stay on their side of it.
    virtual bool mayPierce(const Bounds& /*bounds*/, double /*edgeLength*/) const { return false; }
    /// `edgeLength`: see contactEdgeLength() [m].
    virtual TouchDistances distances(const ContactSettings& settings, double edgeLength) const = 0;
};

/// A vector and a fourth number, rounded to floats.
shared::vec4 packed(const Vec3& v, double w);
/// The record of a box. Columns of `axes`: unit vectors; `half`: half the size along each [m].
shared::BoxRecord boxRecord(const Vec3& center, const Eigen::Matrix3d& axes, const Vec3& half);

/// Static boxes as obstacles; a surface keeps a thickness away from them.
class BoxObstacles final : public Obstacles {
  public:
    static ObstacleKind kind();
    /// Null where there are no boxes.
    static std::unique_ptr<const Obstacles> of(std::vector<StaticBox> boxes);

    explicit BoxObstacles(std::vector<StaticBox> boxes) : boxes_(std::move(boxes)) {}
    std::size_t write(const Bounds& bounds, gpu::Buffer& records) const override;
    bool mayPierce(const Bounds& bounds, double edgeLength) const override;
    TouchDistances distances(const ContactSettings& settings, double edgeLength) const override;

  private:
    std::vector<StaticBox> boxes_;
};

/// The body of the blade as an obstacle: like a static box, but it moves, tapers towards its edge,
/// and holds apart the walls of the slit that the edge has cut.
class BladeObstacle final : public Obstacles {
  public:
    static ObstacleKind kind();
    /// Null where the blade does not push.
    static std::unique_ptr<const Obstacles> of(std::optional<BladeMotion> motion);

    /// The motion in the next step, with one more frame than substeps.
    explicit BladeObstacle(BladeMotion motion) : motion_(std::move(motion)) {}
    std::size_t write(const Bounds& bounds, gpu::Buffer& records) const override;
    TouchDistances distances(const ContactSettings& settings, double edgeLength) const override;

  private:
    BladeMotion motion_;
};

}  // namespace kerf
