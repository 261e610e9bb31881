#include "sim/mesh/piece_figures.h"

#include "sim/base/math.h"
#include "sim/mesh/triangle.h"
#include "sim/mesh/winding.h"

namespace kerf {

namespace {

// A cavity is no sliver: so much of the power 3/2 of its area, of which a sphere encloses 0.094.
constexpr double kLeastHollow = 1e-7;
// Nor a crumb, which a cut or the clean-up may have turned inside out: of the largest shell.
constexpr double kLeastShare = 1e-15;
// What encloses a cavity encloses more than it by this share at least: a core fills one exactly.
constexpr double kLeastAround = 1e-6;

/// What is known of a shell at rest.
struct Shell {
    int lowest = -1;    ///< its lowest vertex
    double volume = 0;  ///< signed [m^3], about that vertex
    double area = 0;    ///< [m^2]
    bool hasSkin = false;
    int largest = -1;  ///< its largest triangle
    double largestArea = 0;
    Bounds bounds;

    bool isHollow() const { return hasSkin && volume < -kLeastHollow * std::pow(area, 1.5); }
};

struct Shells {
    std::vector<Shell> all;
    std::vector<int> ofTriangle;  ///< by slot, -1 for dead ones
};

void add(const SurfaceMesh& mesh, int t, Shell& shell) {
    const Corners at = restCornersOf(mesh, t);
    const Vec3& apex = mesh.restPosition(shell.lowest);
    const double area = triangleArea(at);
    shell.volume += tetrahedronVolume(at[0] - apex, at[1] - apex, at[2] - apex);
    shell.area += area;
    shell.hasSkin = shell.hasSkin || mesh.kind(t) == SurfaceKind::skin;
    if (area > shell.largestArea) {
        shell.largest = t;
        shell.largestArea = area;
    }
    shell.bounds.add(boxOf(at));
}

Shells measure(const SurfaceMesh& mesh, UnionFind& sets) {
    Shells shells;
    shells.ofTriangle.assign(mesh.triangleSlots(), -1);
    std::vector<int> shellOfRoot(mesh.vertexCount(), -1);
    for (const int t : livingTriangles(mesh)) {
        const int root = sets.root(mesh.triangle(t)[0]);
        if (shellOfRoot[root] < 0) {
            shellOfRoot[root] = static_cast<int>(shells.all.size());
            shells.all.emplace_back().lowest = root;
        }
        shells.ofTriangle[t] = shellOfRoot[root];
        add(mesh, t, shells.all[shellOfRoot[root]]);
    }
    return shells;
}

/// Whether there are no two shells of which one might lie in the other.
bool isOneShell(const SurfaceMesh& mesh, UnionFind& shells) {
    int count = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        count += isUsed(mesh, v) && shells.root(v) == v ? 1 : 0;
    }
    return count < 2;
}

/// A point in the hollow, off the walls that it may touch.
Vec3 insideOf(const SurfaceMesh& mesh, const Shells& shells, const Shell& cavity) {
    const int own = shells.ofTriangle[cavity.largest];
    return pointBehind(restCornersOf(mesh, cavity.largest), -1,
                       [&](auto&& f) {
                           for (int t = 0; t < mesh.triangleSlots(); ++t) {
                               if (shells.ofTriangle[t] == own) {
                                   f(restCornersOf(mesh, t));
                               }
                           }
                       })
        .point;
}

/// The smallest shell of material that a cavity lies in, -1 for none.
int shellAround(const SurfaceMesh& mesh, const Shells& shells, const Shell& cavity) {
    const Vec3 point = insideOf(mesh, shells, cavity);
    const auto mayHold = [&](const Shell& shell) {
        return shell.volume > -(1 + kLeastAround) * cavity.volume &&
               contains(shell.bounds, cavity.bounds.low) &&
               contains(shell.bounds, cavity.bounds.high);
    };
    std::vector<char> asked;
    std::ranges::transform(shells.all, std::back_inserter(asked), mayHold);
    std::vector<int> winding(shells.all.size(), 0);
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        const int shell = shells.ofTriangle[t];
        if (shell >= 0 && asked[shell] != 0) {
            winding[shell] += rayCrossing(restCornersOf(mesh, t), point);
        }
    }
    int around = -1;
    for (std::size_t i = 0; i < winding.size(); ++i) {
        if (winding[i] > 0 && (around < 0 || shells.all[i].volume < shells.all[around].volume)) {
            around = static_cast<int>(i);
        }
    }
    return around;
}

/// The triangles that are joined to some by edges, these the first.
std::vector<int> connectedTo(const SurfaceMesh& mesh, std::vector<int> found) {
    std::vector<std::uint8_t> seen(mesh.triangleSlots(), 0);
    for (const int t : found) {
        seen[t] = 1;
    }
    for (std::size_t i = 0; i < found.size(); ++i) {
        for (const int h : mesh.twins(found[i])) {
            const int next = SurfaceMesh::triangleOf(h);
            if (seen[next] == 0) {
                seen[next] = 1;
                found.push_back(next);
            }
        }
    }
    return found;
}

/// Sums of tetrahedra with their apex near the piece, which keeps the digits of small ones.
struct Solid {
    Vec3 apex;
    double volume = 0;
    Vec3 moment = Vec3::Zero();  ///< volume times the way from the apex to the middle

    void add(const Corners& c) {
        const Vec3 a = c[0] - apex;
        const Vec3 b = c[1] - apex;
        const Vec3 d = c[2] - apex;
        const double part = tetrahedronVolume(a, b, d);
        volume += part;
        moment += part * (a + b + d) / 4;
    }
};

}  // namespace

UnionFind shellsOf(const SurfaceMesh& mesh) {
    UnionFind sets(mesh.vertexCount());
    for (const int t : livingTriangles(mesh)) {
        const Triangle& corners = mesh.triangle(t);
        sets.join(corners[0], corners[1]);
        sets.join(corners[0], corners[2]);
    }
    return sets;
}

bool joinCavities(const SurfaceMesh& mesh, UnionFind& shells) {
    if (isOneShell(mesh, shells)) {
        return false;
    }
    const Shells measured = measure(mesh, shells);
    const double largest = std::ranges::max(measured.all, {}, &Shell::volume).volume;
    bool joined = false;
    for (const Shell& shell : measured.all) {
        if (!shell.isHollow() || -shell.volume < kLeastShare * largest) {
            continue;
        }
        const int around = shellAround(mesh, measured, shell);
        if (around >= 0) {
            shells.join(shell.lowest, measured.all[around].lowest);
            joined = true;
        }
    }
    return joined;
}

PieceShells::PieceShells(const SurfaceMesh& mesh) {
    UnionFind shells = shellsOf(mesh);
    UnionFind pieces = shells;
    if (!joinCavities(mesh, pieces)) {
        return;
    }
    shellOfVertex_.assign(mesh.vertexCount(), -1);
    for (const int t : livingTriangles(mesh)) {
        const int shell = shells.root(mesh.triangle(t)[0]);
        if (shellOfVertex_[shell] < 0) {
            shells_.push_back({t, shell, pieces.root(shell)});
        }
        for (const int v : mesh.triangle(t)) {
            shellOfVertex_[v] = shell;
        }
    }
}

std::vector<int> PieceShells::shellsAround(const SurfaceMesh& mesh, int triangle) const {
    std::vector<int> found{triangle};
    if (shellOfVertex_.empty()) {
        return found;
    }
    const int own = shellOfVertex_[mesh.triangle(triangle)[0]];
    const int piece = std::ranges::find(shells_, own, &Shell::shellVertex)->pieceVertex;
    for (const Shell& shell : shells_) {
        if (shell.pieceVertex == piece && shell.shellVertex != own) {
            found.push_back(shell.triangle);
        }
    }
    return found;
}

PieceFigures figuresOfPiece(const SurfaceMesh& mesh, const PieceShells& shells, int triangle) {
    PieceFigures figures;
    Solid solid{mesh.position(mesh.triangle(triangle)[0])};
    for (const int t : connectedTo(mesh, shells.shellsAround(mesh, triangle))) {
        if (!mesh.present(t)) {
            continue;
        }
        const Corners corners = cornersOf(mesh, t);
        ++figures.triangles;
        (mesh.kind(t) == SurfaceKind::wall ? figures.cutArea : figures.skinArea) +=
            triangleArea(corners);
        solid.add(corners);
        figures.bounds.add(boxOf(corners));
    }
    figures.volume = solid.volume;
    const bool hollow = !(solid.volume > 1e-9 * std::pow(figures.bounds.diagonal(), 3));
    figures.centroid =
        hollow ? figures.bounds.center() : Vec3(solid.apex + solid.moment / solid.volume);
    return figures;
}

}  // namespace kerf
