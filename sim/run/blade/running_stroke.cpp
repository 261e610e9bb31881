#include "sim/run/blade/running_stroke.h"

#include "sim/base/pausing.h"
#include "sim/body/solver_uniforms.h"
#include "sim/run/blade/cut_followers.h"
#include "sim/run/parts/led_blade.h"

namespace kerf {

void RunningStroke::step() {
    if (!input_.blade.isTold()) {
        return;
    }
    const WorkWatch watch;
    for (const BladeAction& action : input_.blade.takeActions()) {
        std::visit([this](const auto& a) { carryOut(a); }, action);
    }
    output_.report.times.cut = watch.milliseconds();
}

bool RunningStroke::isInStroke() const {
    return body_.cutter->inStroke() && !body_.memory.tear.goesOn;
}

bool RunningStroke::endsInStep() const {
    const auto lifts = [](const BladeAction& action) {
        return std::holds_alternative<LiftBlade>(action);
    };
    return isInStroke() && std::ranges::any_of(input_.blade.actions(), lifts);
}

void RunningStroke::carryOut(const MoveBlade& move) {
    LedBlade& blade = input_.blade;
    if (blade.isAt(move.blade)) {
        return;
    }
    const Blade edge = blade.edgeAt(move.blade, lag());
    if (blade.isPlaced() && mayTouch(edge)) {
        if (!isInStroke()) {
            begin();
        }
        accept(body_.cutter->advance(edge));
    } else {
        end();
    }
    blade.moveTo(move.blade, push().size.width, edge);
}

void RunningStroke::lift() {
    if (input_.blade.lift()) {
        end();
    }
    log_.endStroke();
}

/// Whether the cutter must look: a front is in the material, or the strip comes near the body.
bool RunningStroke::mayTouch(const Blade& to) {
    const std::vector<RungNode> rung =
        isInStroke() ? body_.cutter->rung() : std::vector<RungNode>{};
    const Blade& from = input_.blade.edge();
    std::vector<Vec3> strip{from.a, from.b, to.a, to.b};
    for (const RungNode& node : rung) {
        strip.push_back(node.position);
    }
    return standsInMaterial(rung) || body_.isNear(strip);
}

void RunningStroke::begin() {
    endTear(body_, log_.history(), output_);
    log_.beginStroke(body_);
    output_.refusal.clear();
    body_.cutter->begin(input_.blade.edge());
    StrokeRecord stroke;
    stroke.number = body_.cutter->strokeNumber();
    stroke.firstTriangle = body_.mesh().triangleSlots();
    body_.memory.beginStroke(stroke);
}

void RunningStroke::end() {
    accept(isInStroke() ? body_.cutter->finish() : CutResult{});
}

void RunningStroke::accept(const CutResult& result) {
    output_.lastCut = result;
    output_.report.add(result.statistics);
    addTo(body_.memory.subdivisions, result.statistics.patterns);
    if (result.outcome == CutOutcome::refused) {
        output_.refusal = refusalSentence(result, output_.clock.stepsDone);
        output_.messages.push_back(output_.refusal);
    }
    if (!result.delta.empty()) {
        log_.noteCut(output_);
    }
    followStep(result, body_, log_.history(), output_);
}

BladePush RunningStroke::push() const {
    const Params& params = input_.params;
    return {{params.bladeWidth * body_.diagonal, params.bladeThickness * body_.diagonal},
            body_.wallEdge,
            body_.cutter->gateAtFront() * body_.wallEdge,
            contactSettings(input_.solved()).substeps};
}

std::optional<BladeMotion> RunningStroke::bladeBody() const {
    return input_.params.bladePush != 0 ? input_.blade.body(push()) : std::nullopt;
}

/// While time stands nothing can yield: there the edge cuts as if it felt nothing.
std::optional<EdgeSpring> RunningStroke::edgeSpring() const {
    const Params& params = input_.params;
    if (params.bladeFeels == 0 || params.toughness <= 0 || params.solver == SolverMode::pbd ||
        !input_.timeRuns) {
        return std::nullopt;
    }
    const double edge = body_.cutter->edgeLengthAtFront();
    return EdgeSpring{params.toughness, params.bladeBluntness, edge,
                      body_.cutter->gateAtFront() * edge};
}

/// Once it has broken in, going on takes less.
double RunningStroke::lag() const {
    const std::optional<EdgeSpring> spring = edgeSpring();
    return spring ? spring->lag(standsInMaterial(body_.cutter->rung())) : 0;
}

std::optional<FeltEdge> RunningStroke::feltEdge() const {
    const std::optional<EdgeSpring> spring = edgeSpring();
    if (!spring || !input_.blade.isPlaced() || input_.blade.back().isZero(0)) {
        return std::nullopt;
    }
    const Blade edge = *input_.blade.pose();
    const Vec3 way = 2 * spring->mostLag(false) * input_.blade.back();
    const std::array<Vec3, 4> strip{edge.a, edge.b, edge.a + way, edge.b + way};
    const std::vector<int> triangles = body_.trianglesNear(strip);
    const std::vector<RungNode> front = body_.front();
    return kerf::feltEdge({edge, input_.blade.back(), front, body_.mesh(), triangles}, *spring);
}

std::optional<PressingEdge> RunningStroke::pressingEdge() const {
    const std::optional<FeltEdge> felt = feltEdge();
    if (!felt) {
        return std::nullopt;
    }
    const Blade from = *input_.blade.pose();
    const Blade to = input_.blade.nextPose();
    PressingEdge edge = felt->pressing;
    edge.way = 0.5 * edge.ahead.dot(to.a + to.b - from.a - from.b);
    return edge;
}

HeldEdge RunningStroke::heldEdge() const {
    const std::optional<FeltEdge> felt = feltEdge();
    return felt ? HeldEdge{felt->pressing.lag, felt->energy, 0} : HeldEdge{};
}

std::optional<BladeMotion> RunningStroke::bladeMotion() const {
    const bool pushes = input_.params.bladePush != 0 && input_.blade.isPlaced();
    return pushes ? input_.blade.motion(push(), body_.front()) : std::nullopt;
}

FrontHold::FrontHold(RunningBody& body, const Params& params) : body_(body), params_(params) {
    if (body_.mesh().openStroke() >= 0) {
        carryHidden();
        return;
    }
    if (!standsInMaterial(body_.cutter->rung())) {
        return;
    }
    anchors_ = findFrontAnchors(body_.cutter->rung(), frame());
    for (const Anchor& anchor : anchors_) {
        body_.solver.masses().anchor(anchor.vertex, anchor.velocity.cast<float>());
    }
}

void FrontHold::release() {
    for (const Anchor& anchor : std::exchange(anchors_, {})) {
        body_.solver.masses().release(anchor.vertex);
    }
}

void FrontHold::carryHidden() {
    std::vector<Anchor> found = findHiddenAnchors(body_.updater->hiddenVertices(), frame());
    std::ranges::sort(found, {}, &Anchor::vertex);
    std::vector<std::uint32_t> vertices;
    std::vector<Vec3f> velocities;
    for (const Anchor& anchor : found) {
        vertices.push_back(static_cast<std::uint32_t>(anchor.vertex));
        velocities.push_back(anchor.velocity.cast<float>());
    }
    if (!vertices.empty()) {
        body_.solver.masses().carry(vertices, velocities);
    }
}

AnchorFrame FrontHold::frame() const {
    return {body_.mesh(),
            body_.updater->pieceOfMeshVertex(),
            body_.cutter->edgeLengthAtFront(),
            body_.cutter->strokeSurface(),
            params_.timeStep,
            catchUpSpeed(params_)};
}

}  // namespace kerf
