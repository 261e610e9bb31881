#include <cstring>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/text_lines.h"
#include "app/import/face_soup.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

constexpr std::size_t kHeader = 80;
constexpr std::size_t kFacetsAt = kHeader + 4;
constexpr std::size_t kFacet = 50;
constexpr std::uint16_t kIsMarked = 0x8000;
constexpr unsigned kFiveBits = 31;

template <class T>
T valueAt(std::string_view bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

bool isComment(std::string_view word) {
    return word.starts_with('#') || word.starts_with(';') || word.starts_with("//");
}

/// Whether its first word is "solid", and no byte is 0 where a binary file has its count.
bool isText(std::string_view bytes) {
    TextLines lines(bytes);
    std::string word;
    while ((word.empty() || isComment(word)) && lines.next()) {
        std::string_view line = lines.line();
        word = lowerCase(std::string(takeWord(line)));
    }
    return word == "solid" && bytes.substr(0, kFacetsAt).find('\0') == std::string_view::npos;
}

/// As Materialise or VisCAM write it: in 15 bits, the blue or the red first.
Eigen::Vector4f colorOf(std::uint16_t attribute, bool materialise) {
    const auto part = [&](unsigned shift) {
        return static_cast<double>((attribute >> shift) & kFiveBits) / kFiveBits;
    };
    return materialise ? linearOf({part(0), part(5), part(10), 1})
                       : linearOf({part(10), part(5), part(0), 1});
}

/// The colour that Materialise writes into the header, for facets that have none of their own.
std::optional<Eigen::Vector4f> colorInHeader(std::string_view header) {
    constexpr std::string_view kColor = "COLOR=";
    const std::size_t at = header.find(kColor);
    if (at == std::string_view::npos || at + kColor.size() + 4 > header.size()) {
        return std::nullopt;
    }
    const auto bytes = valueAt<std::array<std::uint8_t, 4>>(header, at + kColor.size());
    return linearOf(Eigen::Vector4d(bytes[0], bytes[1], bytes[2], bytes[3]) / 255);
}

/// The length of a binary STL at the beginning of the bytes, as its header says; none where they
/// are shorter.
std::optional<std::uint64_t> binarySize(std::string_view bytes) {
    const std::uint64_t count =
        bytes.size() < kFacetsAt ? bytes.size() : valueAt<std::uint32_t>(bytes, kHeader);
    const std::uint64_t size = kFacetsAt + kFacet * count;
    return size <= bytes.size() ? std::optional(size) : std::nullopt;
}

/// One behind another is an object of its own.
void readFacets(std::string_view bytes, FaceSoup& faces) {
    if (faces.faceCount() > 0) {
        faces.beginObject("");
    }
    const bool hasPieces = bytes.starts_with("Kerf, ");
    const std::optional<Eigen::Vector4f> common = colorInHeader(bytes.substr(0, kHeader));
    for (std::size_t at = kFacetsAt; at < bytes.size(); at += kFacet) {
        for (std::size_t corner = 1; corner <= 3; ++corner) {
            const auto p = valueAt<std::array<float, 3>>(bytes, at + 12 * corner);
            faces.addCorner(static_cast<int>(faces.positions.size()));
            faces.positions.emplace_back(p[0], p[1], p[2]);
        }
        const auto attribute = valueAt<std::uint16_t>(bytes, at + kFacet - 2);
        if (hasPieces) {
            faces.enterObject("piece_" + std::to_string(attribute + 1));
        }
        const bool marked = (attribute & kIsMarked) != 0;
        if (common || marked) {
            faces.faceColors.resize(faces.faceCount(), Eigen::Vector4f::Ones());
            faces.faceColors.push_back(common && marked ? *common
                                                        : colorOf(attribute, common.has_value()));
        }
        faces.endFace();
    }
}

/// Several may stand one behind the other.
void readBinary(std::string_view bytes, FaceSoup& faces, std::vector<std::string>& remarks) {
    std::optional<std::uint64_t> size = binarySize(bytes);
    if (!size) {
        throw InputError(
            "it is neither a binary STL as long as its number of triangles says, nor a text that "
            "begins with \"solid\"");
    }
    do {
        readFacets(bytes.substr(0, *size), faces);
        bytes.remove_prefix(*size);
        size = binarySize(bytes);
    } while (size > kFacetsAt);
    const std::string count = std::to_string(faces.faceCount());
    if (!bytes.empty() && bytes.size() % kFacet == 0) {
        throw InputError("its header counts " + count + " triangles, and there are " +
                         std::to_string(faces.faceCount() + bytes.size() / kFacet) +
                         "; export it again");
    }
    if (!bytes.empty()) {
        remarks.push_back(counted(bytes.size(), "byte", "bytes") +
                          " behind its last triangle were left out.");
    }
}

Vec3 takePlace(std::string_view& line) {
    Vec3 place;
    for (double& number : place) {
        number = numberOf(takeWord(line));
    }
    return place;
}

/// A text. Words may be parted into lines in any way, but for a name, which ends with its line.
class StlText {
  public:
    explicit StlText(FaceSoup& faces) : faces_(faces) {}

    void readLine(std::string_view line) {
        for (std::string word = next(line); !word.empty() && !isComment(word); word = next(line)) {
            if (word == "solid" || word == "endsolid") {
                readSolid(word, withoutBlanks(line));
                return;
            }
            readWord(word, line);
        }
    }
    /// Within a solid, whose last line says that nothing is cut off.
    bool isOpen() const { return open_; }

  private:
    static std::string next(std::string_view& line) {
        const std::string word = lowerCase(std::string(takeWord(line)));
        return word == "end" ? word + lowerCase(std::string(takeWord(line))) : word;
    }

    void readSolid(std::string_view word, std::string_view name) {
        requireNoLoop();
        open_ = word == "solid";
        if (open_) {
            faces_.beginObject(std::string(name));
        }
    }

    void readWord(const std::string& word, std::string_view& line) {
        if (word == "vertex") {
            faces_.addCorner(static_cast<int>(faces_.positions.size()));
            faces_.positions.push_back(takePlace(line));
            inLoop_ = true;
        } else if (word == "endloop") {
            faces_.endFace();
            inLoop_ = false;
        } else if (word == "normal" || word == "color") {
            takePart(line);
        } else if (isFrame(word)) {
            requireNoLoop();
            open_ = open_ || word == "facet";
        } else {
            throw InputError("\"" + printable(word.substr(0, 40)) + "\" is no word of STL");
        }
    }

    static bool isFrame(std::string_view word) {
        return word == "facet" || word == "outer" || word == "loop" || word == "endfacet";
    }

    /// The numbers of a normal or a colour, whatever they are.
    static void takePart(std::string_view& line) {
        for (std::string_view rest = line; !withoutBlanks(rest).empty(); line = rest) {
            const std::string word = lowerCase(std::string(takeWord(rest)));
            if (word == "vertex" || isFrame(word)) {
                return;
            }
        }
    }

    void requireNoLoop() const {
        if (inLoop_) {
            throw InputError("a loop before it has no \"endloop\"");
        }
    }

    FaceSoup& faces_;
    bool open_ = false;
    bool inLoop_ = false;
};

void readText(std::string_view bytes, FaceSoup& faces) {
    TextLines lines(bytes);
    StlText text(faces);
    namingLine(lines, [&] {
        while (lines.next()) {
            text.readLine(lines.line());
        }
    });
    if (text.isOpen()) {
        throw InputError("it ends without \"endsolid\", so a part may be missing");
    }
}

}  // namespace

ImportedModel readStl(const std::filesystem::path& file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    const bool text = isText(bytes);
    FaceSoup faces;
    ImportedModel model;
    text ? readText(bytes, faces) : readBinary(bytes, faces, model.remarks);
    takeFaces(faces, model);
    text ? roundNearOrigin(model.soup) : requireFineFloats(model.soup.positions);
    return model;
}

}  // namespace kerf::app
