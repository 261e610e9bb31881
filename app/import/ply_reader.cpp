// From top to bottom: the header; elements; what becomes of them.

#include <sstream>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/text_lines.h"
#include "app/import/appearance_reader.h"
#include "app/import/face_soup.h"
#include "app/import/file_numbers.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

struct Property {
    std::string name;
    const Scalar* type = nullptr;
    const Scalar* count = nullptr;  ///< null for one that is no list
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    /// The place of the first property that has one of the names, -1 for none.
    int find(std::initializer_list<std::string_view> names) const {
        const auto found = std::ranges::find_if(properties, [&](const Property& p) {
            return std::ranges::find(names, p.name) != names.end();
        });
        return found == properties.end() ? -1 : static_cast<int>(found - properties.begin());
    }
};

struct Header {
    Encoding encoding = Encoding::text;
    std::vector<Element> elements;
    std::vector<std::string> images;  ///< the names of their files
    std::size_t size = 0;             ///< [bytes]
};

[[noreturn]] void fail(const std::string& what) {
    throw InputError(what + "; export it again");
}

const Scalar* scalarOf(const std::string& name) {
    const Scalar* const type = findScalar(name);
    if (type == nullptr) {
        fail("its header names \"" + name + "\", which is no type of PLY");
    }
    return type;
}

Encoding encodingOf(const std::string& name) {
    if (name == "ascii") {
        return Encoding::text;
    }
    if (name != "binary_little_endian" && name != "binary_big_endian") {
        fail("its header names \"" + name + "\", which is no format of PLY");
    }
    return name == "binary_big_endian" ? Encoding::bigEndian : Encoding::littleEndian;
}

Property propertyOf(std::istringstream& words) {
    Property property;
    std::string type;
    words >> type;
    if (type == "list") {
        words >> type;
        property.count = scalarOf(type);
        words >> type;
    }
    property.type = scalarOf(type);
    if (!(words >> property.name)) {
        fail("its header has a property without a name");
    }
    return property;
}

void readComment(const std::string& line, Header& header) {
    constexpr std::string_view kTexture = "TextureFile ";
    if (const std::size_t at = line.find(kTexture); at != std::string::npos) {
        header.images.push_back(line.substr(at + kTexture.size()));
    }
}

/// Of a header, those that say nothing here.
constexpr std::array<std::string_view, 3> kOtherLines{"ply", "obj_info", "end_header"};
constexpr std::size_t kShownOfLine = 40;  // most letters of a line in a message

/// False at the last line.
bool readLine(const std::string& line, Header& header) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "comment") {
        readComment(line, header);
    } else if (word == "format") {
        words >> word;
        header.encoding = encodingOf(word);
    } else if (word == "element") {
        Element element;
        if (!(words >> element.name >> element.count) || words >> word) {
            fail("its header has the line \"" + printable(line) + "\" without a count");
        }
        if (std::ranges::count(header.elements, element.name, &Element::name) > 0) {
            fail("its header has the element \"" + printable(element.name) + "\" twice");
        }
        header.elements.push_back(std::move(element));
    } else if (word == "property" && !header.elements.empty()) {
        header.elements.back().properties.push_back(propertyOf(words));
    } else if (!word.empty() && std::ranges::find(kOtherLines, word) == kOtherLines.end()) {
        fail("its header has the line \"" + printable(line.substr(0, kShownOfLine)) +
             "\", which is none of PLY");
    }
    return word != "end_header";
}

/// Lines end as the first one does. A byte order mark may stand before it.
Header headerOf(std::string_view bytes) {
    Header header;
    const std::size_t first = bytes.size() - withoutMark(bytes).size();
    std::size_t at = first;
    const std::size_t firstEnd = std::min(bytes.find_first_of("\r\n", at), bytes.size());
    const char end =
        bytes.substr(firstEnd, 1) == "\r" && bytes.substr(firstEnd, 2) != "\r\n" ? '\r' : '\n';
    std::string line;
    do {
        const std::size_t next = bytes.find(end, at);
        if (next == std::string_view::npos) {
            fail("its header has no line \"end_header\"");
        }
        line = bytes.substr(at, next - at);
        line.erase(line.find_last_not_of(" \t\r") + 1);
        if (at == first && line != "ply") {
            fail("it does not begin with a line \"ply\"");
        }
        at = next + 1;
    } while (readLine(line, header));
    header.size = at;
    return header;
}

/// What one item of an element holds, by property; one number for each that is no list.
using Row = std::vector<std::vector<double>>;

void readRow(const Element& element, FileNumbers& numbers, Row& row) {
    row.resize(element.properties.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        const Property& property = element.properties[i];
        const double count = property.count == nullptr ? 1 : numbers.next(*property.count);
        row[i].clear();
        for (double k = 0; k < count; ++k) {
            row[i].push_back(numbers.next(*property.type));
        }
        if (!(count >= 0 && count == std::floor(count))) {
            throw InputError("a list has " + formatNumber(count) + " items");
        }
    }
}

/// Some properties of one kind, such as the coordinates, by their places in an element.
struct Group {
    std::vector<int> places;

    bool isThere(std::size_t least) const {
        return std::all_of(places.begin(), places.begin() + std::ptrdiff_t(least),
                           [](int place) { return place >= 0; });
    }
    double of(const Row& row, std::size_t i) const {
        const int place = places[i];
        return place < 0 || row[place].empty() ? 0 : row[place].front();
    }
};

/// The properties of an element that are read.
struct ReadProperties {
    explicit ReadProperties(const Element& element)
        : at{{element.find({"x"}), element.find({"y"}), element.find({"z"})}},
          uv{{element.find({"s", "u", "texture_u", "texture_s"}),
              element.find({"t", "v", "texture_v", "texture_t"})}},
          color{{element.find({"red", "r", "diffuse_red"}),
                 element.find({"green", "g", "diffuse_green"}),
                 element.find({"blue", "b", "diffuse_blue"}),
                 element.find({"alpha", "a", "diffuse_alpha"})}},
          corners(element.find({"vertex_indices", "vertex_index"})),
          piece{{element.find({"piece"})}},
          cornerUvs(element.find({"texcoord"})),
          image{{element.find({"texnumber"})}} {}

    Group at;
    Group uv;
    Group color;
    int corners;
    Group piece;  ///< of a cut body, as Kerf writes it
    int cornerUvs;
    Group image;
};

/// As displays take it, with the opacity.
Eigen::Vector4f colorOf(const Element& element, const Group& color, const Row& row) {
    const auto share = [&](std::size_t i) {
        const int place = color.places[i];
        return place < 0 ? 1 : color.of(row, i) / element.properties[place].type->most;
    };
    return Eigen::Vector4d(share(0), share(1), share(2), share(3)).cast<float>();
}

/// Collects vertices and faces in whatever order they come, and makes triangles of them.
class PlyModel {
  public:
    /// Leaves out elements that say nothing about the surface. False for one of these.
    bool read(const Element& element, FileNumbers& numbers) {
        const ReadProperties places(element);
        const bool isVertex = element.name == "vertex";
        const bool isFace = element.name == "face";
        const bool isStrip = element.name == "tristrips";
        if (isVertex && !places.at.isThere(3)) {
            fail("its vertices have no x, y and z");
        }
        Row row;
        const std::uint64_t count = element.properties.empty() ? 0 : element.count;
        for (std::uint64_t i = 0; i < count; ++i) {
            try {
                readRow(element, numbers, row);
            } catch (const InputError& error) {
                fail(std::string(error.what()) + " within its element \"" +
                     printable(element.name) + "\": " + std::to_string(i) + " of " +
                     std::to_string(element.count) + " are there");
            }
            if (isVertex) {
                addVertex(element, places, row);
            } else if (isFace && places.corners >= 0) {
                addFace(element, places, row);
            } else if (isStrip && places.corners >= 0) {
                faces_.addStrips(row[places.corners]);
            }
        }
        return isVertex || isFace || isStrip;
    }

    FaceSoup& faces() {
        makeLinear(faces_.vertexColors);
        makeLinear(faces_.faceColors);
        return faces_;
    }

  private:
    void addVertex(const Element& element, const ReadProperties& places, const Row& row) {
        const Vec3 at(places.at.of(row, 0), places.at.of(row, 1), places.at.of(row, 2));
        faces_.positions.push_back(at);
        if (places.uv.isThere(2)) {
            faces_.vertexUvs.emplace_back(places.uv.of(row, 0), places.uv.of(row, 1));
        }
        if (places.color.isThere(3)) {
            faces_.vertexColors.push_back(colorOf(element, places.color, row));
        }
    }

    void addFace(const Element& element, const ReadProperties& places, const Row& row) {
        const std::vector<double> none;
        const std::vector<double>& uvs = places.cornerUvs < 0 ? none : row[places.cornerUvs];
        const std::vector<double>& corners = row[places.corners];
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const bool hasUv = 2 * i + 1 < uvs.size();
            if (hasUv) {
                faces_.uvs.emplace_back(uvs[2 * i], uvs[2 * i + 1]);
            }
            faces_.addCorner(cornerOf(corners[i]),
                             hasUv ? static_cast<int>(faces_.uvs.size()) - 1 : FaceSoup::kNone);
        }
        if (places.color.isThere(3)) {
            faces_.faceColors.resize(faces_.faceCount(), kNoColor);
            faces_.faceColors.push_back(colorOf(element, places.color, row));
        }
        if (places.piece.isThere(1)) {
            faces_.enterObject("piece_" + formatNumber(places.piece.of(row, 0) + 1));
        }
        faces_.endFace(cornerOf(places.image.of(row, 0)));
    }

    FaceSoup faces_;
};

/// A material for each image, by the numbers that faces have for them.
void addImages(const std::filesystem::path& file, const std::vector<std::string>& names,
               ImportedModel& model) {
    ModelImages images(file, model);
    for (std::size_t i = 0; i < names.size(); ++i) {
        render::SurfaceMaterial material;
        material.name = "image" + (i == 0 ? "" : std::to_string(i + 1));
        images.add(std::move(material), names[i]);
    }
    std::vector<int>& materials = model.soup.skin.materials;
    materials.resize(names.empty() ? 0 : model.soup.triangles.size(), 0);
}

}  // namespace

ImportedModel readPly(const std::filesystem::path& file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    const Header header = headerOf(bytes);
    FileNumbers numbers(std::string_view(bytes).substr(header.size), header.encoding);
    PlyModel read;
    ImportedModel model;
    for (const Element& element : header.elements) {
        if (!read.read(element, numbers) && element.count > 0) {
            model.remarks.push_back("Its element \"" + printable(element.name) +
                                    "\" was left out: Kerf does not know it.");
        }
    }
    if (!numbers.isAtEnd()) {
        model.remarks.emplace_back(
            "What stands behind its last element was left out: its header counts no more.");
    }
    takeFaces(read.faces(), model);
    addImages(file, header.images, model);
    return model;
}

}  // namespace kerf::app
