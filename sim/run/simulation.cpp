#include "sim/run/simulation.h"

#include <utility>

#include "sim/base/stopwatch.h"
#include "sim/base/text.h"
#include "sim/body/folded_triangles.h"
#include "sim/run/front_hold.h"
#include "sim/run/simulation_state.h"
#include "sim/run/state_hash.h"

namespace kerf {

namespace {
// Steps after which a body that is folded, and not being cut, is mended: most folds go by then.
constexpr int kPatience = 10;
}  // namespace

Simulation::State::State(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver,
                         SimulationSetup with)
    : setup(std::move(with)), body(std::move(prepared), std::move(loadedSolver)) {
    startRun();
    beginAtRest();
}

void Simulation::State::start() {
    startRun();
    startBody();
}

/// With the first parameters, at step 0.
void Simulation::State::startRun() {
    params = setup.params;
    setBoxes(setup.boxes);
    messages.clear();
    log.clear();
    stepsDone = 0;
    time = 0;
    lastLossStep = -2;
    report = {};
}

/// The uncut body at rest, with the parameters and at the time that are.
void Simulation::State::startBody() {
    body.startAnew();
    beginAtRest();
}

void Simulation::State::beginAtRest() {
    touch();
    log.endStroke();
    paramsChanged = true;
    blade = {};
    lastCut = {};
    applyParameters();
    body.measureAtRest();
    publish();
}

const StepReport& Simulation::State::step() {
    touch();
    report = {};
    report.step = stepsDone;
    applyParameters();
    solve();
    cutAll();
    mendFolds();
    ++stepsDone;
    time += params.timeStep;
    publish();
    return report;
}

void Simulation::State::applyParameters() {
    if (std::exchange(paramsChanged, false)) {
        body.apply(params);
    }
}

void Simulation::State::solve() {
    body.prepareStep(params.timeStep);
    prefetchCut();
    moveBody();
    body.measureStep();
    takeBackLostPieces();
    const double prefetchMs = body.endStep();
    report.search.milliseconds += params.cutSearch == CutSearch::tree ? prefetchMs : 0;
    report.deformMs = body.solver.stepper().takeDeformMilliseconds();
    report.collideMs = body.solver.stepper().takeCollideMilliseconds();
}

void Simulation::State::prefetchCut() {
    const bool looks = blade.isTold() || body.cutter->inStroke();
    const std::vector<Blade> path = blade.path();
    if (looks && !path.empty() && !body.readsAllBack) {
        body.sync.prefetch(body.cutter->reach(path, params.timeStep),
                           body.cutter->followedVertices());
    }
}

void Simulation::State::moveBody() {
    FrontHold front(body, params.timeStep);
    body.solver.collisions().setBlade(bladeMotion());
    body.solver.unfoldFirmly(!body.cutter->inStroke());
    body.solver.step();
    front.release();
}

/// The others go on. Where it happens step after step, only the first of them says so.
void Simulation::State::takeBackLostPieces() {
    report.lostPieces = static_cast<int>(body.measure.lostPieces.size());
    if (report.lostPieces == 0) {
        return;
    }
    if (std::exchange(lastLossStep, stepsDone) != stepsDone - 1) {
        say("step {}: {} of {} left the range of numbers and went back to where the step began, at "
            "rest. More iterations or more damping make the body steadier.",
            stepsDone, counted(report.lostPieces, "piece", "pieces"), body.model().pieces.size());
    }
    body.bringLostPiecesBack();
}

/// What the solver can't unfold in kPatience steps lies at short edges that a cut left there: these
/// are removed.
void Simulation::State::mendFolds() {
    if (body.cutter->inStroke()) {
        body.foldedSteps = 0;
    } else if (body.solver.stepper().unfolds()) {
        ++body.foldedSteps;  // not in a row: much comes and goes
    }
    if (body.foldedSteps < kPatience) {
        return;
    }
    body.foldedSteps = 0;
    const Stopwatch watch;
    const std::vector<int> triangles = foldedTriangles(body.mesh, body.uncut->mesh.triangleSlots());
    const CutDelta mended = triangles.empty() ? CutDelta{} : body.cutter->mend(triangles);
    if (!mended.empty()) {
        adopt(mended);
    }
    report.cutMs += watch.milliseconds();
}

void Simulation::State::publish() {
    ++bodyRevision;
    report.time = time;
    report.describe(body.model(), body.measure);
    if (params.solver != SolverMode::smallSteps) {
        report.strainEnergy.reset();
    }
    report.open = body.isOpen();
    report.closed = body.closed && !report.open;
}

Simulation::Simulation(SurfaceMesh mesh, const Params& params, std::vector<StaticBox> boxes)
    : Simulation(BodyUpload(PreparedBody(std::move(mesh))), params, std::move(boxes)) {}

Simulation::Simulation(BodyUpload body, const Params& params, std::vector<StaticBox> boxes) {
    body.finish();
    state_ = std::make_unique<State>(std::move(body.prepared_), std::move(body.solver_),
                                     SimulationSetup{params, std::move(boxes)});
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

std::string Simulation::execute(const Command& command) {
    return state_->execute(command);
}

void Simulation::readAllBack(bool all) {
    state_->body.readAllBack(all);
}

int Simulation::wholeReads() const {
    return state_->body.sync.wholeReads();
}

const StepReport& Simulation::step() {
    return state_->step();
}
void Simulation::reset() {
    state_->start();
}
void Simulation::setUndoBudget(std::size_t bytes) {
    state_->log.history().setBudget(bytes);
}
const UndoHistory& Simulation::history() const {
    return state_->log.history();
}
Moment Simulation::moment() {
    return state_->moment();
}
void Simulation::goTo(const Moment& moment) {
    state_->goTo(moment.content());
}
int Simulation::bodyRevision() const {
    return state_->bodyRevision;
}
int Simulation::stepCount() const {
    return state_->stepsDone;
}
const Params& Simulation::params() const {
    return state_->params;
}
const StepReport& Simulation::report() const {
    return state_->report;
}
std::optional<Blade> Simulation::blade() const {
    return state_->blade.pose();
}
std::optional<BladeMotion> Simulation::bladeBody() const {
    return state_->bladeBody();
}
const std::vector<RungNode>& Simulation::rung() const {
    return state_->body.cutter->rung();
}
const SubdivisionCounts& Simulation::subdivisions() const {
    return state_->body.subdivisions;
}
const CutResult& Simulation::lastCut() const {
    return state_->lastCut;
}

std::vector<std::string> Simulation::takeMessages() {
    return std::exchange(state_->messages, {});
}

const std::vector<StaticBox>& Simulation::boxes() const {
    return state_->boxes;
}

const std::vector<std::uint32_t>& Simulation::pinnedVertices() const {
    return state_->body.pins.vertices();
}

const std::vector<Hands::Hand>& Simulation::hands() const {
    return state_->body.hands.hands();
}

BodyView Simulation::bodyView() const {
    return state_->body.solver.view();
}

ConstraintView Simulation::constraintView() const {
    return state_->body.solver.constraintView();
}

const Bounds& Simulation::bounds() const {
    return state_->body.measure.bounds;
}

std::vector<Piece> Simulation::measuredPieces() const {
    std::vector<Piece> out;
    const BodyModel& model = state_->body.model();
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
        const PieceModel& piece = model.pieces[p];
        out.push_back({static_cast<int>(piece.triangleCount), static_cast<int>(piece.vertexCount),
                       state_->body.measure.pieceVolumes[p], piece.restVolume, piece.restArea});
    }
    return out;
}

const std::vector<Bounds>& Simulation::pieceBounds() const {
    return state_->body.measure.pieceBounds;
}

const SurfaceMesh& Simulation::mesh() {
    state_->body.mesh.bringAll();
    return state_->body.mesh;
}

const SurfaceMesh& Simulation::meshAsRead() const {
    return state_->body.mesh;
}

std::vector<int> Simulation::trianglesIn(const OrientedBox& box) {
    return state_->body.sync.lookInto(box);
}

const PieceMap& Simulation::pieces() {
    return state_->body.pieces();
}

std::string Simulation::stateHash() {
    return hashScene(mesh(), state_->boxes).hexadecimal();
}

StateHashes Simulation::stateHashes() {
    return hashParts(mesh(), state_->boxes, params(), blade());
}

}  // namespace kerf
