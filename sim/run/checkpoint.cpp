#include "sim/run/checkpoint.h"

#include <stdexcept>

#include "sim/base/byte_archive.h"
#include "sim/run/simulation_state.h"
#include "sim/run/state_hash.h"

namespace kerf {

namespace {

/// What a checkpoint has besides the body.
template <class Archive, class Input, class Clock>
void visitRun(Archive& io, Input& input, Clock& clock) {
    io(input.params, input.iterations, input.implicitSteps, input.boxes, input.timeRuns, clock);
}

}  // namespace

std::optional<std::vector<std::byte>> bytesOf(const Checkpoint& checkpoint) {
    const Checkpoint::Content& content = checkpoint.content();
    const Snapshot& body = *content.body;
    if (content.input.blade.isPlaced() || content.input.blade.isTold() || body.cutter.inStroke()) {
        return std::nullopt;
    }
    ByteWriter to;
    to.bytes.reserve(snapshotBytes(body.mesh));
    const StateHash uncut = hashMesh(body.uncut->mesh);
    const StateHash state = hashScene(body.mesh, content.input.boxes);
    to(state, uncut, body.uncut->models, body.mesh, body.body);
    body.cutter.write(to);
    to(body.pages, body.memory, body.contact);
    visitRun(to, content.input, content.clock);
    return std::move(to.bytes);
}

bool Simulation::goTo(const std::vector<std::byte>& bytes) {
    try {
        state_->goTo(bytes);
        return true;
    } catch (const std::out_of_range&) {
        reset();
        return false;
    }
}

/// Throws std::out_of_range where they don't fit.
void Simulation::State::goTo(const std::vector<std::byte>& bytes) {
    ByteReader from(bytes);
    StateHash hash;
    from(hash);
    const std::shared_ptr<const UncutBody> uncut = uncutOf(from);
    SurfaceMesh mesh;
    from(mesh);
    *uncut->running = mesh;
    BodyUpdater updater(uncut->body);
    from(updater);
    Snapshot stored{
        std::move(mesh), std::move(updater), Cutter(uncut->cutter, from), {}, {}, {}, uncut};
    from(stored.pages, stored.memory, stored.contact);
    visitRun(from, input, output.clock);
    if (hashScene(stored.mesh, input.boxes).value() != hash.value()) {
        throw std::out_of_range("another state");
    }
    log.clear();
    setBoxes(input.boxes);
    restoreBody(std::make_shared<const Snapshot>(std::move(stored)));
}

/// The uncut body that was written.
std::shared_ptr<const UncutBody> Simulation::State::uncutOf(ByteReader& from) {
    StateHash hash;
    std::vector<PlacedModel> models;
    from(hash, models);
    if (models.size() != body.first->models.size()) {
        throw std::out_of_range("other models");
    }
    std::shared_ptr<const UncutBody> uncut = preparedAs(models);
    if (uncut == nullptr) {
        uncut = makeUncutBody(placedMesh(*body.first, models), models);
    }
    if (hashMesh(uncut->mesh).value() != hash.value()) {
        throw std::out_of_range("other meshes");
    }
    return uncut;
}

}  // namespace kerf
