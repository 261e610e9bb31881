// Models with colours, materials and images of their own, opened and exported, whole and cut, as a
// reader sees them that knows nothing of Kerf (own_looks.py).

#include "sim/cut/stroke/cutter.h"
#include "tests/support/png_head.h"

namespace kerf::app {
namespace {

const std::string kScript = KERF_SOURCE_DIR "/tests/app/files/export/own_looks.py";

/// Runs the script; what it prints goes into a file.
bool runScript(const std::string& words, const fs::path& out) {
    const std::string call =
        "/usr/bin/python3 -B '" + kScript + "' " + words + " > '" + out.string() + "' 2>&1";
    return std::system(call.c_str()) == 0;
}

std::vector<std::string> linesOf(const fs::path& file) {
    std::ifstream stream(file);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);) {
        lines.push_back(line);
    }
    return lines;
}

/// Halves a body at rest, along a slanted plane a little off its middle.
SurfaceMesh halved(const SurfaceMesh& whole) {
    const Bounds bounds = meshBounds(whole);
    const double size = bounds.diagonal();
    const Vec3 middle = bounds.center() + Vec3(0.031, 0, 0.017) * size;
    const auto blade = [&](double height) {
        const Vec3 at = middle + Vec3(0.2 * height, height, 0) * size;
        return Blade{at - Vec3(0, 0, 2) * size, at + Vec3(0, 0, 2) * size};
    };
    SurfaceMesh mesh = whole;
    Cutter cutter(mesh, CutSettings{});
    cutter.begin(blade(0.8));
    for (int i = 1; i <= 12; ++i) {
        cutter.advance(blade(0.8 - 0.13 * i));
    }
    cutter.finish();
    return mesh;
}

void exportTo(const fs::path& folder, const Document& document, const SurfaceMesh& mesh) {
    fs::create_directories(folder);
    const ExportLooks looks{carried(document.looks, document.mesh, mesh), {}};
    for (const char* ending : {".obj", ".glb", ".gltf", ".ply"}) {
        const ExportTarget target{folder / (std::string("out") + ending), false,
                                  Coordinates::model};
        for (const ExportedFile& file :
             encodeExport(target, mesh, findPieces(mesh), looks, {document.session.placement})) {
            writeOutputFile(file.file, file.bytes);
        }
    }
}

std::string underscored(std::string name) {
    std::ranges::replace(name, '-', '_');
    return name;
}

class OwnLooksTest : public ::testing::Test {
  protected:
    void SetUp() override {
        if (std::system("/usr/bin/python3 -c 'import numpy' 2>/dev/null") != 0) {
            GTEST_SKIP() << "python3-numpy is not installed; the script needs it";
        }
    }

    test::TemporaryFolder folder;
};

TEST_F(OwnLooksTest, ComeBackFromEveryModelWholeAndCut) {
    const fs::path models = folder / "models";
    fs::create_directories(models);
    ASSERT_TRUE(runScript("make '" + models.string() + "'", folder / "names"));
    const std::vector<std::string> names = linesOf(folder / "names");
    ASSERT_GE(names.size(), 30U);
    std::string all;
    for (const std::string& name : names) {
        const Document document = openDocument(models / name);
        EXPECT_EQ(document.note.find("image"), std::string::npos) << document.note;
        const fs::path out = folder / "out" / underscored(fs::path(name).stem().string());
        exportTo(out / "whole", document, document.mesh);
        const SurfaceMesh cut = halved(document.mesh);
        EXPECT_EQ(findPieces(cut).pieces.size(), 2U) << name;
        exportTo(out / "cut", document, cut);
        all += " '" + name + "'";
    }
    const bool same =
        runScript("check '" + models.string() + "' '" + (folder / "out").string() + "'" + all,
                  folder / "answer");
    EXPECT_TRUE(same) << readBytes(folder / "answer");
}

// --- What can't be shown ------------------------------------------------------------------------

/// A box of one material, with an image of that name.
fs::path writeBox(const fs::path& folder, const std::string& image) {
    writeText(folder / "box.mtl", "newmtl paint\nKd 0.2 0.4 0.6\nmap_Kd " + image + "\n");
    writeText(folder / "box.obj", "mtllib box.mtl\nusemtl paint\n" + objText(boxSoup()));
    return folder / "box.obj";
}

class LeftOutImage : public ::testing::Test {
  protected:
    std::string remarkOf(const std::string& image) {
        const ModelMesh model = readModel(writeBox(folder.path(), image), {});
        EXPECT_EQ(model.looks.appearance->materials.at(0).name, "paint");
        EXPECT_EQ(model.looks.appearance->materials.at(0).image, -1);
        EXPECT_EQ(model.remarks.size(), 1U);
        return model.remarks.empty() ? "" : model.remarks.front();
    }

    test::TemporaryFolder folder;
};

TEST_F(LeftOutImage, IsNamedWhereItIsMissing) {
    EXPECT_EQ(
        remarkOf("gone.png"),
        "The image \"gone.png\" of the material \"paint\" was left out: there is no such file "
        "in the model's folder or below; put it there and open the model again.");
}

TEST_F(LeftOutImage, IsNamedWhereItsPathOrALinkLeadsOutsideTheFolder) {
    const fs::path below = folder / "models";
    fs::create_directories(below);
    writePng({1, 1, {0, 0, 0, 255}}, folder / "secret.png");
    fs::create_symlink(folder / "secret.png", below / "link.png");
    fs::create_directory_symlink(folder.path(), below / "up");
    fs::create_symlink("/dev/zero", below / "zero.png");
    for (const std::string& name : {std::string("../secret.png"), std::string("link.png"),
                                    std::string("up/secret.png"), (folder / "secret.png").string(),
                                    std::string("zero.png"), std::string("models/../../secret.png"),
                                    std::string("~"), std::string(300, 'a') + ".png"}) {
        const ModelMesh model = readModel(writeBox(below, name), {});
        ASSERT_EQ(model.remarks.size(), 1U) << name;
        EXPECT_THAT(model.remarks.front(), HasSubstr("in the model's folder or below"));
        EXPECT_EQ(model.looks.appearance->images.size(), 0U) << name;
    }
}

TEST_F(LeftOutImage, MaterialsAreNotReadThroughALinkThatLeadsOutside) {
    const fs::path below = folder / "models";
    fs::create_directories(below);
    writeText(folder / "out.mtl", "newmtl paint\nKd 1 0 0\n");
    fs::create_symlink(folder / "out.mtl", below / "link.mtl");
    for (const char* name : {"link.mtl", "../out.mtl"}) {
        writeText(below / "box.obj",
                  "mtllib " + std::string(name) + "\nusemtl paint\n" + objText(boxSoup()));
        const ModelMesh model = readModel(below / "box.obj", {});
        ASSERT_EQ(model.remarks.size(), 1U) << name;
        EXPECT_THAT(model.remarks.front(), HasSubstr("The materials of")) << name;
        const auto& looks = model.looks.appearance;
        EXPECT_TRUE(looks == nullptr || looks->materials[0].baseColor.y() != 0.0F) << name;
    }
}

TEST_F(LeftOutImage, IsNamedWhereItIsNoPictureOrDamaged) {
    writeText(folder / "text.png", "no picture");
    EXPECT_EQ(
        remarkOf("text.png"),
        "The image \"text.png\" was left out: it is neither PNG nor JPEG; save it anew as PNG "
        "and open the model again.");
    writePng({64, 64, std::vector<std::uint8_t>(4 * 64 * 64, 7)}, folder / "half.png");
    const std::string whole = readBytes(folder / "half.png");
    writeText(folder / "half.png", whole.substr(0, whole.size() / 2));
    EXPECT_THAT(remarkOf("half.png"), HasSubstr("it is damaged or cut off"));
}

TEST_F(LeftOutImage, IsNamedWhereItIsTooLargeOrLies) {
    writeText(folder / "lie.png", pngHead(16000, 16000));
    EXPECT_THAT(remarkOf("lie.png"), HasSubstr("claims 16000 x 16000 pixels in 45 bytes"));
    writeText(folder / "wide.png", pngHead(20000, 10));
    EXPECT_THAT(remarkOf("wide.png"),
                HasSubstr("it has 20000 x 10 pixels, of which at most 16384"));
    writeText(folder / "vast.png", pngHead(40000, 40000));
    EXPECT_THAT(remarkOf("vast.png"), HasSubstr("more pixels than are read"));
}

TEST(OwnLooks, SayWhichFileOfMaterialsIsMissing) {
    const test::TemporaryFolder folder;
    writeText(folder / "box.obj", "mtllib my paints.mtl\nusemtl paint\n" + objText(boxSoup()));
    const ModelMesh model = readModel(folder / "box.obj", {});
    ASSERT_EQ(model.remarks.size(), 1U);
    EXPECT_THAT(model.remarks.front(), HasSubstr("The materials of \"my paints.mtl\""));
}

TEST(OwnLooks, OfModelsWithoutAnyAreNone) {
    const test::TemporaryFolder folder;
    writeText(folder / "plain.obj", objText(boxSoup()));
    const ModelMesh model = readModel(folder / "plain.obj", {});
    EXPECT_FALSE(model.looks.colored());
    EXPECT_TRUE(model.looks.skin.empty());
    EXPECT_TRUE(model.remarks.empty());
}

// --- Files beside an export ---------------------------------------------------------------------

class Beside : public ::testing::Test {
  protected:
    std::vector<std::string> namesAfterExport() {
        const ModelMesh model = readModel(writeBox(folder / "in", "tile.png"), {});
        const ExportTarget target{folder / "out" / "slice.obj"};
        std::vector<std::string> names;
        for (const ExportedFile& file :
             encodeExport(target, model.mesh, findPieces(model.mesh), {model.looks, {}})) {
            writeOutputFile(file.file, file.bytes);
            names.push_back(file.file.filename().string());
        }
        return names;
    }
    void SetUp() override {
        fs::create_directories(folder / "in");
        fs::create_directories(folder / "out");
        writePng({1, 1, {200, 100, 50, 255}}, folder / "in" / "tile.png");
    }

    test::TemporaryFolder folder;
};

TEST_F(Beside, LieMaterialsAndImages) {
    EXPECT_THAT(namesAfterExport(), ElementsAre("slice.obj", "tile.png", "slice.mtl"));
    EXPECT_EQ(readBytes(folder / "out" / "tile.png"), readBytes(folder / "in" / "tile.png"));
    EXPECT_THAT(namesAfterExport(), ElementsAre("slice.obj")) << "the others are there already";
}

TEST_F(Beside, NothingOfSomebodyElseIsReplaced) {
    writeText(folder / "out" / "tile.png", "another picture");
    writeText(folder / "out" / "slice.mtl", "newmtl of_somebody");
    EXPECT_THAT(namesAfterExport(), ElementsAre("slice.obj", "tile-2.png", "slice-2.mtl"));
    EXPECT_EQ(readBytes(folder / "out" / "tile.png"), "another picture");
    EXPECT_EQ(readBytes(folder / "out" / "slice.mtl"), "newmtl of_somebody");
    EXPECT_THAT(readBytes(folder / "out" / "slice.obj"), HasSubstr("mtllib slice-2.mtl\n"));
    EXPECT_THAT(readBytes(folder / "out" / "slice-2.mtl"), HasSubstr("map_Kd tile-2.png\n"));
}

TEST_F(Beside, AnEarlierOneOfKerfIsReplaced) {
    writeText(folder / "out" / "slice.mtl", "# Kerf, materials\nnewmtl old\n");
    EXPECT_THAT(namesAfterExport(), ElementsAre("slice.obj", "tile.png", "slice.mtl"));
    EXPECT_THAT(readBytes(folder / "out" / "slice.mtl"), HasSubstr("newmtl paint\n"));
}

TEST_F(Beside, NamesNeedNoEscapeInAUri) {
    fs::rename(folder / "in" / "tile.png", folder / "in" / "ein Grün 100%.png");
    const ModelMesh model = readModel(writeBox(folder / "in", "ein Grün 100%.png"), {});
    const auto files = encodeExport({folder / "out" / "my slice.gltf"}, model.mesh,
                                    findPieces(model.mesh), {model.looks, {}});
    ASSERT_EQ(files.size(), 3U);
    EXPECT_EQ(files[0].file.filename(), "my slice.gltf");
    EXPECT_EQ(files[1].file.filename(), "ein_Gr__n_100_.png");
    EXPECT_EQ(files[2].file.filename(), "my_slice.bin");
    EXPECT_THAT(files[0].bytes, HasSubstr(R"({"uri":"ein_Gr__n_100_.png"})"));
    EXPECT_THAT(files[0].bytes, HasSubstr(R"("uri":"my_slice.bin")"));
}

TEST(ExportedLook, IsThatOfTheModel) {
    const SurfaceMesh box = test::box();
    const ExportLooks looks{{}, render::lookFor("octopus")};
    const std::vector<ExportedFile> files = encodeExport({"box.obj"}, box, findPieces(box), looks);
    ASSERT_EQ(files.size(), 2U);
    EXPECT_THAT(files[1].bytes, HasSubstr("newmtl skin\nKd 0.4 0.045 0.12\n"));
    const std::string gltf = encodeMesh(box, findPieces(box), MeshFormat::gltf, looks);
    EXPECT_THAT(gltf, HasSubstr("0.4000000059604645,0.04500000178813934,0.11999999731779099,1.0"));
}

}  // namespace
}  // namespace kerf::app
