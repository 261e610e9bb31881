#include "app/files/import/import_answer.h"

namespace kerf::app {
namespace {

/// A folder of its own for each test.
class Import : public ::testing::Test {
  protected:
    fs::path write(const std::string& name, const std::string& content) {
        fs::create_directories((folder_ / name).parent_path());
        writeText(folder_ / name, content);
        return folder_ / name;
    }
    test::TemporaryFolder folder_;
};

std::string offText(const TriangleSoup& soup) {
    std::string text = "OFF\n" + std::to_string(soup.positions.size()) + " " +
                       std::to_string(soup.triangles.size()) + " 0\n";
    for (const Vec3& p : soup.positions) {
        text += std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) +
                "\n";
    }
    for (const auto& [a, b, c] : soup.triangles) {
        text += "3 " + std::to_string(a) + " " + std::to_string(b) + " " + std::to_string(c) + "\n";
    }
    return text;
}

std::string plyText(const TriangleSoup& soup) {
    const std::string off = offText(soup);
    return "ply\nformat ascii 1.0\nelement vertex " + std::to_string(soup.positions.size()) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " +
           std::to_string(soup.triangles.size()) +
           "\nproperty list uchar int vertex_indices\nend_header\n" +
           off.substr(off.find('\n', 4) + 1);
}

template <class T>
void append(std::string& bytes, const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string stlBytes(const TriangleSoup& soup) {
    std::string bytes(80, ' ');
    append(bytes, static_cast<std::uint32_t>(soup.triangles.size()));
    for (const Triangle& t : soup.triangles) {
        append(bytes, std::array<float, 3>{});
        for (const int v : t) {
            append(bytes, Vec3f(soup.positions[v].cast<float>()));
        }
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

/// A node that scales by two holds the box; positions and indices are in box.bin.
std::string gltfText(const TriangleSoup& soup, const std::string& uri) {
    const std::size_t vertices = soup.positions.size();
    const std::size_t indices = 3 * soup.triangles.size();
    const std::string bytes = std::to_string(12 * vertices);
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],)"
           R"("nodes":[{"mesh":0,"scale":[2,2,2]}],)"
           R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
           R"("buffers":[{"uri":")" +
           uri + R"(","byteLength":)" + std::to_string(12 * vertices + 4 * indices) +
           R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + bytes +
           R"(},{"buffer":0,"byteOffset":)" + bytes + R"(,"byteLength":)" +
           std::to_string(4 * indices) +
           R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
           std::to_string(vertices) +
           R"(,"min":[-0.5,-0.5,-0.5],"max":[0.5,0.5,0.5]},)"
           R"({"bufferView":1,"componentType":5125,"type":"SCALAR","count":)" +
           std::to_string(indices) + "}]}";
}

std::string gltfBuffer(const TriangleSoup& soup) {
    std::string bytes;
    for (const Vec3& p : soup.positions) {
        append(bytes, Vec3f(p.cast<float>()));
    }
    for (const Triangle& t : soup.triangles) {
        append(bytes, t);
    }
    return bytes;
}

TEST_F(Import, EveryBuiltinModelLoads) {
    const std::vector<std::pair<int, int>> counts = {
        {12, 20}, {42, 80}, {386, 768}, {3147, 6290}, {5800, 11596}};
    for (std::size_t i = 0; i < builtinModels().size(); ++i) {
        MeshReport report;
        const SurfaceMesh mesh = loadModel(builtinModelFile(builtinModels()[i]), &report);
        EXPECT_EQ(checkClosedManifold(mesh), "") << builtinModels()[i];
        EXPECT_EQ(mesh.vertexCount(), counts[i].first);
        EXPECT_EQ(mesh.aliveTriangles(), counts[i].second);
        EXPECT_TRUE(report.cuttable);
        EXPECT_TRUE(report.repairs.empty());
    }
}

TEST_F(Import, UnknownBuiltinModelNamesTheKnownOnes) {
    EXPECT_EQ(inputErrorOf([] { builtinModelFile("apple"); }),
              "there is no builtin model 'apple'; choose one of sphere20, sphere80, sphere768, "
              "banana, octopus");
}

TEST_F(Import, FormatsGiveTheSameBox) {
    const TriangleSoup box = boxSoup(Vec3(1, 2, 3));
    for (const fs::path& file : {write("box.obj", objText(box)), write("box.OFF", offText(box)),
                                 write("box.ply", plyText(box)), write("box.stl", stlBytes(box))}) {
        const SurfaceMesh mesh = loadModel(file);
        EXPECT_EQ(mesh.vertexCount(), 8) << file;
        EXPECT_NEAR(meshVolume(mesh), 6, 1e-6) << file;
    }
}

TEST_F(Import, NodeTransformsAreApplied) {
    const TriangleSoup box = boxSoup();
    write("box.bin", gltfBuffer(box));
    EXPECT_NEAR(meshVolume(loadModel(write("box.gltf", gltfText(box, "box.bin")))), 8, 1e-6);
}

TEST_F(Import, ReferencesOutsideTheFolderAreNotOpened) {
    const TriangleSoup box = boxSoup();
    write("secret.bin", gltfBuffer(box));
    write("inside/other.bin", gltfBuffer(box));
    EXPECT_EQ(inputErrorOf([&] { loadModel(write("inside/a.gltf", gltfText(box, "other.bin"))); }),
              "");
    EXPECT_NE(
        inputErrorOf([&] { loadModel(write("inside/b.gltf", gltfText(box, "../secret.bin"))); }),
        "");
}

TEST_F(Import, PolygonsAreTriangulatedAndLinesLeftOut) {
    const fs::path file = write("cube.obj",
                                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
                                "v 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nv 5 5 5\n"
                                "f 4 3 2 1\nf 5 6 7 8\nf 1 2 6 5\nf 3 4 8 7\nf 2 3 7 6\n"
                                "f 1 5 8 4\nl 1 9\np 9\n");
    const SurfaceMesh mesh = loadModel(file);
    EXPECT_EQ(mesh.vertexCount(), 8);
    EXPECT_EQ(mesh.aliveTriangles(), 12);
    EXPECT_NEAR(meshVolume(mesh), 1, 1e-6);
}

TEST_F(Import, APolygonWithAReflexCornerOnTheSideOfAnEarIsWhole) {
    const std::string points =
        "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
        "v 0 0 1\nv 2 0 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n";
    const std::string faces =
        "f 6 5 4 3 2 1\nf 7 8 9 10 11 12\nf 1 2 8 7\nf 2 3 9 8\nf 3 4 10 9\nf 4 5 11 10\n"
        "f 5 6 12 11\nf 6 1 7 12\n";
    // A face of two corners is a line.
    MeshReport report;
    loadModel(write("l.obj", points + faces + "f 1 2\n"), &report);
    EXPECT_EQ(report.triangles, 20);
    EXPECT_NEAR(report.volume, 3, 1e-12);
}

/// A prism over a regular polygon, with its caps as one face each.
std::string prismOff(int sides) {
    std::string points;
    std::string faces;
    std::string low = std::to_string(sides);
    std::string high = low;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        for (const char* z : {"0", "1"}) {
            points += std::to_string(std::cos(angle)) + " " + std::to_string(std::sin(angle)) +
                      " " + z + "\n";
        }
        const int next = 2 * ((i + 1) % sides);
        faces += "4 " + std::to_string(2 * i) + " " + std::to_string(next) + " " +
                 std::to_string(next + 1) + " " + std::to_string(2 * i + 1) + "\n";
        low += " " + std::to_string(2 * (sides - 1 - i));
        high += " " + std::to_string(2 * i + 1);
    }
    return "OFF # a prism\n\n" + std::to_string(2 * sides) + " " + std::to_string(sides + 2) +
           " 0\n" + points + "# its faces\n" + faces + low + "\n" + high + "\n";
}

TEST_F(Import, FacesOfAnOffHaveAsManyCornersAsTheyLike) {
    EXPECT_EQ(loadModel(write("nine.off", prismOff(9))).aliveTriangles(), 32);
    EXPECT_EQ(loadModel(write("many.off", prismOff(50))).aliveTriangles(), 196);
}

TEST_F(Import, AQuadWithACornerOnASideIsWhole) {
    const SurfaceMesh mesh = loadModel(write("t.obj",
                                             "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\n"
                                             "f 1 4 3 2\nf 1 2 3 5\nf 3 4 5\nf 4 1 5\n"));
    EXPECT_EQ(mesh.aliveTriangles(), 6);
    EXPECT_NEAR(meshVolume(mesh), 8.0 / 6, 1e-12);
}

TEST_F(Import, GltfThatNeedsAnUnknownExtensionIsRefusedByItsName) {
    const std::string needs = R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "x"}],)"
                              R"( "extensionsRequired": ["KHR_draco_mesh_compression"]})";
    std::string glb = "glTF";
    append(glb, std::uint32_t{2});
    append(glb, static_cast<std::uint32_t>(20 + needs.size()));
    append(glb, static_cast<std::uint32_t>(needs.size()));
    glb += "JSON" + needs;
    for (const fs::path& file : {write("a.gltf", needs), write("a.glb", glb)}) {
        EXPECT_THAT(
            inputErrorOf([&] { loadModel(file); }),
            HasSubstr(": it needs the glTF extension KHR_draco_mesh_compression, which Kerf does "
                      "not know; export it without"));
    }
}

TEST_F(Import, InsideOutModelIsTurnedAndSaysSo) {
    TriangleSoup ball = icosphereSoup(1);
    for (Triangle& t : ball.triangles) {
        std::swap(t[0], t[1]);
    }
    MeshReport report;
    const SurfaceMesh mesh = loadModel(write("ball.obj", objText(ball)), &report);
    EXPECT_GT(meshVolume(mesh), 0);
    EXPECT_THAT(report.repairs, ElementsAre("turned 1 inside-out piece"));
}

TEST_F(Import, OpenModelIsRefusedWithItsReport) {
    TriangleSoup ball = icosphereSoup(1);
    ball.triangles.pop_back();
    const fs::path file = write("ball.obj", objText(ball));
    MeshReport report;
    EXPECT_EQ(inputErrorOf([&] { loadModel(file, &report); }),
              file.string() +
                  ": 3 open edges: the surface is not closed, so cut faces can't be capped; fill "
                  "the holes in a modelling tool");
    EXPECT_EQ(report.triangles, 79);
    EXPECT_EQ(report.openEdges, 3);
}

TEST_F(Import, MissingFileFolderEmptyFile) {
    EXPECT_EQ(inputErrorOf([&] { loadModel("/nowhere/a.obj"); }),
              "/nowhere/a.obj: no such file; check the path");
    EXPECT_EQ(inputErrorOf([&] { loadModel("http://example.com/a.obj"); }),
              "http://example.com/a.obj: this is an address, not a file; download it first");
    EXPECT_THAT(inputErrorOf([&] { loadModel(folder_.path()); }), HasSubstr("this is a folder"));
    EXPECT_THAT(inputErrorOf([&] { loadModel(write("a.obj", "")); }), HasSubstr("is empty"));
    EXPECT_THAT(inputErrorOf([&] { loadModel("/dev/null"); }), HasSubstr("not a regular file"));
}

TEST_F(Import, OtherFormatsAreRefusedWithTheList) {
    EXPECT_THAT(inputErrorOf([&] { loadModel(write("a.3mf", "PK")); }),
                HasSubstr(".3mf files are not read as a model; convert it to OBJ, PLY, STL, glTF, "
                          "GLB, OFF, 3DS, DAE, FBX, VTK, VTP, VTU or Gmsh"));
    EXPECT_THAT(inputErrorOf([&] { loadModel(write("a", "PK")); }),
                HasSubstr("a file without extension is not read"));
}

TEST_F(Import, AFileWithoutASurfaceIsToldSo) {
    for (const char* text : {"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "v 0 0 0\nv 1 0 0\np 1 2\n",
                             "v 0 0 0\nv 1 0 0\nl 1 2\n"}) {
        EXPECT_THAT(inputErrorOf([&] { loadModel(write("none.obj", text)); }),
                    HasSubstr("there is no surface in it"));
    }
}

TEST_F(Import, TextIsNoModel) {
    for (const char* name : {"a.obj", "a.stl", "a.gltf", "a.glb", "a.off", "a.3ds", "a.dae",
                             "a.fbx", "a.vtk", "a.vtp", "a.vtu", "a.msh"}) {
        const std::string sentence =
            inputErrorOf([&] { loadModel(write(name, "Dear diary,\ntoday I cut a banana.\n")); });
        EXPECT_THAT(sentence, StartsWith((folder_ / name).string() + ": "));
        EXPECT_THAT(sentence, Not(HasSubstr("\n")));
    }
    EXPECT_EQ(inputErrorOf([&] { loadModel(folder_ / "a.obj"); }),
              (folder_ / "a.obj").string() +
                  ": it can't be read (there is no surface in it); check that it is what its "
                  "extension says, or export it again");
}

class Reader : public Import {
  protected:
    /// The end of a program that reads in place of kerf-import.
    ImportEnd endOf(const std::string& script, const ImportLimits& limits = {},
                    WorkProgress* progress = nullptr) {
        return runImportProcess({program(script).string()}, limits, progress);
    }
    /// What is said of a model that such a program reads.
    std::string sentenceOf(const std::string& script) {
        const Variable chosen("KERF_IMPORT", program(script).string());
        return inputErrorOf([&] { loadModel(write("a.obj", "v 0 0 0\n")); });
    }

  private:
    fs::path program(const std::string& script) {
        fs::path file = write("reader", "#!/bin/sh\n" + script + "\n");
        fs::permissions(file, fs::perms::owner_all);
        return file;
    }
};

TEST_F(Reader, ThatNeverEndsIsStopped) {
    const ImportEnd end = endOf("ulimit -St 1\nwhile :; do :; done");
    EXPECT_TRUE(end.tooSlow);
    EXPECT_EQ(end.signal, SIGXCPU);
    EXPECT_THAT(sentenceOf("ulimit -St 1\nwhile :; do :; done"),
                HasSubstr("reading it as OBJ did not end within 20 s"));
}

TEST_F(Reader, ThatWaitsIsStopped) {
    ImportLimits limits;
    limits.wallSeconds = 1;
    const ImportEnd end = endOf("sleep 60", limits);
    EXPECT_TRUE(end.tooSlow);
    EXPECT_EQ(end.signal, SIGKILL);
    EXPECT_EQ(endOf("exec >&- 2>&-\nsleep 60").signal, SIGKILL) << "its streams are closed";
}

TEST_F(Reader, ThatCrashesIsNamed) {
    const std::string crash = "echo why >&2\nkill -SEGV $$";
    const ImportEnd end = endOf(crash);
    EXPECT_EQ(end.signal, SIGSEGV);
    EXPECT_FALSE(end.tooSlow);
    EXPECT_EQ(end.log, "why\n");
    EXPECT_THAT(sentenceOf(crash), HasSubstr("the OBJ reader failed on it (SEGV)"));
}

TEST_F(Reader, TellsItsStagesWhichAreNoLog) {
    WorkProgress progress;
    const ImportEnd end =
        endOf("printf '\\036Looking for faults\\nodd\\n\\036Uniting\\n' >&2", {}, &progress);
    EXPECT_EQ(end.stage, "Uniting");
    EXPECT_EQ(progress.stage(), "Uniting");
    EXPECT_EQ(end.log, "odd\n");
}

TEST_F(Reader, ThatFailsIsToldWithTheReason) {
    for (const auto& [script, words] :
         {std::pair("kill -KILL $$", "run out of memory; close other programs"),
          {"head -c 99999 /dev/urandom", "stopped in the middle"},
          {"printf '\\036Uniting\\n' >&2\nkill -XCPU $$",
           "\"Uniting\" did not end within 600 s"}}) {
        EXPECT_THAT(sentenceOf(script), HasSubstr(words));
    }
}

TEST_F(Reader, ThatIsMissingIsNamed) {
    EXPECT_THAT(inputErrorOf([&] { runImportProcess({folder_ / "gone"}, {}); }),
                HasSubstr("can't be started"));
}

TEST_F(Import, AFileThatTakesTooLongIsToldSo) {
    const fs::path file = write("a.ply", plyText(boxSoup()));
    ImportLimits limits;
    limits.wallSeconds = 0;
    EXPECT_EQ(inputErrorOf([&] { importModel(file, {}, nullptr, limits); }),
              file.string() +
                  ": reading it as PLY did not end within 0 s; the file may be cut off or damaged, "
                  "export it again");
}

TEST_F(Import, HugeCountsInASmallFileEndInASentence) {
    const fs::path file = write("a.off", "OFF\n4000000000 4000000000 0\n0 0 0\n");
    ImportLimits limits;
    limits.cpuSeconds = 5;
    EXPECT_THAT(inputErrorOf([&] { importModel(file, {}, nullptr, limits); }),
                StartsWith(file.string() + ": "));
}

TEST_F(Import, NotANumber) {
    std::string text = objText(boxSoup());
    text.replace(text.find("v ") + 2, 9, "nan");
    EXPECT_THAT(inputErrorOf([&] { loadModel(write("a.obj", text)); }),
                HasSubstr("1 vertex has a coordinate that is not a finite number"));
}

TEST_F(Import, FileNameThatLooksLikeAnOption) {
    write("--help.obj", objText(boxSoup()));
    const fs::path before = fs::current_path();
    fs::current_path(folder_.path());
    EXPECT_EQ(importModel("--help.obj").model.soup.triangles.size(), 12u);
    fs::current_path(before);
}

// --- The answer of kerf-import -------------------------------------------------------------------

ImportAnswer answerOf(TriangleSoup soup) {
    return answerFor("a.obj", {std::move(soup)}, {});
}

TEST(ImportAnswer, ComesBackAsItWas) {
    ImportAnswer answer = answerOf(joined(boxSoup(), icosphereSoup(2), Vec3(3, 0, 0)));
    answer.report.left = {"one"};
    answer.help.thickness = 0.5;
    answer.model.facts.units = FileUnits{LengthUnit::millimetre, UpAxis::z};
    const ImportAnswer back = decodeAnswers(encodeAnswer(answer)).front();
    EXPECT_EQ(back.outcome, ImportOutcome::cuttable);
    EXPECT_EQ(back.model.soup.positions, answer.model.soup.positions);
    EXPECT_EQ(encodeAnswer(back), encodeAnswer(answer));
}

TEST(ImportAnswer, AnOrderComesBackAsItWas) {
    ImportOrder order{{.repair = true, .edge = 0.25}};
    order.object = 3;
    order.means = MemoryMeans{.free = 12};
    EXPECT_EQ(encodeOrder(decodeOrder(encodeOrder(order))), encodeOrder(order));
    EXPECT_EQ(decodeOrder(encodeOrder(order)).edge, 0.25);
}

TEST(ImportAnswer, AnyOtherLengthIsRefused) {
    const std::string answer = encodeAnswer(answerOf(boxSoup()));
    for (std::size_t length = 0; length < answer.size(); length += 7) {
        EXPECT_THAT(inputErrorOf([&] { decodeAnswers(answer.substr(0, length)); }),
                    HasSubstr("stopped in the middle"))
            << length;
    }
    EXPECT_THAT(inputErrorOf([&] { decodeAnswers(answer + "x"); }), HasSubstr("in the middle"));
}

TEST(ImportAnswer, NoNumberIsTrusted) {
    ImportAnswer answer = answerOf(boxSoup());
    answer.outcome = static_cast<ImportOutcome>(77);
    answer.model.facts.units = FileUnits{static_cast<LengthUnit>(-1), static_cast<UpAxis>(99)};
    answer.model.soup.skin.materials.assign(12, 5);
    answer.model.soup.skin.uvs.resize(12);
    answer.model.soup.skin.uvs[0][0].x() = std::numeric_limits<float>::quiet_NaN();
    answer.model.facts.objects = {"two\nlines"};
    const ImportAnswer back = decodeAnswers(encodeAnswer(answer)).front();
    EXPECT_EQ(back.outcome, ImportOutcome::cuttable);
    EXPECT_EQ(back.model.facts.units->unit, LengthUnit::metre);
    EXPECT_EQ(back.model.soup.skin.materials, std::vector<int>(12, -1));
    EXPECT_EQ(back.model.soup.skin.uvs[0][0].x(), 0);
    EXPECT_EQ(back.model.facts.objects.front(), "two_lines");

    answer.model.soup.triangles[3][1] = 8;
    EXPECT_THAT(inputErrorOf([&] { decodeAnswers(encodeAnswer(answer)); }), HasSubstr("not there"));
}

TEST(ImportAnswer, PositionsMustBeSane) {
    EXPECT_EQ(answerOf(boxSoup()).reason, "");
    EXPECT_THAT(answerOf(boxSoup(Vec3::Constant(1e-7))).reason, HasSubstr("scale or move"));
    TriangleSoup soup = boxSoup();
    soup.positions[0].x() = 1e30;
    EXPECT_THAT(answerOf(soup).reason, HasSubstr("scale or move"));
    soup.positions[0].x() = std::numeric_limits<double>::infinity();
    EXPECT_THAT(answerOf(soup).reason,
                HasSubstr("1 vertex has a coordinate that is not a finite number"));
    EXPECT_THAT(answerOf({}).reason, HasSubstr("no triangle in it"));
}

}  // namespace
}  // namespace kerf::app
