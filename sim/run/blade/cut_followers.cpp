#include "sim/run/blade/cut_followers.h"

#include "sim/base/math.h"
#include "sim/base/pausing.h"
#include "sim/cut/cut_change.h"
#include "sim/mesh/invariants.h"

namespace kerf {

namespace {

/// So that both sides go on from the same numbers. Returns what the GPU is to hold.
BodyState roundVertices(SurfaceMesh& mesh, const std::vector<std::uint32_t>& vertices) {
    for (const std::uint32_t vertex : vertices) {
        const int v = static_cast<int>(vertex);
        mesh.setPosition(v, nearestFloats(mesh.position(v)));
        mesh.setVelocity(v, nearestFloats(mesh.velocity(v)));
    }
    return stateOf(mesh, vertices);
}

}  // namespace

// Whatever follows a step of the cutter as a whole has its row here, and nowhere else. Each row may
// read what those above it have brought up to date. What the cutter looks up within a step has
// followed before: CutBody::follow in sim/cut/stroke/cut_body.cpp.
void followCut(const CutDelta& delta, RunningBody& body, UndoHistory& history,
               SimulationOutput& output) {
    BodyMemory& memory = body.memory;
    const bool wasOpen = body.isOpen();
    // Positions and velocities: what is written becomes what the GPU will hold.
    const std::vector<std::uint32_t> written = rewrittenVertices(body.mesh(), delta);
    const BodyState state = roundVertices(body.mesh(), written);
    // What is torn, not cut; the model, by the mesh.
    if (memory.tear.goesOn) {
        body.mesh().noteTorn(delta.firstNewVertex);
    }
    pausePoint();
    body.whole = false;
    const BodyChange change = body.updater->update(delta);
    pausePoint();
    // The solver, by the records of the model that changed.
    body.solver.update(body.model(), change, written, state);
    pausePoint();
    // The measure, by the solver: new pieces have volumes of their own.
    if (change.pieces.piecesChanged || body.isOpen() != wasOpen) {
        memory.measure = body.solver.measure();
        pausePoint();
    }
    body.becomeWhole();
    // The volumes at which pieces are held, by the measure; and the solver with them.
    memory.volumeTargets.follow(change.pieces.source, body.model(), memory.measure.pieceVolumes);
    // What is drawn back to its shape, by the pieces.
    memory.recovery.follow(change.pieces.source);
    body.holdVolumes();
    // The pins and forces, by the mesh; and the solver with them.
    if (memory.pins.follow(body.mesh(), delta)) {
        body.holdPins();
    }
    // The bonds of tears, by the mesh.
    if (memory.tear.goesOn) {
        memory.cohesion.bond(body.mesh(), delta, body.cutter->strokeNumber(),
                             memory.tear.firstVertex);
    }
    memory.cohesion.follow(body.mesh());
    // The pieces that are measured in double precision, once somebody asks.
    body.forgetPieces();
    // The pins that an undo would bring back.
    history.followCut(body.mesh(), delta);
    // Last of all the check, and what a person is told.
    const std::string defect = checkClosedManifoldAround(body.mesh(), changedTriangles(delta));
    memory.closed = memory.closed && defect.empty();
    if (!defect.empty()) {
        output.say("the cut left the mesh open: {}", defect);
    }
}

void endTear(RunningBody& body, UndoHistory& history, SimulationOutput& output) {
    if (body.memory.tear.goesOn) {
        followStep(body.cutter->finish(), body, history, output);
        body.memory.tear.goesOn = false;
    }
}

void followStep(const CutResult& result, RunningBody& body, UndoHistory& history,
                SimulationOutput& output) {
    output.report.search.add(body.cutter->takeSearchWork());
    output.report.debris.add(result.statistics.debris);
    std::ranges::move(sentencesAboutEnd(result, output.clock.stepsDone),
                      std::back_inserter(output.messages));
    const auto record =
        std::ranges::find(body.memory.strokes, body.cutter->strokeNumber(), &StrokeRecord::number);
    if (record != body.memory.strokes.end()) {
        record->add(result);
    }
    if (!result.delta.empty()) {
        followCut(result.delta, body, history, output);
    }
}

}  // namespace kerf
