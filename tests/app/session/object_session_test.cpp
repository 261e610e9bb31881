// Objects of a file in sessions: one of them alone, or a model of each.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/files/io/file_io.h"
#include "app/scene/document/editor_document.h"
#include "app/session/session.h"
#include "sim/mesh/invariants.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;

/// A box of quads from a corner on, whose first vertex has this number.
std::string boxText(const Vec3& low, const Vec3& size, int first) {
    std::string text;
    for (int v = 0; v < 8; ++v) {
        const Vec3 p = low + Vec3(v & 1, (v >> 1) & 1, (v >> 2) & 1).cwiseProduct(size);
        text += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
                std::to_string(p.z()) + "\n";
    }
    for (const std::array<int, 4>& quad : {std::array{0, 2, 3, 1},
                                           {4, 5, 7, 6},
                                           {0, 1, 5, 4},
                                           {2, 6, 7, 3},
                                           {0, 4, 6, 2},
                                           {1, 3, 7, 5}}) {
        text += "f";
        for (const int v : quad) {
            text += " " + std::to_string(first + v);
        }
        text += "\n";
    }
    return text;
}

/// A plate of wood and a bolt of steel that stands on it.
class ObjectSession : public ::testing::Test {
  protected:
    ObjectSession() {
        test::writeText(folder / "bolt.mtl", "newmtl wood\nKd 1 0 0\nnewmtl steel\nKd 0 0 1\n");
        test::writeText(file, "mtllib bolt.mtl\no plate\nusemtl wood\n" +
                                  boxText(Vec3::Zero(), {4, 1, 4}, 1) + "o bolt\nusemtl steel\n" +
                                  boxText({1, 1, 1}, {1, 2, 1}, 9));
    }
    ModelMesh read(int object) {
        ReadOptions options;
        options.object = object;
        return readModel(file, options);
    }

    test::TemporaryFolder folder;
    std::filesystem::path file = folder / "bolt.obj";
};

TEST_F(ObjectSession, AnObjectComesAloneWithItsLooks) {
    EXPECT_NEAR(meshVolume(read(0).mesh), 18, 1e-12);
    const ModelMesh bolt = read(2);
    EXPECT_NEAR(meshVolume(bolt.mesh), 2, 1e-12);
    ASSERT_EQ(bolt.looks.appearance->materials.size(), 1U);
    EXPECT_EQ(bolt.looks.appearance->materials[0].name, "steel");
    EXPECT_THAT(bolt.looks.skin.materials, ::testing::Each(0));
}

TEST_F(ObjectSession, OneThatIsNotThereIsRefused) {
    try {
        read(3);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), HasSubstr("object 3 is wanted, but it has 2 objects; name"));
    }
}

TEST_F(ObjectSession, EachBecomesAModelWhereTheWholeWas) {
    const Document whole = openDocument(file);
    EXPECT_THAT(whole.objects, ::testing::ElementsAre("plate", "bolt"));
    const Document models = openScene("models", parted(whole.session, 2));
    EXPECT_EQ(models.placed.size(), 2U);
    EXPECT_NEAR(meshVolume(models.mesh), meshVolume(whole.mesh), 1e-12);
    EXPECT_EQ(meshBounds(models.mesh).low, whole.restBounds.low);
    EXPECT_EQ(meshBounds(models.mesh).high, whole.restBounds.high);
    Session kept = models.session;
    kept.steps = 1;
    EXPECT_EQ(parseSession(formatSession(kept, folder.path()), folder.path())
                  .moreModels.at(0)
                  .model.object,
              2);
}

}  // namespace
}  // namespace kerf::app
