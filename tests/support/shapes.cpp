#include "tests/support/shapes.h"

#include <fstream>
#include <stdexcept>

#include "gpu/data_path.h"

namespace kerf::test {

namespace {

constexpr double kPi = std::numbers::pi;

void addQuad(TriangleSoup& soup, int a, int b, int c, int d) {
    soup.triangles.push_back({a, b, c});
    soup.triangles.push_back({a, c, d});
}

TriangleSoup icosahedron() {
    const double g = (1 + std::sqrt(5.0)) / 2;
    TriangleSoup soup;
    soup.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    soup.triangles = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    return soup;
}

TriangleSoup subdivided(const TriangleSoup& coarse) {
    TriangleSoup fine;
    fine.positions = coarse.positions;
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [place, isNew] =
            middles.try_emplace(std::minmax(a, b), static_cast<int>(fine.positions.size()));
        if (isNew) {
            fine.positions.push_back(0.5 * (coarse.positions[a] + coarse.positions[b]));
        }
        return place->second;
    };
    for (const auto& [a, b, c] : coarse.triangles) {
        const int ab = middle(a, b);
        const int bc = middle(b, c);
        const int ca = middle(c, a);
        for (const Triangle& t : {Triangle{a, ab, ca}, Triangle{ab, b, bc}, Triangle{ca, bc, c},
                                  Triangle{ab, bc, ca}}) {
            fine.triangles.push_back(t);
        }
    }
    return fine;
}

void pushToSphere(TriangleSoup& soup, double radius) {
    for (Vec3& p : soup.positions) {
        p = radius * p.normalized();
    }
}

/// The cube [-n, n]^3 on its integer grid, so that welding joins the faces.
TriangleSoup gridCube(int n) {
    TriangleSoup soup;
    for (int axis = 0; axis < 3; ++axis) {
        for (const int side : {-1, 1}) {
            const int first = static_cast<int>(soup.positions.size());
            for (int i = 0; i <= n; ++i) {
                for (int j = 0; j <= n; ++j) {
                    Vec3 p;
                    p[axis] = side * n;
                    p[(axis + 1) % 3] = side * (2 * i - n);
                    p[(axis + 2) % 3] = 2 * j - n;
                    soup.positions.push_back(p);
                }
            }
            for (int i = 0; i < n; ++i) {
                for (int j = 0; j < n; ++j) {
                    const int a = first + i * (n + 1) + j;
                    addQuad(soup, a, a + n + 1, a + n + 2, a + 1);
                }
            }
        }
    }
    return weldExactly(soup);
}

/// Quads between `rings` rings of `around` vertices each, both periodic where `closedAlong`.
void addRings(TriangleSoup& soup, int rings, int around, bool closedAlong) {
    for (int i = 0; i < (closedAlong ? rings : rings - 1); ++i) {
        for (int j = 0; j < around; ++j) {
            const int next = (i + 1) % rings;
            const int right = (j + 1) % around;
            addQuad(soup, i * around + j, i * around + right, next * around + right,
                    next * around + j);
        }
    }
}

constexpr double kGrading = 8;  // longest over shortest edge of graded bodies

/// Halves edges that are too long, and with each the longest of its triangle, so that angles stay
/// (Rivara 1984).
class Refinement {
  public:
    using Length = std::function<double(const Vec3&)>;
    using Project = std::function<Vec3(const Vec3&)>;
    Refinement(TriangleSoup& soup, const Length& wanted, const Project& project)
        : soup_(soup), wanted_(wanted), project_(project) {}

    void run() {
        while (markLong()) {
            markLongest();
            divide();
        }
    }

  private:
    using Edge = std::pair<int, int>;
    static Edge edge(const Triangle& t, int e) { return std::minmax(t[e], t[(e + 1) % 3]); }
    double length(const Edge& e) const {
        return (soup_.positions[e.second] - soup_.positions[e.first]).norm();
    }
    Vec3 middle(const Edge& e) const {
        return 0.5 * (soup_.positions[e.first] + soup_.positions[e.second]);
    }

    bool markLong() {
        constexpr double kTooLong = 1.5;
        middles_.clear();
        for (const Triangle& t : soup_.triangles) {
            for (int e = 0; e < 3; ++e) {
                if (length(edge(t, e)) > kTooLong * wanted_(middle(edge(t, e)))) {
                    middles_[edge(t, e)] = -1;
                }
            }
        }
        return !middles_.empty();
    }

    int longest(const Triangle& t) const {
        int best = 0;
        for (int e = 1; e < 3; ++e) {
            const auto key = [&](int i) { return std::pair(length(edge(t, i)), edge(t, i)); };
            best = key(e) > key(best) ? e : best;
        }
        return best;
    }

    void markLongest() {
        for (bool changed = true; changed;) {
            changed = false;
            for (const Triangle& t : soup_.triangles) {
                const bool any = isMarked(t, 0) || isMarked(t, 1) || isMarked(t, 2);
                changed = (any && middles_.try_emplace(edge(t, longest(t)), -1).second) || changed;
            }
        }
    }

    bool isMarked(const Triangle& t, int e) const { return middles_.count(edge(t, e)) > 0; }

    // The longest edge first, then what is left of the others.
    void divide() {
        for (auto& [ends, middleVertex] : middles_) {
            middleVertex = static_cast<int>(soup_.positions.size());
            soup_.positions.push_back(project_(middle(ends)));
        }
        std::vector<Triangle> divided;
        for (const Triangle& t : soup_.triangles) {
            const int e = longest(t);
            if (!isMarked(t, e)) {
                divided.push_back(t);
                continue;
            }
            const int a = t[e], b = t[(e + 1) % 3], c = t[(e + 2) % 3];
            const int m = middles_.at(edge(t, e));
            addHalf({m, b, c}, divided);
            addHalf({c, a, m}, divided);
        }
        soup_.triangles = divided;
    }

    // Its one old edge is opposite to a corner at the middle: the second or third corner pair.
    void addHalf(const Triangle& t, std::vector<Triangle>& divided) const {
        for (int e = 0; e < 3; ++e) {
            const auto found = middles_.find(edge(t, e));
            if (found != middles_.end()) {
                const int a = t[e], b = t[(e + 1) % 3], c = t[(e + 2) % 3];
                divided.push_back({a, found->second, c});
                divided.push_back({found->second, b, c});
                return;
            }
        }
        divided.push_back(t);
    }

    TriangleSoup& soup_;
    const Length& wanted_;
    const Project& project_;
    std::map<Edge, int> middles_;  ///< of marked edges
};

}  // namespace

TriangleSoup icosphereSoup(int subdivisions, double radius) {
    TriangleSoup soup = icosahedron();
    pushToSphere(soup, radius);
    for (int i = 0; i < subdivisions; ++i) {
        soup = subdivided(soup);
        pushToSphere(soup, radius);
    }
    return soup;
}

TriangleSoup cubeSphereSoup(int n, double radius) {
    TriangleSoup soup = gridCube(n);
    for (Vec3& p : soup.positions) {
        p = (p * (kPi / (4 * n))).array().tan();
    }
    pushToSphere(soup, radius);
    return soup;
}

TriangleSoup torusSoup(int around, int across, double radius, double tube) {
    TriangleSoup soup;
    for (int i = 0; i < around; ++i) {
        const double u = 2 * kPi * i / around;
        for (int j = 0; j < across; ++j) {
            const double v = 2 * kPi * j / across;
            const double r = radius + tube * std::cos(v);
            soup.positions.push_back({r * std::cos(u), tube * std::sin(v), r * std::sin(u)});
        }
    }
    addRings(soup, around, across, true);
    return soup;
}

TriangleSoup gradedSphereSoup(double coarse, double radius) {
    TriangleSoup soup = icosphereSoup(1, radius);
    const Refinement::Length wanted = [&](const Vec3& p) {
        return coarse * std::pow(kGrading, -0.5 * (p.x() / radius + 1));
    };
    const Refinement::Project project = [&](const Vec3& p) {
        return Vec3(radius * p.normalized());
    };
    Refinement(soup, wanted, project).run();
    return soup;
}

TriangleSoup gradedTorusSoup(double coarse, double radius, double tube) {
    TriangleSoup soup = torusSoup(16, 8, radius, tube);
    const Refinement::Length wanted = [&](const Vec3& p) {
        return coarse * std::pow(kGrading, std::fabs(std::atan2(p.z(), p.x())) / kPi - 1);
    };
    const Refinement::Project project = [&](const Vec3& p) {
        const Vec3 ring = Vec3(p.x(), 0, p.z()).normalized() * radius;
        return Vec3(ring + (p - ring).normalized() * tube);
    };
    Refinement(soup, wanted, project).run();
    return soup;
}

TriangleSoup bentTubeSoup(int along, int around) {
    TriangleSoup soup;
    const double bendRadius = 0.6;
    const auto center = [&](double s) {
        const double angle = 0.8 * s;
        return Vec3(bendRadius * std::sin(angle), bendRadius * (1 - std::cos(angle)), 0);
    };
    for (int i = 1; i < along; ++i) {
        const double s = 2.0 * i / along - 1;
        const double radius = 0.14 * std::sqrt(1 - 0.95 * s * s);
        const Vec3 inward(-std::sin(0.8 * s), std::cos(0.8 * s), 0);
        for (int j = 0; j < around; ++j) {
            const double v = 2 * kPi * j / around;
            soup.positions.push_back(center(s) +
                                     radius * (std::cos(v) * inward + std::sin(v) * Vec3::UnitZ()));
        }
    }
    addRings(soup, along - 1, around, false);
    const int start = static_cast<int>(soup.positions.size());
    soup.positions.push_back(center(-1));
    soup.positions.push_back(center(1));
    const int lastRing = (along - 2) * around;
    for (int j = 0; j < around; ++j) {
        const int right = (j + 1) % around;
        soup.triangles.push_back({start, right, j});
        soup.triangles.push_back({start + 1, lastRing + j, lastRing + right});
    }
    return soup;
}

TriangleSoup boxSoup(const Vec3& size, int n) {
    TriangleSoup soup = gridCube(n);
    for (Vec3& p : soup.positions) {
        p = p.cwiseProduct(size) / (2 * n);
    }
    return soup;
}

SurfaceMesh movedBy(SurfaceMesh mesh, const Vec3& way) {
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v) + way);
        mesh.setRestPosition(v, mesh.position(v));
    }
    return mesh;
}

Vec3 middleOf(const SurfaceMesh& mesh) {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : mesh.positions()) {
        sum += p;
    }
    return sum / mesh.vertexCount();
}

double topSpeed(const SurfaceMesh& mesh) {
    double top = 0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        top = std::max(top, mesh.outgoing(v) < 0 ? 0.0 : mesh.velocity(v).norm());
    }
    return top;
}

SurfaceMesh meshOf(const TriangleSoup& soup) {
    return SurfaceMesh::fromTriangles(soup.positions, soup.triangles);
}

SurfaceMesh icosphere(int subdivisions, double radius) {
    return meshOf(icosphereSoup(subdivisions, radius));
}

SurfaceMesh cubeSphere(int n, double radius) {
    return meshOf(cubeSphereSoup(n, radius));
}

SurfaceMesh torus(int around, int across, double radius, double tube) {
    return meshOf(torusSoup(around, across, radius, tube));
}

SurfaceMesh bentTube(int along, int around) {
    return meshOf(bentTubeSoup(along, around));
}

SurfaceMesh gradedSphere(double coarse) {
    return meshOf(gradedSphereSoup(coarse));
}

SurfaceMesh gradedTorus(double coarse) {
    return meshOf(gradedTorusSoup(coarse));
}

SurfaceMesh box(const Vec3& size, int n) {
    return meshOf(boxSoup(size, n));
}

TriangleSoup builtinSoup(const std::string& name) {
    const std::string path = gpu::dataPath("assets/models/" + name + ".obj");
    std::ifstream file(path);
    TriangleSoup soup;
    for (std::string word; file >> word;) {
        if (word == "v") {
            Vec3& p = soup.positions.emplace_back();
            file >> p.x() >> p.y() >> p.z();
        } else if (word == "f") {
            auto& [a, b, c] = soup.triangles.emplace_back();
            file >> a >> b >> c;
            a -= 1;
            b -= 1;
            c -= 1;
        } else {
            std::getline(file, word);
        }
    }
    if (soup.triangles.empty()) {
        throw std::runtime_error("no triangles in " + path);
    }
    return soup;
}

SurfaceMesh builtin(const std::string& name) {
    return meshOf(builtinSoup(name));
}

std::string objText(const TriangleSoup& soup) {
    std::string text;
    for (const Vec3& p : soup.positions) {
        text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                std::to_string(p.z()) + "\n";
    }
    for (const auto& [a, b, c] : soup.triangles) {
        text += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
                std::to_string(c + 1) + "\n";
    }
    return text;
}

TriangleSoup joined(const TriangleSoup& first, const TriangleSoup& second, const Vec3& offset) {
    TriangleSoup both = first;
    const int shift = static_cast<int>(first.positions.size());
    for (const Vec3& p : second.positions) {
        both.positions.push_back(p + offset);
    }
    for (const auto& [a, b, c] : second.triangles) {
        both.triangles.push_back({a + shift, b + shift, c + shift});
    }
    return both;
}

TriangleSoup turned(TriangleSoup soup) {
    for (Triangle& t : soup.triangles) {
        std::swap(t[1], t[2]);
    }
    return soup;
}

SurfaceMesh hollow(const TriangleSoup& outer, const TriangleSoup& inner, const Vec3& offset) {
    return meshOf(joined(outer, turned(inner), offset));
}

}  // namespace kerf::test
