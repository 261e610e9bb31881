// Blades in the plane of faces, edges and vertices: no foil comes off, and walls lie in the blade.

#include "sim/cut/cut_types.h"

namespace kerf {
namespace {

/// Cells of a grid, each in the set or not.
struct Cells {
    std::array<int, 3> counts{};
    std::vector<char> filled;

    bool has(const std::array<int, 3>& cell) const {
        int place = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (cell[axis] < 0 || cell[axis] >= counts[axis]) {
                return false;
            }
            place = place * counts[axis] + cell[axis];
        }
        return filled[static_cast<std::size_t>(place)] != 0;
    }
    template <class F>
    void forEachPlace(F&& f) const {
        for (int x = 0; x < counts[0]; ++x) {
            for (int y = 0; y < counts[1]; ++y) {
                for (int z = 0; z < counts[2]; ++z) {
                    f(std::array{x, y, z});
                }
            }
        }
    }
    template <class F>
    void forEach(F&& f) const {
        forEachPlace([&](const std::array<int, 3>& cell) {
            if (has(cell)) {
                f(cell);
            }
        });
    }
};

std::array<int, 3> beside(std::array<int, 3> cell, int axis, int way) {
    cell[axis] += way;
    return cell;
}

/// The surface of a set; each square has one of its two diagonals.
TriangleSoup surfaceOf(const Cells& cells, std::mt19937_64& dice) {
    TriangleSoup soup;
    std::map<std::array<int, 3>, int> known;
    const auto vertex = [&](const std::array<int, 3>& at) {
        const auto [place, isNew] = known.emplace(at, static_cast<int>(soup.positions.size()));
        if (isNew) {
            soup.positions.emplace_back(at[0], at[1], at[2]);
        }
        return place->second;
    };
    cells.forEach([&](const std::array<int, 3>& cell) {
        for (int axis = 0; axis < 3; ++axis) {
            for (const int way : {-1, 1}) {
                if (cells.has(beside(cell, axis, way))) {
                    continue;
                }
                const std::array<int, 3> low = beside(cell, axis, way > 0 ? 1 : 0);
                const int u = (axis + 1) % 3;
                const int v = (axis + 2) % 3;
                std::array<int, 4> q{vertex(low), vertex(beside(low, u, 1)),
                                     vertex(beside(beside(low, u, 1), v, 1)),
                                     vertex(beside(low, v, 1))};
                if (way < 0) {
                    std::swap(q[1], q[3]);
                }
                std::rotate(q.begin(), q.begin() + static_cast<int>(dice() % 2), q.end());
                soup.triangles.push_back({q[0], q[1], q[2]});
                soup.triangles.push_back({q[0], q[2], q[3]});
            }
        }
    });
    return soup;
}

/// The volumes of the parts that a plane across an axis makes of a set, ascending. Cells that it
/// halves count on both sides.
std::vector<double> partsOf(const Cells& cells, int axis, double plane) {
    std::map<std::array<int, 4>, bool> seen;  // cells with the side of the plane
    const auto isOn = [&](const std::array<int, 3>& cell, int side) {
        return cells.has(cell) && (side == 0 ? cell[axis] < plane : cell[axis] + 1 > plane);
    };
    std::vector<double> volumes;
    for (const int side : {0, 1}) {
        cells.forEach([&](const std::array<int, 3>& first) {
            std::vector<std::array<int, 3>> pending{first};
            double volume = 0;
            while (!pending.empty()) {
                const std::array<int, 3> cell = pending.back();
                pending.pop_back();
                if (!isOn(cell, side) ||
                    std::exchange(seen[{cell[0], cell[1], cell[2], side}], true)) {
                    continue;
                }
                volume += cell[axis] < plane && cell[axis] + 1 > plane ? 0.5 : 1;
                for (int k = 0; k < 3; ++k) {
                    pending.push_back(beside(cell, k, 1));
                    pending.push_back(beside(cell, k, -1));
                }
            }
            if (volume > 0) {
                volumes.push_back(volume);
            }
        });
    }
    std::ranges::sort(volumes);
    return volumes;
}

std::vector<double> volumesOf(const SurfaceMesh& mesh) {
    std::vector<double> volumes;
    for (const auto& piece : findPieces(mesh).pieces) {
        volumes.push_back(piece.volume);
    }
    std::ranges::sort(volumes);
    return volumes;
}

/// Right through, in a plane across an axis.
Stroke flat(const SurfaceMesh& mesh, int axis, double plane, int steps, bool back = false) {
    const Bounds bounds = meshBounds(mesh);
    Vec3 center = bounds.center();
    center[axis] = plane;
    const Vec3 travel = Vec3::Unit((axis + 1) % 3) * (back ? -1 : 1);
    return straightStroke(center, Vec3::Unit((axis + 2) % 3), travel, 3 * bounds.diagonal(),
                          3 * bounds.diagonal(), steps);
}

/// The volumes of the pieces after a stroke, ascending.
std::vector<double> cut(SurfaceMesh& mesh, const Stroke& stroke) {
    expectSound(runStroke(mesh, CutSettings{}, stroke));
    return volumesOf(mesh);
}

void expectVolumes(const std::vector<double>& volumes, const std::vector<double>& expected) {
    ASSERT_THAT(volumes, SizeIs(expected.size()));
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        EXPECT_NEAR(volumes[i], expected[i], 1e-6 * expected[i]);
    }
}

TEST(Flush, ABladeInThePlaneOfAFaceTakesNothingOff) {
    for (int axis = 0; axis < 3; ++axis) {
        for (const double side : {-0.5, 0.5}) {
            for (const int squares : {1, 3}) {
                SurfaceMesh mesh = box(Vec3::Ones(), squares);
                expectVolumes(cut(mesh, flat(mesh, axis, side, 17)), {1});
            }
        }
    }
}

TEST(Flush, HalvesAreEqual) {
    SurfaceMesh cube = box(Vec3::Ones(), 4);
    expectVolumes(cut(cube, flat(cube, 1, 0, 17)), {0.5, 0.5});
    SurfaceMesh ball = icosphere(3);
    const double half = 0.5 * meshVolume(ball);
    expectVolumes(cut(ball, flat(ball, 0, 0, 23)), {half, half});
    SurfaceMesh plate = box(Vec3(1, 0.0005, 1), 1);
    expectVolumes(cut(plate, flat(plate, 1, 0, 17)), {0.00025, 0.00025});
}

// The second and third stroke go through vertices of older walls.
TEST(Flush, EighthsAreEqual) {
    for (const int squares : {3, 4}) {
        SurfaceMesh mesh = box(Vec3::Ones(), squares);
        Cutter cutter(mesh, CutSettings{});
        for (int axis = 0; axis < 3; ++axis) {
            expectSound(runStroke(cutter, mesh, flat(mesh, axis, 0, 17)));
        }
        expectVolumes(volumesOf(mesh), std::vector<double>(8, 0.125));
    }
}

TEST(Flush, FinsComeOffAtTheirRoots) {
    Cells comb{{11, 2, 4}, {}};
    comb.forEachPlace([&](const std::array<int, 3>& at) {
        comb.filled.push_back(at[1] == 0 || at[0] % 2 == 0 ? 1 : 0);
    });
    for (const bool back : {false, true}) {
        std::mt19937_64 dice(1);
        SurfaceMesh mesh = meshOf(surfaceOf(comb, dice));
        expectVolumes(cut(mesh, flat(mesh, 1, 1, 17, back)), {4, 4, 4, 4, 4, 4, 44});
    }
}

TEST(Flush, FacesOfBothSidesInOnePlaneStayWithTheirMaterial) {
    Cells stairs{{3, 2, 1}, {1, 0, 1, 1, 0, 1}};  // two cells below, two above, side by side
    std::mt19937_64 dice(1);
    SurfaceMesh mesh = meshOf(surfaceOf(stairs, dice));
    expectVolumes(cut(mesh, flat(mesh, 1, 1, 17)), {2, 2});
}

TEST(Flush, TheFloorOfACavityStaysBelow) {
    SurfaceMesh mesh = hollow(boxSoup(Vec3::Constant(3)), boxSoup(), Vec3::Zero());
    cut(mesh, flat(mesh, 1, -0.5, 17));
    const std::vector<double> volumes = volumesOf(mesh);
    expectVolumes(volumes, {9, 17});
}

TEST(Flush, ASecondStrokeInTheWallOfTheFirstCutsNothing) {
    SurfaceMesh mesh = box(Vec3::Ones(), 3);
    Cutter cutter(mesh, CutSettings{});
    for (const int steps : {17, 23}) {
        const CutCheck check = runStroke(cutter, mesh, flat(mesh, 1, 0.1, steps));
        EXPECT_EQ(check.problem, "");
        EXPECT_EQ(check.refused, 0);
    }
    expectVolumes(volumesOf(mesh), {0.4, 0.6});
}

// In the place of the 1 m ball that was refused at (500, 500, 500).
TEST(Flush, ABodyFarFromTheOriginIsCutAsOneThatIsNot) {
    SurfaceMesh here = icosphere(3);
    const std::vector<double> expected = cut(here, flat(here, 1, 0.1, 23));
    ASSERT_THAT(expected, SizeIs(2));
    for (const double away : {500.0, 10000.0}) {
        TriangleSoup soup = icosphereSoup(3);
        for (Vec3& p : soup.positions) {
            p += Vec3::Constant(away);
        }
        SurfaceMesh mesh = meshOf(soup);
        cut(mesh, flat(mesh, 1, away + 0.1, 23));
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            mesh.setPosition(v, mesh.position(v) - Vec3::Constant(away));
        }
        expectVolumes(volumesOf(mesh), expected);
    }
}

/// Whether cells of one kind around each corner of the grid hang together by their faces, so that
/// the surface is a manifold.
bool isManifold(const Cells& cells) {
    for (int corner = 0;
         corner < (cells.counts[0] + 1) * (cells.counts[1] + 1) * (cells.counts[2] + 1); ++corner) {
        const std::array<int, 3> at{corner % (cells.counts[0] + 1),
                                    corner / (cells.counts[0] + 1) % (cells.counts[1] + 1),
                                    corner / (cells.counts[0] + 1) / (cells.counts[1] + 1)};
        unsigned kinds = 0;
        for (unsigned k = 0; k < 8; ++k) {
            const std::array<int, 3> cell{at[0] - static_cast<int>(k & 1U),
                                          at[1] - static_cast<int>(k >> 1 & 1U),
                                          at[2] - static_cast<int>(k >> 2)};
            kinds |= cells.has(cell) ? 1U << k : 0U;
        }
        for (const unsigned kind : {kinds, kinds ^ 0xFFU}) {
            unsigned joined = kind & -kind;
            for (int round = 0; round < 8; ++round) {
                for (unsigned k = 0; k < 8; ++k) {
                    const unsigned near = 1U << (k ^ 1U) | 1U << (k ^ 2U) | 1U << (k ^ 4U);
                    joined |= (near & joined) != 0 ? kind & 1U << k : 0U;
                }
            }
            if (joined != kind) {
                return false;
            }
        }
    }
    return true;
}

bool hasCavity(const Cells& cells) {
    Cells air{{cells.counts[0] + 2, cells.counts[1] + 2, cells.counts[2] + 2}, {}};
    air.forEachPlace([&](const std::array<int, 3>& at) {
        air.filled.push_back(cells.has({at[0] - 1, at[1] - 1, at[2] - 1}) ? 0 : 1);
    });
    return partsOf(air, 0, -1).size() > 1;
}

/// Of up to five cells along each axis, without an edge or a corner in which it only touches
/// itself, and without a cavity.
Cells randomCells(std::mt19937_64& dice) {
    while (true) {
        Cells cells;
        for (int& count : cells.counts) {
            count = 2 + static_cast<int>(dice() % 4);
        }
        cells.filled.assign(std::size_t(cells.counts[0]) * cells.counts[1] * cells.counts[2], 0);
        const std::uint64_t share = 40 + dice() % 50;
        for (char& cell : cells.filled) {
            cell = dice() % 100 < share ? 1 : 0;
        }
        for (int round = 0; round < 100 && !isManifold(cells); ++round) {
            cells.filled[dice() % cells.filled.size()] = 1;
        }
        if (isManifold(cells) && std::ranges::count(cells.filled, 1) > 0 && !hasCavity(cells)) {
            return cells;
        }
    }
}

// KERF_FUZZ_SEED and KERF_FUZZ_RUNS as in CutFuzz.
TEST(Flush, RandomBoxesAreCutAsTheirCells) {
    const char* seedText = std::getenv("KERF_FUZZ_SEED");
    const std::uint64_t first = seedText == nullptr ? 1 : std::strtoull(seedText, nullptr, 10);
    const int runs = test::runs("KERF_FUZZ_RUNS", 600, 10000);
    int wrong = 0;
    for (int i = 0; i < runs; ++i) {
        std::mt19937_64 dice(first + static_cast<std::uint64_t>(i));
        const Cells cells = randomCells(dice);
        SurfaceMesh mesh = meshOf(surfaceOf(cells, dice));
        const int axis = static_cast<int>(dice() % 3);
        const double half = dice() % 2 == 0 ? 0 : 0.5;
        const double plane = static_cast<double>(dice() % cells.counts[axis]) + half;
        const Stroke stroke =
            flat(mesh, axis, plane, 1 + static_cast<int>(dice() % 30), dice() % 2 == 0);
        const CutCheck check = runStroke(mesh, CutSettings{}, stroke);
        EXPECT_EQ(check.problem, "") << "seed " << first + i;
        const std::vector<double> expected = partsOf(cells, axis, plane);
        const std::vector<double> volumes = volumesOf(mesh);
        const bool right = std::ranges::equal(
            volumes, expected, [](double p, double q) { return std::fabs(p - q) <= 1e-6 * q; });
        if (!right) {
            ++wrong;
            std::cout << "seed " << first + i << ": " << volumes.size() << " pieces for "
                      << expected.size() << "\n";
        }
    }
    EXPECT_LE(wrong, runs / 1000) << "of " << runs;
}

}  // namespace
}  // namespace kerf
