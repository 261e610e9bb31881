#include "tests/support/scene_player.h"

#include <cstdio>
#include <stdexcept>

#include "sim/mesh/triangle.h"
#include "tests/support/contact_scenes.h"
#include "tests/support/cut_strokes.h"
#include "tests/support/folds.h"

namespace kerf::test {

namespace {

constexpr double kGravity = 9.81;
constexpr int kSoon = 50;       // steps after a stroke
constexpr double kChip = 1e-4;  // of the body's volume

double heightOf(const SurfaceMesh& mesh) {
    const Bounds bounds = meshBounds(mesh);
    return bounds.high.y() - bounds.low.y();
}

Params parametersOf(const SceneRun& run, bool weightless) {
    Params params;
    params.youngsModulus = run.youngsModulus;
    params.contact = run.contact ? 1 : 0;
    params.bladePush = run.push ? 1 : 0;
    params.wallCoarsening = run.grading;
    if (weightless) {
        params.gravity = Vec3::Zero();
        params.floor.reset();
    }
    return params;
}

const char* nameOf(CutOutcome outcome) {
    constexpr std::array kNames{"air", "waiting", "withdrawing", "cut", "refused"};
    return kNames[static_cast<int>(outcome)];
}

}  // namespace

ScenePlayer::ScenePlayer(const SceneRun& run, SurfaceMesh mesh, bool weightless)
    : run_(run),
      draw_(run.seed * 7919 + static_cast<std::uint64_t>(run.index) * 104729),
      bodyVolume_(meshRestVolume(mesh)),
      diagonal_(meshBounds(mesh).diagonal()),
      fallSpeed_(std::sqrt(2 * kGravity * heightOf(mesh))),
      simulation_(std::move(mesh), parametersOf(run, weightless)) {}

Vec3 ScenePlayer::middle() {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : mesh().positions()) {
        sum += p;
    }
    return sum / mesh().vertexCount();
}

void ScenePlayer::settle(int steps) {
    for (int i = 0; i < steps; ++i) {
        simulation_.step();
    }
}

void ScenePlayer::stroke(const Path& path, int steps, bool through) {
    const int first = labelsSoFar();
    for (int i = 0; i <= steps; ++i) {
        const Blade blade = path(i / static_cast<double>(steps));
        if (through) {
            requireEndsOutside(blade);
        }
        simulation_.execute(MoveBlade{blade});
        cutStep();
    }
    simulation_.execute(LiftBlade{});
    cutStep();
    if (through) {
        for (int label = first; label < labelsSoFar(); ++label) {
            throughLabels_.push_back(label);
        }
    }
}

void ScenePlayer::requireEndsOutside(const Blade& blade) {
    for (const Vec3& end : {blade.a, blade.b}) {
        if (depthInside(mesh(), end) > 0) {
            throw std::logic_error("a stroke that should pass through ends inside the body");
        }
    }
}

void ScenePlayer::watch(int steps) {
    figures_.foldsInView = 0;
    for (int i = 0; i < steps; ++i) {
        simulation_.step();
        readMessages();
        figures_.speedAfter = std::max(figures_.speedAfter, topSpeed() / diagonal_);
        if (run_.verbose && (i + 1) % kSoon == 0) {
            std::printf("  %d steps after the stroke\n", i + 1);
            describeFolds();
        }
        if (i + 1 == kSoon || steps - i <= kInView) {
            countFolds();
            figures_.foldsInView += steps - i <= kInView ? figures_.folded : 0;
            figures_.foldedSoon = i + 1 == kSoon ? figures_.folded : figures_.foldedSoon;
        }
    }
}

void ScenePlayer::cutStep() {
    simulation_.step();
    countOutcome(simulation_.lastCut());
    readMessages();
    const double speed = topSpeed();
    figures_.speedCutting = std::max(figures_.speedCutting, speed / fallSpeed_);
    if (run_.verbose) {
        describeStep(speed);
    }
}

void ScenePlayer::describeStep(double speed) {
    const CutResult& cut = simulation_.lastCut();
    const SurfaceMesh& mesh = simulation_.mesh();
    const std::vector<int> strayed = strayedHalfEdges(mesh, simulation_.rung());
    std::printf("  step %4d %-11s tries %2d  walls %3d  pieces %d  speed %6.2f  strayed %d  %s\n",
                simulation_.stepCount() - 1, nameOf(cut.outcome), cut.statistics.tries,
                cut.statistics.wallTriangles, simulation_.report().pieces, speed,
                static_cast<int>(strayed.size()), cut.reason.c_str());
    if (strayed.size() > strayedBefore_) {
        for (const int h : strayed) {
            const Vec3& p = mesh.position(mesh.origin(h));
            const Vec3& q = mesh.position(mesh.target(h));
            std::printf("    slit edge %d-%d (%.3f %.3f %.3f)-(%.3f %.3f %.3f)\n", mesh.origin(h),
                        mesh.target(h), p.x(), p.y(), p.z(), q.x(), q.y(), q.z());
        }
    }
    if (strayed.size() > strayedBefore_ || cut.outcome == CutOutcome::refused) {
        for (const RungNode& node : rungBefore_) {
            std::printf("    rung %d s %.4f (%.3f %.3f %.3f)%s\n", node.vertex, node.s,
                        node.position.x(), node.position.y(), node.position.z(),
                        node.attached ? " attached" : "");
        }
    }
    strayedBefore_ = strayed.size();
    rungBefore_ = simulation_.rung();
    for (RungNode& node : rungBefore_) {
        node.position = node.vertex >= 0 ? mesh.position(node.vertex) : node.position;
    }
}

void ScenePlayer::describeFolds() {
    const std::vector<Vec3>& now = mesh().positions();
    const std::vector<Vec3>& rest = mesh().restPositions();
    const auto area = [](const std::vector<Vec3>& at, int a, int b, int c) {
        return triangleArea(at[a], at[b], at[c]);
    };
    constexpr double kDegrees = 180 / std::numbers::pi;
    for (const Fold& fold : foldsOf(mesh(), simulation_.pinnedVertices())) {
        const auto [v0, v1, v2, v3] = fold.corners;
        const double left = area(rest, v0, v1, v2);
        const double right = area(rest, v0, v1, v3);
        std::printf(
            "    fold %u-%u (%u %u) %4.0f from %4.0f degrees  edge %.4f of %.4f m  "
            "areas %.2f of %.1e, %.2f of %.1e m^2\n",
            v0, v1, v2, v3, fold.turn * kDegrees, fold.restAngle * kDegrees,
            (now[v1] - now[v0]).norm(), (rest[v1] - rest[v0]).norm(), area(now, v0, v1, v2) / left,
            left, area(now, v0, v1, v3) / right, right);
    }
}

void ScenePlayer::countOutcome(const CutResult& result) {
    const CutStatistics& counts = result.statistics;
    figures_.attempted += counts.cutPieces + counts.refusedPieces;
    figures_.refused += counts.refusedPieces;
    figures_.retried += result.outcome == CutOutcome::cut && counts.tries > 1;
    if (counts.refusedPieces > 0) {
        ++refusedInARow_;
    } else if (counts.cutPieces > 0) {
        refusedInARow_ = 0;
    }
    figures_.longestRefusal = std::max(figures_.longestRefusal, refusedInARow_);
}

void ScenePlayer::readMessages() {
    for (const std::string& message : simulation_.takeMessages()) {
        figures_.nonFinite += message.find("range of numbers") != std::string::npos;
    }
}

int ScenePlayer::labelsSoFar() {
    const SurfaceMesh& mesh = simulation_.mesh();
    int last = -1;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        last = std::max(last, mesh.wallLabel(t));
    }
    return (last + 1) / 2;
}

double ScenePlayer::topSpeed() {
    const SurfaceMesh& mesh = simulation_.mesh();
    double top = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (mesh.outgoing(v) >= 0) {
            top = std::max(top, mesh.velocity(v).norm());
        }
    }
    return top;
}

int ScenePlayer::chips() {
    return static_cast<int>(std::ranges::count_if(simulation_.pieces().pieces, [&](const Piece& p) {
        return p.restVolume < kChip * bodyVolume_;
    }));
}

int ScenePlayer::slitEdgesLeft() {
    int count = 0;
    for (const int stroke : throughLabels_) {
        count += slitEdges(simulation_.mesh(), stroke);
    }
    return count;
}

void ScenePlayer::countFolds() {
    const int all = foldedEdges(mesh());
    figures_.folded = foldedEdges(mesh(), simulation_.pinnedVertices());
    figures_.foldedAtPins = all - figures_.folded;
}

SceneFigures ScenePlayer::finish(int pieces) {
    figures_.runs = 1;
    figures_.open = !checkClosedManifold(simulation_.mesh()).empty();
    figures_.chips = chips();
    const int solid = static_cast<int>(simulation_.pieces().pieces.size()) - figures_.chips;
    figures_.slitEdges = slitEdgesLeft();
    figures_.unseparated = solid < pieces;
    countFolds();
    return figures_;
}

}  // namespace kerf::test
