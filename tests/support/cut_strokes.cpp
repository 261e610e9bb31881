#include "tests/support/cut_strokes.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <map>
#include <set>

namespace kerf::test {

namespace {

constexpr double kVolumeTolerance = 1e-9;

/// The state that a step must conserve.
struct Before {
    double volume;
    double restVolume;
    std::size_t pieces;
    std::string bytes;
};

Before remember(const SurfaceMesh& mesh) {
    return {meshVolume(mesh), meshRestVolume(mesh), findPieces(mesh).pieces.size(),
            fingerprint(mesh)};
}

std::string checkConserved(const SurfaceMesh& mesh, const Before& before) {
    const double scale = std::fabs(before.volume);
    if (std::fabs(meshVolume(mesh) - before.volume) > kVolumeTolerance * scale) {
        return "the volume changed";
    }
    if (std::fabs(meshRestVolume(mesh) - before.restVolume) >
        kVolumeTolerance * std::fabs(before.restVolume)) {
        return "the rest volume changed";
    }
    return findPieces(mesh).pieces.size() < before.pieces ? "pieces were joined" : "";
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
    const std::set<int> relabelled(delta.relabelledTriangles.begin(),
                                   delta.relabelledTriangles.end());
    for (int v = delta.firstNewVertex; v < mesh.vertexCount(); ++v) {
        std::string problem;
        mesh.forEachOutgoing(v, [&](int h) {
            if (listed.count(h / 3) == 0 && relabelled.count(h / 3) == 0) {
                problem = "a triangle at a new vertex is not in the delta";
            }
        });
        if (!problem.empty()) {
            return problem;
        }
    }
    return "";
}

std::string checkCut(const SurfaceMesh& mesh, const Cutter& cutter, const CutResult& result,
                     const Before& before) {
    for (const std::string& problem :
         {checkClosedManifold(mesh), checkConserved(mesh, before), checkFront(mesh, cutter.rung()),
          checkDelta(mesh, result.delta)}) {
        if (!problem.empty()) {
            return problem;
        }
    }
    return "";
}

std::string checkStep(const SurfaceMesh& mesh, const Cutter& cutter, const CutResult& result,
                      const Before& before) {
    if (result.outcome == CutOutcome::cut) {
        return checkCut(mesh, cutter, result, before);
    }
    return fingerprint(mesh) == before.bytes ? "" : "a step that did not cut changed the mesh";
}

void countStep(const CutResult& result, CutCheck& check) {
    ++check.steps;
    check.cuts += result.outcome == CutOutcome::cut;
    check.refused += result.outcome == CutOutcome::refused;
    check.retried += result.outcome == CutOutcome::cut && result.statistics.tries > 1;
    check.tries += result.statistics.tries;
    if (result.outcome == CutOutcome::refused) {
        check.reason = result.reason;
    }
}

double tetrahedron(const Vec3& a, const Vec3& b, const Vec3& c) {
    return a.dot(b.cross(c)) / 6;
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
        volume += tetrahedron(polygon[0], polygon[i], polygon[i + 1]);
    }
    return volume;
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

CutSettings exactSettings() {
    CutSettings settings;
    settings.offset = 1e-7;
    settings.tolerance = 1e-9;
    return settings;
}

CutCheck runStroke(Cutter& cutter, SurfaceMesh& mesh, const Stroke& stroke,
                   const BetweenSteps& between) {
    CutCheck check;
    cutter.begin(stroke.front());
    for (std::size_t i = 1; i <= stroke.size() && check.problem.empty(); ++i) {
        if (between) {
            between(mesh, static_cast<int>(i));
        }
        const Before before = remember(mesh);
        const CutResult result = i < stroke.size() ? cutter.advance(stroke[i]) : cutter.finish();
        countStep(result, check);
        check.problem = checkStep(mesh, cutter, result, before);
    }
    if (check.problem.empty()) {
        check.unmirrored = checkMirroredWalls(mesh);
    }
    return check;
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
        append(bytes, mesh.mateGroup(v));
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
            points[i] = mesh.materialPoint(mesh.triangle(t)[i]);
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
