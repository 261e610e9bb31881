#include "app/files/import_protocol.h"

#include <algorithm>
#include <cstring>
#include <sstream>

#include "app/files/model_source.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr char kMagic[8] = {'K', 'E', 'R', 'F', 'M', 'E', 'S', '2'};
constexpr std::uint64_t kMaxMessage = 1000;
constexpr std::uint64_t kLeastTriangles = 4;  // a tetrahedron; the sentence below says it

ImportHeader header(std::uint64_t failed) {
    ImportHeader head{};
    std::memcpy(head.magic, kMagic, sizeof(kMagic));
    head.failed = failed;
    return head;
}

template <class T>
void append(std::string& bytes, const T* items, std::size_t count) {
    bytes.append(reinterpret_cast<const char*>(items), count * sizeof(T));
}

/// One line of printable ASCII: what a reader quotes from a damaged file may be anything.
std::string cleaned(std::string_view message) {
    std::string line(message.substr(0, message.find('\n')));
    std::ranges::replace_if(
        line, [](char c) { return c < ' ' || c > '~'; }, '?');
    return line.empty() ? "no reason given" : line.substr(0, line.find_last_not_of(". ") + 1);
}

ImportHeader readHeader(std::string_view answer) {
    ImportHeader head{};
    if (answer.size() < sizeof(head)) {
        throw InputError("the model reader stopped before it answered; the file may be damaged");
    }
    std::memcpy(&head, answer.data(), sizeof(head));
    if (std::memcmp(head.magic, kMagic, sizeof(kMagic)) != 0) {
        throw InputError("the model reader gave an answer of another kind; rebuild Kerf");
    }
    return head;
}

[[noreturn]] void throwFailure(const ImportHeader& head, std::string_view body) {
    const std::uint64_t size =
        std::min<std::uint64_t>({head.messageLength, body.size(), kMaxMessage});
    throw InputError("it can't be read (" + cleaned(body.substr(0, size)) +
                     "); check that it is what its extension says, or export it again");
}

void checkCounts(const ImportHeader& head) {
    if (head.vertices > kMaxImportVertices || head.triangles > kMaxImportTriangles) {
        throw InputError(std::to_string(head.triangles) + " triangles and " +
                         std::to_string(head.vertices) + " vertices, of which at most " +
                         std::to_string(kMaxImportTriangles) + " and " +
                         std::to_string(kMaxImportVertices) + " are read; decimate the model");
    }
    if (head.triangles < kLeastTriangles) {
        throw InputError(counted(head.triangles, "triangle", "triangles") +
                         ", but a solid needs at least 4; export the model as a triangle mesh");
    }
}

void checkIndices(const TriangleSoup& soup) {
    const int count = static_cast<int>(soup.positions.size());
    const auto bad = std::ranges::count_if(soup.triangles, [&](const Triangle& t) {
        return std::ranges::any_of(t, [&](int v) { return v < 0 || v >= count; });
    });
    if (bad > 0) {
        throw InputError(counted(bad, "triangle names a vertex that is not there",
                                 "triangles name vertices that are not there") +
                         "; the file is damaged, export it again");
    }
}

void clearOddUvs(std::vector<CornerUvs>& uvs) {
    for (CornerUvs& corners : uvs) {
        for (Eigen::Vector2f& uv : corners) {
            if (!uv.allFinite()) {
                uv.setZero();
            }
        }
    }
}

TriangleSoup readBody(const ImportHeader& head, std::string_view body) {
    const std::size_t positionBytes = head.vertices * sizeof(Vec3);
    const std::size_t triangleBytes = head.triangles * sizeof(Triangle);
    const std::size_t uvBytes = head.textured != 0 ? head.triangles * sizeof(CornerUvs) : 0;
    if (body.size() != positionBytes + triangleBytes + uvBytes) {
        throw InputError("the model reader stopped in the middle; the file may be damaged");
    }
    TriangleSoup soup;
    soup.positions.resize(head.vertices);
    soup.triangles.resize(head.triangles);
    std::memcpy(static_cast<void*>(soup.positions.data()), body.data(), positionBytes);
    std::memcpy(soup.triangles.data(), body.data() + positionBytes, triangleBytes);
    if (uvBytes > 0) {
        soup.uvs.resize(head.triangles);
        std::memcpy(static_cast<void*>(soup.uvs.data()),
                    body.data() + positionBytes + triangleBytes, uvBytes);
        clearOddUvs(soup.uvs);
    }
    return soup;
}

}  // namespace

std::string encodeImport(const TriangleSoup& soup) {
    static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12 && sizeof(CornerUvs) == 24);
    ImportHeader head = header(0);
    head.vertices = soup.positions.size();
    head.triangles = soup.triangles.size();
    head.textured = soup.uvs.empty() ? 0 : 1;
    std::string bytes;
    append(bytes, &head, 1);
    append(bytes, soup.positions.data(), soup.positions.size());
    append(bytes, soup.triangles.data(), soup.triangles.size());
    append(bytes, soup.uvs.data(), soup.uvs.size());
    return bytes;
}

std::string encodeImportFailure(std::string_view message) {
    ImportHeader head = header(1);
    head.messageLength = message.size();
    std::string bytes;
    append(bytes, &head, 1);
    return bytes.append(message);
}

TriangleSoup decodeImport(std::string_view answer) {
    const ImportHeader head = readHeader(answer);
    const std::string_view body = answer.substr(sizeof(head));
    if (head.failed != 0) {
        throwFailure(head, body);
    }
    checkCounts(head);
    TriangleSoup soup = readBody(head, body);
    checkIndices(soup);
    return soup;
}

void checkImportedPositions(const TriangleSoup& soup) {
    const auto bad =
        std::ranges::count_if(soup.positions, [](const Vec3& p) { return !p.allFinite(); });
    if (bad > 0) {
        throw InputError(
            counted(bad, "vertex has a coordinate that is", "vertices have coordinates that are") +
            " not a finite number; the file is damaged, export it again");
    }
    Bounds bounds;
    for (const Vec3& p : soup.positions) {
        bounds.add(p);
    }
    const double extent = (bounds.high - bounds.low).maxCoeff();
    const double farthest =
        std::max(bounds.high.cwiseAbs().maxCoeff(), bounds.low.cwiseAbs().maxCoeff());
    if (extent < kMinImportExtent || farthest > kMaxImportExtent) {
        std::ostringstream message;
        message << "the model is " << extent << " m long and reaches " << farthest
                << " m from the origin, but must be longer than " << kMinImportExtent
                << " m and stay within " << kMaxImportExtent << " m; scale or move it";
        throw InputError(message.str());
    }
}

}  // namespace kerf::app
