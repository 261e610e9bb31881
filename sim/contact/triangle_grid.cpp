#include "sim/contact/triangle_grid.h"

#include <algorithm>
#include <bit>
#include <cstddef>

#include "shaders/shared/body_records.h"
#include "shaders/shared/contact_bindings.h"
#include "shaders/shared/contact_records.h"

namespace kerf {

namespace {

using shared::uint;

gpu::Defines definesFor(TriangleGrid::Pieces pieces) {
    return pieces == TriangleGrid::Pieces::some ? gpu::Defines{{"SOME_PIECES", "1"}}
                                                : gpu::Defines{};
}

}  // namespace

TriangleGrid::TriangleGrid(Pieces pieces)
    : boxesKernel_(gpu::Program::compute("sim/contact/boxes.comp", definesFor(pieces))),
      scan_(gpu::Program::compute("sim/contact/scan.comp")),
      scanBlocks_(gpu::Program::compute("sim/contact/scan_blocks.comp")),
      fill_(gpu::Program::compute("sim/contact/fill.comp")) {}

uint TriangleGrid::bucketsFor(uint triangles) {
    return std::max(shared::kGroupSize, std::bit_ceil(2 * triangles));
}

void TriangleGrid::resize(uint triangles) {
    triangles_ = triangles;
    const std::size_t room = std::max(triangles, 1u);
    const std::size_t buckets = bucketsFor(triangles);
    boxes_.resize(room * sizeof(shared::ContactBox));
    buckets_.resize(room * sizeof(uint));
    entries_.resize(room * sizeof(uint));
    counts_.resize(buckets * sizeof(uint));
    starts_.resize(buckets * sizeof(shared::ContactBucket));
    blocks_.resize((buckets / shared::kGroupSize + 1) * sizeof(uint));
}

void TriangleGrid::fill(const gpu::Buffer& positions) {
    starts_.clear();
    positions.bindStorage(shared::kContactPositionsBinding);
    boxes_.bindStorage(shared::kContactBoxesBinding);
    buckets_.bindStorage(shared::kContactBucketsBinding);
    counts_.bindStorage(shared::kContactCountsBinding);
    starts_.bindStorage(shared::kContactStartsBinding);
    blocks_.bindStorage(shared::kContactBlocksBinding);
    entries_.bindStorage(shared::kContactEntriesBinding);
    boxesKernel_.dispatch(triangles_);
    scan_.dispatch(bucketsFor(triangles_));
    scanBlocks_.dispatch(1);
    fill_.dispatch(triangles_);
}

}  // namespace kerf
