// Exports read back, by Kerf itself and by assimp, as other programs would read them.
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "sim/cut/stroke/cutter.h"

namespace kerf::app {
namespace {

/// A textured box in two pieces, with walls.
struct CutBox {
    CutBox() {
        for (int t = 0; t < uncut.triangleSlots(); ++t) {
            CornerUvs corners;
            for (int i = 0; i < 3; ++i) {
                corners[i] = uvAt(uncut.restPosition(uncut.triangle(t)[i]));
            }
            uncutUvs.push_back(corners);
        }
        mesh = uncut;
        Cutter cutter(mesh, CutSettings{});
        cutter.begin({Vec3(0.1, 1, -2), Vec3(0.1, 1, 2)});
        for (int i = 1; i <= 10; ++i) {
            cutter.advance({Vec3(0.1, 1 - 0.2 * i, -2), Vec3(0.1, 1 - 0.2 * i, 2)});
        }
        cutter.finish();
        pieces = findPieces(mesh);
        looks.own.skin = carrySkin(uncut, {uncutUvs, {}, {}}, mesh);
        openUp();
    }

    /// The walls would be welded to each other where they lie in one place.
    void openUp() {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            if (mesh.outgoing(v) >= 0 && pieces.ofVertex[v] == 1) {
                mesh.setPosition(v, mesh.position(v) + Vec3(kGap, 0, 0));
            }
        }
    }
    /// Where a point of the exported body was before openUp().
    static Vec3 closed(const Vec3& p) { return p.x() > 1.5 ? Vec3(p - Vec3(kGap, 0, 0)) : p; }

    static Eigen::Vector2f uvAt(const Vec3& p) {
        return {0.5F + 0.4F * static_cast<float>(p.x()), 0.5F + 0.3F * static_cast<float>(p.y())};
    }
    int count(SurfaceKind kind) const {
        int found = 0;
        for (int t = 0; t < mesh.triangleSlots(); ++t) {
            found += mesh.alive(t) && mesh.kind(t) == kind;
        }
        return found;
    }

    static constexpr double kGap = 3;
    SurfaceMesh uncut = test::box(Vec3::Ones(), 4);
    std::vector<CornerUvs> uncutUvs;
    SurfaceMesh mesh;
    PieceMap pieces;
    ExportLooks looks;
};

Vec3 placeOf(const aiVector3D& p) {
    return {p.x, p.y, p.z};
}

/// Six times the volume that the triangles of the node's own meshes and of those below it enclose.
double sixfoldVolume(const aiScene& scene, const aiNode& node) {
    double sum = 0;
    for (unsigned m = 0; m < node.mNumMeshes; ++m) {
        const aiMesh& mesh = *scene.mMeshes[node.mMeshes[m]];
        for (unsigned f = 0; f < mesh.mNumFaces; ++f) {
            const unsigned* corners = mesh.mFaces[f].mIndices;
            const auto at = [&](int i) { return placeOf(mesh.mVertices[corners[i]]); };
            sum += at(0).dot(at(1).cross(at(2)));
        }
    }
    for (unsigned i = 0; i < node.mNumChildren; ++i) {
        sum += sixfoldVolume(scene, *node.mChildren[i]);
    }
    return sum;
}

class ExportReadBack : public ::testing::TestWithParam<const char*> {
  protected:
    const aiScene* read(const fs::path& file) {
        const aiScene* scene = importer_.ReadFile(file.string(), aiProcess_ValidateDataStructure);
        EXPECT_NE(scene, nullptr) << importer_.GetErrorString();
        return scene;
    }
    fs::path write(const CutBox& box, bool filePerPiece) {
        fs::path file = folder_ / (std::string("box") + GetParam());
        for (const ExportedFile& part :
             encodeExport({file, filePerPiece}, box.mesh, box.pieces, box.looks)) {
            writeOutputFile(part.file, part.bytes);
        }
        return file;
    }

    test::TemporaryFolder folder_;
    Assimp::Importer importer_;
};

TEST_P(ExportReadBack, TheWholeBodyKeepsItsVolumeAndItsTriangles) {
    const CutBox box;
    ASSERT_EQ(box.pieces.pieces.size(), 2U);
    MeshReport report;
    loadModel(write(box, false), &report);
    EXPECT_EQ(report.pieces, 2);
    EXPECT_EQ(report.triangles, box.mesh.aliveTriangles());
    EXPECT_NEAR(report.volume, 1, 1e-5);
}

TEST_P(ExportReadBack, AFilePerPieceHoldsThatPieceAlone) {
    const CutBox box;
    const fs::path file = write(box, true);
    EXPECT_FALSE(fs::exists(file));
    double volume = 0;
    for (int piece = 0; piece < 2; ++piece) {
        MeshReport report;
        loadModel(pieceFile(file, piece), &report);
        EXPECT_EQ(report.pieces, 1);
        EXPECT_EQ(report.triangles, box.pieces.pieces[piece].triangles);
        EXPECT_NEAR(report.volume, box.pieces.pieces[piece].volume, 1e-5);
        volume += report.volume;
    }
    EXPECT_NEAR(volume, 1, 1e-5);
}

TEST_P(ExportReadBack, TextureCoordinatesComeBackWhereTheFormatHasThem) {
    const CutBox box;
    const ModelMesh model = readModel(write(box, false), {});
    if (std::string(GetParam()) == ".stl") {
        EXPECT_TRUE(model.looks.skin.uvs.empty());
        return;
    }
    ASSERT_EQ(static_cast<int>(model.looks.skin.uvs.size()), model.mesh.triangleSlots());
    int right = 0;
    for (int t = 0; t < model.mesh.triangleSlots(); ++t) {
        double worst = 0;
        for (int i = 0; i < 3; ++i) {
            const Eigen::Vector2f expected =
                CutBox::uvAt(CutBox::closed(model.mesh.restPosition(model.mesh.triangle(t)[i])));
            worst = std::max<double>(worst, (model.looks.skin.uvs[t][i] - expected).norm());
        }
        right += worst < 1e-4;
    }
    if (std::string(GetParam()) == ".ply") {
        // The reader keeps one pair a vertex, so walls get those of the rim.
        EXPECT_GE(right, box.count(SurfaceKind::skin));
    } else {
        EXPECT_EQ(right, box.count(SurfaceKind::skin)) << "the walls have none";
    }
}

TEST_P(ExportReadBack, AssimpFindsEachTriangle) {
    const CutBox box;
    const aiScene* scene = read(write(box, false));
    ASSERT_NE(scene, nullptr);
    unsigned faces = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        faces += scene->mMeshes[i]->mNumFaces;
    }
    EXPECT_EQ(static_cast<int>(faces), box.mesh.aliveTriangles());
    EXPECT_NEAR(sixfoldVolume(*scene, *scene->mRootNode) / 6, 1, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Formats, ExportReadBack,
                         ::testing::Values(".obj", ".ply", ".stl", ".glb", ".gltf"),
                         [](const auto& format) { return std::string(format.param + 1); });

class ExportGroups : public ExportReadBack {};

TEST_P(ExportGroups, WallsAreAMeshOfTheirOwnInEachPiece) {
    const CutBox box;
    const aiScene* scene = read(write(box, false));
    ASSERT_NE(scene, nullptr);
    ASSERT_EQ(scene->mNumMeshes, 4U) << "skin and cut of two pieces";
    std::map<std::string, int> faces;  // by material, or by the mesh's name where there is none
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        const aiMesh& mesh = *scene->mMeshes[i];
        const aiString material = scene->mMaterials[mesh.mMaterialIndex]->GetName();
        const bool named = material == aiString("skin") || material == aiString("cut");
        faces[named ? material.C_Str() : mesh.mName.C_Str()] += static_cast<int>(mesh.mNumFaces);
    }
    EXPECT_EQ(faces["skin"], box.count(SurfaceKind::skin));
    EXPECT_EQ(faces["cut"], box.count(SurfaceKind::wall));
}

TEST_P(ExportGroups, SkinKeepsItsTextureCoordinates) {
    const CutBox box;
    const aiScene* scene = read(write(box, false));
    ASSERT_NE(scene, nullptr);
    int seen = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i) {
        const aiMesh& mesh = *scene->mMeshes[i];
        ASSERT_TRUE(mesh.HasTextureCoords(0));
        if (scene->mMaterials[mesh.mMaterialIndex]->GetName() == aiString("cut")) {
            continue;
        }
        for (unsigned v = 0; v < mesh.mNumVertices; ++v) {
            const aiVector3D& uv = mesh.mTextureCoords[0][v];
            const Eigen::Vector2f wanted = CutBox::uvAt(CutBox::closed(placeOf(mesh.mVertices[v])));
            EXPECT_LT((Eigen::Vector2f(uv.x, uv.y) - wanted).norm(), 1e-4);
            ++seen;
        }
    }
    EXPECT_GT(seen, 100);
}

INSTANTIATE_TEST_SUITE_P(Formats, ExportGroups, ::testing::Values(".obj", ".glb", ".gltf"),
                         [](const auto& format) { return std::string(format.param + 1); });

/// Of an .obj assimp keeps groups alone.
class ExportNodes : public ExportReadBack {};

TEST_P(ExportNodes, PiecesAreNodesWithTheirVolume) {
    const CutBox box;
    const aiScene* scene = read(write(box, false));
    ASSERT_NE(scene, nullptr);
    for (int piece = 0; piece < 2; ++piece) {
        const std::string name = "piece_" + std::to_string(piece + 1);
        const aiNode* node = scene->mRootNode->FindNode(name.c_str());
        ASSERT_NE(node, nullptr) << name;
        EXPECT_NEAR(sixfoldVolume(*scene, *node) / 6, box.pieces.pieces[piece].volume, 1e-5);
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, ExportNodes, ::testing::Values(".glb", ".gltf"),
                         [](const auto& format) { return std::string(format.param + 1); });

// Bodies as VTK XML PolyData, read back without VTK.

/// A cube of 1 m that is stretched along x and moves.
struct MovingBox {
    MovingBox() {
        for (int v = 0; v < mesh.vertexCount(); ++v) {
            const Vec3 rest = mesh.restPosition(v);
            mesh.setState(v, {1.2 * rest.x(), rest.y(), rest.z()}, Vec3(1, 2, 3));
        }
        pieces = findPieces(mesh);
    }
    Json exported(const Placement& placement, Coordinates coordinates) const {
        const test::TemporaryFolder folder;
        const fs::path file = folder / "box.vtp";
        const auto files = encodeExport({file, false, coordinates}, mesh, pieces, {}, {placement});
        EXPECT_EQ(files.size(), 1U);
        writeText(file, files.front().bytes);
        return Json::parse(outputOf("/usr/bin/python3 -B '" KERF_SOURCE_DIR
                                    "/tests/app/files/export/read_mesh.py' '" +
                                    file.string() + "' 2>&1"));
    }

    SurfaceMesh mesh = test::box(Vec3::Ones(), 4);
    PieceMap pieces;
};

void expectNumbers(const Json& found, double volume, const Vec3& velocity) {
    EXPECT_NEAR(found["volumes"][0].get<double>(), volume, 1e-5 * volume);
    EXPECT_NEAR(found["measured_volumes"][0].get<double>(), volume, 1e-5 * volume);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(found["mean_velocity"][i].get<double>(), velocity[i], 1e-5 * velocity.norm());
    }
    EXPECT_NEAR(found["most_strain"].get<double>(), 0.2, 1e-6) << "a share, in whatever unit";
}

TEST(ExportVtp, HasStrainVelocityAndVolumeInMetresOfTheScene) {
    expectNumbers(MovingBox().exported({}, Coordinates::scene), 1.2, {1, 2, 3});
}

TEST(ExportVtp, HasThemInTheUnitAndAxesOfTheModel) {
    Placement placement;
    placement.unit = LengthUnit::millimetre;
    placement.up = UpAxis::z;
    placement.translate = Vec3(5, 5, 5);
    // The scene's y is up, which is the model's z.
    expectNumbers(MovingBox().exported(placement, Coordinates::model), 1.2e9, {1000, -3000, 2000});
}

TEST(ExportVtp, PiecesAreObjectsForKerf) {
    const CutBox box;
    const test::TemporaryFolder folder;
    writeText(folder / "box.vtp",
              encodeExport({folder / "box.vtp"}, box.mesh, box.pieces, box.looks).front().bytes);
    const ImportedModel model = importModel(folder / "box.vtp").model;
    EXPECT_THAT(model.facts.objects, ElementsAre("piece_1", "piece_2"));
    EXPECT_NEAR(inspectTriangles(model.soup).volume, 1, 1e-6);
}

}  // namespace
}  // namespace kerf::app
