#include "sim/run/parts/running_body.h"

#include "shaders/shared/constraints.h"
#include "sim/base/containers.h"
#include "sim/base/math.h"
#include "sim/base/pausing.h"
#include "sim/base/placement.h"
#include "sim/base/text.h"
#include "sim/body/solver_uniforms.h"
#include "sim/contact/impact_zones.h"
#include "sim/mesh/oriented_box.h"
#include "sim/solve/implicit/step_choice.h"

namespace kerf {

namespace {

constexpr double kStill = 2e-4;  // at which nothing moves, diagonals of the uncut body per second

/// Ascending.
std::vector<std::uint32_t> verticesOf(const std::vector<shared::PullRecord>& pulls) {
    std::vector<std::uint32_t> vertices(pulls.size());
    std::ranges::transform(pulls, vertices.begin(), &shared::PullRecord::vertex);
    sortUnique(vertices);
    return vertices;
}

OrientedBox oriented(const Bounds& box) {
    return {box.center(), Eigen::Matrix3d::Identity(), 0.5 * (box.high - box.low)};
}

/// What flesh of the modulus of the edges is as stiff as the skin [m].
double skinAsFlesh(const Params& params, double ownModulus) {
    const double flesh =
        modulusFactor(shared::kStretch, params) * params.youngsModulus * ownModulus;
    const bool has = flesh > 0 && params.solver != SolverMode::pbd;
    return has ? params.skinModulus * params.skinThickness / flesh : 0;
}

/// Of what the parameters say of each model, as multiples of what they say of all.
std::vector<MemberMaterial> materialsOf(const Params& params, std::size_t models) {
    std::vector<MemberMaterial> materials(models);
    for (std::size_t m = 1; m < std::min(models, params.models.size() + 1); ++m) {
        const OwnMaterial& own = params.models[m - 1];
        materials[m].modulus =
            own.youngsModulus.value_or(params.youngsModulus) / params.youngsModulus;
        materials[m].density = own.density.value_or(params.density) / params.density;
    }
    for (MemberMaterial& material : materials) {
        material.skin = skinAsFlesh(params, material.modulus);
    }
    return materials;
}

/// In the coming step, at twice its speed.
bool mayMeetFloor(const BodyMeasure& measure, const Params& params) {
    const double way = 2 * measure.fastest * params.timeStep;
    return params.floor && measure.bounds.low.y() < *params.floor + way;
}

/// Whether some piece is led to another volume, by more than what a cut leaves.
bool volumesWork(const BodyModel& model, const VolumeTargets& volumes) {
    constexpr double kMuch = 1e-3;  // of the piece
    const std::span<const VolumeTarget> targets = volumes.targets();
    return std::ranges::any_of(targets, [&](const VolumeTarget& target) {
        const double rest = model.pieces[&target - targets.data()].restVolume;
        return std::abs(target.volume - rest) > kMuch * std::abs(rest);
    });
}

}  // namespace

RunningBody::RunningBody(PreparedBody prepared, std::unique_ptr<GpuSolver> loadedSolver)
    : first(std::move(prepared.uncut)),
      updater(std::move(prepared.body)),
      solverOwner(std::move(loadedSolver)),
      cutter(std::move(*prepared.cutter)) {
    take(first);
    lookUpTriangles();
    beginAtRest();
}

void RunningBody::take(std::shared_ptr<const UncutBody> body) {
    uncut = std::move(body);
    sync.followMesh(mesh());
    diagonal = boxOf(uncut->mesh.restPositions()).diagonal();
    wallEdge = contactEdgeLength(uncut->body.model());
    thin = thinWalls(uncut->body.model()).many();
}

void RunningBody::startAsAtFirst() {
    take(first);
    startAnew();
}

std::string RunningBody::checkModel(int model) const {
    const std::size_t models = uncut->models.size();
    return static_cast<std::size_t>(model) < models
               ? ""
               : "There is no model " + std::to_string(model) + "; the scene has " +
                     counted(models, "model", "models") + ", numbered from 0.";
}

void RunningBody::startAnew(std::shared_ptr<const UncutBody> placed) {
    whole = false;
    take(std::move(placed));
    startAnew();
}

void RunningBody::startAnew() {
    whole = false;
    mesh() = uncut->mesh;
    pausePoint();
    updater = std::make_unique<BodyUpdater>(uncut->body);
    pausePoint();
    solver.setModel(model(), stateOf(mesh()));
    pausePoint();
    cutter.emplace(uncut->cutter);
    lookUpTriangles();
    beginAtRest();
    becomeWhole();
}

/// As another one than before.
void RunningBody::becomeWhole() {
    ++modelRevision;
    whole = true;
}

/// With updater, solver and cutter as new.
void RunningBody::beginAtRest() {
    memory = {};
    memory.volumeTargets.reset(model());
    memory.closed = uncut->closed;
    sync.invalidate();  // by the rounding to float
    forgetPieces();
}

void RunningBody::measureAtRest() {
    memory.measure = solver.measure();
    sync.setBounds(memory.measure.bounds);
    solver.savedPieces().save();
}

void RunningBody::apply(const Params& params) {
    if (params.solver == SolverMode::implicit) {
        solver.compileImplicitSteps();
    }
    solver.setUniforms(solverUniforms(params));
    if (updater->ispcRays() != ispcRays(params)) {
        castIspcs(ispcRays(params));
    }
    if (updater->setMaterials(materialsOf(params, uncut->models.size()))) {
        solver.takeMaterials(model());
    }
    volumesHeld = holdsVolume(params);
    holdVolumes();
    CutSettings& settings = cutter->settings();
    settings.wallCoarsening = params.wallCoarsening;
    settings.debrisVolume = params.debrisVolume;
    settings.openCut = params.openCut != 0;
    settings.search = params.cutSearch;
}

int RunningBody::iterationsFor(const Params& params, const Surroundings& around, int steps) const {
    if (params.iterations != kAutoIterations) {
        return params.iterations;
    }
    if (params.solver == SolverMode::pbd) {
        return kUsualSweeps;
    }
    const double way = relativeSpeed(params, around) * params.timeStep / steps;
    return implicitIterations(model(), way / leastDiagonal(model()), params.iterationError);
}

int RunningBody::implicitStepsFor(const Params& params, const Surroundings& around) const {
    if (params.solver != SolverMode::implicit) {
        return 1;
    }
    const double longest =
        std::min(longestStep(model(), params),
                 longestStepAt(relativeSpeed(params, around), leastDiagonal(model())));
    return std::min(stepsWithin(params.timeStep, longest) * memory.guard.divisions(),
                    kMostImplicitSteps);
}

double RunningBody::stillEnergy(const Params& params) const {
    double mass = 0;
    for (const BodyMember& member : model().members) {
        mass += params.density * member.density * std::abs(member.restVolume);
    }
    return 0.5 * mass * std::pow(kStill * diagonal, 2);
}

std::optional<double> RunningBody::residual(const Params& params) const {
    return params.solver == SolverMode::implicit ? solver.measurer().residual(stillEnergy(params))
                                                 : std::nullopt;
}

bool RunningBody::guardSteps(const Params& params, bool worked) {
    const bool gains = worked || isMoved_ || cutter->inStroke() || solver.stepper().unfolds();
    const BodyMeasure& measure = memory.measure;
    return params.solver == SolverMode::implicit &&
           memory.guard.note(
               {measure.kineticEnergy + measure.strainEnergy, measure.potentialEnergy},
               params.timeStep, gains, stillEnergy(params));
}

double RunningBody::relativeSpeed(const Params& params, const Surroundings& around) const {
    const BodyMeasure& measure = memory.measure;
    const bool meets = mayMeetFloor(measure, params) || around.boxes || around.bladeSpeed > 0;
    const double own = meets ? measure.fastest : solver.collisions().relativeSpeed();
    return own + around.bladeSpeed;
}

void RunningBody::applyToSolver(const Params& params) {
    solver.setUniforms(solverUniforms(params));
    solver.collisions().setSettings(contactSettings(params));
}

void RunningBody::castIspcs(IspcRays rays) {
    whole = false;
    const BodyChange change = updater->castIspcs(rays);
    solver.update(model(), change, {}, {});
    becomeWhole();
}

SnapshotPointer RunningBody::capture() {
    mesh().bringAll();
    const auto rested = [](const auto& part) {
        pausePoint();
        return part;
    };
    return std::make_shared<const Snapshot>(Snapshot{rested(mesh()), rested(*updater),
                                                     rested(*cutter), solver.pages(), memory,
                                                     solver.contactMemory(), uncut});
}

void RunningBody::restore(const Snapshot& snapshot) {
    whole = false;
    take(snapshot.uncut);
    mesh() = snapshot.mesh;
    pausePoint();
    updater = std::make_unique<BodyUpdater>(snapshot.body);
    pausePoint();
    cutter.emplace(snapshot.cutter);
    lookUpTriangles();
    pausePoint();
    memory = snapshot.memory;
    sync.setBounds(memory.measure.bounds);
    solver.restoreModel(model(), stateOf(mesh()), snapshot.pages);
    solver.remember(snapshot.contact);
    holdVolumes();
    holdPins();
    solver.savedPieces().save();
    forgetPieces();
    becomeWhole();
}

void RunningBody::setPins(Pins pins) {
    pins.goOnFrom(memory.pins, mesh());
    memory.pins = std::move(pins);
    memory.guard.startAnew();  // what is pinned counts for no energy
    holdPins();
}

void RunningBody::holdPins() {
    solver.masses().setPinned(memory.pins.vertices());
    if (memory.hands.empty()) {
        solver.setPulls(forces(1, {}));
    }
}

std::vector<shared::PullRecord> RunningBody::forces(
    double density, const std::vector<std::uint32_t>& pulled) const {
    constexpr double kArrow = 0.15;  // diagonals
    return memory.pins.accelerations(model(), density, pulled, kArrow * diagonal);
}

Bounds RunningBody::pinnedAfter(const MovePins& move) const {
    return boxOf(placesAfter(move));
}

std::vector<Vec3> RunningBody::placesAfter(const MovePins& move) const {
    std::vector<Vec3> places;
    for (const std::uint32_t v : memory.pins.vertices()) {
        places.push_back(mesh().position(static_cast<int>(v)));
    }
    // Their mean stays the same however they are turned.
    const Vec3 sum = std::accumulate(places.begin(), places.end(), Vec3(Vec3::Zero()));
    const Vec3 middle = sum / static_cast<double>(std::max<std::size_t>(1, places.size()));
    const Eigen::Matrix3d turn = turnOf(move.rotate);
    for (Vec3& place : places) {
        place = nearestFloats(middle + turn * (place - middle) + move.by);
    }
    return places;
}

void RunningBody::movePinned(const MovePins& move) {
    mesh().bringAll();
    const std::vector<Vec3> places = placesAfter(move);
    for (std::size_t i = 0; i < places.size(); ++i) {
        const int v = static_cast<int>(memory.pins.vertices()[i]);
        mesh().setPosition(v, places[i]);
        mesh().setVelocity(v, Vec3::Zero());
    }
    memory.pins.goOnFrom(memory.pins, mesh());
    memory.guard.startAnew();
    solver.setState(stateOf(mesh()));
    sync.forget();
    measureAtRest();
    forgetPieces();
}

void RunningBody::prepareStep(const Params& params, bool autoIterations) {
    const bool volumesChange = volumesHeld && memory.volumeTargets.fade(params.timeStep);
    const bool draws = memory.recovery.draws();
    std::vector<shared::PullRecord> pulls = memory.hands.advance(params.timeStep);
    if (draws) {
        const std::vector<shared::PullRecord> leads = leadsBack(params);
        pulls.insert(pulls.end(), leads.begin(), leads.end());
    }
    if (volumesChange || draws) {
        holdVolumes();
    }
    const std::vector<shared::PullRecord> pushes = forces(params.density, verticesOf(pulls));
    pulls.insert(pulls.end(), pushes.begin(), pushes.end());
    if (!memory.cohesion.empty() && params.solver == SolverMode::implicit) {
        const std::vector<shared::PullRecord> bonds = memory.cohesion.pulls(verticesOf(pulls));
        pulls.insert(pulls.end(), bonds.begin(), bonds.end());
    }
    solver.setPulls(pulls);
    isMoved_ = volumesWork(model(), memory.volumeTargets) || !pulls.empty() || memory.pins.moves();
    chooseSteps(params, autoIterations);
    const Pins::Course course = memory.pins.advance(params.timeStep, mesh());
    if (!course.vertices.empty()) {
        solver.masses().carryFrom(course.vertices, course.from, course.velocities);
    }
}

void RunningBody::chooseSteps(const Params& params, bool autoIterations) {
    if (params.solver == SolverMode::implicit) {
        ImplicitStep step =
            ImplicitStep::of(params, model().restPositions.size(), longestStep(model(), params));
        // Elasticity unfolds lips; pulls would hold them back in what falls.
        step.unfolds = memory.crumpled;
        step.close = autoIterations ? energyLeft(params.iterationError) : 0;
        solver.stepImplicitly(model(), params, step, memory.pins.vertices());
    } else {
        solver.stepBySweeps();
    }
}

/// What is drawn back to its shape passes other pieces on its way, and needs no volume.
void RunningBody::holdVolumes() {
    const std::span<const VolumeTarget> held = memory.volumeTargets.targets();
    std::vector<VolumeTarget> targets(held.begin(), held.end());
    for (std::size_t p = 0; p < targets.size(); ++p) {
        targets[p].constrained =
            targets[p].constrained && !memory.recovery.draws(static_cast<int>(p));
    }
    solver.setVolumeTargets(targets);
}

std::vector<shared::PullRecord> RunningBody::leadsBack(const Params& params) {
    return memory.recovery.advance({model(), mesh(), params, heldVertices()});
}

std::vector<std::uint32_t> RunningBody::heldVertices() const {
    std::vector<std::uint32_t> held = memory.hands.heldVertices();
    const std::vector<std::uint32_t>& pinned = memory.pins.vertices();
    held.insert(held.end(), pinned.begin(), pinned.end());
    sortUnique(held);
    return held;
}

/// What needs no result is done while the GPU measures.
void RunningBody::measureStep() {
    solver.measurer().start();
    sync.invalidate();
    forgetPieces();
    memory.measure = solver.measurer().take();
}

void RunningBody::bringLostPiecesBack() {
    solver.savedPieces().restoreAtRest(memory.measure.lostPieces);
    memory.measure = solver.measure();
}

bool RunningBody::keepsTrianglesApart(const Params& params) const {
    constexpr double kMuchStretch = 2.75;
    const bool isDrawn = memory.measure.largestStretch > kMuchStretch && keepsShape(params) &&
                         !memory.mayHaveCollapsed && !memory.crumpled &&
                         !cutter->inStroke();  // a front is drawn out for a moment
    return contactSettings(params).enabled && !memory.recovery.draws() && (thin || isDrawn);
}

void RunningBody::stopCrossings(const std::vector<Vec3>& before, const Params& params) {
    mesh().bringAll();
    if (kerf::stopCrossings({model(), before, params.floor, memory.pins.vertices(), thin},
                            mesh())) {
        solver.setState(stateOf(mesh()));
        sync.forget();
        measureAtRest();
    }
}

double RunningBody::endStep() {
    const std::vector<double>& volumes = memory.measure.pieceVolumes;
    for (int p = 0; p < static_cast<int>(volumes.size()); ++p) {
        if (!volumesHeld || memory.recovery.draws(p)) {
            memory.volumeTargets.startAt(p, volumes[p]);
        }
    }
    solver.savedPieces().save();
    const double prefetchMs = sync.takePrefetched();
    sync.setBounds(memory.measure.bounds);
    return prefetchMs;
}

/// By the box of the body, which is at hand, and that of the strip, then by what lies in the
/// latter.
std::vector<int> RunningBody::trianglesNear(std::span<const Vec3> strip) {
    Bounds swept = boxOf(strip);
    swept.widen(model().edgeLength);
    if (!swept.overlaps(memory.measure.bounds)) {
        return {};
    }
    OrientedBox sweptBox = orientedBoxOf(strip);
    sweptBox.widen(model().edgeLength);
    if (!overlap(sweptBox, oriented(memory.measure.bounds))) {
        return {};
    }
    if (readsAllBack) {
        sync.forget();  // the cutter does not tell it of changes then
    }
    return sync.near(sweptBox);
}

std::vector<RungNode> RunningBody::front() const {
    std::vector<RungNode> nodes = cutter->rung();
    for (RungNode& node : nodes) {
        if (node.vertex >= 0) {
            node.position = mesh().position(node.vertex);
        }
    }
    return nodes;
}

void RunningBody::readAllBack(bool all) {
    readsAllBack = all;
    lookUpTriangles();
}

void RunningBody::lookUpTriangles() {
    cutter->useFinder(readsAllBack ? nullptr : &sync);
}

bool RunningBody::liesStill() const {
    constexpr double kLongEnough = 1;  // [s]
    return memory.stillFor >= kLongEnough && memory.hands.empty() && !memory.pins.moves() &&
           !cutter->inStroke() && !memory.recovery.draws() && !looksCollapsed();
}

void RunningBody::noteStillness(double timeStep, bool lost) {
    const bool still = !lost && memory.measure.fastest <= kStill * diagonal;
    memory.stillFor = still ? memory.stillFor + timeStep : 0;
}

bool RunningBody::looksCollapsed() const {
    constexpr double kLittle = 0.5;
    const std::vector<PieceModel>& pieces = model().pieces;
    bool little = false;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        little = little || (pieces[p].holdsVolume &&
                            memory.measure.pieceVolumes[p] < kLittle * pieces[p].restVolume);
    }
    return little || solver.collisions().expectsFolds();
}

bool RunningBody::isOpen() const {
    return std::ranges::any_of(model().pieces, &PieceModel::open);
}

const PieceMap& RunningBody::pieces() {
    if (!pieces_) {
        pieces_ = findPieces(mesh());
    }
    return *pieces_;
}

}  // namespace kerf
