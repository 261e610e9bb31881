#include "sim/run/state_hash.h"

#include <gtest/gtest.h>

#include "sim/base/float_rounding.h"
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
