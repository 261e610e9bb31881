#include "sim/solve/implicit_stepper.h"

#include <bit>

#include "shaders/shared/bindings.h"
#include "sim/body/solver_uniforms.h"
#include "sim/solve/float_vectors.h"

namespace kerf {

namespace {

using gpu::TexelFormat;
using shared::uint;

// Of a way at the speed of depenetration, since contacts that are pressed together gain speed.
constexpr double kLetOutShare = 0.4;

/// All that does not follow from the body.
void setParameters(shared::ImplicitUniforms& u, const Params& params, double step) {
    const StageScale scale = stageScale(step, params.damping);
    const TypeModuli moduli = typeModuli(params);
    u.gravity = {static_cast<float>(params.gravity.x()), static_cast<float>(params.gravity.y()),
                 static_cast<float>(params.gravity.z()), 0};
    u.stage = static_cast<float>(scale.stage);
    u.inertia = static_cast<float>(scale.inertia);
    u.rest = static_cast<float>(step - scale.stage);
    u.damping = static_cast<float>(scale.damped - 1);
    u.kept = static_cast<float>(std::exp(-params.airDrag * step));
    u.step = static_cast<float>(step);
    u.contact.friction = static_cast<float>(params.friction);
    u.contact.stiffness = static_cast<float>(contactRate(step) * contactRate(step));
    u.contact.let_out = static_cast<float>(kLetOutShare * params.depenetrationSpeed * step);
    u.contact.floor_height = static_cast<float>(params.floor.value_or(BodyReach::kNoFloor));
    u.holds_volume = holdsVolume(params) ? 1 : 0;
    u.inverse_density = static_cast<float>(1 / params.density);
    for (uint type = 0; type < kConstraintTypes; ++type) {
        u.modulus[type] = static_cast<float>(moduli[type]);
    }
}

constexpr double kFloorReach = 0.02;  // diagonals: nearer vertices are looked at in each step

/// A kernel of groups that work for a page or an aggregate.
gpu::Program compileGroups(const SolverBody& body, const std::string& name,
                           gpu::Defines defines = {}) {
    const uint many = name == "product" ? shared::kPageSize : 64;
    const uint threads = body.way == gpu::KernelWay::images ? 8 : many;
    defines.emplace_back("GROUP", std::to_string(threads) + "u");
    return body.compile("implicit/" + name, std::move(defines));
}

}  // namespace

ImplicitStepper::MatrixKernels::MatrixKernels(const SolverBody& body)
    : factors{body.compile("implicit/factors", {{"OF_EDGES", "1"}}),
              body.compile("implicit/factors", {{"OF_BENDS", "1"}}),
              body.compile("implicit/factors")},
      blocks(body.compile("implicit/blocks")),
      forces(body.compile("implicit/forces")),
      turns(body.compile("implicit/turns")),
      volume(body.compile("volume_gradient", body.groupsOfSums())) {}

ImplicitStepper::ContactKernels::ContactKernels(const SolverBody& body)
    : meet(body.compile("implicit/meet")),
      meetBoxes(body.compile("implicit/meet_obstacles")),
      pulls(body.compile("implicit/pulls")),
      rows(compileGroups(body, "rows")),
      startReach(compileGroups(body, "reach", {{"OF_START", "1"}})),
      reach(compileGroups(body, "reach")),
      hold(body.compile("implicit/hold")),
      carry(body.compile("implicit/hold", {{"CARRIES", "1"}})) {}

ImplicitStepper::BladeKernels::BladeKernels(const SolverBody& body)
    : meet(body.compile("implicit/meet_obstacles", {{"BLADE", "1"}})),
      load(body.compile("implicit/blade_load")),
      press(body.compile("implicit/press")),
      pressLoad(body.compile("implicit/press_load")) {}

ImplicitStepper::PressureKernels::PressureKernels(const SolverBody& body)
    : patches(compileGroups(body, "patches", {{"OF_PRESSURE", "1"}})),
      coarse(compileGroups(body, "coarse", {{"OF_PRESSURE", "1"}})),
      product(compileGroups(body, "product", {{"OF_START", "1"}})) {}

ImplicitStepper::RegionKernels::RegionKernels(const SolverBody& body)
    : restrict(compileGroups(body, "restrict")),
      regions(compileGroups(body, "regions")),
      pressCoarse(compileGroups(body, "coarse", {{"OF_PRESSURE", "1"}, {"OF_REGIONS", "1"}})),
      coarse(compileGroups(body, "coarse", {{"OF_REGIONS", "1"}})) {}

ImplicitStepper::StageKernels::StageKernels(const SolverBody& body)
    : begin{compileGroups(body, "begin"), compileGroups(body, "begin", {{"OF_SECOND", "1"}})},
      startProduct(compileGroups(body, "product", {{"OF_START", "1"}, {"OF_MOTION", "1"}})),
      startPatches(compileGroups(body, "patches", {{"OF_START", "1"}})),
      coarse(compileGroups(body, "coarse")),
      product(compileGroups(body, "product")),
      patches(compileGroups(body, "patches")),
      leave(compileGroups(body, "leave")),
      turning(compileGroups(body, "turning")),
      spin(compileGroups(body, "spin")),
      end(compileGroups(body, "end")) {}

ImplicitStepper::ImplicitStepper(SolverBody& body, Collisions& collisions)
    : body_(body),
      collisions_(collisions),
      make_(body),
      contact_(body),
      press_(body),
      stage_(body) {}

void ImplicitStepper::setBody(const BodyModel& model, const Params& params,
                              const ImplicitStep& step, std::span<const uint> pinned) {
    const std::vector<double> masses = massesWithout(model, params.density, pinned);
    const double firmest = firmestIn(step.prepared);
    const std::vector<ConstraintPull> pulls =
        boundedPullsAtRest(model, typeModuli(params), masses, firmest);
    const VertexGroups groups = groupVertices(model, pulls, step.aggregateSize);
    const RestInverse inverse =
        invertAtRest(model, pulls, groups, masses, stageScale(step.prepared, params.damping));
    std::vector<std::vector<uint>> pages;
    for (std::size_t piece = 0; piece < model.pieces.size(); ++piece) {
        pages.push_back(body_.pieces.pages().pagesOf(piece));
    }
    own_.matrix.assign(model, body_.pieces.pages().places(), pages);
    own_.inverse.assign(model, groups, inverse, pages);
    own_.contact.assign(model, contactFirmness(pulls, masses.size()), masses,
                        own_.matrix.pageCount);
    body_.state.courses.resize(std::max<std::size_t>(model.pieces.size(), 1) *
                               sizeof(shared::Course));
    body_.state.courses.clear();
    body_.state.displacement.clear();  // steps keep it so: volumes are those at X
    own_.vectors.makeRoom(model.restPositions.size(), own_.inverse.aggregateCount,
                          model.pieces.size());
    uniforms_.bounds.firmest = static_cast<float>(firmest);
    uniforms_.vertex_count = size32(model.restPositions.size());
    uniforms_.block_count = own_.matrix.blockCount;
    uniforms_.patch_count = own_.inverse.patchCount;
    uniforms_.aggregate_count = own_.inverse.aggregateCount;
    uniforms_.region_count = own_.inverse.regionCount;
    if (own_.inverse.regionCount > 0 && !regions_) {
        regions_.emplace(body_);
    }
    uniforms_.page_count = own_.matrix.pageCount;
    uniforms_.piece_count = size32(model.pieces.size());
    uniforms_.contact.reach = static_cast<float>(kFloorReach * model.diagonal);
    setStep(params, step);
}

void ImplicitStepper::setStep(const Params& params, const ImplicitStep& step) {
    iterations_ = static_cast<uint>(step.iterations);
    own_.vectors.makeSlots(shared::kFirstSlot + iterations_ + 2, own_.matrix.pageCount,
                           own_.inverse.aggregateCount);
    setParameters(uniforms_, params, step.step);
    uniforms_.bounds.close = static_cast<float>(step.close);
    own_.setForceUnits(uniforms_.contact.stiffness);
    uniformBuffer_.assign(std::span<const shared::ImplicitUniforms>(&uniforms_, 1));
}

void ImplicitStepper::bindVectors() const {
    uniformBuffer_.bindStorage(shared::kImplicitBinding);
    const auto bind = [&](const gpu::Buffer& buffer, uint binding) {
        buffer.bindStorage(binding);
        body_.bindFetched(buffer, binding, TexelFormat::float32x4);
    };
    bind(body_.state.positions, shared::kPositionsBinding);
    bind(body_.state.velocities, shared::kVelocitiesBinding);
    bind(own_.vectors.residual, shared::kResidualBinding);
    bind(own_.vectors.answer, shared::kAnswerBinding);
    bind(own_.vectors.direction, shared::kDirectionBinding);
    bind(own_.vectors.image, shared::kImageBinding);
    bind(own_.vectors.way, shared::kWayBinding);
    bind(own_.vectors.pressure, shared::kPressureBinding);
    bind(own_.vectors.pressureImage, shared::kPressureImageBinding);
    bind(own_.vectors.force, shared::kForceBinding);
    bind(own_.vectors.productSums, shared::kProductSumsBinding);
    own_.vectors.answerSums.bindStorage(shared::kAnswerSumsBinding);
    body_.bindFetched(body_.state.courses, shared::kCoursesUnit, TexelFormat::float32x4);
    bind(own_.inverse.modes, shared::kModesBinding);
    bind(own_.vectors.firstWay, shared::kFirstWayBinding);
    own_.inverse.turned.bindStorage(shared::kTurnedBinding);
    body_.bindFetched(body_.state.gradients, shared::kGradientsBinding, TexelFormat::float32x4);
}

void ImplicitStepper::bindLists() const {
    const auto quads = TexelFormat::uint32x4;
    const auto pairs = TexelFormat::uint32x2;
    const auto floats = TexelFormat::float32x4;
    body_.bindFetched(own_.matrix.rows, shared::kRowsUnit, pairs);
    if (body_.way == gpu::KernelWay::images) {
        own_.inverse.turned.bindImage(shared::kTurnedUnit, floats);
    }
    body_.bindFetched(own_.matrix.blocks, shared::kBlocksUnit, floats);
    body_.bindFetched(own_.matrix.rowOrder, shared::kRowOrderUnit, TexelFormat::uint32);
    body_.bindFetched(own_.matrix.pageTable, shared::kPageTableUnit, pairs);
    body_.bindFetched(own_.inverse.aggregates, shared::kAggregatesUnit, quads);
    body_.bindFetched(own_.inverse.members, shared::kMembersUnit, quads);
    body_.bindFetched(own_.inverse.memberShares, shared::kMemberSharesUnit, floats);
    body_.bindFetched(own_.inverse.patchInverse, shared::kPatchInverseUnit, floats);
    body_.bindFetched(own_.inverse.coarse, shared::kCoarseUnit, floats);
    body_.bindFetched(own_.inverse.turns, shared::kTurnsUnit, floats);
    body_.bindFetched(own_.inverse.pieces, shared::kPiecesUnit, quads);
}

void ImplicitStepper::runGroups(const gpu::Program& kernel, uint groups, uint slot, uint second,
                                uint third) {
    kernel.setNumbers({slot, second, third, 0});
    kernel.dispatchGroups(groups);
    ++body_.dispatches;
}

std::vector<shared::vec4> ImplicitStepper::slips() const {
    const gpu::Buffer& kept = own_.contact.keptSlips;
    return kept.read<shared::vec4>(0, kept.size() / sizeof(shared::vec4));
}

void ImplicitStepper::setSlips(const std::vector<shared::vec4>& slips) {
    own_.contact.keptSlips.clear();
    own_.contact.keptSlips.write(0, std::span<const shared::vec4>(slips));
}

void ImplicitStepper::begin(uint number) {
    number_ = number;
    meet();
    linearise();
}

/// The spin that pieces lack, then new positions and velocities, also of what is held.
void ImplicitStepper::end(bool heldMove) {
    const uint last = shared::kFirstSlot + iterations_ + 1;
    bindVectors();
    bindLists();
    body_.bindFetched(own_.contact.rows, shared::kContactRowsUnit, TexelFormat::float32x4);
    body_.bindFetched(own_.contact.states, shared::kRowStatesUnit, TexelFormat::float32x4);
    own_.contact.keptSlips.bindStorage(shared::kKeptSlipsBinding);
    own_.vectors.motions.bindStorage(shared::kMotionsBinding);
    runGroups(stage_.turning, own_.inverse.aggregateCount, last);
    body_.bindFetched(own_.vectors.motions, shared::kMotionsUnit, TexelFormat::float32x4);
    own_.vectors.spins.bindStorage(shared::kMadeSpinsBinding);
    runGroups(stage_.spin, uniforms_.piece_count, last);
    body_.bindFetched(own_.vectors.spins, shared::kSpinsUnit, TexelFormat::float32x4);
    collisions_.contacts().state().bindStorage(shared::kEndContactsBinding);
    runGroups(stage_.end, own_.inverse.aggregateCount, last);
    if (heldMove) {
        body_.run(contact_.carry, uniforms_.vertex_count);
    }
    collisions_.keepSides(body_.state.velocities, uniforms_.step);
}

/// What the motion of held vertices does to the others.
void ImplicitStepper::driftBy(bool heldMove) {
    if (heldMove) {
        bindVectors();
        body_.run(contact_.hold, uniforms_.vertex_count);
        own_.vectors.drift.bindStorage(shared::kImageBinding);
        runGroups(press_.product, own_.matrix.pageCount, shared::kStartSlot);
    } else if (drifts_) {
        own_.vectors.drift.clear();
    }
    drifts_ = heldMove;
}

/// What hands, forces and bonds do in a stage that ends then.
void ImplicitStepper::pull(double stageEnd, bool begins) {
    const uint count = body_.uniforms.pull_count;
    if (count == 0) {
        return;
    }
    body_.bind();
    uniformBuffer_.bindStorage(shared::kImplicitBinding);
    body_.pulls.bindStorage(shared::kPullsBinding);
    own_.contact.parents.bindStorage(shared::kParentsBinding);
    own_.contact.states.bindStorage(shared::kRowStatesBinding);
    own_.contact.rows.bindStorage(shared::kPullRowsBinding);
    own_.contact.rowVertices.bindStorage(shared::kPullVerticesBinding);
    own_.vectors.force.bindStorage(shared::kForceBinding);
    contact_.pulls.setNumbers(
        {firstPull(), count, std::bit_cast<uint>(static_cast<float>(stageEnd)), begins ? 1U : 0U});
    body_.run(contact_.pulls, count);
}

/// Which contacts there may be in the step, and which pieces they join.
void ImplicitStepper::meet() {
    const ContactSolver& contacts = collisions_.contacts();
    body_.bind();
    if (contacts.mayTouch()) {
        contacts.bindAnswers({shared::kMeetContactBinding, shared::kMadeListBinding,
                              shared::kMadeListBinding, shared::kMadeListBinding},
                             body_.way);
    }
    uniformBuffer_.bindStorage(shared::kImplicitBinding);
    own_.contact.parents.copyFrom(own_.contact.unjoined);
    own_.contact.parents.bindStorage(shared::kParentsBinding);
    contacts.state().bindStorage(shared::kMeetStateBinding);
    own_.contact.rows.bindStorage(shared::kMadeRowsBinding);
    own_.contact.rowVertices.bindStorage(shared::kMadeRowVerticesBinding);
    body_.bindFetched(own_.contact.firmness, shared::kFirmnessUnit, TexelFormat::uint32);
    body_.bindFetched(own_.contact.keptSlips, shared::kKeptSlipsUnit, TexelFormat::float32x4);
    const gpu::Program& kernel = contacts.folds() == nullptr ? contact_.meet : meetBesideFolds();
    kernel.setNumbers({contacts.mayTouch() ? 1U : 0U, 0, 0, 0});
    body_.run(kernel, uniforms_.vertex_count);
    meetObstacles(collisions_.boxes(), contact_.meetBoxes);
    if (!blade_ && (collisions_.bladeBody().mayTouch() || collisions_.push().mayTouch())) {
        blade_.emplace(body_);
    }
    if (blade_) {
        meetObstacles(collisions_.bladeBody(), blade_->meet);
    }
    own_.contact.makeRows(std::size_t{firstPull()} + body_.uniforms.pull_count +
                          (pressedRows() > 0 ? uniforms_.vertex_count : 0));
    pull(uniforms_.step, true);
    press();

    own_.inverse.pieces.bindStorage(shared::kMadePiecesBinding);
    own_.contact.list.bindStorage(shared::kMadeListBinding);
    body_.bindFetched(own_.inverse.pieces, shared::kPiecesUnit, TexelFormat::uint32x4);
    body_.bindFetched(own_.contact.rows, shared::kContactRowsUnit, TexelFormat::float32x4);
    body_.bindFetched(own_.matrix.rowOrder, shared::kRowOrderUnit, TexelFormat::uint32);
    body_.bindFetched(own_.matrix.pageTable, shared::kPageTableUnit, TexelFormat::uint32x2);
    contact_.rows.setNumbers(
        {firstPull(), body_.uniforms.pull_count, pressedRows() > 0 ? 1U : 0U, 0});
    contact_.rows.dispatchGroups(uniforms_.piece_count);
    ++body_.dispatches;
}

const gpu::Program& ImplicitStepper::meetBesideFolds() {
    if (!meetBesideFolds_) {
        meetBesideFolds_ = body_.compile("implicit/meet", {{"UNFOLDS", "1"}});
    }
    collisions_.contacts().folds()->bindTexels(shared::kFoldsUnit, TexelFormat::uint32);
    return *meetBesideFolds_;
}

void ImplicitStepper::meetObstacles(const ObstacleContact& obstacles, const gpu::Program& kernel) {
    if (!obstacles.mayTouch()) {
        return;
    }
    obstacles.bindMeetings(body_.way);
    kernel.setNumbers({number_, 0, 0, 0});
    body_.run(kernel, uniforms_.vertex_count);
}

uint ImplicitStepper::firstPull() const {
    return shared::kRowsOfVertex * uniforms_.vertex_count;
}

uint ImplicitStepper::pressedRows() const {
    return collisions_.push().mayTouch() ? firstPull() + body_.uniforms.pull_count : 0;
}

/// Makes the rows of an edge that presses.
void ImplicitStepper::press() {
    if (pressedRows() == 0) {
        return;
    }
    collisions_.push().bindPressing();
    own_.contact.rows.bindStorage(shared::kMadeRowsBinding);
    own_.contact.rowVertices.bindStorage(shared::kMadeRowVerticesBinding);
    blade_->press.setNumbers({number_, pressedRows(), 0, 0});
    body_.run(blade_->press, uniforms_.vertex_count);
}

/// What a blade has done in a stage, from its rows.
void ImplicitStepper::addLoads(bool second) {
    const float share = (second ? uniforms_.stage : uniforms_.rest) / uniforms_.step;
    const uint bits = std::bit_cast<uint>(share);
    if (collisions_.bladeBody().bindLoads()) {
        blade_->load.setNumbers({number_, bits, 0, 0});
        body_.run(blade_->load, uniforms_.vertex_count);
    }
    if (pressedRows() > 0) {
        collisions_.push().bindPressing();
        blade_->pressLoad.setNumbers({pressedRows(), bits, second ? 1U : 0U, 0});
        blade_->pressLoad.dispatchGroups(1);
        ++body_.dispatches;
    }
}

/// What the iterations of a stage have of contact, besides vectors.
void ImplicitStepper::bindContacts() const {
    const auto floats = TexelFormat::float32x4;
    own_.contact.forces.bindStorage(shared::kContactForcesBinding);
    own_.contact.relatives.bindStorage(shared::kRelativeBinding);
    own_.contact.reaches.bindStorage(shared::kReachesBinding);
    own_.contact.states.bindStorage(shared::kRowStatesBinding);
    own_.vectors.total.bindStorage(shared::kTotalBinding);
    body_.bindFetched(own_.contact.forces, shared::kContactForcesUnit, TexelFormat::uint32x4);
    body_.bindFetched(own_.contact.relatives, shared::kRelativeUnit, floats);
    body_.bindFetched(own_.contact.reaches, shared::kReachesUnit, floats);
    body_.bindFetched(own_.vectors.total, shared::kTotalUnit, floats);
    body_.bindFetched(own_.contact.rows, shared::kContactRowsUnit, floats);
    body_.bindFetched(own_.contact.rowVertices, shared::kRowVerticesUnit, TexelFormat::uint32x4);
    body_.bindFetched(own_.contact.list, shared::kRowListUnit, TexelFormat::uint32);
    body_.bindFetched(own_.contact.states, shared::kRowStatesUnit, floats);
}

/// The matrix, the forces, the volumes and their gradients, and how the parts of the preconditioner
/// have turned: all at X.
void ImplicitStepper::linearise() {
    body_.bind();
    body_.pieces.blockSums.bindStorage(shared::kBlockSumsBinding);
    body_.runOverBlocks(make_.volume);

    uniformBuffer_.bindStorage(shared::kImplicitBinding);
    body_.bindFetched(body_.state.positions, shared::kPositionsBinding, TexelFormat::float32x4);
    own_.matrix.pulls.bindStorage(shared::kMadePullsBinding);
    for (uint type = 0; type < kConstraintTypes; ++type) {
        makeFactors(type);
    }
    body_.bindFetched(own_.matrix.factors, shared::kFactorsUnit, TexelFormat::float32x4);
    body_.bindFetched(own_.matrix.pulls, shared::kPullsUnit, TexelFormat::float32x4);
    body_.bindFetched(own_.matrix.blockShares, shared::kBlockSharesUnit, TexelFormat::uint32);
    own_.vectors.force.bindStorage(shared::kForceBinding);
    body_.bindFetched(own_.matrix.blockList, shared::kBlockListUnit, TexelFormat::uint32x4);
    own_.matrix.blocks.bindStorageParts(
        shared::kMadeBlocksBinding, 3 * sizeof(shared::vec4),
        [&](std::size_t first, std::size_t bound) {
            make_.blocks.setNumbers({size32(first), size32(bound), 0, 0});
            body_.run(make_.blocks, own_.matrix.blockCount);
        });
    body_.bindFetched(own_.matrix.ownShares, shared::kOwnSharesUnit, TexelFormat::uint32x2);
    body_.run(make_.forces, uniforms_.vertex_count);

    body_.bindFetched(own_.inverse.aggregates, shared::kAggregatesUnit, TexelFormat::uint32x4);
    body_.bindFetched(own_.inverse.members, shared::kMembersUnit, TexelFormat::uint32x4);
    body_.bindFetched(own_.inverse.patches, shared::kPatchesUnit, TexelFormat::uint32x2);
    body_.bindFetched(body_.model.restPositions, shared::kRestUnit, TexelFormat::float32x4);
    body_.bindFetched(own_.inverse.regions, shared::kRegionsUnit, TexelFormat::uint32x4);
    own_.inverse.turns.bindStorage(shared::kMadeTurnsBinding);
    body_.run(make_.turns,
              uniforms_.patch_count + uniforms_.aggregate_count + uniforms_.region_count);
}

void ImplicitStepper::makeFactors(uint type) {
    const ConstraintBuffers& constraints = body_.model.constraints[type];
    const bool spokes = type == shared::kStretch;
    body_.bindFetched(spokes ? constraints.entries : constraints.records,
                      shared::kConstraintsBinding, TexelFormat::uint32x4);
    body_.bindFetched(own_.matrix.spokeOwners, shared::kSpokeOwnersUnit, TexelFormat::uint32);
    const uint count = spokes ? size32(constraints.entries.size() / sizeof(shared::Spoke))
                              : body_.uniforms.count[type];
    own_.matrix.factors.bindStorageParts(
        shared::kMadeFactorsBinding, sizeof(shared::vec4),
        [&](std::size_t first, std::size_t bound) {
            make_.factors[type].setNumbers(
                {count, own_.matrix.firstFactor[type], size32(first), size32(bound)});
            body_.run(make_.factors[type], count);
        });
}

/// By which volumes are held: the preconditioner's answer to dV/dp, and the matrix times that.
void ImplicitStepper::answerPressure() {
    bindVectors();
    bindLists();
    body_.pieces.pieceBuffer.bindStorage(shared::kPiecesBinding);
    runGroups(press_.patches, own_.inverse.aggregateCount, shared::kPressureSlot);
    own_.vectors.pressure.bindStorage(shared::kPressureBinding);
    answerByModes(true, shared::kPressureSlot);
    body_.bindFetched(own_.vectors.pressure, shared::kDirectionBinding, TexelFormat::float32x4);
    own_.vectors.pressureImage.bindStorage(shared::kImageBinding);
    runGroups(press_.product, own_.matrix.pageCount, shared::kPressureSlot);
}

/// Adds the answer of the aggregates to that of the patches.
void ImplicitStepper::answerByModes(bool ofPressure, uint slot) {
    const uint aggregates = own_.inverse.aggregateCount;
    // What a blade feels and leads needs all of them; friction's bounds are renewed in half.
    const bool bladeActs = collisions_.bladeBody().mayTouch() || collisions_.push().mayTouch();
    const uint mayEnd =
        shared::kFirstSlot + (bladeActs ? iterations_ : std::max(iterations_ / 2, 1U));
    if (own_.inverse.regionCount == 0) {
        runGroups(ofPressure ? press_.coarse : stage_.coarse, aggregates, slot, mayEnd);
        return;
    }
    body_.bindFetched(own_.inverse.regions, shared::kRegionsUnit, TexelFormat::uint32x4);
    body_.bindFetched(own_.inverse.levels, shared::kLevelsUnit, TexelFormat::float32x4);
    runGroups(regions_->restrict, own_.inverse.regionCount, slot);
    runGroups(regions_->regions, own_.inverse.regionCount, slot);
    runGroups(ofPressure ? regions_->pressCoarse : regions_->coarse, aggregates, slot, mayEnd);
    body_.bindFetched(own_.matrix.rowOrder, shared::kRowOrderUnit, TexelFormat::uint32);
    body_.bindFetched(own_.matrix.pageTable, shared::kPageTableUnit, TexelFormat::uint32x2);
}

void ImplicitStepper::solveStage(bool second) {
    const uint aggregates = own_.inverse.aggregateCount;
    const uint left = shared::kFirstSlot + iterations_ + 1;
    pull(second ? uniforms_.step : uniforms_.stage, false);
    bindVectors();
    bindLists();
    body_.bindFetched(own_.vectors.drift, shared::kDriftUnit, TexelFormat::float32x4);
    body_.bindFetched(own_.contact.rows, shared::kContactRowsUnit, TexelFormat::float32x4);
    body_.bindFetched(own_.contact.states, shared::kRowStatesUnit, TexelFormat::float32x4);
    own_.contact.states.bindStorage(shared::kRowStatesBinding);
    runGroups(stage_.begin[second ? 1 : 0], aggregates, left, pressedRows());
    runGroups(stage_.startProduct, own_.matrix.pageCount, shared::kStartSlot);
    bindContacts();
    body_.pieces.pieceBuffer.bindStorage(shared::kPiecesBinding);
    body_.pieces.blockSums.bindStorage(shared::kBlockSumsBinding);
    runGroups(contact_.startReach, uniforms_.piece_count, shared::kStartSlot);
    own_.vectors.answerSums.bindStorage(shared::kAnswerSumsBinding);
    body_.state.courses.bindStorage(shared::kMadeCoursesBinding);
    runGroups(stage_.startPatches, aggregates, shared::kStartSlot);
    for (uint i = 0; i < iterations_; ++i) {
        const uint slot = shared::kFirstSlot + i;
        answerByModes(false, slot);
        runGroups(stage_.product, own_.matrix.pageCount, slot);
        runGroups(contact_.reach, uniforms_.piece_count, slot, i + 1 == iterations_ / 2 ? 1 : 0,
                  i + 1 == iterations_ ? 1 : 0);
        if (i + 1 < iterations_) {
            runGroups(stage_.patches, aggregates, slot);
        }
    }
    runGroups(stage_.leave, aggregates, left - 2, left);
    addLoads(second);
}

}  // namespace kerf
