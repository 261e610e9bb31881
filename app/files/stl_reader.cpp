#include "app/files/stl_reader.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <optional>

#include "app/files/face_soup.h"
#include "app/files/file_io.h"
#include "app/files/model_source.h"
#include "app/files/text_lines.h"
#include "render/scene/body_look.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kFacetsAt = kHeader + 4;
constexpr std::size_t kFacet = 50;
constexpr std::uint16_t kIsColor = 0x8000;
constexpr unsigned kFiveBits = 31;

template <class T>
T valueAt(std::string_view bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// The length of a binary file with as many facets as it says.
std::optional<std::uint64_t> binarySize(std::string_view bytes) {
    if (bytes.size() < kFacetsAt) {
        return std::nullopt;
    }
    return kFacetsAt + kFacet * std::uint64_t{valueAt<std::uint32_t>(bytes, kHeader)};
}

bool isComment(std::string_view word) {
    return word.starts_with('#') || word.starts_with(';') || word.starts_with("//");
}

/// Whether its first word is "solid", and a second line is one of a text too.
bool isText(std::string_view bytes) {
    constexpr std::size_t kLooked = 4096;
    TextLines lines(bytes.substr(0, kLooked));
    bool begun = false;
    while (lines.next()) {
        std::string_view line = lines.line();
        const std::string word = lowerCase(std::string(takeWord(line)));
        if (word.empty() || isComment(word)) {
            continue;
        }
        if (begun || word != "solid") {
            return begun && (word == "facet" || word == "endsolid" || word == "solid");
        }
        begun = true;
    }
    return begun;
}

/// As Materialise or VisCAM write it: in 15 bits, the blue or the red first.
Eigen::Vector4f colorOf(std::uint16_t attribute, bool materialise) {
    const auto part = [&](unsigned shift) {
        return static_cast<double>((attribute >> shift) & kFiveBits) / kFiveBits;
    };
    const Vec3 display =
        materialise ? Vec3(part(0), part(5), part(10)) : Vec3(part(10), part(5), part(0));
    const Vec3f linear = render::toLinear(display);
    return {linear.x(), linear.y(), linear.z(), 1};
}

/// In Materialise's files the highest bit says that a facet has none of its own.
void readBinary(std::string_view bytes, FaceSoup& faces) {
    const bool materialise = bytes.substr(0, kHeader).find("COLOR=") != std::string_view::npos;
    const bool hasPieces = bytes.starts_with("Kerf, ");
    const auto count = valueAt<std::uint32_t>(bytes, kHeader);
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::size_t at = kFacetsAt + kFacet * i;
        for (std::size_t corner = 1; corner <= 3; ++corner) {
            const auto p = valueAt<std::array<float, 3>>(bytes, at + 12 * corner);
            faces.addCorner(static_cast<int>(faces.positions.size()));
            faces.positions.emplace_back(p[0], p[1], p[2]);
        }
        const auto attribute = valueAt<std::uint16_t>(bytes, at + kFacet - 2);
        if (hasPieces) {
            faces.enterObject("piece_" + std::to_string(attribute + 1));
        }
        if (const bool colored = (attribute & kIsColor) != 0; colored != materialise && colored) {
            faces.faceColors.resize(i, Eigen::Vector4f::Ones());
            faces.faceColors.push_back(colorOf(attribute, materialise));
        }
        faces.endFace();
    }
}

/// `open`: within a solid, whose last line says that nothing is cut off.
void readLine(std::string_view line, FaceSoup& faces, bool& open) {
    const std::string word = lowerCase(std::string(takeWord(line)));
    open = word == "solid" || word == "facet" || (open && word != "endsolid");
    if (word == "solid") {
        faces.beginObject(std::string(withoutBlanks(line)));
    } else if (word == "vertex") {
        Vec3 place;
        for (double& number : place) {
            number = numberOf(takeWord(line));
        }
        faces.addCorner(static_cast<int>(faces.positions.size()));
        faces.positions.push_back(place);
    } else if (word == "endloop") {
        faces.endFace();
    }
}

void readText(std::string_view bytes, FaceSoup& faces) {
    TextLines lines(bytes);
    bool open = false;
    while (lines.next()) {
        try {
            readLine(lines.line(), faces, open);
        } catch (const InputError& error) {
            throw InputError("line " + std::to_string(lines.number()) + ": " + error.what());
        }
    }
    if (open) {
        throw InputError("it ends without \"endsolid\", so a part may be missing");
    }
}

}  // namespace

ImportedModel readStl(const std::filesystem::path& file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    const std::optional<std::uint64_t> binary = binarySize(bytes);
    const bool text = binary != bytes.size() && isText(bytes);
    FaceSoup faces;
    if (!text && binary && *binary <= bytes.size()) {
        readBinary(bytes, faces);
    } else if (text) {
        readText(bytes, faces);
    } else {
        throw InputError(
            "it is neither a binary STL as long as its number of triangles says, nor a text that "
            "begins with \"solid\"");
    }
    ImportedModel model;
    takeFaces(faces, model);
    text ? roundNearOrigin(model.soup) : requireFineFloats(model.soup.positions);
    return model;
}

}  // namespace kerf::app
