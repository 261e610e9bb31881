#include "sim/simulation.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "sim/body/body_updater.h"
#include "sim/box_edit.h"
#include "sim/boxes.h"
#include "sim/contact/paper_contact.h"
#include "sim/cut/cut_change.h"
#include "sim/float_rounding.h"
#include "sim/mesh/oriented_box.h"
#include "sim/mesh_sync.h"
#include "sim/snapshot.h"
#include "sim/solve/front_anchors.h"
#include "sim/solve/gpu_solver.h"
#include "sim/solve/solver_uniforms.h"
#include "sim/solve/volume_targets.h"
#include "sim/state_hash.h"
#include "sim/stopwatch.h"
#include "sim/text.h"
#include "sim/undo_history.h"

namespace kerf {

namespace {

using BladeAction = std::variant<MoveBlade, LiftBlade>;

bool samePose(const Blade& a, const Blade& b) {
    return a.a == b.a && a.b == b.b;
}

std::string checkBlade(const Blade& blade) {
    if (!blade.a.allFinite() || !blade.b.allFinite()) {
        return "The blade needs finite coordinates for both ends; it stays where it was.";
    }
    if (blade.a == blade.b) {
        return "The two ends of the blade are the same point; give it a length.";
    }
    return "";
}

/// Vertices become what the GPU will hold, so that both sides go on from the same numbers.
void roundVertices(SurfaceMesh& mesh, const std::vector<std::uint32_t>& vertices) {
    for (const std::uint32_t vertex : vertices) {
        const int v = static_cast<int>(vertex);
        mesh.setPosition(v, nearestFloats(mesh.position(v)));
        mesh.setVelocity(v, nearestFloats(mesh.velocity(v)));
    }
}

// By how much the front of a cut lags behind the edge until it moves on (CutSettings::gate), of the
// edge length of walls.
constexpr double kMostLag = 0.5;

double restDiagonal(const SurfaceMesh& mesh) {
    return boxOf(mesh.restPositions()).diagonal();
}

bool standsInMaterial(const std::vector<RungNode>& rung) {
    for (const RungNode& node : rung) {
        if (node.vertex >= 0) {
            return true;
        }
    }
    return false;
}

}  // namespace

struct Moment::Content {
    SnapshotPointer body;
    Params params;
    std::vector<StaticBox> boxes;
    std::optional<Blade> blade;
    BladeCourse course;
    UndoHistory history;
    SnapshotPointer beforeStroke;
    bool strokeNoted = false;
    int cutsSoFar = 0;
    int stepsDone = 0;
    double time = 0;  ///< [s]
    StepReport report;
};

struct Simulation::State {
    State(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver, const Params& firstParams,
          std::vector<StaticBox> firstBoxes)
        : uncut(std::move(prepared.uncut)),
          initialParams(firstParams),
          initialBoxes(std::move(firstBoxes)),
          diagonal(restDiagonal(uncut->mesh)),
          wallEdge(contactEdgeLength(uncut->body.model())),
          meshOwner(std::move(prepared.mesh)),
          body(std::move(prepared.body)),
          solverOwner(std::move(loadedSolver)),
          closed(uncut->closed),
          cutter(std::move(*prepared.cutter)) {
        startRun();
        lookUpTriangles();
        beginAtRest();
    }

    void start();
    void startRun();
    void startBody();
    void beginAtRest();
    const StepReport& step();

    // Commands that take effect at once; each returns "" or one sentence.
    std::string execute(const MoveBlade& move);
    std::string execute(const LiftBlade& lift);
    std::string execute(const SetParam& set);
    std::string execute(const Grab& grab);
    std::string execute(const Drag& drag);
    std::string execute(const Release& release);
    std::string execute(const Pin& pin);
    std::string execute(const AddBox& add) { return apply(edited(boxes, add)); }
    std::string execute(const ChangeBox& change) { return apply(edited(boxes, change)); }
    std::string execute(const RemoveBox& remove) { return apply(edited(boxes, remove)); }
    std::string execute(const Restart&);
    std::string execute(const Undo&);
    std::string execute(const Redo&);

    // Undo.
    SnapshotPointer capture();
    SnapshotPointer captureForUndo();
    void noteBodyChange(std::string name, SnapshotPointer before);
    void restoreBody(const SnapshotPointer& snapshot);
    Moment moment();
    void goTo(const Moment::Content& then);
    void apply(const UndoEntry::ParamChange& change, bool forward);
    void apply(const UndoEntry::PinChange& change, bool forward);
    void apply(const UndoEntry::BodyChange& change, bool forward);
    void apply(const UndoEntry::BoxesChange& change, bool forward);
    std::string apply(BoxEdit edit);
    void setBoxes(std::vector<StaticBox> now);
    void putBladeAway();
    void beginStroke();
    void noteCut();

    // The phases of a step.
    void applyParameters();
    void solve();
    void foreseeCut();
    std::vector<Blade> pathOfBlade() const;
    BladeCourse courseTo(const Blade& to) const;
    BladeSize bladeSize() const;
    double bladeFront(const BladeCourse& end) const;
    std::optional<BladeMotion> bladeMotion() const;
    std::optional<BladeMotion> bladeBody() const;
    void lookUpTriangles();
    void holdFront();
    void carryHidden();
    AnchorFrame anchorFrame() const;
    void releaseFront();
    void pull();
    void collideAsThePaper();
    void takeBackLostPieces();
    void cutAll();
    void publish();

    void cut(const MoveBlade& move);
    void cut(const LiftBlade& lift);
    void endStroke();
    bool mayTouch(const Blade& blade);
    bool nearBody(std::span<const Vec3> sweep);
    void accept(const CutResult& result);
    void adoptNewTopology(const CutDelta& delta);
    void countDebris(const Debris& debris);
    void tellOfClosing(const WoundClosing& closing);

    const BodyModel& model() const { return body->model(); }
    bool isOpen() const { return std::ranges::any_of(model().pieces, &PieceModel::open); }
    const PieceMap& syncPieces();
    template <class... Parts>
    void say(fmt::format_string<Parts...> format, Parts&&... parts) {
        messages.push_back(fmt::format(format, std::forward<Parts>(parts)...));
    }
    /// Something is about to differ from the last snapshot.
    void touch() { current.reset(); }

    // What the simulation was made with.
    const std::shared_ptr<const UncutBody> uncut;
    const Params initialParams;
    const std::vector<StaticBox> initialBoxes;
    const double diagonal;  ///< of the uncut body at rest [m]
    const double wallEdge;  ///< edge length of walls [m]

    // The body: constant set-up, running state on the GPU, and the mesh, which is the truth about
    // topology and fetches positions where they are read.
    const std::unique_ptr<SurfaceMesh> meshOwner;
    SurfaceMesh& mesh = *meshOwner;
    std::unique_ptr<BodyUpdater> body;
    const std::unique_ptr<GpuSolver> solverOwner;
    GpuSolver& solver = *solverOwner;
    MeshSync sync{mesh, solver};
    bool readsAllBack = false;
    VolumeTargets volumeTargets;
    std::vector<Anchor> anchors;
    Hands hands;
    Pins pins;
    bool closed = true;

    // Input.
    Params params;
    bool paramsChanged = false;
    std::vector<StaticBox> boxes;
    std::vector<BladeAction> bladeActions;
    std::optional<Blade> blade;
    BladeCourse course;  ///< of the blade, while there is one
    std::optional<Cutter> cutter;

    // Undo.
    UndoHistory history;
    SnapshotPointer current;       ///< equal to the state as it is; null where none is known to be
    SnapshotPointer beforeStroke;  ///< while the blade is placed and has not changed the body
    bool strokeNoted = false;      ///< in the history, since the blade was placed
    bool toldTooLarge = false;     ///< for the undo memory, since a body last fit into it
    int cutsSoFar = 0;

    // Output.
    BodyMeasure measure;
    StepReport report;
    CutResult lastCut;
    SubdivisionCounts subdivisions{};
    std::vector<std::string> messages;
    std::optional<PieceMap> pieces;
    int stepsDone = 0;
    int bodyRevision = 0;
    double time = 0;
    int lastLossStep = -2;  ///< the last step that lost a piece
    int paperContacts = 0;  ///< pairs of triangles, with paper_contact
    double paperContactMs = 0;
};

void Simulation::State::start() {
    startRun();
    startBody();
}

/// With the first parameters, at step 0.
void Simulation::State::startRun() {
    params = initialParams;
    setBoxes(initialBoxes);
    messages.clear();
    history.clear();
    stepsDone = 0;
    time = 0;
    cutsSoFar = 0;
    lastLossStep = -2;
    report = {};
}

/// The uncut body at rest, with the parameters and at the time that are.
void Simulation::State::startBody() {
    mesh = uncut->mesh;
    body = std::make_unique<BodyUpdater>(uncut->body);
    solver.setModel(model(), stateOf(mesh));
    closed = uncut->closed;
    cutter.emplace(uncut->cutter);
    lookUpTriangles();
    beginAtRest();
}

/// With body, solver and cutter as new.
void Simulation::State::beginAtRest() {
    touch();
    beforeStroke.reset();
    strokeNoted = false;
    volumeTargets.reset(model());
    sync.outdate();  // by the rounding to float
    paramsChanged = true;
    bladeActions.clear();
    blade.reset();
    hands = {};
    pins = {};
    lastCut = {};
    subdivisions = {};
    paperContacts = 0;
    pieces.reset();
    applyParameters();
    measure = solver.measure();
    sync.setBounds(measure.bounds);
    solver.saveState();
    publish();
}

const StepReport& Simulation::State::step() {
    touch();
    report = {};
    report.step = stepsDone;
    applyParameters();
    solve();
    cutAll();
    ++stepsDone;
    time += params.timeStep;
    publish();
    return report;
}

void Simulation::State::applyParameters() {
    if (std::exchange(paramsChanged, false)) {
        solver.setUniforms(solverUniforms(params));
        cutter->setWallCoarsening(params.wallCoarsening);
        cutter->setDebrisVolume(params.debrisVolume);
        cutter->setOpenCut(params.openCut != 0);
        solver.setContact(contactSettings(params));
    }
}

void Simulation::State::solve() {
    if (volumeTargets.fade(params.timeStep)) {
        solver.setVolumeTargets(volumeTargets.targets());
    }
    pull();
    foreseeCut();
    holdFront();
    solver.setBlade(bladeMotion());
    solver.step();
    releaseFront();
    collideAsThePaper();
    measure = solver.measure();
    takeBackLostPieces();
    solver.saveState();
    sync.outdate();
    sync.setBounds(measure.bounds);
    if (readsAllBack) {
        mesh.bringAll();
    }
    pieces.reset();
    report.deformMs = solver.takeDeformMilliseconds();
    report.collideMs = solver.takeCollideMilliseconds() + paperContactMs;
}

/// Where the blade goes in this step, from where it stands.
std::vector<Blade> Simulation::State::pathOfBlade() const {
    std::vector<Blade> path;
    if (blade) {
        path.push_back(*blade);
    }
    for (const BladeAction& action : bladeActions) {
        if (const auto* move = std::get_if<MoveBlade>(&action)) {
            path.push_back(move->blade);
        }
    }
    return path;
}

BladeSize Simulation::State::bladeSize() const {
    return {params.bladeWidth * diagonal, params.bladeThickness * diagonal};
}

BladeCourse Simulation::State::courseTo(const Blade& to) const {
    return blade ? ledTo(course, to, bladeSize().width) : BladeCourse{to};
}

/// How far behind the edge at the end of a step its body begins: not before where the edge has cut.
double Simulation::State::bladeFront(const BladeCourse& end) const {
    const std::vector<RungNode>& rung = cutter->rung();
    double front = 0;
    const auto keepBehind = [&](const Vec3& p, double s) {
        const Vec3 edge = end.edge.a + s * (end.edge.b - end.edge.a);
        front = std::max(front, end.back.dot(p - edge));
    };
    keepBehind(blade->a, 0);
    keepBehind(blade->b, 1);
    // A front that waits at the gate and one that has just been cut are one to the plate: it comes
    // on evenly.
    const double mostLag = front + kMostLag * wallEdge;
    for (const RungNode& node : rung) {
        keepBehind(node.vertex >= 0 ? mesh.position(node.vertex) : node.position, node.s);
    }
    return standsInMaterial(rung) ? std::max(front, mostLag) : front;
}

std::optional<BladeMotion> Simulation::State::bladeBody() const {
    if (params.bladePush == 0 || !blade || course.farthest <= 0) {
        return std::nullopt;
    }
    return motionOf(std::array{course}, bladeSize(), 0, wallEdge, 1);
}

/// In the coming step, up to where the blade is lifted.
std::optional<BladeMotion> Simulation::State::bladeMotion() const {
    if (params.bladePush == 0 || !blade) {
        return std::nullopt;
    }
    std::vector<BladeCourse> courses{course};
    for (const BladeAction& action : bladeActions) {
        const auto* move = std::get_if<MoveBlade>(&action);
        if (move == nullptr) {
            break;
        }
        courses.push_back(ledTo(courses.back(), move->blade, bladeSize().width));
    }
    BladeMotion motion = motionOf(courses, bladeSize(), bladeFront(courses.back()), wallEdge,
                                  contactSettings(params).substeps);
    return motion.back > motion.front ? std::optional(std::move(motion)) : std::nullopt;
}

void Simulation::State::foreseeCut() {
    const bool looks = !bladeActions.empty() || cutter->inStroke();
    const std::vector<Blade> path = pathOfBlade();
    if (looks && !path.empty() && !readsAllBack) {
        sync.foresee(cutter->reach(path, params.timeStep), cutter->followedVertices());
    }
}

void Simulation::State::lookUpTriangles() {
    cutter->useFinder(readsAllBack ? nullptr : &sync);
}

/// See findFrontAnchors.
void Simulation::State::holdFront() {
    if (mesh.openStroke() >= 0) {
        carryHidden();
        return;
    }
    if (!standsInMaterial(cutter->rung())) {
        return;
    }
    anchors = findFrontAnchors(cutter->rung(), anchorFrame());
    for (const Anchor& anchor : anchors) {
        solver.anchor(anchor.vertex, anchor.velocity.cast<float>());
    }
}

/// What is not part of the body follows it.
void Simulation::State::carryHidden() {
    std::vector<Anchor> found = findHiddenAnchors(body->hiddenVertices(), anchorFrame());
    std::ranges::sort(found, {}, &Anchor::vertex);
    std::vector<std::uint32_t> vertices;
    std::vector<Vec3f> velocities;
    for (const Anchor& anchor : found) {
        vertices.push_back(static_cast<std::uint32_t>(anchor.vertex));
        velocities.push_back(anchor.velocity.cast<float>());
    }
    if (!vertices.empty()) {
        solver.carry(vertices, velocities);
    }
}

AnchorFrame Simulation::State::anchorFrame() const {
    return {mesh, body->pieceOfMeshVertex(), cutter->edgeLengthAtFront(), cutter->strokeSurface(),
            params.timeStep};
}

void Simulation::State::releaseFront() {
    for (const Anchor& anchor : std::exchange(anchors, {})) {
        solver.release(anchor.vertex);
    }
}

/// The state comes back from the GPU and goes up again.
void Simulation::State::collideAsThePaper() {
    paperContacts = 0;
    const Stopwatch watch;
    if (params.paperContact != 0 && model().pieces.size() > 1) {
        BodyState state = solver.readState();
        paperContacts = respondAsThePaper(model(), params.timeStep, state);
        if (paperContacts > 0) {
            solver.setState(state);
        }
    }
    paperContactMs = watch.milliseconds();
}

void Simulation::State::pull() {
    solver.setPulls(hands.advance(params.timeStep));
}

/// The others go on. Where it happens step after step, only the first of them says so.
void Simulation::State::takeBackLostPieces() {
    report.lostPieces = static_cast<int>(measure.lostPieces.size());
    if (report.lostPieces == 0) {
        return;
    }
    if (std::exchange(lastLossStep, stepsDone) != stepsDone - 1) {
        say("step {}: {} of {} left the range of numbers and went back to where the step began, at "
            "rest. More iterations or more damping make the body steadier.",
            stepsDone, counted(report.lostPieces, "piece", "pieces"), model().pieces.size());
    }
    solver.restorePiecesAtRest(measure.lostPieces);
    measure = solver.measure();
}

void Simulation::State::cutAll() {
    if (bladeActions.empty()) {
        return;
    }
    const Stopwatch watch;
    for (const BladeAction& action : std::exchange(bladeActions, {})) {
        std::visit([this](const auto& a) { cut(a); }, action);
    }
    report.cutMs = watch.milliseconds();
}

// A stroke begins when the blade comes near the body, and ends when it has left it.
void Simulation::State::cut(const MoveBlade& move) {
    if (blade && samePose(*blade, move.blade)) {
        return;
    }
    if (blade && mayTouch(move.blade)) {
        if (!cutter->inStroke()) {
            beginStroke();
        }
        accept(cutter->advance(move.blade));
    } else {
        endStroke();
    }
    course = courseTo(move.blade);
    blade = move.blade;
}

void Simulation::State::cut(const LiftBlade&) {
    if (std::exchange(blade, std::nullopt)) {
        endStroke();
    }
    beforeStroke.reset();
    strokeNoted = false;
}

void Simulation::State::beginStroke() {
    if (!strokeNoted && !beforeStroke) {
        beforeStroke = captureForUndo();
    }
    cutter->begin(*blade);
}

/// A stroke counts from its first change of the body, back to where the blade came near it.
void Simulation::State::noteCut() {
    if (history.keeps() && !strokeNoted) {
        strokeNoted = true;
        ++cutsSoFar;
        noteBodyChange(fmt::format("Cut {}", cutsSoFar), std::exchange(beforeStroke, nullptr));
    }
}

void Simulation::State::endStroke() {
    if (!cutter->inStroke()) {
        accept({});
        return;
    }
    accept(cutter->finish());
}

/// Whether the cutter must look: a front is in the material, or the strip comes near the body.
bool Simulation::State::mayTouch(const Blade& to) {
    const std::vector<RungNode>& rung = cutter->rung();
    std::vector<Vec3> sweep{blade->a, blade->b, to.a, to.b};
    for (const RungNode& node : rung) {
        sweep.push_back(node.position);
    }
    return standsInMaterial(rung) || nearBody(sweep);
}

/// By the box of the body, which is at hand, and that of the sweep, then by what lies in the
/// latter.
bool Simulation::State::nearBody(std::span<const Vec3> sweep) {
    Bounds swept = boxOf(sweep);
    swept.widen(model().edgeLength);
    if (!swept.overlaps(measure.bounds)) {
        return false;
    }
    OrientedBox sweptBox = orientedBoxOf(sweep);
    sweptBox.widen(model().edgeLength);
    const Bounds& whole = measure.bounds;
    if (!overlap(sweptBox,
                 {whole.center(), Eigen::Matrix3d::Identity(), 0.5 * (whole.high - whole.low)})) {
        return false;
    }
    if (readsAllBack) {
        sync.forget();  // the cutter does not tell it of changes then
    }
    return !sync.near(sweptBox).empty();
}

void Simulation::State::accept(const CutResult& result) {
    lastCut = result;
    report.touchedTriangles += result.statistics.touchedTriangles;
    addTo(report.subdivisions, result.statistics.patterns);
    addTo(subdivisions, result.statistics.patterns);
    report.seeds += result.statistics.seeds;
    if (result.outcome == CutOutcome::refused) {
        say("step {}: the cut was refused ({}); the blade goes on", stepsDone, result.reason);
    }
    countDebris(result.statistics.debris);
    tellOfClosing(result.statistics.closing);
    if (!result.delta.empty()) {
        noteCut();
        adoptNewTopology(result.delta);
    }
}

void Simulation::State::countDebris(const Debris& debris) {
    if (debris.pieces > 0) {
        report.debris.pieces += debris.pieces;
        report.debris.volume += debris.volume;
        say("step {}: removed {} that the cut left, {:.3g} m^3 in all", stepsDone,
            counted(debris.pieces, "chip", "chips"), debris.volume);
    }
}

/// Of wounds without a patch.
void Simulation::State::tellOfClosing(const WoundClosing& closing) {
    if (closing.slits > 0) {
        say("step {}: the stroke ended inside the body, where a wound has no loop to patch; {} "
            "closed by the walls that the blade swept",
            stepsDone, counted(closing.slits, "wound is", "wounds are"));
    }
    if (closing.unpatched > 0) {
        say("step {}: {} closed by the walls that the blade swept instead of a patch ({})",
            stepsDone, counted(closing.unpatched, "wound is", "wounds are"), closing.reason);
    }
}

void Simulation::State::adoptNewTopology(const CutDelta& delta) {
    const bool wasOpen = isOpen();
    const std::vector<std::uint32_t> written = rewrittenVertices(mesh, delta);
    roundVertices(mesh, written);
    const BodyChange change = body->update(delta);
    solver.update(model(), change, written, stateOf(mesh, written));
    if (change.pieces.piecesChanged || isOpen() != wasOpen) {
        measure = solver.measure();
    }
    volumeTargets.follow(change.pieces.source, model(), measure.pieceVolumes);
    solver.setVolumeTargets(volumeTargets.targets());
    if (pins.follow(mesh, delta)) {
        solver.setPinned(pins.vertices());
    }
    pieces.reset();
    const std::string defect = checkClosedManifoldAround(mesh, changedTriangles(delta));
    if (!defect.empty()) {
        closed = false;
        say("step {}: the cut left the mesh open: {}", stepsDone, defect);
    }
}

void Simulation::State::publish() {
    ++bodyRevision;
    report.time = time;
    report.volume = 0;
    report.vertices = 0;
    for (std::size_t p = 0; p < model().pieces.size(); ++p) {
        report.volume += measure.pieceVolumes[p];
        report.vertices += static_cast<int>(model().pieces[p].vertexCount);
    }
    report.volumeRatio = report.volume / model().uncutRestVolume;
    report.pieces = static_cast<int>(model().pieces.size());
    report.triangles = static_cast<int>(model().triangles.size());
    report.contacts = measure.contacts + paperContacts;
    report.kineticEnergy = measure.kineticEnergy;
    report.potentialEnergy = measure.potentialEnergy;
    report.strainEnergy = params.solver == SolverMode::smallSteps
                              ? std::optional(measure.strainEnergy)
                              : std::nullopt;
    report.ispcs = static_cast<int>(model().ispcs.size());
    report.open = isOpen();
    report.closed = closed && !report.open;
}

const PieceMap& Simulation::State::syncPieces() {
    if (!pieces) {
        pieces = findPieces(mesh);
    }
    return *pieces;
}

// --- Commands and undo ---------------------------------------------------------------------------

std::string Simulation::State::execute(const MoveBlade& move) {
    std::string error = checkBlade(move.blade);
    if (error.empty()) {
        bladeActions.emplace_back(move);
    }
    return error;
}

std::string Simulation::State::execute(const LiftBlade& lift) {
    bladeActions.emplace_back(lift);
    return "";
}

std::string Simulation::State::execute(const SetParam& set) {
    const ParamValue before = getParam(params, set.name);
    if (std::string error = setParam(params, set.name, set.value); !error.empty()) {
        return error;
    }
    const ParamValue after = getParam(params, set.name);
    if (after == before) {
        return "";
    }
    touch();
    paramsChanged = true;
    std::string name = nameOfChange(*findParam(set.name), after);
    auto* last = history.continued<UndoEntry::ParamChange>();
    if (set.continues && last != nullptr && last->param == set.name) {
        last->after = after;
        history.renameLast(std::move(name));
    } else {
        history.add({std::move(name), time, UndoEntry::ParamChange{set.name, before, after}});
    }
    return "";
}

std::string Simulation::State::execute(const Grab& grab) {
    const SnapshotPointer before = captureForUndo();
    touch();
    std::string error = hands.grab(grab, mesh);
    if (error.empty()) {
        noteBodyChange("Pull", before);
    }
    return error;
}

std::string Simulation::State::execute(const Drag& drag) {
    touch();
    return hands.drag(drag);
}

std::string Simulation::State::execute(const Release& release) {
    touch();
    return hands.release(release);
}

std::string Simulation::State::execute(const Pin& pin) {
    touch();
    const Pins before = pins;
    if (pins.change(pin.region, pin.pinned, mesh) == 0) {
        return pin.pinned ? "No free vertex lies in that region; nothing was pinned."
                          : "No pinned vertex lies in that region; nothing was freed.";
    }
    solver.setPinned(pins.vertices());
    auto* last = history.continued<UndoEntry::PinChange>();
    if (pin.continues && last != nullptr) {
        last->after = pins;
    } else {
        history.add({pin.pinned ? "Pin" : "Free pins", time, UndoEntry::PinChange{before, pins}});
    }
    return "";
}

std::string Simulation::State::apply(BoxEdit edit) {
    if (!edit.error.empty() || edit.after == boxes) {
        return edit.error;
    }
    auto* last = history.continued<UndoEntry::BoxesChange>();
    if (edit.continues && last != nullptr && last->changed == edit.changed) {
        last->after = edit.after;
    } else {
        history.add(
            {std::move(edit.name), time, UndoEntry::BoxesChange{boxes, edit.after, edit.changed}});
    }
    setBoxes(std::move(edit.after));
    return "";
}

void Simulation::State::apply(const UndoEntry::BoxesChange& change, bool forward) {
    setBoxes(forward ? change.after : change.before);
}

void Simulation::State::setBoxes(std::vector<StaticBox> now) {
    boxes = std::move(now);
    solver.setBoxes(boxes);
}

std::string Simulation::State::execute(const Restart&) {
    putBladeAway();
    noteBodyChange("Restart", captureForUndo());
    startBody();
    return "";
}

std::string Simulation::State::execute(const Undo&) {
    putBladeAway();
    if (!history.canUndo()) {
        return "There is nothing to undo.";
    }
    SnapshotPointer after;
    const UndoEntry& entry = history.lastDone();
    if (std::holds_alternative<UndoEntry::BodyChange>(entry.change)) {
        after = capture();
    }
    std::visit([this](const auto& change) { apply(change, false); }, entry.change);
    history.markUndone(std::move(after));
    return "";
}

std::string Simulation::State::execute(const Redo&) {
    if (!history.canRedo()) {
        return "There is nothing to redo.";
    }
    putBladeAway();
    std::visit([this](const auto& change) { apply(change, true); }, history.firstUndone().change);
    history.markRedone();
    return "";
}

void Simulation::State::apply(const UndoEntry::ParamChange& change, bool forward) {
    touch();
    setParam(params, change.param, forward ? change.after : change.before);
    paramsChanged = true;
}

void Simulation::State::apply(const UndoEntry::PinChange& change, bool forward) {
    touch();
    pins = forward ? change.after : change.before;
    solver.setPinned(pins.vertices());
}

void Simulation::State::apply(const UndoEntry::BodyChange& change, bool forward) {
    restoreBody(forward ? change.after : change.before);
}

/// Whatever the blade was about to do, it does no more.
void Simulation::State::putBladeAway() {
    bladeActions.clear();
    if (blade) {
        touch();
        cut(LiftBlade{});
        publish();
    }
}

/// Null where nothing is kept, or where a snapshot would not fit: a large body is not copied for
/// nothing.
SnapshotPointer Simulation::State::captureForUndo() {
    const bool fits = history.keeps() && snapshotBytes(mesh) <= history.budget();
    return fits ? capture() : nullptr;
}

void Simulation::State::noteBodyChange(std::string name, SnapshotPointer before) {
    if (before) {
        history.add({std::move(name), time, UndoEntry::BodyChange{std::move(before), nullptr}});
        toldTooLarge = false;
    } else if (history.keeps()) {
        history.forgetAll();
        if (!std::exchange(toldTooLarge, true)) {
            say("step {}: the body is larger than the undo memory ({} MB), so what has changed it "
                "so far can't be undone",
                stepsDone, history.budget() >> 20);
        }
    }
}

SnapshotPointer Simulation::State::capture() {
    mesh.bringAll();
    if (!current) {
        current = std::make_shared<const Snapshot>(
            Snapshot{mesh, *body, *cutter, solver.pages(), volumeTargets, hands, pins, measure,
                     solver.contactMemory(), closed, subdivisions});
    }
    return current;
}

void Simulation::State::restoreBody(const SnapshotPointer& snapshot) {
    mesh = snapshot->mesh;
    sync.forget();
    body = std::make_unique<BodyUpdater>(snapshot->body);
    cutter.emplace(snapshot->cutter);
    lookUpTriangles();
    volumeTargets = snapshot->volumeTargets;
    hands = snapshot->hands;
    pins = snapshot->pins;
    measure = snapshot->measure;
    sync.setBounds(measure.bounds);
    closed = snapshot->closed;
    subdivisions = snapshot->subdivisions;
    solver.restoreModel(model(), stateOf(mesh), snapshot->pages);
    solver.rememberContacts(snapshot->contact);
    solver.setVolumeTargets(volumeTargets.targets());
    solver.setPinned(pins.vertices());
    solver.saveState();
    bladeActions.clear();
    blade.reset();
    lastCut = {};
    pieces.reset();
    paramsChanged = true;  // the cutter follows some of them
    current = snapshot;
    publish();
}

Moment Simulation::State::moment() {
    return Moment(std::make_shared<const Moment::Content>(
        Moment::Content{capture(), params, boxes, blade, course, history, beforeStroke, strokeNoted,
                        cutsSoFar, stepsDone, time, report}));
}

void Simulation::State::goTo(const Moment::Content& then) {
    restoreBody(then.body);
    params = then.params;
    setBoxes(then.boxes);
    blade = then.blade;
    course = then.course;
    history = then.history;
    beforeStroke = then.beforeStroke;
    strokeNoted = then.strokeNoted;
    cutsSoFar = then.cutsSoFar;
    stepsDone = then.stepsDone;
    time = then.time;
    report = then.report;
}

Simulation::Simulation(SurfaceMesh mesh, const Params& params, std::vector<StaticBox> boxes)
    : Simulation(BodyUpload(PreparedBody(std::move(mesh))), params, std::move(boxes)) {}

Simulation::Simulation(BodyUpload body, const Params& params, std::vector<StaticBox> boxes) {
    body.finish();
    state_ = std::make_unique<State>(std::move(body.prepared_), std::move(body.solver_), params,
                                     std::move(boxes));
}

Simulation::~Simulation() = default;
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;

std::string Simulation::execute(const Command& command) {
    return std::visit([this](const auto& c) { return state_->execute(c); }, command);
}

void Simulation::readAllBack(bool all) {
    state_->readsAllBack = all;
    state_->lookUpTriangles();
}

int Simulation::wholeReads() const {
    return state_->sync.wholeReads();
}

const StepReport& Simulation::step() {
    return state_->step();
}
void Simulation::reset() {
    state_->start();
}
void Simulation::setUndoBudget(std::size_t bytes) {
    state_->history.setBudget(bytes);
}
const UndoHistory& Simulation::history() const {
    return state_->history;
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
    return state_->blade;
}
std::optional<BladeMotion> Simulation::bladeBody() const {
    return state_->bladeBody();
}
const std::vector<RungNode>& Simulation::rung() const {
    return state_->cutter->rung();
}
const SubdivisionCounts& Simulation::subdivisions() const {
    return state_->subdivisions;
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
    return state_->pins.vertices();
}

const std::vector<Hands::Hand>& Simulation::hands() const {
    return state_->hands.hands();
}

BodyView Simulation::bodyView() const {
    return state_->solver.view();
}

ConstraintView Simulation::constraintView() const {
    return state_->solver.constraintView();
}

const Bounds& Simulation::bounds() const {
    return state_->measure.bounds;
}

std::vector<Piece> Simulation::measuredPieces() const {
    std::vector<Piece> out;
    const BodyModel& model = state_->model();
    for (std::size_t p = 0; p < model.pieces.size(); ++p) {
        const PieceModel& piece = model.pieces[p];
        out.push_back({static_cast<int>(piece.triangleCount), static_cast<int>(piece.vertexCount),
                       state_->measure.pieceVolumes[p], piece.restVolume, piece.restArea});
    }
    return out;
}

const std::vector<Bounds>& Simulation::pieceBounds() const {
    return state_->measure.pieceBounds;
}

const SurfaceMesh& Simulation::mesh() {
    state_->mesh.bringAll();
    return state_->mesh;
}

const PieceMap& Simulation::pieces() {
    return state_->syncPieces();
}

std::string Simulation::stateHash() {
    return hashScene(mesh(), state_->boxes).hexadecimal();
}

}  // namespace kerf
