#include <spdlog/fmt/fmt.h>

#include <charconv>

#include "app/session/metrics.h"

namespace kerf::app {
namespace {

/// Two boxes; one triangle of the second passes for a wall, and an unused vertex lies about.
SurfaceMesh twoPieces() {
    SurfaceMesh mesh = meshOf(joined(boxSoup(), boxSoup(), Vec3(3, 0, 0)));
    mesh.addVertex(Vec3(9, 9, 9), Vec3::Zero(), Vec3::Zero());
    return mesh;
}

std::string encode(const SurfaceMesh& mesh, MeshFormat format) {
    return encodeMesh(mesh, findPieces(mesh), format);
}

template <class T>
T valueAt(const std::string& bytes, std::size_t offset) {
    T value;
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

TEST(Export, FormatFollowsTheExtension) {
    EXPECT_EQ(meshFormatOf("a.ply"), MeshFormat::ply);
    EXPECT_EQ(meshFormatOf("b/a.obj"), MeshFormat::obj);
    EXPECT_EQ(meshFormatOf("a.stl"), MeshFormat::stl);
    EXPECT_EQ(meshFormatOf("a.ply.txt"), std::nullopt);
    EXPECT_EQ(meshFormatOf("ply"), std::nullopt);
}

TEST(Export, PlyHoldsSharedVerticesUnitNormalsAndPieces) {
    const std::string bytes = encode(twoPieces(), MeshFormat::ply);
    EXPECT_NE(bytes.find("element vertex 16\n"), std::string::npos);
    EXPECT_NE(bytes.find("element face 24\n"), std::string::npos);
    const std::size_t start = bytes.find("end_header\n") + std::strlen("end_header\n");
    constexpr std::size_t vertexBytes = 24;
    constexpr std::size_t faceBytes = 1 + 12 + 4 + 1;
    ASSERT_EQ(bytes.size(), start + 16 * vertexBytes + 24 * faceBytes);
    for (std::size_t v = 0; v < 16; ++v) {
        Vec3f position;
        Vec3f normal;
        std::memcpy(position.data(), bytes.data() + start + v * vertexBytes, 12);
        std::memcpy(normal.data(), bytes.data() + start + v * vertexBytes + 12, 12);
        EXPECT_NEAR(normal.norm(), 1, 1e-6);
        const Vec3f center = position.x() > 1 ? Vec3f(3, 0, 0) : Vec3f(0, 0, 0);
        EXPECT_GT(normal.dot(position - center), 0) << "vertex " << v;
    }
    std::map<int, int> facesOfPiece;
    for (std::size_t f = 0; f < 24; ++f) {
        const std::size_t face = start + 16 * vertexBytes + f * faceBytes;
        EXPECT_EQ(valueAt<std::uint8_t>(bytes, face), 3);
        EXPECT_LT(valueAt<std::int32_t>(bytes, face + 1), 16);
        ++facesOfPiece[valueAt<std::int32_t>(bytes, face + 13)];
        EXPECT_EQ(valueAt<std::uint8_t>(bytes, face + 17), 0);
    }
    EXPECT_EQ(facesOfPiece, (std::map<int, int>{{0, 12}, {1, 12}}));
}

/// Two triangles back to back, as the walls at the front of a slit lie before it opens.
SurfaceMesh closedSlit() {
    return SurfaceMesh::fromTriangles({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)},
                                      {{0, 1, 2}, {0, 2, 1}});
}

TEST(Export, PlyNormalsHaveLengthOneWhereWallsCancelEachOther) {
    const std::string bytes = encode(closedSlit(), MeshFormat::ply);
    const std::size_t start = bytes.find("end_header\n") + std::strlen("end_header\n");
    for (std::size_t v = 0; v < 3; ++v) {
        Vec3f normal;
        std::memcpy(normal.data(), bytes.data() + start + v * 24 + 12, 12);
        EXPECT_NEAR(normal.norm(), 1, 1e-6) << "vertex " << v;
    }
}

TEST(Export, PlyMarksTheFacesOfCuts) {
    SurfaceMesh mesh = box();
    const Triangle corners = mesh.triangle(0);
    SurfaceMesh walled = box();
    walled.removeTriangle(0);
    const int added = walled.addTriangle(corners, SurfaceKind::wall, 0);
    for (int corner = 0; corner < 3; ++corner) {
        walled.setTwin(3 * added + corner, mesh.twin(corner));
        walled.setTwin(mesh.twin(corner), 3 * added + corner);
        walled.setOutgoing(corners[corner], 3 * added + corner);
    }
    const std::string bytes = encode(walled, MeshFormat::ply);
    EXPECT_NE(bytes.find("element face 12\n"), std::string::npos);
    EXPECT_EQ(bytes.back(), 1);
}

TEST(Export, ObjNamesPiecesAndCountsFromOne) {
    std::istringstream text(encode(twoPieces(), MeshFormat::obj));
    std::map<std::string, int> lines;
    std::string objects;
    for (std::string line; std::getline(text, line);) {
        const std::string keyword = line.substr(0, line.find(' '));
        ++lines[keyword];
        if (keyword == "o") objects += line + ";";
        EXPECT_EQ(line.find(" 0//"), std::string::npos);
    }
    EXPECT_EQ(lines["v"], 16);
    EXPECT_EQ(lines["vn"], 16);
    EXPECT_EQ(lines["f"], 24);
    EXPECT_EQ(objects, "o piece_1;o piece_2;");
}

TEST(Export, StlHasOneRecordPerTriangleWithItsPiece) {
    const std::string bytes = encode(twoPieces(), MeshFormat::stl);
    ASSERT_EQ(bytes.size(), 84u + 24 * 50);
    EXPECT_EQ(valueAt<std::uint32_t>(bytes, 80), 24u);
    EXPECT_EQ(valueAt<std::uint16_t>(bytes, 84 + 48), 0);
    EXPECT_EQ(valueAt<std::uint16_t>(bytes, 84 + 23 * 50 + 48), 1);
}

double parsed(const std::string& text) {
    double value = 0;
    std::from_chars(text.data(), text.data() + text.size(), value);
    return value;
}

TEST(FormatNumber, ReadsBackAsTheSameNumber) {
    for (const double value : {0.1, 1.0 / 3, -9.81, 1e-300, 6.02214076e23, 0.99999999999999989}) {
        EXPECT_EQ(parsed(formatNumber(value)), value);
    }
    EXPECT_EQ(formatNumber(0.1), "0.1");
    EXPECT_EQ(formatNumber(0.1f), "0.1");
}

TEST(Metrics, RowsHaveTheColumnsOfTheHeader) {
    MetricsRow row;
    row.report.step = 3;
    row.report.volume = 0.1;
    row.report.closed = false;
    row.frameMs = 2.5;
    row.report.subdivisions = {7, 0, 0, 1, 2, 0, 3};
    row.report.seeds = 2;
    row.report.kineticEnergy = 1.5;
    row.report.potentialEnergy = -0.25;
    EXPECT_EQ(
        metricsHeader(),
        "step,time,volume,volume_ratio,pieces,vertices,triangles,ispcs,touched_triangles,"
        "closed,deform_ms,collide_ms,cut_ms,render_ms,frame_ms,contacts,one_to_four,one_to_three_a,"
        "one_to_two,one_to_three_b,other_patterns,seeds,kinetic_energy,potential_energy,"
        "debris_pieces,debris_volume,strain_energy,lost_pieces,search_ms,search_walk_ms,"
        "search_seeds,search_tests,swept_area,swept_area_at_rest,fracture_energy,blade_force_x,"
        "blade_force_y,blade_force_z,blade_moment_x,blade_moment_y,blade_moment_z,blade_work,"
        "blade_energy,blade_lag,iterations,other_ms,tears,tear_refused,"
        "tear_opening,tear_stress,real_time_factor,implicit_steps,residual\n");
    EXPECT_EQ(formatMetrics(row),
              "3,0,0.1,1,1,0,0,0,0,0,0,0,0,0,2.5,0,7,0,0,1,5,2,1.5,-0.25,0,0,,0,0,0,0,0,0,0,0,,,,,,"
              ",0,0,0,0,2.5,,,,,,1,\n")
        << "with plain PBD there is no energy of strained material";
    row.report.strainEnergy = 0.75;
    row.report.lostPieces = 2;
    row.report.iterations = 6;
    row.report.implicitSteps = 2;
    row.report.residual = 0.125;
    row.report.times = {1, 0.5, 0.25};
    row.report.search = {1.5, 0.25, 2, 80};
    row.report.swept = {0.5, 0.25};
    row.report.fractureEnergy = 40;
    row.report.heldEdge = {0.25, 3, 2};
    row.report.bladeLoad = BladeLoad{Vec3(1, 2, 3), Vec3(4, 5, 6)};
    row.report.tear = TearReport{.opening = 0.5, .stress = 0.25, .failure = "no room"};
    row.simulatedSeconds = 0.005;
    EXPECT_EQ(formatMetrics(row),
              "3,0,0.1,1,1,0,0,0,0,0,1,0.5,0.25,0,2.5,0,7,0,0,1,5,2,1.5,-0.25,0,0,0.75,2,1.5,0.25,"
              "2,80,0.5,0.25,40,1,2,3,4,5,6,2,3,0.25,6,0.75,0,1,0.5,0.25,2,2,0.125\n");
    row.namesToughness = false;
    EXPECT_TRUE(formatMetrics(row).ends_with(
        ",0.5,0.25,,1,2,3,4,5,6,2,3,0.25,6,0.75,0,1,0.5,0.25,2,2,0.125\n"))
        << "nobody said what new surface takes";
}

TEST(Metrics, RangeOfASeries) {
    Range range;
    EXPECT_EQ(range.mean(), 0);
    for (const double value : {4.0, -1.0, 3.0}) range.add(value);
    EXPECT_EQ(range.mean(), 2);
    EXPECT_EQ(range.min(), -1);
    EXPECT_EQ(range.max(), 4);
}

TEST(Metrics, SummaryHoldsWhatScriptsReadFromIt) {
    RunSummary summary;
    summary.renderer = "llvmpipe";
    summary.stateHash = "00000000000000ff";
    summary.before = {12, 20, 12};
    summary.pieces = {Piece{10, 7, 0.5, 0.5, 1}, Piece{14, 9, 0.25, 0.25, 1}};
    MetricsRow row;
    row.frameMs = 10;
    row.simulatedSeconds = 0.005;
    row.report.volumeRatio = 1;
    row.report.search.milliseconds = 3;
    summary.statistics.add(row);
    row.frameMs = 30;
    row.report.volumeRatio = 0.5;
    row.report.subdivisions = {1, 2, 3, 4, 5, 6, 7};
    row.report.closed = false;
    summary.statistics.add(row);
    const auto json = Json::parse(formatSummary(summary));
    EXPECT_EQ(json["renderer"], "llvmpipe");
    EXPECT_EQ(json["steps"], 2);
    EXPECT_EQ(json["state_hash"], "00000000000000ff");
    EXPECT_EQ(json["before"]["ispcs"], 12);
    EXPECT_EQ(json["after"]["triangles"], 0);
    EXPECT_EQ(json["pieces"][1]["volume"], 0.25);
    EXPECT_EQ(json["volume_ratio"]["mean"], 0.75);
    EXPECT_EQ(json["subdivisions"]["1-to-3a"], 2);
    EXPECT_EQ(json["subdivisions"]["1-to-3b"], 4);
    EXPECT_EQ(json["subdivisions"]["other"], 18);
    EXPECT_EQ(json["volume_ratio"]["min"], 0.5);
    EXPECT_EQ(json["volume_ratio"]["final"], 0.5);
    EXPECT_EQ(json["fps"]["mean"], 50);
    EXPECT_EQ(json["fps"]["max"], 100);
    EXPECT_EQ(json["real_time_factor"]["median"], 0.5);
    EXPECT_DOUBLE_EQ(json["real_time_factor"]["worst"], 0.005 / 0.03);
    EXPECT_EQ(json["stages_ms"]["cut"]["max"], 0);
    EXPECT_EQ(json["stages_ms"]["search"]["max"], 3);
    EXPECT_EQ(json["closed_every_step"], false);
}

TEST(AtomicFile, AppearsAndReplacesOnlyWhenItIsComplete) {
    const test::TemporaryFolder folder;
    const auto abandon = [&] {
        AtomicFile file(folder / "a.txt");
        file.write("half");
        return fs::exists(folder / "a.txt");
    };
    EXPECT_FALSE(abandon());
    EXPECT_TRUE(fs::is_empty(folder.path())) << "an abandoned file leaves nothing";
    writeOutputFile(folder / "a.txt", "whole");
    abandon();
    EXPECT_EQ(readBytes(folder / "a.txt"), "whole");
}

TEST(AtomicFile, FailuresNameTheFileAndTheReason) {
    const test::TemporaryFolder folder;
    const fs::path file = folder / "missing/a.txt";
    try {
        writeOutputFile(file, "x");
        FAIL() << "no error";
    } catch (const OutputError& error) {
        EXPECT_EQ(error.what(), file.string() +
                                    ": it could not be written (No such file or directory); that "
                                    "folder doesn't exist or takes no files; choose another one.");
    }
    fs::create_directory(folder / "a.txt");
    EXPECT_THROW(writeOutputFile(folder / "a.txt", "x"), OutputError);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder.path()), {}), 1)
        << "the hidden file is gone";
}

// Slits, notches and tears in a sheet of gelatin whose ends are drawn apart.

/// 60 x 6 x 40 mm, in squares of 2 and 3 mm. Corners are written once for each square: readers
/// join them.
std::string sheet() {
    constexpr std::array<int, 3> kCells{30, 2, 20};
    const Vec3 kSize(0.06, 0.006, 0.04);
    std::string text;
    for (int k = 0; k < 3; ++k) {
        const int u = (k + 1) % 3;
        const int v = (k + 2) % 3;
        for (int square = 0; square < 2 * kCells[u] * kCells[v]; ++square) {
            const bool far = square % 2 == 1;
            for (const auto& [du, dv] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) {
                Vec3 share = Vec3::Zero();
                share[k] = far ? 0.5 : -0.5;
                const int column = square / 2 % kCells[u] + (far ? du : dv);
                const int row = square / 2 / kCells[u] + (far ? dv : du);
                share[u] = static_cast<double>(column) / kCells[u] - 0.5;
                share[v] = static_cast<double>(row) / kCells[v] - 0.5;
                const Vec3 at = kSize.cwiseProduct(share);
                text += fmt::format("v {:.4f} {:.4f} {:.4f}\n", at.x(), at.y(), at.z());
            }
            text += "f -4 -3 -2 -1\n";
        }
    }
    return text;
}

/// A blade along y, from one place (x, z) to another [m].
using Slit = std::array<double, 4>;

Json bladeAt(int step, double x, double z) {
    return {{"step", step}, {"type", "blade"}, {"a", {x, 0.01, z}}, {"b", {x, -0.01, z}}};
}

/// Slits are made while time stands; then one end is drawn away for 0.3 s.
Json pulledApart(const std::vector<Slit>& slits) {
    Json events = {
        {{"step", 0}, {"type", "hold"}},
        {{"step", 0}, {"type", "pin"}, {"low", {-0.05, -1, -1}}, {"high", {-0.026, 1, 1}}}};
    int step = 1;
    for (const auto& [fromX, fromZ, toX, toZ] : slits) {
        events.push_back(bladeAt(step, fromX, fromZ));
        events.push_back(bladeAt(step + 10, toX, toZ));
        events.push_back({{"step", step + 11}, {"type", "lift"}});
        step += 13;
    }
    events.push_back({{"step", step}, {"type", "run"}});
    events.push_back({{"step", step},
                      {"type", "pin"},
                      {"low", {0.026, -1, -1}},
                      {"high", {0.05, 1, 1}},
                      {"velocity", {0.15, 0, 0}},
                      {"seconds", 0.3}});
    return {{"format", "kerf-session"},
            {"version", 1},
            {"model", {{"path", "sheet.obj"}}},
            {"material", "gelatin"},
            {"params",
             {{"time_step", 0.002},
              {"iterations", "auto"},
              {"iteration_error", 0.05},
              {"floor", nullptr},
              {"gravity", {0, 0, 0}},
              {"tearing", 1},
              {"wall_coarsening", 3}}},
            {"steps", 200},
            {"events", events}};
}

/// The largest number of a column of a CSV file.
double largest(const std::string& csv, const std::string& column) {
    std::istringstream lines(csv);
    const auto cells = [&lines] {
        std::string line;
        std::getline(lines, line);
        std::istringstream stream(line);
        std::vector<std::string> found;
        for (std::string cell; std::getline(stream, cell, ',');) {
            found.push_back(cell);
        }
        return found;
    };
    const std::vector<std::string> head = cells();
    const auto place = std::ranges::find(head, column) - head.begin();
    double most = 0;
    for (std::vector<std::string> row = cells(); !row.empty(); row = cells()) {
        most = std::max(most, row[place].empty() ? 0 : std::stod(row[place]));
    }
    return most;
}

struct Torn {
    Json summary;
    double stress = 0;  ///< largest of all steps, over the strength
};

Torn tear(const std::vector<Slit>& slits) {
    const test::TemporaryFolder folder;
    writeText(folder / "sheet.obj", sheet());
    writeText(folder / "tear.kerf.json", pulledApart(slits).dump());
    const ProgramRun run = runKerf({"replay", folder / "tear.kerf.json", "--out", folder / "out"});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    return {Json::parse(readBytes(folder / "out/summary.json")),
            largest(readBytes(folder / "out/metrics.csv"), "tear_stress")};
}

// 7 pairs of walls passed through each other.
TEST(ReplayTears, ATearThatMeetsASlitCrossesNoWall) {
    const Torn torn = tear({{-0.012, -0.0033, 0.014, -0.0033}, {0.0007, 0.03, 0.0007, 0.004}});
    EXPECT_GE(torn.summary["pieces"].size(), 2U) << "crumbs may be torn off where they meet";
    EXPECT_TRUE(torn.summary["closed_every_step"]);
    EXPECT_EQ(torn.summary["cut_report"]["self_intersections"]["pairs"], 0);
    EXPECT_NEAR(torn.summary["volume_ratio"]["final"].get<double>(), 1, 1e-3);
}

// A blade along a row of vertices leaves slivers, whose stretch was told as the largest: 3.7e7.
TEST(ReplayTears, NoSliverTellsTheStress) {
    const Torn torn = tear({{-0.004, 0.03, -0.004, 0.008}, {0.005, -0.03, 0.005, -0.008}});
    EXPECT_TRUE(torn.summary["closed_every_step"]);
    EXPECT_GT(torn.stress, 1);
    EXPECT_LT(torn.stress, 700);
}

}  // namespace
}  // namespace kerf::app
