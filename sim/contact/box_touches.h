#pragma once

#include "gpu/buffer.h"
#include "gpu/program.h"
#include "shaders/shared/box_records.h"
#include "sim/contact/contact_solver.h"
#include "sim/math.h"

namespace kerf {

/// Where a body is and how fast it moves at most: what decides which boxes it can reach.
struct BodyReach {
    Bounds bounds;      ///< [m]
    double speed = 0;   ///< no vertex is faster [m/s]
    double margin = 0;  ///< what it may move besides in a time step [m]
};
/// Where it may come in a time step [m].
Bounds boundsInStep(const BodyReach& reach, const ContactSettings& settings);

/// Where corners and edges of boxes meet triangles, and how these answer: the kernels that static
/// boxes and the body of the blade have in common, with what they work on.
class BoxTouches {
  public:
    /// Compiles the kernels. `defines`: which kind of boxes. Throws gpu::ShaderError.
    explicit BoxTouches(const gpu::Defines& defines);

    /// Makes room for a body. Throws gpu::OutOfMemory.
    void resize(const ContactBody& body);
    void setUniforms(const shared::BoxUniforms& uniforms);
    /// For solve(), and for kernels after it.
    void bind(const ContactBody& body, const gpu::Buffer& boxes) const;
    /// Changes d and X where a box touches a triangle. After bind().
    void solve(const ContactBody& body) const;
    /// The one of the kernels that knows where boxes are.
    const gpu::Program& triangles() const { return triangles_; }

  private:
    gpu::Program triangles_, respond_, apply_;
    gpu::Buffer uniformBuffer_, records_, shares_, sums_;
};

/// What the kernels get to know of a body and the settings: no thickness is kept, and nothing lies
/// deep. `boxCount`: of those in the buffer.
shared::BoxUniforms boxUniforms(const ContactSettings& settings, const ContactBody& body,
                                std::size_t boxCount);

/// Rounded to floats.
shared::vec4 packed(const Vec3& v, double w);
/// Columns of `axes`: unit vectors; `half`: half the size along each [m].
shared::BoxRecord boxRecord(const Vec3& center, const Eigen::Matrix3d& axes, const Vec3& half);

/// One thread each, then a storage barrier.
void runOver(const gpu::Program& kernel, std::uint32_t threads);

}  // namespace kerf
