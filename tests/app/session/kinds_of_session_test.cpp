// Objects of a file in sessions: one of them alone, or a model of each.
#include "app/session/paper_experiments.h"

namespace kerf::app {
namespace {

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
        writeText(folder / "bolt.mtl", "newmtl wood\nKd 1 0 0\nnewmtl steel\nKd 0 0 1\n");
        writeText(file, "mtllib bolt.mtl\no plate\nusemtl wood\n" +
                            boxText(Vec3::Zero(), {4, 1, 4}, 1) + "o bolt\nusemtl steel\n" +
                            boxText({1, 1, 1}, {1, 2, 1}, 9));
    }
    ModelMesh read(int object) {
        ReadOptions options;
        options.object = object;
        return readModel(file, options);
    }

    test::TemporaryFolder folder;
    fs::path file = folder / "bolt.obj";
};

TEST_F(ObjectSession, AnObjectComesAloneWithItsLooks) {
    EXPECT_NEAR(meshVolume(read(0).mesh), 18, 1e-12);
    const ModelMesh bolt = read(2);
    EXPECT_NEAR(meshVolume(bolt.mesh), 2, 1e-12);
    ASSERT_EQ(bolt.looks.appearance->materials.size(), 1U);
    EXPECT_EQ(bolt.looks.appearance->materials[0].name, "steel");
    EXPECT_THAT(bolt.looks.skin.materials, Each(0));
}

TEST_F(ObjectSession, OneThatIsNotThereIsRefused) {
    EXPECT_THAT(inputErrorOf([&] { read(3); }),
                HasSubstr("object 3 is wanted, but it has 2 objects; name"));
}

TEST_F(ObjectSession, EachBecomesAModelWhereTheWholeWas) {
    const Document whole = openDocument(file);
    EXPECT_THAT(whole.objects, ElementsAre("plate", "bolt"));
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

TEST_F(ObjectSession, TheFileIsReadOnceForAllItsModels) {
    Session session = parted(openDocument(file).session, 2);
    session.moreModels.push_back(session.moreModels.front());
    session.moreModels.push_back({session.model, session.placement, {}});
    session.moreModels.back().model.remesh = true;
    const fs::path reader = folder / "reader";
    writeText(reader, "#!/bin/sh\necho start >>'" + (folder / "starts").string() + "'\nexec '" +
                          importProgram().string() + "' \"$@\"\n");
    fs::permissions(reader, fs::perms::owner_all);
    const Variable counting("KERF_IMPORT", reader.string());
    const ModelMesh scene = loadSessionModel(session);
    EXPECT_EQ(readBytes(folder / "starts"), "start\n");
    ASSERT_EQ(scene.placed.size(), 4U);
    const auto vertices = [&](int m) {
        return scene.placed[m + 1].firstVertex - scene.placed[m].firstVertex;
    };
    EXPECT_EQ(vertices(0), 8);
    EXPECT_EQ(vertices(1), vertices(2));
    EXPECT_GT(scene.mesh.vertexCount() - scene.placed[3].firstVertex, 8) << "even triangles";
    const double unit = std::pow(session.placement.scale, 3);
    EXPECT_NEAR(meshVolume(scene.mesh), (16 + 2 + 2 + 16) * unit, 0.01 * unit);
}

// Sheets in sessions: an open surface is given a thickness, then cut as any body.

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

class SheetSession : public GlTest {
  protected:
    Session sessionWith(const std::string& mending) {
        writeText(folder / "cloth.obj", clothText());
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

// An image may repeat right at its border, so strips take it from inside the sheet.
TEST_F(SheetSession, BothSidesHaveTheTextureAndStripsThatOfTheSheetInside) {
    const ModelMesh model = loadSessionModel(sessionWith(R"(, "thicken": 0.02)"));
    ASSERT_EQ(static_cast<int>(model.looks.skin.uvs.size()), model.mesh.triangleSlots());
    for (int t = 0; t < model.mesh.triangleSlots(); ++t) {
        const Corners corners = restCornersOf(model.mesh, t);
        const bool strip = std::abs(areaNormal(corners).normalized().y()) < 0.5;
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector2f uv = model.looks.skin.uvs[t][i];
            EXPECT_NEAR(uv.x(), corners[i].x() + 0.5, strip ? 0.05 : 1e-5);
            EXPECT_NEAR(uv.y(), corners[i].z() + 0.5, strip ? 0.05 : 1e-5);
            EXPECT_TRUE(!strip || (uv.minCoeff() > 0 && uv.maxCoeff() < 1));
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

// The sessions of the paper's experiments are those that it tells of.

class PaperSessions : public ::testing::TestWithParam<PaperExperiment> {};

TEST_P(PaperSessions, HaveThePapersSettingsAndCourse) {
    const PaperExperiment& paper = GetParam();
    const Session session = readSession(fs::path(KERF_SOURCE_DIR) / "assets/sessions" /
                                        (std::string(paper.name) + ".kerf.json"));
    EXPECT_EQ(session.model.builtin, paper.name);
    EXPECT_EQ(session.params.timeStep, paper.timeStep);
    EXPECT_EQ(session.params.iterations, kAutoIterations) << "those of the paper are sweeps";
    EXPECT_TRUE(session.params.floor.has_value());
    EXPECT_EQ(session.params.gravity, Vec3::Zero()) << "while the blade cuts";
    std::vector<const MoveBlade*> poses;
    const kerf::SetParam* gravity = nullptr;
    for (const SessionEvent& event : session.events) {
        if (const auto* pose = std::get_if<MoveBlade>(&event.action)) {
            EXPECT_EQ(gravity, nullptr);
            poses.push_back(pose);
        }
        if (const auto* set = std::get_if<kerf::SetParam>(&event.action)) {
            gravity = set;
        }
    }
    ASSERT_EQ(poses.size(), 2u);
    EXPECT_GT(poses[0]->blade.a.y(), poses[1]->blade.a.y()) << "it comes down";
    ASSERT_NE(gravity, nullptr);
    EXPECT_EQ(gravity->name, "gravity");
}

INSTANTIATE_TEST_SUITE_P(All, PaperSessions, ::testing::ValuesIn(paperExperiments()),
                         [](const auto& each) { return std::string(each.param.name); });

// A model that starts below the floor is told.

std::vector<std::string> remarksOn(const std::string& rest) {
    return loadSessionModel(parseSession(R"({"format": "kerf-session", "version": 1, "steps": 1,
                                             "model": {"builtin": "sphere80"}, )" +
                                             rest + "}",
                                         {}))
        .remarks;
}

TEST(StartBelowFloor, IsToldFarFromTheOriginToo) {
    const std::string sentence =
        "sphere80 starts 25 cm below the floor and will be pushed up; raise it by \"placement\".";
    EXPECT_THAT(remarksOn(R"("params": {"floor": 0}, "placement": {"scale": 0.5})"),
                ElementsAre(sentence));
    EXPECT_THAT(remarksOn(R"("params": {"floor": -0.25}, "placement": {"scale": 0.5})"), IsEmpty());
    EXPECT_THAT(remarksOn(R"("params": {"floor": null}, "placement": {"scale": 0.5})"), IsEmpty());
    EXPECT_THAT(
        remarksOn(R"("params": {"floor": 1e6}, "placement": {"translate": [0, 1000002, 0]})"),
        Each(Not(HasSubstr("below the floor"))));
}

}  // namespace
}  // namespace kerf::app
