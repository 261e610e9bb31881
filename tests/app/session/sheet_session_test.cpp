// Sheets in sessions: an open surface is given a thickness, then cut as any body.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/cli/replay/replay.h"
#include "app/files/import/model_source.h"
#include "app/files/io/file_io.h"
#include "tests/support/gl_fixture.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// A cloth of 1 m on a side about the origin in the x-z plane, with texture coordinates.
std::string clothText(int n = 12) {
    std::string text;
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            const double u = static_cast<double>(i) / n;
            const double v = static_cast<double>(j) / n;
            text += "v " + std::to_string(u - 0.5) + " 0 " + std::to_string(v - 0.5) + "\n";
            text += "vt " + std::to_string(u) + " " + std::to_string(v) + "\n";
        }
    }
    for (int j = 0; j < n; ++j) {
        for (int i = 0; i < n; ++i) {
            const auto corner = [&](int k) {
                return " " + std::to_string(k) + "/" + std::to_string(k);
            };
            const int a = j * (n + 1) + i + 1;
            text += "f" + corner(a) + corner(a + n + 1) + corner(a + n + 2) + corner(a + 1) + "\n";
        }
    }
    return text;
}

class SheetSession : public test::GlTest {
  protected:
    Session sessionWith(const std::string& mending) {
        test::writeText(folder / "cloth.obj", clothText());
        return parseSession(R"({"format": "kerf-session", "version": 1, "steps": 40,
            "model": {"path": "cloth.obj")" +
                                mending + R"(},
            "params": {"gravity": [0, 0, 0], "floor": null}, "events": [
              {"step": 1, "type": "blade", "a": [-0.2013, -0.3, -0.7], "b": [-0.2013, 0.3, -0.7]},
              {"step": 30, "type": "blade", "a": [-0.2013, -0.3, 0.7], "b": [-0.2013, 0.3, 0.7]},
              {"step": 31, "type": "lift"}]})",
                            folder.path());
    }
    RunSummary run(const Session& session) {
        return replaySession(session, loadSessionModel(session), folder / "out", {}).summary;
    }

    test::TemporaryFolder folder;
};

TEST_F(SheetSession, AClothIsCutAndReplaysTheSame) {
    const Session session = sessionWith(R"(, "thicken": 0.02)");
    const RunSummary cut = run(session);
    EXPECT_THAT(cut.messages, IsEmpty());
    ASSERT_EQ(cut.pieces.size(), 2U);
    const auto [less, more] = std::minmax(cut.pieces[0].volume, cut.pieces[1].volume);
    EXPECT_NEAR(less, 0.02 * (0.5 - 0.2013), 1e-5);
    EXPECT_NEAR(more, 0.02 * (0.5 + 0.2013), 1e-5);
    const Session again = parseSession(formatSession(session, folder.path()), folder.path());
    EXPECT_EQ(again.model.thicken, 0.02);
    EXPECT_EQ(run(again).stateHash, cut.stateHash);
}

TEST_F(SheetSession, BothSidesHaveTheTexture) {
    const ModelMesh model = loadSessionModel(sessionWith(R"(, "thicken": 0.02)"));
    ASSERT_EQ(static_cast<int>(model.looks.skin.uvs.size()), model.mesh.triangleSlots());
    for (int t = 0; t < model.mesh.triangleSlots(); ++t) {
        for (int i = 0; i < 3; ++i) {
            const Vec3& at = model.mesh.restPosition(model.mesh.triangle(t)[i]);
            const Eigen::Vector2f uv = model.looks.skin.uvs[t][i];
            EXPECT_NEAR(uv.x(), at.x() + 0.5, 1e-5);
            EXPECT_NEAR(uv.y(), at.z() + 0.5, 1e-5);
        }
    }
}

TEST_F(SheetSession, EvenTrianglesComeAfterTheThickness) {
    const ModelMesh model =
        loadSessionModel(sessionWith(R"(, "thicken": 0.1, "remesh": true, "remesh_edge": 0.06)"));
    EXPECT_NEAR(meshVolume(model.mesh), 0.1, 1e-6);
}

TEST_F(SheetSession, WithoutAThicknessItIsRefusedAsBefore) {
    EXPECT_THROW(loadSessionModel(sessionWith("")), ModelFault);
    for (const char* wrong : {"0", "-1", "1e9", "true", "null"}) {
        EXPECT_THROW(sessionWith(std::string(R"(, "thicken": )") + wrong), InputError) << wrong;
    }
    try {
        loadSessionModel(sessionWith(R"(, "thicken": 1e-9)"));
        ADD_FAILURE() << "floats hold none so thin";
    } catch (const ModelFault& fault) {
        EXPECT_THAT(fault.what(), HasSubstr("cloth.obj: a thickness of 1e-09 is too little"));
    }
}

TEST_F(SheetSession, ARepairFillsNoHoleOfASheet) {
    const ModelMesh model = loadSessionModel(sessionWith(R"(, "thicken": 0.02, "repair": true)"));
    EXPECT_NEAR(meshVolume(model.mesh), 0.02, 1e-9);
    EXPECT_EQ(loadSessionModel(sessionWith(R"(, "thicken": 0.02, "fill_holes": true)"))
                  .mesh.restPositions(),
              model.mesh.restPositions());
}

}  // namespace
}  // namespace kerf::app
