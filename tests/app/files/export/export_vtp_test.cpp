// Bodies as VTK XML PolyData, read back without VTK.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "app/files/export/export.h"
#include "tests/paths.h"
#include "tests/support/program_output.h"
#include "tests/support/shapes.h"
#include "tests/support/temporary_folder.h"

namespace kerf::app {
namespace {

using Json = nlohmann::json;

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
        const std::filesystem::path file = folder / "box.vtp";
        const auto files = encodeExport({file, false, coordinates}, mesh, pieces, {}, {placement});
        EXPECT_EQ(files.size(), 1U);
        test::writeText(file, files.front().bytes);
        return Json::parse(test::outputOf("/usr/bin/python3 -B '" KERF_SOURCE_DIR
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

}  // namespace
}  // namespace kerf::app
