#include "gpu/traffic.h"

#include <glad/gl.h>

namespace kerf::gpu {

Traffic operator-(const Traffic& now, const Traffic& before) {
    return {now.dispatches - before.dispatches, now.indirect - before.indirect,
            now.barriers - before.barriers,     now.waits - before.waits,
            now.reads - before.reads,           now.bytesUp - before.bytesUp,
            now.bytesDown - before.bytesDown};
}

Traffic& traffic() {
    static Traffic count;
    return count;
}

void barrier(std::uint32_t bits) {
    ++traffic().barriers;
    glMemoryBarrier(bits);
}

namespace {
std::optional<std::uint64_t> visible;  // dispatches before the last barrier of this context
}

void updateBarrier() {
    if (visible != traffic().dispatches) {
        barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        visible = traffic().dispatches;
    }
}

void noteOtherContext() {
    visible.reset();
}

}  // namespace kerf::gpu
