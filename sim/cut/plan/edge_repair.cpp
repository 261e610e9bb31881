#include "sim/cut/plan/edge_repair.h"

#include "sim/base/containers.h"
#include "sim/cut/wall_copies.h"

namespace kerf::cut {

namespace {

/// Splits the edge of half-edge h at its middle, both triangles into two. Returns the new vertex.
int splitEdgeAtMiddle(SurfaceMesh& mesh, int h) {
    const int g = mesh.twin(h);
    const int t = h / 3, o = g / 3;
    const int a = mesh.origin(h), b = mesh.target(h), c = mesh.apex(h), d = mesh.apex(g);
    const std::array<int, 4> before{SurfaceMesh::next(h), SurfaceMesh::previous(h),
                                    SurfaceMesh::next(g), SurfaceMesh::previous(g)};
    std::array<int, 4> outer{};
    for (int i = 0; i < 4; ++i) {
        outer[i] = mesh.twin(before[i]);
    }
    const int m = mesh.addVertex(0.5 * (mesh.position(a) + mesh.position(b)),
                                 0.5 * (mesh.restPosition(a) + mesh.restPosition(b)),
                                 0.5 * (mesh.velocity(a) + mesh.velocity(b)));
    mesh.setCorners(t, {a, m, c});
    mesh.setCorners(o, {b, m, d});
    const int t1 = mesh.addTriangle({m, b, c}, mesh.kind(t), mesh.wallLabel(t));
    const int o1 = mesh.addTriangle({m, a, d}, mesh.kind(o), mesh.wallLabel(o));
    mesh.link(3 * t, 3 * o1);
    mesh.link(3 * t + 1, 3 * t1 + 2);
    mesh.link(3 * t1, 3 * o);
    mesh.link(3 * o + 1, 3 * o1 + 2);
    const std::array<int, 4> after{3 * t1 + 1, 3 * t + 2, 3 * o1 + 1, 3 * o + 2};
    for (int i = 0; i < 4; ++i) {  // a partner may be one of the four itself
        const auto moved = std::find(before.begin(), before.end(), outer[i]);
        mesh.link(after[i], moved == before.end() ? outer[i] : after[moved - before.begin()]);
    }
    mesh.setOutgoing(m, 3 * t1);
    mesh.setOutgoing(a, 3 * t);
    mesh.setOutgoing(b, 3 * o);
    mesh.setOutgoing(c, 3 * t + 2);
    mesh.setOutgoing(d, 3 * o + 2);
    return m;
}

bool intersects(const std::vector<int>& p, const std::vector<int>& q) {
    return std::any_of(p.begin(), p.end(),
                       [&](int x) { return std::find(q.begin(), q.end(), x) != q.end(); });
}

bool hasParallels(const SurfaceMesh& mesh, std::span<const int> spokes) {
    for (std::size_t i = 0; i < spokes.size(); ++i) {
        const auto isParallel = [&, v = mesh.target(spokes[i])](int h) {
            return mesh.target(h) == v;
        };
        if (std::ranges::any_of(spokes.first(i), isParallel)) {
            return true;
        }
    }
    return false;
}

class DuplicateEdges {
  public:
    DuplicateEdges(SurfaceMesh& mesh, int firstTriangle, int stroke,
                   const std::set<Edge>& frontEdges)
        : mesh_(mesh), first_(firstTriangle), stroke_(stroke), frontEdges_(frontEdges) {}

    std::vector<int> run() {
        const int end = mesh_.triangleSlots();
        for (int t = first_; t < end; ++t) {
            for (int e = 0; e < 3; ++e) {
                resolve(3 * t + e);
            }
        }
        return divided_;
    }

  private:
    std::vector<int> edgesBetween(int u, int v) const {
        std::vector<int> result;
        mesh_.forEachOutgoing(u, [&](int h) {
            if (mesh_.target(h) == v) {
                result.push_back(h);
            }
        });
        return result;
    }

    void resolve(int h) {
        const int u = mesh_.origin(h);
        const int v = mesh_.target(h);
        const std::vector<int> parallel = edgesBetween(u, v);
        if (parallel.size() < 2) {
            return;
        }
        bool frontToKeep = isFront(u, v);
        int kept = 0;
        std::vector<int> ofWalls;
        for (const int x : parallel) {
            if (!runs(x, u, v)) {
                continue;
            }
            if (frontToKeep && joinsSheets(x)) {
                frontToKeep = false;
                kept = 1;
            } else if (!isWall(x / 3) && !isWall(mesh_.twin(x) / 3)) {
                split(x);
            } else {
                ofWalls.push_back(x);
            }
        }
        if (sizeOf(ofWalls) + kept > 1) {
            splitWithMirrors(u, v, ofWalls, parallel);
        }
    }

    bool runs(int h, int u, int v) const { return mesh_.origin(h) == u && mesh_.target(h) == v; }
    bool isWall(int t) const { return mesh_.kind(t) == SurfaceKind::wall; }
    bool isFront(int u, int v) const { return frontEdges_.count(edgeOf(u, v)) > 0; }

    bool joinsSheets(int h) const {
        const int t = h / 3;
        const int o = mesh_.twin(h) / 3;
        return mesh_.wallLabel(t) / 2 == stroke_ && mesh_.wallLabel(o) / 2 == stroke_ &&
               mesh_.wallLabel(t) != mesh_.wallLabel(o) && isWall(t) && isWall(o);
    }

    // The first copies of the apexes of an edge in the walls beside it: mirrored edges share them.
    std::vector<int> wallApexes(int h) const {
        std::vector<int> result;
        for (const int side : {h, mesh_.twin(h)}) {
            if (isWall(side / 3)) {
                result.push_back(mesh_.firstCopy(mesh_.apex(side)));
            }
        }
        return result;
    }

    std::vector<int> allApexes(const std::vector<int>& edges) const {
        std::vector<int> result;
        for (const int h : edges) {
            const std::vector<int> apexes = wallApexes(h);
            result.insert(result.end(), apexes.begin(), apexes.end());
        }
        return result;
    }

    // Copies of the edge between other copies of u and v, in the mirror of the same walls.
    std::vector<int> mirrorsOf(int u, int v, const std::vector<int>& edges,
                               const std::vector<int>& parallel) const {
        std::set<int> known;
        for (const int x : parallel) {
            known.insert(x);
            known.insert(mesh_.twin(x));
        }
        const std::vector<int> apexes = allApexes(edges);
        const std::vector<int> ends = livingCopies(mesh_, v);
        std::vector<int> result;
        for (const int start : livingCopies(mesh_, u)) {
            mesh_.forEachOutgoing(start, [&](int h) {
                if (std::find(ends.begin(), ends.end(), mesh_.target(h)) == ends.end() ||
                    known.count(h) > 0) {
                    return;
                }
                const std::vector<int> own = wallApexes(h);
                const bool slitEnd = own.size() == 2 && own[0] == own[1];
                if (intersects(own, apexes) && !slitEnd &&
                    !isFront(mesh_.origin(h), mesh_.target(h))) {
                    result.push_back(h);
                    known.insert(h);
                    known.insert(mesh_.twin(h));
                }
            });
        }
        return result;
    }

    void splitWithMirrors(int u, int v, const std::vector<int>& ofWalls,
                          const std::vector<int>& parallel) {
        std::vector<int> edges = ofWalls;
        const std::vector<int> mirrors = mirrorsOf(u, v, ofWalls, parallel);
        edges.insert(edges.end(), mirrors.begin(), mirrors.end());
        struct Middle {
            std::vector<int> apexes;
            Edge ends;
            int vertex = -1;
        };
        std::vector<Middle> middles = mapped(edges, [this](int h) -> Middle {
            return {wallApexes(h), {mesh_.origin(h), mesh_.target(h)}};
        });
        for (std::size_t i = 0; i < edges.size(); ++i) {
            Middle& middle = middles[i];
            if (!runs(edges[i], middle.ends.first, middle.ends.second)) {
                continue;  // an earlier split moved it to another slot
            }
            middle.vertex = split(edges[i]);
            for (std::size_t j = 0; j < i; ++j) {
                if (middles[j].vertex >= 0 && intersects(middles[j].apexes, middle.apexes)) {
                    mesh_.joinCopies(middles[j].vertex, middle.vertex);
                }
            }
        }
    }

    int split(int h) {
        for (const int t : {h / 3, mesh_.twin(h) / 3}) {
            if (t < first_) {
                divided_.push_back(t);
            }
        }
        return splitEdgeAtMiddle(mesh_, h);
    }

    SurfaceMesh& mesh_;
    int first_;
    int stroke_;
    const std::set<Edge>& frontEdges_;
    std::vector<int> divided_;
};

}  // namespace

//     c                 c
//    / \               /|\        t = abc, o = bad become
//   a---b     ->      a-m-b       t = amc, t1 = mbc, o = bmd, o1 = mad
//    \ /               \|/
//     d                 d
bool hasDuplicateEdges(const SurfaceMesh& mesh, const Umbrellas& umbrellas) {
    const std::span<const int> spokes = umbrellas.spokes;
    int first = 0;
    return std::ranges::any_of(umbrellas.ends, [&](int end) {
        const int begin = std::exchange(first, end);
        return hasParallels(mesh, spokes.subspan(begin, end - begin));
    });
}

std::vector<int> splitDuplicateEdges(SurfaceMesh& mesh, int firstTriangle, int stroke,
                                     const std::set<Edge>& frontEdges) {
    return DuplicateEdges(mesh, firstTriangle, stroke, frontEdges).run();
}

}  // namespace kerf::cut
