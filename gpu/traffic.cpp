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

void updateBarrier() {
    static std::uint64_t visible = 0;  // dispatches before the last one
    if (visible != traffic().dispatches) {
        barrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        visible = traffic().dispatches;
    }
}

}  // namespace kerf::gpu
