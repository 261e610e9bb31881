#pragma once

#include <cstdint>

#include "gpu/buffer.h"

namespace kerf {

/// The buffers of what acts on the running body: the solver's own, for overlays. A buffer without
/// entries may be null. Edges are those of the triangles (see BodyView).
struct ConstraintView {
    const gpu::Buffer* bends = nullptr;         ///< BendRecord
    const gpu::Buffer* ispcs = nullptr;         ///< IspcConstraint
    const gpu::Buffer* pulls = nullptr;         ///< PullRecord, of the last step
    const gpu::Buffer* contacts = nullptr;      ///< ContactRecord, of the last substep
    const gpu::Buffer* contactState = nullptr;  ///< ContactState: how many of them count
    std::uint32_t bendCount = 0;
    std::uint32_t ispcCount = 0;
    std::uint32_t pullCount = 0;
    std::uint32_t mostContacts = 0;  ///< 0 where contact is off
};

}  // namespace kerf
