namespace kerf {
namespace {

constexpr double kWallEdge = 0.04;
constexpr double kRatio = 3;
const Vec3 kSphereCenter(0.013, 0.021, 0.034);

CutSettings settingsWith(double ratio) {
    CutSettings settings = exactSettings();
    settings.wallEdgeLength = kWallEdge;
    settings.wallCoarsening = ratio;
    return settings;
}

Stroke down() {
    return straightStroke(kSphereCenter, Vec3::UnitX(), -Vec3::UnitY(), 3.0, 2.4, 50);
}

Stroke inItsPlane() {
    return straightStroke(Vec3(0.003, 0.0012, 0.007), Vec3::UnitX(), Vec3::UnitZ(), 3.0, 2.4, 50);
}

/// Bends about half a radius aside on its way down.
Stroke curved() {
    Stroke stroke = down();
    for (Blade& blade : stroke) {
        const Vec3 aside = 0.2 * std::sin(2 * blade.a.y()) * Vec3::UnitZ();
        blade.a += aside;
        blade.b += aside;
    }
    return stroke;
}

/// From above, the tip about the middle of the body.
Stroke slit() {
    Stroke stroke;
    for (int i = 0; i <= 40; ++i) {
        const double x = -0.8 + 1.6 * i / 40;
        stroke.push_back({{x, 1.5, 0.011}, {x + 0.01, -0.1, 0.013}});
    }
    return stroke;
}

struct GradedCase {
    const char* name;
    SurfaceMesh mesh;
    std::vector<Stroke> strokes;
};

std::vector<GradedCase> gradedCases() {
    const Stroke across =
        straightStroke(kSphereCenter, Vec3(1, 0.2, 0.1).normalized(), Vec3::UnitZ(), 3.0, 2.4, 50);
    return {{"sphere", icosphere(3), {down()}},
            {"ring cut in its plane", torus(48, 24), {inItsPlane()}},
            {"sphere, curved", icosphere(3), {curved()}},
            {"sphere, slit", icosphere(3), {slit()}},
            {"sphere, across a cut", icosphere(3), {down(), across}}};
}

void run(SurfaceMesh& mesh, const CutSettings& settings, const Stroke& stroke) {
    Cutter cutter(mesh, settings);
    eachStep(cutter, stroke,
             [](const CutResult& result) { EXPECT_EQ(result.statistics.refusedPieces, 0); });
}

SurfaceMesh cutBody(const GradedCase& sample, double ratio) {
    SurfaceMesh mesh = sample.mesh;
    for (const Stroke& stroke : sample.strokes) {
        run(mesh, settingsWith(ratio), stroke);
    }
    return mesh;
}

std::vector<int> wallsOf(const SurfaceMesh& mesh) {
    std::vector<int> triangles = livingTriangles(mesh);
    std::erase_if(triangles, [&](int t) { return mesh.kind(t) != SurfaceKind::wall; });
    return triangles;
}

double longestWallEdge(const SurfaceMesh& mesh) {
    double longest = 0;
    for (const int t : wallsOf(mesh)) {
        for (int h = 3 * t; h < 3 * t + 3; ++h) {
            longest = std::max(
                longest, (mesh.position(mesh.target(h)) - mesh.position(mesh.origin(h))).norm());
        }
    }
    return longest;
}

/// Median over the walls of twice the area over the square of the longest edge.
double medianShape(const SurfaceMesh& mesh) {
    std::vector<double> shapes;
    for (const int t : wallsOf(mesh)) {
        const Corners at = cornersOf(mesh, t);
        shapes.push_back(areaNormal(at).norm() / longestEdgeSquare(at));
    }
    const auto middle = shapes.begin() + static_cast<std::ptrdiff_t>(shapes.size() / 2);
    std::ranges::nth_element(shapes, middle);
    return *middle;
}

double sumOfVolumes(const SurfaceMesh& mesh) {
    double sum = 0;
    for (const Piece& piece : findPieces(mesh).pieces) {
        sum += piece.volume;
    }
    return sum;
}

TEST(GradedWalls, AreThinInsideAndWellShaped) {
    for (const GradedCase& sample : gradedCases()) {
        SCOPED_TRACE(sample.name);
        const SurfaceMesh fine = cutBody(sample, 1);
        const SurfaceMesh graded = cutBody(sample, kRatio);
        EXPECT_EQ(findPieces(graded).pieces.size(), findPieces(fine).pieces.size());
        EXPECT_NEAR(sumOfVolumes(graded) / sumOfVolumes(sample.mesh), 1, 1e-9);
        EXPECT_LT(10 * wallsOf(graded).size(), 8 * wallsOf(fine).size());
        EXPECT_LE(longestWallEdge(graded),
                  std::max(longestWallEdge(fine), kRatio * kWallEdge * 4 / 3));
        EXPECT_GT(medianShape(graded), medianShape(fine));
        EXPECT_EQ(checkClosedManifold(graded), "");
        EXPECT_EQ(checkMirroredWalls(graded), "");
    }
}

// A stroke of a quarter of a second and a swipe, through a sphere of 81,920 triangles.
TEST(GradedWalls, AreAQuarterOfTheFineOnesAsSoonAsTheyAreMade) {
    const SurfaceMesh sphere = icosphere(6);
    for (const int steps : {15, 1}) {
        SCOPED_TRACE(steps);
        const auto wallsMade = [&](double ratio) {
            SurfaceMesh mesh = sphere;
            CutSettings settings = exactSettings();
            settings.wallCoarsening = ratio;
            Cutter cutter(mesh, settings);
            const Stroke stroke =
                straightStroke(kSphereCenter, Vec3::UnitX(), -Vec3::UnitY(), 3.0, 2.4, steps);
            cutter.begin(stroke.front());
            for (const Blade& blade : stroke) {
                EXPECT_EQ(cutter.advance(blade).statistics.refusedPieces, 0);
            }
            EXPECT_EQ(checkClosedManifold(mesh), "");
            return wallsOf(mesh).size();
        };
        EXPECT_LE(4 * wallsMade(kRatio), wallsMade(1));
    }
}

// Blades far slower than an edge a step: the rows of the wall get higher, too.
TEST(GradedWalls, OfASlowStrokeAreWellShapedToo) {
    const GradedCase sample{
        "slow",
        icosphere(4),
        {straightStroke(kSphereCenter, Vec3::UnitX(), -Vec3::UnitY(), 3.0, 2.4, 400)}};
    const SurfaceMesh fine = cutBody(sample, 1);
    const SurfaceMesh graded = cutBody(sample, kRatio);
    EXPECT_LT(2 * wallsOf(graded).size(), wallsOf(fine).size());
    EXPECT_GT(medianShape(graded), medianShape(fine));
}

/// The largest lag of the front behind the blade, and the largest that the cutter tells, in edges.
struct Lags {
    double seen = 0;
    double told = 0;
};

Lags lagsOf(double ratio) {
    SurfaceMesh mesh = icosphere(4);
    const Stroke stroke =
        straightStroke(kSphereCenter, Vec3::UnitX(), -Vec3::UnitY(), 3.0, 2.4, 400);
    Cutter cutter(mesh, settingsWith(ratio));
    cutter.begin(stroke.front());
    Lags lags;
    for (const Blade& blade : stroke) {
        cutter.advance(blade);
        for (const RungNode& node : cutter.rung()) {
            const double lag = node.vertex < 0 ? 0 : node.position.y() - blade.a.y();
            lags.seen = std::max(lags.seen, lag / kWallEdge);
        }
        lags.told = std::max(lags.told, cutter.gateAtFront());
    }
    return lags;
}

// A pushing blade begins that far behind the edge, and a felt one averages over it.
TEST(GradedWalls, TheCutterTellsHowFarASlowStrokeLags) {
    const Lags fine = lagsOf(1);
    EXPECT_EQ(fine.told, 0.5);
    EXPECT_LE(fine.seen, fine.told);
    const Lags graded = lagsOf(kRatio);
    EXPECT_GT(graded.seen, 0.6);
    EXPECT_LE(graded.seen, graded.told);
    EXPECT_EQ(graded.told, 1);
}

TEST(GradedWalls, OfRatioOneAreTheFineOnes) {
    const GradedCase sample = gradedCases().front();
    SurfaceMesh mesh = sample.mesh;
    CutSettings settings = exactSettings();
    settings.wallEdgeLength = kWallEdge;
    run(mesh, settings, sample.strokes[0]);
    EXPECT_EQ(fingerprint(cutBody(sample, 1)), fingerprint(mesh));
}

}  // namespace
}  // namespace kerf
