// What a solver does to a body between two steps of the blade, each alone and exaggerated.

#include "sim/cut/surface/piece_groups.h"

namespace kerf {
namespace {

const Vec3 kCenter(0.013, 0.021, 0.034);

Stroke downThrough(int steps = 60) {
    return straightStroke(kCenter, Vec3::UnitX(), -Vec3::UnitY(), 3.0, 2.4, steps);
}

void expectParted(const SurfaceMesh& mesh, const CutCheck& check) {
    EXPECT_EQ(check.problem, "");
    EXPECT_EQ(check.refused, 0) << check.reason;
    EXPECT_EQ(slitEdges(mesh, 0), 0);
    EXPECT_EQ(piecesOf(mesh), 2);
}

void shift(SurfaceMesh& mesh, const std::vector<int>& vertices, const Vec3& by) {
    for (const int v : vertices) {
        mesh.setPosition(v, mesh.position(v) + by);
    }
}

std::vector<int> allVertices(const SurfaceMesh& mesh) {
    std::vector<int> all(mesh.vertexCount());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        all[v] = v;
    }
    return all;
}

/// Where the front leaves the skin.
std::vector<int> frontEnds(const std::vector<RungNode>& rung) {
    std::vector<int> ends;
    for (std::size_t i = 0; i < rung.size(); ++i) {
        const bool before = i > 0 && rung[i - 1].attached;
        if (rung[i].vertex >= 0 && rung[i].attached != before) {
            ends.push_back(rung[i].vertex);
        }
    }
    return ends;
}

/// Wall vertices beside the front, not on it.
std::vector<int> rowBehind(const SurfaceMesh& mesh, const std::vector<RungNode>& rung) {
    std::vector<int> row;
    for (const RungNode& node : rung) {
        if (node.vertex < 0) {
            continue;
        }
        mesh.forEachOutgoing(node.vertex, [&](int h) {
            const int v = mesh.target(h);
            const bool onFront = std::any_of(rung.begin(), rung.end(),
                                             [&](const RungNode& n) { return n.vertex == v; });
            bool inside = true;
            mesh.forEachOutgoing(v,
                                 [&](int g) { inside &= mesh.kind(g / 3) == SurfaceKind::wall; });
            if (!onFront && inside && std::find(row.begin(), row.end(), v) == row.end()) {
                row.push_back(v);
            }
        });
    }
    return row;
}

TEST(MovingBody, RisingThroughTheBladeInTheAirIsCutFromItsSkinOn) {
    for (const double rise : {0.01, 0.03, 0.06}) {
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        const CutCheck check =
            runStroke(cutter, mesh, downThrough(), [&](SurfaceMesh& body, int step) {
                if (step == 19) {  // the blade has come to y = 0.50
                    shift(body, allVertices(body), Vec3(0, rise, 0));
                }
            });
        expectParted(mesh, check);
    }
}

int wallCountOf(const SurfaceMesh& mesh) {
    int walls = 0;
    for (int t = 0; t < mesh.triangleSlots(); ++t) {
        walls += mesh.alive(t) && mesh.kind(t) == SurfaceKind::wall;
    }
    return walls;
}

// The rung goes by points that the skin carried along, which are near one end of the blade.
TEST(MovingBody, RisingThroughTheBladeInTheAirMakesNoMoreWalls) {
    const Vec3 aside(0.9, 0, 0);
    const Stroke stroke =
        straightStroke(kCenter + aside, Vec3::UnitX(), -Vec3::UnitY(), 3.0, 2.4, 60);
    std::vector<int> walls;
    for (const double rise : {0.0, 0.03}) {
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        const CutCheck check = runStroke(cutter, mesh, stroke, [&](SurfaceMesh& body, int step) {
            if (step == 19) {
                shift(body, allVertices(body), Vec3(0, rise, 0));
            }
        });
        expectParted(mesh, check);
        walls.push_back(wallCountOf(mesh));
    }
    EXPECT_NEAR(walls[1], walls[0], 0.1 * walls[0]);
}

/// The body at rest with waves across z, turned about z.
void turnAndBend(SurfaceMesh& mesh, double angle, double phase) {
    const Eigen::AngleAxisd turn(angle, Vec3::UnitZ());
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Vec3& rest = mesh.restPosition(v);
        const double wave = 0.009 * std::sin(25 * rest.y() + 10 * rest.x() + phase);
        mesh.setPosition(v, turn * Vec3(rest + Vec3(0, 0, wave)));
    }
}

// A front of a single edge: the strip to the far ends of the blade would fold back onto its walls.
TEST(MovingBody, AShortFrontMayLeanAgainstALongBlade) {
    for (const double angle : {0.02, 0.06, 0.1}) {
        SurfaceMesh mesh = box({0.1, 1, 1}, 4);
        Cutter cutter(mesh, CutSettings{});
        const CutCheck check = runStroke(
            cutter, mesh, downThrough(),
            [&](SurfaceMesh& body, int step) { turnAndBend(body, angle * (step % 3), step); });
        expectParted(mesh, check);
        EXPECT_EQ(check.retried, 0);
        EXPECT_EQ(check.resumed, 0);
    }
}

// Meanwhile the front slips past the blade sideways, which is not where the cut goes on.
TEST(MovingBody, WhatFallsAlongWithTheBladeIsCutOnceItStands) {
    const Vec3 fall(0, -0.041, 0);  // a little faster than the blade
    for (const double slip : {-0.005, 0.003, 0.01, 0.02, 0.03, 0.05}) {
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        const CutCheck check =
            runStroke(cutter, mesh, downThrough(), [&](SurfaceMesh& body, int step) {
                if (step > 27 && step < 36) {
                    shift(body, allVertices(body), fall + Vec3(0, 0, slip));
                }
            });
        expectParted(mesh, check);
    }
}

TEST(MovingBody, AFrontEndThatSlidesOverItsNeighboursIsNoReasonToRefuse) {
    const double h = 0.08;
    for (const double slip : {0.1, 0.2, 0.3}) {
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        const CutCheck check =
            runStroke(cutter, mesh, downThrough(), [&](SurfaceMesh& body, int step) {
                const Vec3 aside(0, 0, step % 2 == 0 ? slip * h : -slip * h);
                const Vec3 up(0, 0.5 * slip * h, 0);
                shift(body, frontEnds(cutter.rung()), aside + up);
            });
        EXPECT_EQ(check.problem, "");
        EXPECT_EQ(check.refused, 0) << check.reason;
        EXPECT_EQ(slitEdges(mesh, 0), 0);
        EXPECT_GE(piecesOf(mesh), 2);
    }
}

TEST(MovingBody, WallsThatBendAheadOfTheFrontDoNotStopTheBlade) {
    for (const int when : {25, 31, 37}) {
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        const CutCheck check =
            runStroke(cutter, mesh, downThrough(), [&](SurfaceMesh& body, int step) {
                if (step == when) {
                    shift(body, rowBehind(body, cutter.rung()), Vec3(0, -0.12, 0.01));
                }
            });
        expectParted(mesh, check);
    }
}

TEST(MovingBody, AnInnerFrontVertexThatCameOutThroughTheSkinIsNoReasonToRefuse) {
    for (const double out : {0.005, 0.02}) {
        SurfaceMesh mesh = icosphere(3);
        Cutter cutter(mesh, CutSettings{});
        const CutCheck check =
            runStroke(cutter, mesh, downThrough(), [&](SurfaceMesh& body, int step) {
                if (step != 43) {  // the blade stands at y = -0.46, 0.04 above the skin
                    return;
                }
                const std::vector<RungNode>& rung = cutter.rung();
                const int middle = rung[rung.size() / 2].vertex;
                ASSERT_GE(middle, 0);
                const double depth = body.position(middle).y() + 0.5;
                shift(body, {middle}, Vec3(0, -depth - out, 0));
            });
        expectParted(mesh, check);
    }
}

TEST(MovingBody, HalvesThatOverlapAreCutEachForItself) {
    SurfaceMesh mesh = icosphere(3);
    Cutter cutter(mesh, CutSettings{});
    runStroke(cutter, mesh, downThrough());
    const PieceMap halves = findPieces(mesh);
    ASSERT_EQ(halves.pieces.size(), 2u);
    const double side = meanSide(mesh, halves, 0, kCenter, Vec3::UnitZ()) > 0 ? -1.0 : 1.0;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        if (halves.ofVertex[v] == 0) {
            mesh.setPosition(v, mesh.position(v) + Vec3(0.03, -0.05, side * 0.2));
        }
    }
    const Stroke across =
        straightStroke(kCenter, Vec3(0.05, 0.02, 1).normalized(), -Vec3::UnitY(), 3.0, 2.4, 60);
    const CutCheck check = runStroke(cutter, mesh, across);
    EXPECT_EQ(check.problem, "");
    EXPECT_EQ(check.refused, 0) << check.reason;
    EXPECT_EQ(check.retried, 0) << check.reason;
    EXPECT_EQ(slitEdges(mesh, 1), 0);
    EXPECT_EQ(piecesOf(mesh), 4);
}

TEST(MovingBody, TheFrontHasRoomAtItsEnds) {
    SurfaceMesh mesh = icosphere(3);
    CutSettings settings;
    settings.wallEdgeLength = 0.08;
    Cutter cutter(mesh, settings);
    int looked = 0;
    runStroke(cutter, mesh, downThrough(), [&](SurfaceMesh& body, int) {
        const std::vector<RungNode>& rung = cutter.rung();
        for (std::size_t i = 1; i + 2 < rung.size(); ++i) {
            const bool whole = rung[i].attached && rung[i + 1].vertex >= 0;
            const bool atEnd = whole && rung[i - 1].attached != rung[i + 1].attached;
            if (atEnd) {
                ++looked;
                EXPECT_GT(
                    (body.position(rung[i].vertex) - body.position(rung[i + 1].vertex)).norm(),
                    0.29 * settings.wallEdgeLength);
            }
        }
    });
    EXPECT_GT(looked, 20);
}

TEST(PieceGroups, KeepPiecesTogetherUntilTheyPart) {
    SurfaceMesh mesh = icosphere(2);
    runStroke(mesh, exactSettings(), downThrough());
    const PieceLabels halves(mesh);
    ASSERT_EQ(halves.pieces().size(), 2u);
    const auto groups = [&](const std::vector<int>& before) {
        std::vector<int> found = cut::groupPieces(mesh, halves, 1e-3, before);
        std::sort(found.begin(), found.end());
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found.size();
    };
    EXPECT_EQ(groups({}), 1u);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v) + Vec3(halves.ofVertex()[v] * 0.01, 0, 0));
    }
    const std::vector<int> apart = cut::groupPieces(mesh, halves, 1e-3, {});
    EXPECT_EQ(groups({}), 2u);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        mesh.setPosition(v, mesh.position(v) - Vec3(halves.ofVertex()[v] * 0.01, 0, 0));
    }
    EXPECT_EQ(groups(apart), 2u) << "what has parted stays apart for the stroke";
}

}  // namespace
}  // namespace kerf
