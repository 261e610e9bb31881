#include "sim/run/simulation.h"

#include "sim/base/containers.h"
#include "sim/base/pausing.h"
#include "sim/base/text.h"
#include "sim/body/folded_triangles.h"
#include "sim/body/solver_uniforms.h"
#include "sim/run/blade/cut_followers.h"
#include "sim/run/blade/running_stroke.h"
#include "sim/run/simulation_state.h"
#include "sim/run/start/prepared_body.h"
#include "sim/run/state_hash.h"

namespace kerf {

namespace {
// Steps after which a body that is folded, and not being cut, is looked after: most folds go by
// then.
constexpr int kPatience = 10;
constexpr int kMendings = 2;  // after a stroke
// Share of a piece that is inside out, up to which its folds are those of a cut.
constexpr double kMostMended = 0.01;
}  // namespace

Simulation::State::State(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver,
                         SimulationSetup with)
    : setup(std::move(with)), body(std::move(prepared), std::move(loadedSolver)) {
    startRun();
    beginAtRest();
}

void Simulation::State::start() {
    startRun();
    body.startAsAtFirst();
    beginAtRest();
}

/// With the first parameters, at step 0.
void Simulation::State::startRun() {
    input.params = setup.params;
    input.timeRuns = true;
    setBoxes(setup.boxes);
    log.clear();
    output.messages.clear();
    output.clock = {};
    output.report = {};
    lastLossStep_ = -2;
}

/// The uncut body at rest, with the parameters and at the time that are.
void Simulation::State::startBody() {
    body.startAnew();
    beginAtRest();
}

void Simulation::State::beginAtRest() {
    log.touch();
    log.endStroke();
    input.paramsChanged = true;
    input.blade = {};
    output.lastCut = {};
    applyParameters();
    body.measureAtRest();
    publish();
}

const StepReport& Simulation::State::step() {
    log.touch();
    output.report = {};
    output.report.step = output.clock.stepsDone;
    applyParameters();
    if (input.timeRuns) {
        if (!sleeps()) {
            solve();
        }
        cut();
        tear.step();
        noteHeldEdge();
        lookAfterShape();
        output.clock.time += input.params.timeStep;
    } else {
        cut();
    }
    log.touch();  // a stroke that began was noted with the body before it
    ++output.clock.stepsDone;
    publish();
    return output.report;
}

/// A stroke that has not cut yet asks for the volume of the whole body as soon as it does.
void Simulation::State::cut() {
    body.sync.readAllAtOnce(!body.cutter->hasCut());
    stroke.step();
    body.sync.readAllAtOnce(false);
}

/// What is folded now was so by the parameters before.
void Simulation::State::noteParamsChanged() {
    input.paramsChanged = true;
    body.memory.guard.startAnew();
    if (body.solver.stepper().unfolds() || body.looksCollapsed()) {
        body.memory.mayHaveCollapsed = true;
    }
}

Surroundings Simulation::State::surroundings() const {
    const bool feels = input.params.bladeFeels != 0 && input.params.toughness > 0;
    const bool acts = input.params.bladePush != 0 || feels;
    const bool isLed = acts && input.blade.isPlaced();
    return {!input.boxes.empty(), isLed ? input.blade.comingWay() / input.params.timeStep : 0};
}

void Simulation::State::applyParameters() {
    const bool changed = std::exchange(input.paramsChanged, false);
    if (changed) {
        body.apply(input.params);
    }
    const Surroundings around = surroundings();
    const int steps = body.implicitStepsFor(input.params, around);
    const int iterations = body.iterationsFor(input.params, around, steps);
    const bool sameIterations = std::exchange(input.iterations, iterations) == iterations;
    const bool sameSteps = std::exchange(input.implicitSteps, steps) == steps;
    if (!sameIterations || !sameSteps || changed) {
        body.applyToSolver(input.solved());
    }
}

/// A blade in the scene may touch it in any step.
bool Simulation::State::sleeps() const {
    return input.params.sleeps != 0 && body.liesStill() && !input.blade.isTold() &&
           !input.blade.pose();
}

void Simulation::State::solve() {
    body.prepareStep(input.solved(), input.params.iterations == kAutoIterations);
    const bool keepsApart = body.keepsTrianglesApart(input.params);
    const std::vector<Vec3> before = keepsApart ? body.mesh().positions() : std::vector<Vec3>();
    moveBody();
    const Vec3 middle = middleOfBlade();
    body.measureStep();
    output.report.residual = body.residual(input.params);
    noteBladeLoad(middle);
    takeBackLostPieces();
    guardSteps();
    body.noteStillness(input.params.timeStep, output.report.lostPieces > 0);
    const double prefetchMs = body.endStep();
    if (keepsApart) {
        body.stopCrossings(before, input.params);
    }
    StepReport& report = output.report;
    report.search.milliseconds += input.params.cutSearch == CutSearch::tree ? prefetchMs : 0;
    report.times.deform = body.solver.stepper().takeDeformMilliseconds();
    report.times.collide = body.solver.stepper().takeCollideMilliseconds();
}

/// About which the moment is told, where the edge feels [m]. Before the mesh is old, whose front
/// the blade's plate follows.
Vec3 Simulation::State::middleOfBlade() {
    if (!body.solver.collisions().edge()) {
        return Vec3::Zero();
    }
    const std::optional<BladeMotion> plate = stroke.bladeMotion();
    const Blade led = input.blade.nextPose();
    return plate ? plate->middle() : Vec3(0.5 * (led.a + led.b));
}

/// That of the plate as far as it is measured, and that of the edge where it feels.
void Simulation::State::noteBladeLoad(const Vec3& middle) {
    const bool feels = stroke.feels();
    if (!body.feelsBlade && !feels) {
        return;
    }
    BladeLoad load = body.solver.collisions().bladeLoad();
    if (const std::optional<PressingEdge> edge = body.solver.collisions().edge()) {
        const EdgeLoad& of = body.solver.collisions().edgeLoad();
        const Vec3 force = -of.force * edge->ahead;
        load.force += force;
        load.moment += (of.middle - middle).cross(force);
        output.report.heldEdge.work = of.work;
    }
    output.report.bladeLoad = load;
}

void Simulation::State::noteHeldEdge() {
    const double work = output.report.heldEdge.work;
    output.report.heldEdge = stroke.heldEdge();
    output.report.heldEdge.work = work;
}

/// Whether the step reads what is near the blade.
bool Simulation::State::bladeLooks() const {
    return input.blade.isTold() || body.cutter->inStroke() || stroke.feels();
}

/// Where a step is known to read all of the body, it comes with the measure.
void Simulation::State::prefetchCut() {
    const std::vector<Blade> path = input.blade.path();
    std::vector<int> vertices = tear.watched();
    if (bladeLooks() && !path.empty() && !body.readsAllBack) {
        const std::vector<int> followed = body.cutter->followedVertices();
        vertices.insert(vertices.end(), followed.begin(), followed.end());
        sortUnique(vertices);
        body.sync.prefetch(body.cutter->reach(path, input.params.timeStep), vertices);
    } else if (!vertices.empty() && !body.readsAllBack) {
        body.sync.prefetch(std::nullopt, vertices);
    }
    if (body.readsAllBack || body.keepsTrianglesApart(input.params) || stroke.endsInStep()) {
        body.sync.prefetchAll();
    }
}

void Simulation::State::moveBody() {
    FrontHold front(body, input.params);
    body.solver.collisions().setBlade(stroke.bladeMotion());
    body.solver.collisions().setEdge(stroke.pressingEdge());
    body.solver.collisions().feelBlade(body.feelsBlade || stroke.feels());
    body.solver.unfoldFirmly(!body.cutter->inStroke());
    prefetchCut();
    body.solver.step();
    front.release();
}

/// The others go on. Where it happens step after step, only the first of them says so.
void Simulation::State::takeBackLostPieces() {
    const int lost = static_cast<int>(body.memory.measure.lostPieces.size());
    output.report.lostPieces = lost;
    if (lost == 0) {
        return;
    }
    const int now = output.clock.stepsDone;
    if (std::exchange(lastLossStep_, now) != now - 1) {
        output.say(
            "{} of {} left the range of numbers and went back to where the step began, at rest. "
            "More iterations or more damping make the body steadier.",
            counted(lost, "piece", "pieces"), body.model().pieces.size());
    }
    body.bringLostPiecesBack();
}

void Simulation::State::guardSteps() {
    const bool worked = output.report.lostPieces > 0 || surroundings().bladeSpeed > 0;
    if (body.guardSteps(input.params, worked)) {
        output.say("The body gained energy of itself; its steps are divided further for a while.");
    }
}

/// Every few steps with folds: what has collapsed is drawn back to its shape, and what a cut left
/// folded elsewhere is mended.
void Simulation::State::lookAfterShape() {
    const bool unfolds = body.solver.stepper().unfolds();
    const bool keeps = keepsShape(input.params);
    if (!keeps) {
        body.memory.recovery.stop();
        body.memory.mayHaveCollapsed = true;
        body.memory.mendings = 0;
    }
    body.memory.crumpled =
        body.memory.crumpled && (unfolds || body.looksCollapsed() || body.memory.recovery.draws());
    int& foldedSteps = body.memory.foldedSteps;
    if (body.cutter->inStroke()) {
        foldedSteps = 0;
        body.memory.mendings = kMendings;
    } else if (unfolds || (keeps && body.looksCollapsed())) {
        ++foldedSteps;  // not in a row: much comes and goes
    }
    if (foldedSteps < kPatience) {
        return;
    }
    foldedSteps = 0;
    std::vector<double> insideOut = findInsideOut();
    if (keeps) {
        drawCollapsedBack(std::move(insideOut));
    }
    if (unfolds && body.memory.mendings > 0 && !body.memory.crumpled && !body.thin) {
        --body.memory.mendings;
        mendFolds();
    }
}

std::vector<double> Simulation::State::findInsideOut() {
    if (!body.memory.mayHaveCollapsed) {
        return std::vector<double>(body.model().pieces.size(), 0);
    }
    std::vector<double> shares = sharesInsideOut(body.model(), body.mesh());
    const bool any = std::ranges::any_of(shares, [](double s) { return s > kMostMended; });
    body.memory.crumpled = body.memory.crumpled || any;
    body.memory.mayHaveCollapsed = any || body.memory.recovery.draws();
    return shares;
}

/// Not what a hand holds: somebody is at work on it.
void Simulation::State::drawCollapsedBack(std::vector<double> insideOut) {
    for (const std::uint32_t v : body.memory.hands.heldVertices()) {
        if (const int piece = body.model().pieceOfVertex[v]; piece >= 0) {
            insideOut[piece] = 0;
        }
    }
    const int collapsed = body.memory.recovery.begin(insideOut);
    if (collapsed > 0) {
        output.say("{} of {} collapsed, partly inside out, and {} drawn back to {} at rest.",
                   counted(collapsed, "piece", "pieces"), insideOut.size(),
                   collapsed == 1 ? "is" : "are", collapsed == 1 ? "its shape" : "their shapes");
    }
}

/// What the solver can't unfold in kPatience steps lies at short edges that a cut left there: these
/// are removed. The folds of what has collapsed say nothing about edges, nor do those that are left
/// of it or that come long after the cut.
void Simulation::State::mendFolds() {
    const WorkWatch watch;
    const std::vector<int> triangles =
        foldedTriangles(body.mesh(), body.uncut->mesh.triangleSlots());
    const CutDelta mended = triangles.empty() ? CutDelta{} : body.cutter->mend(triangles);
    if (!mended.empty()) {
        followCut(mended, body, log.history(), output);
    }
    output.report.times.cut += watch.milliseconds();
}

void Simulation::State::publish() {
    ++output.bodyRevision;
    StepReport& report = output.report;
    report.time = output.clock.time;
    report.iterations = input.iterations;
    report.implicitSteps = input.implicitSteps;
    report.describe(body.model(), body.memory.measure);
    report.fractureEnergy += input.params.toughness * report.swept.atRest;
    if (input.params.solver == SolverMode::pbd) {
        report.strainEnergy.reset();
    }
    report.open = body.isOpen();
    report.closed = body.memory.closed && !report.open;
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

void Simulation::feelBlade(bool wanted) {
    state_->body.feelsBlade = wanted;
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
Checkpoint Simulation::checkpoint() {
    return state_->checkpoint();
}
void Simulation::goTo(const Checkpoint& checkpoint) {
    state_->goTo(checkpoint.content());
}
int Simulation::bodyRevision() const {
    return state_->output.bodyRevision;
}
int Simulation::stepCount() const {
    return state_->output.clock.stepsDone;
}
bool Simulation::isWhole() const {
    return state_->body.whole;
}
bool Simulation::timeRuns() const {
    return state_->input.timeRuns;
}
const Params& Simulation::params() const {
    return state_->input.params;
}
const StepReport& Simulation::report() const {
    return state_->output.report;
}
std::optional<Blade> Simulation::blade() const {
    return state_->input.blade.pose();
}
const std::vector<BladeAction>& Simulation::bladeActions() const {
    return state_->input.blade.actions();
}
std::optional<Blade> Simulation::comingBlade() const {
    return state_->input.blade.comingPose();
}
std::optional<Blade> Simulation::bladeEdge() const {
    std::optional<Blade> edge = blade();
    const double lag = state_->output.report.heldEdge.lag;
    if (edge && lag > 0) {
        const Vec3 back = lag * state_->input.blade.back();
        edge = Blade{edge->a + back, edge->b + back};
    }
    return edge;
}
std::optional<BladeMotion> Simulation::bladeBody() const {
    return state_->stroke.bladeBody();
}
const std::vector<RungNode>& Simulation::rung() const {
    return state_->body.cutter->rung();
}
const SubdivisionCounts& Simulation::subdivisions() const {
    return state_->body.memory.subdivisions;
}
const std::vector<StrokeRecord>& Simulation::strokes() const {
    return state_->body.memory.strokes;
}
const CutResult& Simulation::lastCut() const {
    return state_->output.lastCut;
}

const std::string& Simulation::refusalOfStroke() const {
    return state_->output.refusal;
}

std::vector<std::string> Simulation::takeMessages() {
    return std::exchange(state_->output.messages, {});
}

const std::shared_ptr<const UncutBody>& Simulation::uncut() const {
    return state_->body.uncut;
}

const std::shared_ptr<const UncutBody>& Simulation::firstUncut() const {
    return state_->body.first;
}

void Simulation::expectPlacement(std::shared_ptr<const UncutBody> placed) {
    state_->preparedPlacement = std::move(placed);
}

int Simulation::modelCount() const {
    return static_cast<int>(uncut()->models.size());
}

const Placement& Simulation::placement(int model) const {
    return uncut()->models[model].placement;
}

const std::vector<StaticBox>& Simulation::boxes() const {
    return state_->input.boxes;
}

const std::vector<std::uint32_t>& Simulation::pinnedVertices() const {
    return state_->body.memory.pins.vertices();
}

const std::vector<Pins::Motion>& Simulation::motions() const {
    return state_->body.memory.pins.motions();
}

const std::vector<Pins::Force>& Simulation::forces() const {
    return state_->body.memory.pins.forces();
}

const std::vector<Hands::Hand>& Simulation::hands() const {
    return state_->body.memory.hands.hands();
}

BodyView Simulation::bodyView() const {
    return state_->body.solver.view();
}

const BodyModel& Simulation::bodyModel() const {
    return state_->body.model();
}

int Simulation::modelRevision() const {
    return state_->body.modelRevision;
}

ConstraintView Simulation::constraintView() const {
    return state_->body.solver.constraintView();
}

const Bounds& Simulation::bounds() const {
    return state_->body.memory.measure.bounds;
}

std::vector<Piece> Simulation::measuredPieces() const {
    std::vector<Piece> out;
    const BodyModel& model = state_->body.model();
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
        const PieceModel& piece = model.pieces[p];
        out.push_back({static_cast<int>(piece.triangleCount), static_cast<int>(piece.vertexCount),
                       state_->body.memory.measure.pieceVolumes[p], piece.restVolume,
                       piece.restArea});
    }
    return out;
}

std::vector<int> Simulation::trianglesOfPieces() const {
    const BodyModel& model = state_->body.model();
    std::vector<int> triangles(model.pieces.size(), -1);
    for (std::size_t t = 0; t < model.triangles.size(); ++t) {
        triangles[model.triangles[t][3] >> 8U] = model.meshTriangle[t];
    }
    return triangles;
}

const std::vector<Bounds>& Simulation::pieceBounds() const {
    return state_->body.memory.measure.pieceBounds;
}

const SurfaceMesh& Simulation::mesh() {
    state_->body.mesh().bringAll();
    return state_->body.mesh();
}

const SurfaceMesh& Simulation::meshAsRead() const {
    return state_->body.mesh();
}

std::vector<int> Simulation::trianglesIn(const OrientedBox& box) {
    return state_->body.sync.lookInto(box);
}

const PieceMap& Simulation::pieces() {
    return state_->body.pieces();
}

std::string Simulation::stateHash() {
    return hashScene(mesh(), state_->input.boxes).hexadecimal();
}

StateHashes Simulation::stateHashes() {
    return hashParts(mesh(), state_->input.boxes, params(), blade());
}

}  // namespace kerf
