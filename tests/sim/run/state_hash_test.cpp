#include "sim/run/state_hash.h"

#include <gtest/gtest.h>

#include "sim/base/math.h"
#include "tests/support/shapes.h"

namespace kerf {
namespace {

TEST(StateHash, IsFnv1aOfLittleEndianWords) {
    StateHash hash;
    EXPECT_EQ(hash.hexadecimal(), "cbf29ce484222325");
    hash.add(0x64636261u);  // "abcd"
    EXPECT_EQ(hash.hexadecimal(), "fc179f83ee0724dd");
    hash.add(0x68676665u);  // "efgh"
    EXPECT_EQ(hash.value(), 0x25da8c1836a8d66dull);
}

TEST(StateHash, SeesEveryPartOfTheState) {
    const SurfaceMesh mesh = test::icosphere(1);
    const std::string before = hashMesh(mesh).hexadecimal();
    EXPECT_EQ(hashMesh(test::icosphere(1)).hexadecimal(), before);

    SurfaceMesh moved = mesh;
    moved.setPosition(5, mesh.position(5) + Vec3(1e-6, 0, 0));
    EXPECT_NE(hashMesh(moved).hexadecimal(), before);

    SurfaceMesh pushed = mesh;
    pushed.setVelocity(5, Vec3(0, 0, 1e-20));
    EXPECT_NE(hashMesh(pushed).hexadecimal(), before);

    SurfaceMesh turned = mesh;
    const Triangle corners = mesh.triangle(3);
    for (int k = 0; k < 3; ++k) {
        turned.setCorner(3, k, corners[(k + 1) % 3]);
    }
    EXPECT_NE(hashMesh(turned).hexadecimal(), before);
}

TEST(StateHash, SeesBoxesWhereThereAreAny) {
    const SurfaceMesh mesh = test::icosphere(1);
    std::vector<StaticBox> boxes(1);
    const std::string before = hashScene(mesh, boxes).hexadecimal();
    EXPECT_EQ(hashScene(mesh, {}).hexadecimal(), hashMesh(mesh).hexadecimal());
    EXPECT_NE(before, hashMesh(mesh).hexadecimal());
    boxes[0].rotate.z() = 1e-6;
    EXPECT_NE(hashScene(mesh, boxes).hexadecimal(), before);
}

/// The parts in which two states differ.
std::vector<StatePart> differingParts(const StateHashes& a, const StateHashes& b) {
    std::vector<StatePart> parts;
    for (std::size_t i = 0; i < a.parts.size(); ++i) {
        if (a.parts[i] != b.parts[i]) {
            parts.push_back(static_cast<StatePart>(i));
        }
    }
    return parts;
}

TEST(StateHash, EachPartHasItsOwn) {
    const SurfaceMesh mesh = test::icosphere(1);
    const std::vector<StaticBox> boxes(1);
    const Blade blade{{0, 0, 0}, {1, 0, 0}};
    const StateHashes before = hashParts(mesh, boxes, {}, blade);
    EXPECT_EQ(before.state, hashScene(mesh, boxes).hexadecimal());

    using Parts = std::vector<StatePart>;
    SurfaceMesh moved = mesh;
    moved.setPosition(5, mesh.position(5) + Vec3(1e-6, 0, 0));
    EXPECT_EQ(differingParts(hashParts(moved, boxes, {}, blade), before),
              Parts{StatePart::positions});
    SurfaceMesh pushed = mesh;
    pushed.setVelocity(5, Vec3(0, 0, 1e-20));
    EXPECT_EQ(differingParts(hashParts(pushed, boxes, {}, blade), before),
              Parts{StatePart::velocities});
    SurfaceMesh turned = mesh;
    turned.setCorner(3, 0, mesh.triangle(3)[1]);
    EXPECT_EQ(differingParts(hashParts(turned, boxes, {}, blade), before),
              Parts{StatePart::topology});
    EXPECT_EQ(differingParts(hashParts(mesh, {}, {}, blade), before), Parts{StatePart::boxes});
    EXPECT_EQ(differingParts(hashParts(mesh, boxes, {}, std::nullopt), before),
              Parts{StatePart::blade});
    EXPECT_EQ(differingParts(hashParts(mesh, boxes, {}, Blade{{1e-17, 0, 0}, {1, 0, 0}}), before),
              Parts{StatePart::blade});
}

TEST(StateHash, SeesEveryParameterThatChangesStates) {
    const SurfaceMesh mesh = test::icosphere(0);
    Params tearing;
    tearing.tearing = 1;  // without it strengths wait
    const StateHashes before = hashParts(mesh, {}, tearing, std::nullopt);
    for (const ParamInfo& info : paramTable()) {
        const ParamValue now = getParam(tearing, info.name);
        ParamValue other = info.type == ParamType::choice
                               ? ParamValue(std::string(info.choices.back()))
                           : info.type == ParamType::vector ? ParamValue(Vec3(0, 0, info.high))
                                                            : ParamValue(info.high);
        if (other == now) {
            other = info.type == ParamType::choice ? ParamValue(std::string(info.choices.front()))
                                                   : ParamValue(info.low);
        }
        Params changed = tearing;
        ASSERT_EQ(setParam(changed, info.name, other), "") << info.name;
        EXPECT_EQ(
            differingParts(hashParts(mesh, {}, changed, std::nullopt), before),
            info.changesStates ? std::vector{StatePart::parameters} : std::vector<StatePart>{})
            << info.name;
    }
    EXPECT_FALSE(findParam("cut_search")->changesStates);
}

TEST(StateHash, IsThatOfOldRunsWhereTheBodyDoesNotTear) {
    const SurfaceMesh mesh = test::icosphere(0);
    Params strong;
    strong.tensileStrength = 1e6;
    strong.skinToughness = 7;
    strong.skinStrength = 1e7;
    EXPECT_EQ(differingParts(hashParts(mesh, {}, strong, std::nullopt),
                             hashParts(mesh, {}, {}, std::nullopt)),
              std::vector<StatePart>{});
}

TEST(StateHash, RoundsToFloat) {
    const SurfaceMesh mesh = test::icosphere(1);
    SurfaceMesh rounded = mesh;
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        rounded.setPosition(v, nearestFloats(mesh.position(v)));
    }
    EXPECT_EQ(hashMesh(rounded).hexadecimal(), hashMesh(mesh).hexadecimal());
}

}  // namespace
}  // namespace kerf
