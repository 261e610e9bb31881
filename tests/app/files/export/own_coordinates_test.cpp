// Models that are opened and exported untouched have the coordinates of their files again, as
// plain readers of the formats see them, without assimp and without what wrote them.

#include "app/files/import/import_answer.h"

namespace kerf::app {
namespace {

using Point = std::array<float, 3>;
using Corners3 = std::array<Point, 3>;
/// Triangles by their corners.
using Soup = std::vector<Corners3>;

/// Whether all numbers are the same, in the order of the file. `rounding`: of a number, by which
/// they may differ.
bool areSame(const Soup& a, const Soup& b, float rounding) {
    bool same = a.size() == b.size();
    for (std::size_t t = 0; same && t < a.size(); ++t) {
        for (int i = 0; i < 9; ++i) {
            const float x = a[t][i / 3][i % 3];
            const float y = b[t][i / 3][i % 3];
            same &= std::fabs(x - y) <= rounding * std::fabs(x);
        }
    }
    return same;
}

template <class T>
T take(const std::string& bytes, std::size_t& at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    at += sizeof value;
    return value;
}

Soup soupOf(const std::vector<Point>& points, const std::vector<std::array<int, 3>>& triangles) {
    Soup soup;
    for (const auto& [a, b, c] : triangles) {
        soup.push_back({points[a], points[b], points[c]});
    }
    return soup;
}

Soup plainObj(const std::string& text) {
    std::vector<Point> points;
    std::vector<std::array<int, 3>> triangles;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        std::string word;
        words >> word;
        if (word == "v") {
            std::array<std::string, 3> numbers;
            words >> numbers[0] >> numbers[1] >> numbers[2];
            points.push_back({std::stof(numbers[0]), std::stof(numbers[1]), std::stof(numbers[2])});
        } else if (word == "f") {
            std::array<std::string, 3> corners;
            words >> corners[0] >> corners[1] >> corners[2];
            triangles.push_back(
                {std::stoi(corners[0]) - 1, std::stoi(corners[1]) - 1, std::stoi(corners[2]) - 1});
        }
    }
    return soupOf(points, triangles);
}

int countIn(const std::string& header, const std::string& element) {
    return std::stoi(header.substr(header.find("element " + element) + 9 + element.size()));
}

Point inFloats(const std::array<double, 3>& place) {
    return {static_cast<float>(place[0]), static_cast<float>(place[1]),
            static_cast<float>(place[2])};
}

Soup plainPly(const std::string& bytes) {
    std::size_t at = bytes.find("end_header\n") + 11;
    const std::string header = bytes.substr(0, at);
    const bool colored = header.find("uchar red") != std::string::npos;
    const bool far = header.find("double x") != std::string::npos;
    std::vector<Point> points(countIn(header, "vertex"));
    for (Point& point : points) {
        point = far ? inFloats(take<std::array<double, 3>>(bytes, at)) : take<Point>(bytes, at);
        take<Point>(bytes, at);  // normal
        at += colored ? 4 : 0;
    }
    std::vector<std::array<int, 3>> triangles(countIn(header, "face"));
    for (auto& triangle : triangles) {
        take<std::uint8_t>(bytes, at);
        triangle = take<std::array<int, 3>>(bytes, at);
        at += 5;  // piece, cut
    }
    return soupOf(points, triangles);
}

Soup plainStl(const std::string& bytes) {
    std::size_t at = 80;
    Soup soup(take<std::uint32_t>(bytes, at));
    for (Corners3& corners : soup) {
        take<Point>(bytes, at);  // normal
        corners = take<Corners3>(bytes, at);
        at += 2;
    }
    return soup;
}

/// Of one mesh with one primitive, without a transform but for a translation.
Soup plainGlb(const std::string& bytes) {
    std::size_t at = 12;
    const auto size = take<std::uint32_t>(bytes, at);
    const auto json = Json::parse(bytes.substr(20, size));
    const std::size_t buffer = 20 + size + 8;
    const auto startOf = [&](const Json& accessor) {
        return buffer + json["bufferViews"][accessor["bufferView"].get<int>()]["byteOffset"]
                            .get<std::size_t>();
    };
    EXPECT_FALSE(json["nodes"][0].contains("scale") || json["nodes"][0].contains("matrix"));
    const auto& primitive = json["meshes"][0]["primitives"][0];
    const auto& positions = json["accessors"][primitive["attributes"]["POSITION"].get<int>()];
    const auto& indices = json["accessors"][primitive["indices"].get<int>()];
    std::vector<Point> points(positions["count"].get<std::size_t>());
    at = startOf(positions);
    const auto moved = json["nodes"][0].value("translation", std::array<double, 3>{});
    for (Point& point : points) {
        const auto own = take<Point>(bytes, at);
        point = inFloats({own[0] + moved[0], own[1] + moved[1], own[2] + moved[2]});
    }
    std::vector<std::array<int, 3>> triangles(indices["count"].get<std::size_t>() / 3);
    at = startOf(indices);
    for (auto& triangle : triangles) triangle = take<std::array<int, 3>>(bytes, at);
    return soupOf(points, triangles);
}

Soup readPlainly(const std::string& ending, const std::string& bytes) {
    return ending == ".obj"   ? plainObj(bytes)
           : ending == ".ply" ? plainPly(bytes)
           : ending == ".stl" ? plainStl(bytes)
                              : plainGlb(bytes);
}

struct Shape {
    const char* name;
    TriangleSoup soup;
    double size;
    Vec3 offset;
};

/// From a thousandth to a thousand long, at the origin and far from it.
std::vector<Shape> shapes() {
    const Vec3 far(1e4, -2e4, 3e4);
    return {
        {"sphere", icosphereSoup(2), 1, Vec3::Zero()},
        {"a sphere far away", icosphereSoup(1, 5), 1, far},
        {"a tiny ring", torusSoup(), 1e-3, Vec3::Zero()},
        {"a tiny box aside", boxSoup(Vec3(1, 2, 3), 2), 1e-3, Vec3(10, 0, -10)},
        {"a huge tube", bentTubeSoup(), 1e3, Vec3::Zero()},
        {"a huge ball far away", cubeSphereSoup(5), 1e3, far},
        {"a figure of 9.66", gradedTorusSoup(), 9.66, Vec3(0, 4.83, 0)},
        {"a print of 60", bentTubeSoup(), 60, Vec3(100, 100, 0)},
    };
}

class OwnCoordinates : public ::testing::TestWithParam<const char*> {
  protected:
    /// The soup in floats, as a file of the format has it; what is zero but for rounding is zero.
    fs::path write(const Shape& shape) {
        TriangleSoup soup = shape.soup;
        for (Vec3& p : soup.positions) {
            const Vec3 exact = p.unaryExpr([](double x) { return std::fabs(x) < 1e-9 ? 0 : x; });
            p = nearestFloats(shape.size * exact + shape.offset);
        }
        const SurfaceMesh mesh = meshOf(soup);
        fs::path file = folder / (std::string("model") + GetParam());
        writeOutputFile(file, encodeMesh(mesh, findPieces(mesh), *meshFormatOf(file)));
        return file;
    }
    std::string exported(const Document& document, const std::string& ending) {
        const ExportTarget target{"out" + ending, false, Coordinates::model};
        return encodeExport(target, document.mesh, findPieces(document.mesh), {},
                            {document.session.placement})
            .front()
            .bytes;
    }

    test::TemporaryFolder folder;
};

/// Of a text, assimp reads the last digit of a float otherwise than others now and then.
TEST_P(OwnCoordinates, ComeBackExactlyInEveryFormat) {
    const float rounding = std::string(GetParam()) == ".obj" ? 2.4e-7F : 0;
    for (const Shape& shape : shapes()) {
        const fs::path file = write(shape);
        const Soup before = readPlainly(GetParam(), readInputFile(file, kMaxModelBytes));
        const Document document = openDocument(file);
        EXPECT_FALSE(document.note.empty());
        for (const char* ending : {".obj", ".ply", ".stl", ".glb"}) {
            EXPECT_TRUE(areSame(readPlainly(ending, exported(document, ending)), before, rounding))
                << shape.name << " as " << ending;
        }
    }
}

TEST_P(OwnCoordinates, LieOverTheOriginOfTheSceneInMetres) {
    for (const Shape& shape : shapes()) {
        const Document document = openDocument(write(shape));
        const Bounds& bounds = document.restBounds;
        EXPECT_NEAR(bounds.center().x(), 0, 1e-6 * bounds.diagonal()) << shape.name;
        EXPECT_NEAR(bounds.low.y(), 0.02 * bounds.diagonal(), 1e-6 * bounds.diagonal());
        const double unit = document.session.placement.metresPerUnit();
        const double length = shape.size * (boxOf(shape.soup.positions).diagonal());
        EXPECT_NEAR(bounds.diagonal(), unit * length, 1e-3 * unit * length) << shape.name;
    }
}

INSTANTIATE_TEST_SUITE_P(Formats, OwnCoordinates, ::testing::Values(".obj", ".ply", ".stl", ".glb"),
                         [](const auto& format) { return std::string(format.param).substr(1); });

}  // namespace
}  // namespace kerf::app
