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

}  // namespace

TriangleGrid::TriangleGrid()
    : boxesKernel_(gpu::Program::compute("sim/contact/boxes.comp")),
      scan_(gpu::Program::compute("sim/contact/scan.comp")),
      scanBlocks_(gpu::Program::compute("sim/contact/scan_blocks.comp")),
      fill_(gpu::Program::compute("sim/contact/fill.comp")),
      summarize_(gpu::Program::compute("sim/contact/summarize.comp")) {}

uint TriangleGrid::bucketsFor(uint triangles) {
    return std::max(shared::kGroupSize, std::bit_ceil(triangles) / 2);
}

void TriangleGrid::resize(uint triangles) {
    triangles_ = triangles;
    const std::size_t room = std::max(triangles, 1u);
    const std::size_t buckets = bucketsFor(triangles);
    boxes_.resize(room * sizeof(shared::ContactBox));
    homes_.resize(room * sizeof(uint));
    entries_.resize(room * sizeof(uint));
    counts_.resize(buckets * sizeof(uint));
    starts_.resize(buckets * sizeof(uint));
    buckets_.resize(buckets * sizeof(shared::ContactBucket));
    blocks_.resize(buckets / shared::kGroupSize * sizeof(uint));
}

void TriangleGrid::fill(const gpu::Buffer& positions) {
    positions.bindStorage(shared::kContactPositionsBinding);
    boxes_.bindStorage(shared::kContactBoxesBinding);
    homes_.bindStorage(shared::kContactHomesBinding);
    buckets_.bindStorage(shared::kContactBucketsBinding);
    counts_.bindStorage(shared::kContactCountsBinding);
    starts_.bindStorage(shared::kContactStartsBinding);
    blocks_.bindStorage(shared::kContactBlocksBinding);
    entries_.bindStorage(shared::kContactEntriesBinding);
    boxesKernel_.dispatch(triangles_);
    scan_.dispatch(bucketsFor(triangles_));
    scanBlocks_.dispatch(1);
    fill_.dispatch(triangles_);
    summarize_.dispatch(bucketsFor(triangles_));
}

}  // namespace kerf
