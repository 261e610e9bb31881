#include "tests/support/cut_strokes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <iostream>

#include "sim/body/rest_geometry.h"
#include "sim/cut/wall_copies.h"
#include "sim/mesh/triangle.h"

namespace kerf::test {

namespace {

constexpr double kVolumeTolerance = 1e-9;

/// The state that a step must conserve.
struct Before {
    double volume;
    double restVolume;
    std::size_t pieces;
    std::string bytes;
    std::vector<Vec3> restPositions;
};

Before remember(const SurfaceMesh& mesh) {
    return {meshVolume(mesh), meshRestVolume(mesh), findPieces(mesh).pieces.size(),
            fingerprint(mesh), mesh.restPositions()};
}

double relativeChange(double now, double before) {
    return std::fabs(now - before) / std::fabs(before);
}

std::string checkConserved(const SurfaceMesh& mesh, const CutResult& result, const Before& before,
                           double admitted) {
    const double tolerance = kVolumeTolerance + admitted;
    if (relativeChange(meshVolume(mesh), before.volume) > tolerance) {
        return "the volume changed";
    }
    if (relativeChange(meshRestVolume(mesh), before.restVolume) > tolerance) {
        return "the rest volume changed";
    }
    const std::size_t pieces = findPieces(mesh).pieces.size();
    if (pieces < before.pieces) {
        return "pieces were joined";
    }
    return result.outcome != CutOutcome::cut && pieces != before.pieces
               ? "the clean-up changed the number of pieces"
               : "";
}

std::string checkDelta(const SurfaceMesh& mesh, const CutDelta& delta) {
    for (const int t : delta.removedTriangles) {
        if (mesh.alive(t)) {
            return "a removed triangle is alive";
        }
    }
    for (const int t : delta.addedTriangles) {
        if (!mesh.alive(t)) {
            return "an added triangle is dead";
        }
    }
    const std::set<int> listed(delta.addedTriangles.begin(), delta.addedTriangles.end());
    const std::set<int> changed(delta.changedTriangles.begin(), delta.changedTriangles.end());
    std::vector<int> vertices = delta.movedVertices;
    for (int v = delta.firstNewVertex; v < mesh.vertexCount(); ++v) {
        vertices.push_back(v);
    }
    for (const int v : vertices) {
        bool complete = true;
        mesh.forEachOutgoing(v, [&](int h) {
            complete = complete && (listed.count(h / 3) > 0 || changed.count(h / 3) > 0);
        });
        if (!complete) {
            return "a triangle at a new or moved vertex is not in the delta";
        }
    }
    for (const int v : delta.deadVertices) {
        if (mesh.outgoing(v) >= 0) {
            return "a dead vertex has a triangle";
        }
    }
    return "";
}

std::string checkChange(const SurfaceMesh& mesh, const Cutter& cutter, const CutResult& result,
                        const Before& before, double admitted) {
    for (const std::string& problem :
         {checkClosedManifold(mesh), checkConserved(mesh, result, before, admitted),
          checkFront(mesh, cutter.rung()), checkDelta(mesh, result.delta)}) {
        if (!problem.empty()) {
            return problem;
        }
    }
    return "";
}

/// Vertices of the uncut skin that a step moved at rest or took away must lie beside a wall. How
/// near depends on the edge length there (Workspace::isKept), of which `h` is the mean.
std::string checkSkinBesideTheCut(const SurfaceMesh& mesh, const Before& before, double h) {
    constexpr double kBeside = 0.3;
    const std::vector<int> living = livingTriangles(mesh);
    for (int v = 0; mesh.isOriginal(v); ++v) {
        const Vec3& was = before.restPositions[v];
        if (mesh.outgoing(v) >= 0 && mesh.restPosition(v) == was) {
            continue;
        }
        const bool isBesideCut = std::ranges::any_of(living, [&](int t) {
            const Triangle& c = mesh.triangle(t);
            const Vec3& p = mesh.restPosition(c[0]);
            const Vec3& q = mesh.restPosition(c[1]);
            const Vec3& r = mesh.restPosition(c[2]);
            const Vec3 w = closestWeights(was, p, q, r);
            return mesh.kind(t) == SurfaceKind::wall &&
                   (w[0] * p + w[1] * q + w[2] * r - was).norm() < kBeside * h;
        });
        if (!isBesideCut) {
            return "the skin changed far from the cut, at vertex " + std::to_string(v);
        }
    }
    return "";
}

std::string checkStep(const SurfaceMesh& mesh, const Cutter& cutter, const CutResult& result,
                      const Before& before, double admitted) {
    if (!result.delta.empty()) {
        return checkChange(mesh, cutter, result, before, admitted);
    }
    return fingerprint(mesh) == before.bytes ? "" : "a step that did not cut changed the mesh";
}

void countStep(const CutResult& result, CutCheck& check) {
    ++check.steps;
    check.cuts += result.outcome == CutOutcome::cut;
    check.refused += result.outcome == CutOutcome::refused;
    check.resumed += result.statistics.resumed;
    check.retried += result.outcome == CutOutcome::cut && result.statistics.tries > 1;
    check.tries += result.statistics.tries;
    check.cleanup.collapses += result.statistics.cleanup.collapses;
    check.cleanup.flips += result.statistics.cleanup.flips;
    check.cleanup.slides += result.statistics.cleanup.slides;
    check.cleanup.volumeSpent =
        std::max(check.cleanup.volumeSpent, result.statistics.cleanup.volumeSpent);
    if (result.outcome == CutOutcome::refused) {
        check.reason = result.reason;
    }
}

// KERF_FUZZ_TRACE=1 tells what each step did.
void trace(const CutResult& result, int step, const SurfaceMesh& mesh) {
    static const bool wanted = std::getenv("KERF_FUZZ_TRACE") != nullptr;
    if (wanted && (result.outcome == CutOutcome::cut || result.outcome == CutOutcome::refused)) {
        std::cerr << "  step " << step << (result.outcome == CutOutcome::cut ? " cut" : " refused")
                  << ", tries " << result.statistics.tries << ", touched "
                  << result.statistics.touchedTriangles << ", triangles "
                  << livingTriangles(mesh).size() << ", volume change "
                  << result.statistics.volumeChange
                  << (result.statistics.resumed > 0 ? ", resumed " : " ") << result.reason << "\n";
    }
}

/// The part of a triangle on the positive side, relative to a point on the plane: the cap in the
/// plane then has no volume of its own.
double volumeAbove(std::array<Vec3, 3> p, const Vec3& normal) {
    std::vector<Vec3> polygon;
    for (int i = 0; i < 3; ++i) {
        const Vec3& a = p[i];
        const Vec3& b = p[(i + 1) % 3];
        const double da = a.dot(normal);
        const double db = b.dot(normal);
        if (da >= 0) {
            polygon.push_back(a);
        }
        if ((da > 0 && db < 0) || (da < 0 && db > 0)) {
            polygon.push_back(a + (b - a) * (da / (da - db)));
        }
    }
    double volume = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        volume += tetrahedronVolume(polygon[0], polygon[i], polygon[i + 1]);
    }
    return volume;
}

/// The distance to the nearest part of what was swept, positive on the side of along x travel.
double signedDistance(const Stroke& stroke, const Vec3& p) {
    double least = 1e300;
    double side = 0;
    Vec3 facing = Vec3::Zero();  // a blade that goes back keeps its sides
    const auto measure = [&](const Vec3& a, const Vec3& b, const Vec3& c) {
        Vec3 normal = areaNormal(a, b, c);
        if (normal.dot(facing) < 0) {
            normal = -normal;
        }
        facing = normal.isZero(0) ? facing : normal;
        const Vec3 w = closestWeights(p, a, b, c);
        const double distance = (w[0] * a + w[1] * b + w[2] * c - p).norm();
        if (distance < least) {
            least = distance;
            side = normal.dot(p - a) > 0 ? distance : -distance;
        }
    };
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
        measure(stroke[i].a, stroke[i].b, stroke[i + 1].b);
        measure(stroke[i].a, stroke[i + 1].b, stroke[i + 1].a);
    }
    return side;
}

double heightOverLongestEdge(const SurfaceMesh& mesh, int t) {
    const Corners at = cornersOf(mesh, t);
    const double longest = longestEdgeSquare(at);
    return longest > 0 ? areaNormal(at).norm() / longest : 0;
}

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(T));
}

void append(std::string& bytes, const Vec3& p) {
    bytes.append(reinterpret_cast<const char*>(p.data()), 3 * sizeof(double));
}

}  // namespace

Stroke straightStroke(const Vec3& center, const Vec3& along, const Vec3& travel, double length,
                      double distance, int steps) {
    Stroke stroke;
    for (int i = 0; i <= steps; ++i) {
        const Vec3 middle = center + travel * (distance * (i / static_cast<double>(steps) - 0.5));
        stroke.push_back({middle - along * (0.5 * length), middle + along * (0.5 * length)});
    }
    return stroke;
}

void SliverCount::add(const SliverCount& other) {
    triangles += other.triangles;
    below002 += other.below002;
    below0001 += other.below0001;
}

void StrokeQuality::add(const StrokeQuality& other) {
    skin.add(other.skin);
    walls.add(other.walls);
}

SliverCount StrokeQuality::all() const {
    SliverCount sum = skin;
    sum.add(walls);
    return sum;
}

StrokeQuality qualityOf(const SurfaceMesh& mesh, const std::vector<int>& triangles) {
    StrokeQuality result;
    for (const int t : triangles) {
        if (!mesh.alive(t)) {
            continue;
        }
        const double quality = heightOverLongestEdge(mesh, t);
        SliverCount& count = mesh.kind(t) == SurfaceKind::skin ? result.skin : result.walls;
        ++count.triangles;
        count.below002 += quality < 0.02;
        count.below0001 += quality < 0.001;
    }
    return result;
}

CutSettings exactSettings() {
    CutSettings settings;
    settings.offset = 1e-7;
    settings.tolerance = 1e-9;
    return settings;
}

CutCheck runStroke(Cutter& cutter, SurfaceMesh& mesh, const Stroke& stroke,
                   const BetweenSteps& between) {
    CutCheck check;
    std::set<int> made;
    const double h = wallEdgeFor(meanRestEdgeLength(mesh), meshBounds(mesh).diagonal());
    cutter.begin(stroke.front());
    for (std::size_t i = 1; i <= stroke.size() && check.problem.empty(); ++i) {
        if (between) {
            between(mesh, static_cast<int>(i));
        }
        const Before before = remember(mesh);
        const CutResult result = i < stroke.size() ? cutter.advance(stroke[i]) : cutter.finish();
        const double spentBefore = check.cleanup.volumeSpent;
        countStep(result, check);
        trace(result, static_cast<int>(i), mesh);
        check.problem =
            checkStep(mesh, cutter, result, before, check.cleanup.volumeSpent - spentBefore);
        if (check.problem.empty()) {
            check.problem = checkSkinBesideTheCut(mesh, before, h);
        }
        check.volumeChange += std::max(relativeChange(meshVolume(mesh), before.volume),
                                       relativeChange(meshRestVolume(mesh), before.restVolume));
        made.insert(result.delta.addedTriangles.begin(), result.delta.addedTriangles.end());
        made.insert(result.delta.changedTriangles.begin(), result.delta.changedTriangles.end());
    }
    check.quality = qualityOf(mesh, {made.begin(), made.end()});
    if (check.problem.empty()) {
        check.unmirrored = checkMirroredWalls(mesh);
    }
    return check;
}

void expectSound(const CutCheck& check) {
    EXPECT_EQ(check.problem, "");
    EXPECT_EQ(check.unmirrored, "");
    EXPECT_EQ(check.refused, 0) << check.reason;
}

CutCheck runStroke(SurfaceMesh& mesh, const CutSettings& settings, const Stroke& stroke) {
    Cutter cutter(mesh, settings);
    return runStroke(cutter, mesh, stroke);
}

std::string fingerprint(const SurfaceMesh& mesh) {
    std::string bytes;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        append(bytes, mesh.position(v));
        append(bytes, mesh.restPosition(v));
        append(bytes, mesh.velocity(v));
        append(bytes, mesh.outgoing(v));
        append(bytes, mesh.copyGroup(v));
    }
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        append(bytes, mesh.triangle(t));
        append(bytes, mesh.kind(t));
        append(bytes, mesh.wallLabel(t));
        for (int e = 0; e < 3; ++e) {
            append(bytes, mesh.twin(3 * t + e));
        }
    }
    return bytes;
}

std::string checkMirroredWalls(const SurfaceMesh& mesh) {
    std::map<std::pair<int, std::array<int, 3>>, int> balance;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t) || mesh.kind(t) != SurfaceKind::wall) {
            continue;
        }
        std::array<int, 3> points{};
        for (int i = 0; i < 3; ++i) {
            points[i] = mesh.firstCopy(mesh.triangle(t)[i]);
        }
        std::sort(points.begin(), points.end());
        balance[{mesh.wallLabel(t) / 2, points}] += mesh.wallLabel(t) % 2 == 0 ? 1 : -1;
    }
    int lonely = 0;
    for (const auto& [key, count] : balance) {
        lonely += std::abs(count);
    }
    return lonely == 0 ? "" : std::to_string(lonely) + " wall triangles have no mirror";
}

std::string checkFront(const SurfaceMesh& mesh, const std::vector<RungNode>& rung) {
    for (std::size_t i = 0; i + 1 < rung.size(); ++i) {
        if (!rung[i].attached) {
            continue;
        }
        const int h = mesh.findHalfEdge(rung[i].vertex, rung[i + 1].vertex);
        if (h < 0) {
            return "a front edge is not in the mesh";
        }
        if (mesh.kind(h / 3) != SurfaceKind::wall ||
            mesh.kind(mesh.twin(h) / 3) != SurfaceKind::wall) {
            return "a front edge does not lie between two walls";
        }
    }
    return "";
}

std::vector<int> slitHalfEdges(const SurfaceMesh& mesh, int stroke) {
    std::vector<int> found;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        if (mesh.alive(h / 3) && mesh.wallLabel(h / 3) == 2 * stroke &&
            mesh.wallLabel(mesh.twin(h) / 3) == 2 * stroke + 1) {
            found.push_back(h);
        }
    }
    return found;
}

int slitEdges(const SurfaceMesh& mesh, int stroke) {
    return static_cast<int>(slitHalfEdges(mesh, stroke).size());
}

int piecesOf(const SurfaceMesh& mesh) {
    return static_cast<int>(findPieces(mesh).pieces.size());
}

int piecesOnBothSides(const SurfaceMesh& mesh, const Stroke& stroke, double distance) {
    const PieceMap map = findPieces(mesh);
    std::vector<std::array<bool, 2>> sides(map.pieces.size(), {false, false});
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const double side = map.ofVertex[v] < 0 ? 0 : signedDistance(stroke, mesh.position(v));
        if (std::fabs(side) > distance) {
            sides[map.ofVertex[v]][side > 0 ? 1 : 0] = true;
        }
    }
    return static_cast<int>(
        std::ranges::count_if(sides, [](const auto& s) { return s[0] && s[1]; }));
}

std::vector<int> strayedHalfEdges(const SurfaceMesh& mesh, const std::vector<RungNode>& rung) {
    std::set<int> front;
    for (std::size_t i = 0; i + 1 < rung.size(); ++i) {
        if (rung[i].attached) {
            const int h = mesh.findHalfEdge(rung[i].vertex, rung[i + 1].vertex);
            front.insert({h, mesh.twin(h)});
        }
    }
    std::vector<int> found;
    for (int h = 0; h < 3 * mesh.triangleSlots(); ++h) {
        const int label = mesh.alive(h / 3) ? mesh.wallLabel(h / 3) : -1;
        if (label >= 0 && label % 2 == 0 && mesh.wallLabel(mesh.twin(h) / 3) == label + 1 &&
            front.count(h) == 0) {
            found.push_back(h);
        }
    }
    return found;
}

HalfSpaceVolumes clipVolumes(const SurfaceMesh& mesh, const Vec3& point, const Vec3& normal) {
    HalfSpaceVolumes volumes;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        if (!mesh.alive(t)) {
            continue;
        }
        std::array<Vec3, 3> p;
        for (int i = 0; i < 3; ++i) {
            p[i] = mesh.position(mesh.triangle(t)[i]) - point;
        }
        volumes.above += volumeAbove(p, normal);
        volumes.below += volumeAbove(p, -normal);
    }
    return volumes;
}

double meanSide(const SurfaceMesh& mesh, const PieceMap& map, int piece, const Vec3& point,
                const Vec3& normal) {
    double sum = 0;
    int count = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (map.ofVertex[v] == piece) {
            sum += (mesh.position(v) - point).dot(normal);
            ++count;
        }
    }
    return count == 0 ? 0 : sum / count;
}

}  // namespace kerf::test
