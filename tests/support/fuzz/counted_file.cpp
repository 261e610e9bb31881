// From top to bottom: what all share; OBJ, OFF, STL, PLY; glTF; what assimp reads.
#include "tests/support/fuzz/counted_file.h"

#include <bit>
#include <cstdlib>
#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "sim/base/text.h"

namespace kerf::test {

namespace {

using Json = nlohmann::json;
using Words = std::vector<std::string>;

/// A file that is more than is understood here.
struct Unclear {};
/// A file that can't be a whole model.
struct Damaged {
    std::string why;
};

/// What a file says, as it says it.
struct FaceList {
    std::vector<Vec3> points;
    std::vector<std::vector<long long>> faces;  ///< numbers of points, from 0
};

/// Whether it comes to a place twice: a part without area, such as a spike, need not arrive then.
bool repeats(const std::vector<long long>& face, const std::vector<Vec3>& points) {
    std::set<std::array<double, 3>> places;
    for (const long long corner : face) {
        const Vec3& p = points[static_cast<std::size_t>(corner)];
        places.insert({p.x(), p.y(), p.z()});
    }
    return face.size() > 3 && places.size() < face.size();
}

FileCount countOf(const FaceList& list) {
    FileCount count;
    Bounds bounds;
    bool plain = true;
    for (const auto& face : list.faces) {
        for (std::size_t i = 0; face.size() > 2 && i < face.size(); ++i) {
            if (face[i] < 0 || face[i] >= static_cast<long long>(list.points.size())) {
                throw Damaged{"a face names point " + std::to_string(face[i])};
            }
            bounds.add(list.points[static_cast<std::size_t>(face[i])]);
        }
        if (face.size() > 2) {
            const bool repeated = repeats(face, list.points);
            plain = plain && !repeated;
            count.triangles += face.size() - 2;
            count.least += repeated ? 1 : face.size() - 2;
        }
    }
    count.bounds = plain ? std::optional(bounds) : std::nullopt;
    return count;
}

template <class T>
T valueAt(std::string_view bytes, std::size_t at, bool swapped = false) {
    if (at > bytes.size() || bytes.size() - at < sizeof(T)) {
        throw Damaged{"it ends"};
    }
    std::array<char, sizeof(T)> own{};
    std::memcpy(own.data(), bytes.data() + at, sizeof(T));
    if (swapped) {
        std::ranges::reverse(own);
    }
    return std::bit_cast<T>(own);
}

double numberOf(const std::string& word) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (word.empty() || *end != '\0') {
        throw Damaged{word + " is no number"};
    }
    return number;
}

long long wholeOf(const std::string& word) {
    const double number = numberOf(word);
    if (number != std::floor(number) || std::abs(number) > 1e15) {
        throw Damaged{word + " is no whole number"};
    }
    return static_cast<long long>(number);
}

Words wordsOf(const std::string& line) {
    std::istringstream words(line);
    Words list;
    for (std::string word; words >> word;) {
        list.push_back(word);
    }
    return list;
}

std::string_view withoutMark(std::string_view bytes) {
    return bytes.substr(bytes.starts_with("\xef\xbb\xbf") ? 3 : 0);
}

/// The words of each line that has some.
std::vector<Words> linesOf(std::string_view bytes, char comment) {
    std::vector<Words> lines;
    std::string text(withoutMark(bytes));
    std::ranges::replace(text, '\r', '\n');
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) {
        if (line.ends_with('\\')) {
            throw Unclear{};
        }
        if (Words words = wordsOf(line.substr(0, line.find(comment))); !words.empty()) {
            lines.push_back(std::move(words));
        }
    }
    return lines;
}

Vec3 pointOf(const Words& words, std::size_t first) {
    if (words.size() < first + 3) {
        throw Damaged{"a point has fewer than three numbers"};
    }
    return {numberOf(words[first]), numberOf(words[first + 1]), numberOf(words[first + 2])};
}

// --- OBJ, OFF, STL, PLY -------------------------------------------------------------------------

FaceList facesOfObj(std::string_view bytes) {
    FaceList list;
    for (const Words& words : linesOf(bytes, '#')) {
        if (words[0] == "v" && words.size() == 5) {
            throw Unclear{};  // a weight
        } else if (words[0] == "v") {
            list.points.push_back(pointOf(words, 1));
        } else if (words[0] == "f" || words[0] == "fo") {
            auto& face = list.faces.emplace_back();
            for (const std::string& word : std::span(words).subspan(1)) {
                const long long number = wholeOf(word.substr(0, word.find('/')));
                const auto count = static_cast<long long>(list.points.size());
                face.push_back(number < 0 ? count + number : number - 1);
            }
        }
    }
    return list;
}

/// With its two or three counts on the second line.
FaceList facesOfOff(std::string_view bytes) {
    const std::vector<Words> lines = linesOf(bytes, '#');
    if (lines.size() < 2 || lines[0].size() > 1 || !lines[0][0].ends_with("OFF") ||
        lines[0][0].find_first_of("4n") != std::string::npos || lines[1].size() < 2 ||
        lines[1].size() > 3) {
        throw Unclear{};
    }
    std::size_t line = 2;
    std::size_t word = 0;
    const auto next = [&] {
        for (; line < lines.size() && word == lines[line].size(); ++line) {
            word = 0;
        }
        return line < lines.size() ? lines[line][word++] : throw Damaged{"it ends"};
    };
    const auto leaveLine = [&] {
        ++line;
        word = 0;
    };
    FaceList list;
    for (long long i = wholeOf(lines[1][0]); i > 0; --i) {
        const double x = numberOf(next());
        const double y = numberOf(next());
        list.points.emplace_back(x, y, numberOf(next()));
        for (int k = 0; k < 3 && lines[0][0].find('N') != std::string::npos; ++k) {
            next();
        }
        leaveLine();
    }
    for (long long i = wholeOf(lines[1][1]); i > 0; --i) {
        auto& face = list.faces.emplace_back();
        for (long long corners = wholeOf(next()); corners > 0; --corners) {
            face.push_back(wholeOf(next()));
        }
        leaveLine();
    }
    return list;
}

/// One behind the other; bytes that make up none are left over.
FaceList facesOfBinaryStl(std::string_view bytes) {
    FaceList list;
    while (bytes.size() >= 84) {
        const std::size_t end = 84 + std::size_t{50} * valueAt<std::uint32_t>(bytes, 80);
        for (std::size_t at = 84; end <= bytes.size() && at < end; at += 50) {
            auto& face = list.faces.emplace_back();
            for (std::size_t corner = 1; corner <= 3; ++corner) {
                const std::size_t from = at + 12 * corner;
                face.push_back(static_cast<long long>(list.points.size()));
                list.points.emplace_back(valueAt<float>(bytes, from),
                                         valueAt<float>(bytes, from + 4),
                                         valueAt<float>(bytes, from + 8));
            }
        }
        bytes.remove_prefix(std::min(end, bytes.size()));
    }
    return list;
}

/// With its words in lines as programs part them. A facet may have several loops.
FaceList facesOfTextStl(std::string_view bytes) {
    static const std::set<std::string> kFirst{"loop", "endloop", "endfacet",
                                              "end",  "color",   "normal"};
    FaceList list;
    for (Words& words : linesOf(bytes, '#')) {
        std::ranges::transform(words, words.begin(), lowerCase);
        const std::string& first = words[0];
        const bool facet = first == "facet";
        if (first == "solid" || first == "endsolid") {
            continue;  // A name follows.
        }
        if (std::ranges::count(words, "vertex") > 1 || (facet && words.size() > 5) ||
            first.starts_with(';') || first.starts_with('/')) {
            throw Unclear{};
        }
        if (facet || (first == "outer" && (list.faces.empty() || !list.faces.back().empty()))) {
            list.faces.emplace_back();
        } else if (first == "vertex" && words.size() == 4 && !list.faces.empty()) {
            list.faces.back().push_back(static_cast<long long>(list.points.size()));
            list.points.push_back(pointOf(words, 1));
        } else if (first != "outer" && !kFirst.contains(first)) {
            throw Damaged{"it has a line " + first};
        }
    }
    return list;
}

FaceList facesOfStl(std::string_view bytes) {
    const bool text = lowerCase(std::string(withoutMark(bytes).substr(0, 5))) == "solid" &&
                      bytes.substr(0, 84).find('\0') == std::string_view::npos;
    const bool whole = bytes.size() >= 84 &&
                       bytes.size() >= 84 + std::uint64_t{50} * valueAt<std::uint32_t>(bytes, 80);
    if (!text && !whole) {
        throw Unclear{};
    }
    return text ? facesOfTextStl(bytes) : facesOfBinaryStl(bytes);
}

struct PlyProperty {
    std::string count;  ///< the type of the length of a list; "" for one that is none
    std::string type;
    std::string name;
};
struct PlyElement {
    std::string name;
    long long count = 0;
    std::vector<PlyProperty> properties;
};

class PlyCounter {
  public:
    explicit PlyCounter(std::string_view bytes) : bytes_(withoutMark(bytes)) { readHead(); }

    FaceList faces() {
        FaceList list;
        for (const PlyElement& element : elements_) {
            if (element.name == "tristrips") {
                throw Unclear{};
            }
            for (long long i = 0; !element.properties.empty() && i < element.count; ++i) {
                readItem(element, list);
            }
        }
        return list;
    }

  private:
    void readHead() {
        const std::size_t first = bytes_.find_first_of("\r\n");
        bool more = true;
        while (more) {
            const std::size_t end = bytes_.find('\n', at_);
            if (end == std::string_view::npos ||
                (bytes_[first] == '\r' && bytes_.substr(first, 2) != "\r\n")) {
                throw Unclear{};
            }
            const Words words = wordsOf(std::string(bytes_.substr(at_, end - at_)));
            at_ = end + 1;
            more = words.empty() || words[0] != "end_header";
            if (more && !words.empty()) {
                readHeadLine(words);
            }
        }
    }

    void readHeadLine(const Words& words) {
        static const std::set<std::string> kSaysNothing{"ply", "comment", "obj_info"};
        if (words[0] == "format" && words.size() > 1) {
            format_ = words[1];
        } else if (words[0] == "element" && words.size() == 3) {
            elements_.push_back({words[1], wholeOf(words[2]), {}});
            if (elements_.back().count < 0) {
                throw Damaged{"a count is negative"};
            }
        } else if (words[0] == "property" && words.size() > 2 && words[1] != "list" &&
                   !elements_.empty()) {
            elements_.back().properties.push_back({"", words[1], words[2]});
        } else if (words[0] == "property" && words.size() > 4 && words[1] == "list" &&
                   !elements_.empty()) {
            elements_.back().properties.push_back({words[2], words[3], words[4]});
        } else if (!kSaysNothing.contains(words[0])) {
            throw Damaged{"its header has the line " + words[0]};
        }
    }

    void readItem(const PlyElement& element, FaceList& list) {
        Vec3 point = Vec3::Zero();
        for (const PlyProperty& property : element.properties) {
            const double count = property.count.empty() ? 1 : next(property.count);
            std::vector<double> numbers;
            while (static_cast<double>(numbers.size()) < count) {
                numbers.push_back(next(property.type));
            }
            if (count != std::floor(count)) {
                throw Damaged{"a list has a part of an item"};
            }
            if (element.name == "vertex" && property.name.size() == 1 && count == 1) {
                const std::size_t axis = std::string_view("xyz").find(property.name[0]);
                (axis < 3 ? point[static_cast<int>(axis)] : numbers[0]) = numbers[0];
            } else if (element.name == "face" && property.name.starts_with("vertex_ind")) {
                addFace(numbers, list);
            }
        }
        if (element.name == "vertex") {
            list.points.push_back(point);
        }
    }

    static void addFace(const std::vector<double>& numbers, FaceList& list) {
        auto& face = list.faces.emplace_back();
        for (const double number : numbers) {
            if (!(number >= 0 && number < 1e9 && number == std::floor(number))) {
                throw Damaged{"a face names point " + std::to_string(number)};
            }
            face.push_back(static_cast<long long>(number));
        }
    }

    double next(const std::string& type) {
        if (format_ == "ascii") {
            at_ = std::min(bytes_.find_first_not_of(" \t\r\n", at_), bytes_.size());
            const std::size_t end = std::min(bytes_.find_first_of(" \t\r\n", at_), bytes_.size());
            const std::string word(bytes_.substr(at_, end - at_));
            at_ = end;
            return numberOf(word);
        }
        using Reader = double (PlyCounter::*)();
        static const std::map<std::string, Reader> kReaders{
            {"char", &PlyCounter::take<std::int8_t>},
            {"int8", &PlyCounter::take<std::int8_t>},
            {"uchar", &PlyCounter::take<std::uint8_t>},
            {"uint8", &PlyCounter::take<std::uint8_t>},
            {"short", &PlyCounter::take<std::int16_t>},
            {"int16", &PlyCounter::take<std::int16_t>},
            {"ushort", &PlyCounter::take<std::uint16_t>},
            {"uint16", &PlyCounter::take<std::uint16_t>},
            {"int", &PlyCounter::take<std::int32_t>},
            {"int32", &PlyCounter::take<std::int32_t>},
            {"uint", &PlyCounter::take<std::uint32_t>},
            {"uint32", &PlyCounter::take<std::uint32_t>},
            {"float", &PlyCounter::take<float>},
            {"float32", &PlyCounter::take<float>},
            {"double", &PlyCounter::take<double>},
            {"float64", &PlyCounter::take<double>}};
        const auto reader = kReaders.find(type);
        if (reader == kReaders.end()) {
            throw Damaged{"it has the type " + type};
        }
        return (this->*reader->second)();
    }
    template <class T>
    double take() {
        const T value = valueAt<T>(bytes_, at_, format_ == "binary_big_endian");
        at_ += sizeof(T);
        return static_cast<double>(value);
    }

    std::string_view bytes_;
    std::size_t at_ = 0;
    std::string format_ = "ascii";
    std::vector<PlyElement> elements_;
};

// --- glTF ---------------------------------------------------------------------------------------

std::string bytesOfBase64(std::string_view text) {
    constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned bits = 0;
    int count = 0;
    for (const char c : text.substr(0, text.find('='))) {
        const std::size_t digit = kDigits.find(c);
        if (digit == std::string_view::npos) {
            throw Unclear{};
        }
        bits = bits << 6 | static_cast<unsigned>(digit);
        count += 6;
        if (count >= 8) {
            count -= 8;
            bytes += static_cast<char>(bits >> count & 255U);
        }
    }
    return bytes;
}

class GltfCounter {
  public:
    explicit GltfCounter(std::string_view bytes) {
        std::string_view json = withoutMark(bytes);
        if (bytes.starts_with("glTF")) {
            const auto length = valueAt<std::uint32_t>(bytes, 12);
            if (length % 4 != 0 || valueAt<std::uint32_t>(bytes, 16) != 0x4E4F534A) {
                throw Unclear{};
            }
            json = bytes.substr(20, length);
            const bool more = bytes.size() >= 28 + std::size_t{length};
            binary_ = more ? bytes.substr(28 + std::size_t{length}) : "";
        }
        top_ = Json::parse(json.substr(0, json.find_last_not_of('\0') + 1), nullptr, false);
        if (!top_.is_object()) {
            throw Damaged{"it is no JSON"};
        }
    }

    FileCount count() {
        if (!listed(top_, "scenes").empty()) {
            const Json& scene = item("scenes", number(top_, "scene", 0));
            for (const Json& node : listed(scene, "nodes")) {
                show(whole(node));
            }
        } else {
            std::set<std::size_t> children;
            for (const Json& node : listed(top_, "nodes")) {
                for (const Json& child : listed(node, "children")) {
                    children.insert(whole(child));
                }
            }
            for (std::size_t i = 0; i < listed(top_, "nodes").size(); ++i) {
                if (!children.contains(i)) {
                    show(i);
                }
            }
        }
        FileCount all = countOf(faces_);
        if (moved_) {
            all.bounds.reset();
        }
        return all;
    }

  private:
    static const Json& listed(const Json& object, const char* key) {
        static const Json kNone = Json::array();
        const auto found = object.find(key);
        if (found != object.end() && !found->is_array()) {
            throw Damaged{std::string(key) + " is no list"};
        }
        return found == object.end() ? kNone : *found;
    }
    static std::size_t whole(const Json& value) {
        if (!value.is_number() || value.get<double>() < 0 ||
            value.get<double>() != std::floor(value.get<double>())) {
            throw Damaged{value.dump(-1, ' ', true, Json::error_handler_t::replace) +
                          " stands for an index or a count"};
        }
        return value.get<double>() > 1e12 ? throw Unclear{} : value.get<std::size_t>();
    }
    static std::size_t number(const Json& object, const char* key, std::size_t otherwise) {
        return object.contains(key) ? whole(object.at(key)) : otherwise;
    }
    const Json& item(const char* list, std::size_t index) const {
        const Json& items = listed(top_, list);
        if (index >= items.size() || !items[index].is_object()) {
            throw Damaged{"it names one of its " + std::string(list) + " that is not there"};
        }
        return items[index];
    }

    void show(std::size_t index) {
        const Json& node = item("nodes", index);
        if (!shown_.insert(index).second) {
            throw Damaged{"a node hangs twice"};
        }
        for (const char* key : {"matrix", "translation", "rotation", "scale", "skin", "weights"}) {
            moved_ = moved_ || node.contains(key);
        }
        if (node.contains("mesh")) {
            const Json& mesh = item("meshes", whole(node.at("mesh")));
            moved_ = moved_ || mesh.contains("weights");
            for (const Json& primitive : listed(mesh, "primitives")) {
                addPrimitive(primitive);
            }
        }
        for (const Json& child : listed(node, "children")) {
            show(whole(child));
        }
    }

    void addPrimitive(const Json& primitive) {
        const std::size_t mode = primitive.is_object() ? number(primitive, "mode", 4)
                                                       : throw Damaged{"a primitive is none"};
        const auto attributes = primitive.find("attributes");
        if (attributes != primitive.end() && !attributes->is_object()) {
            throw Damaged{"attributes are none"};
        }
        if (mode < 4 || attributes == primitive.end() || !attributes->contains("POSITION")) {
            return;
        }
        const auto first = static_cast<long long>(faces_.points.size());
        const std::vector<double> places = placesOf(whole(attributes->at("POSITION")));
        for (std::size_t i = 0; i + 2 < places.size(); i += 3) {
            faces_.points.emplace_back(places[i], places[i + 1], places[i + 2]);
        }
        std::vector<double> corners;
        if (primitive.contains("indices")) {
            corners = numbers(whole(primitive.at("indices")), 1);
        } else {
            for (std::size_t i = 0; i < places.size() / 3; ++i) {
                corners.push_back(static_cast<double>(i));
            }
        }
        for (std::size_t i = 0; i + 2 < corners.size(); i += mode == 4 ? 3 : 1) {
            auto& face = faces_.faces.emplace_back();
            for (const std::size_t k : {mode == 6 ? 0 : i, i + 1, i + 2}) {
                const auto corner = static_cast<long long>(corners[k]);
                face.push_back(corner < static_cast<long long>(places.size() / 3) ? first + corner
                                                                                  : -1);
            }
        }
    }

    /// Zeros where they are not plain floats.
    std::vector<double> placesOf(std::size_t accessor) {
        try {
            return numbers(accessor, 3);
        } catch (const Unclear&) {
            moved_ = true;
            const std::size_t count = number(item("accessors", accessor), "count", 0);
            if (count > 100'000) {
                throw;
            }
            return std::vector<double>(3 * count);
        }
    }

    static double componentAt(std::size_t type, std::string_view bytes, std::size_t at) {
        switch (type) {
            case 5121:
                return valueAt<std::uint8_t>(bytes, at);
            case 5123:
                return valueAt<std::uint16_t>(bytes, at);
            case 5125:
                return valueAt<std::uint32_t>(bytes, at);
            case 5126:
                return valueAt<float>(bytes, at);
            default:
                throw Unclear{};
        }
    }

    /// Floats for points, whole numbers for corners.
    std::vector<double> numbers(std::size_t index, std::size_t width) const {
        const Json& accessor = item("accessors", index);
        if (accessor.contains("sparse") || !accessor.contains("bufferView")) {
            throw Unclear{};
        }
        const Json& view = item("bufferViews", whole(accessor.at("bufferView")));
        const std::string bytes = buffer(number(view, "buffer", 0))
                                      .substr(number(view, "byteOffset", 0))
                                      .substr(0, number(view, "byteLength", 0));
        const std::size_t type = number(accessor, "componentType", 0);
        if (width == 3 && type != 5126) {
            throw Unclear{};
        }
        const std::size_t size = type == 5121 ? 1 : type == 5123 ? 2 : 4;
        const std::size_t given = number(view, "byteStride", 0);
        const std::size_t stride = given == 0 ? width * size : given;
        std::vector<double> list;
        for (std::size_t i = 0; i < number(accessor, "count", 0); ++i) {
            for (std::size_t k = 0; k < width; ++k) {
                const std::size_t at = number(accessor, "byteOffset", 0) + i * stride + k * size;
                list.push_back(componentAt(type, bytes, at));
            }
        }
        return list;
    }

    std::string buffer(std::size_t index) const {
        const Json& buffer = item("buffers", index);
        if (!buffer.contains("uri")) {
            return index == 0 ? binary_ : throw Unclear{};
        }
        const std::string uri = buffer.at("uri").is_string() ? buffer.at("uri").get<std::string>()
                                                             : throw Damaged{"a URI is none"};
        const std::size_t data = uri.find(";base64,");
        return uri.starts_with("data:") && data != std::string::npos
                   ? bytesOfBase64(std::string_view(uri).substr(data + 8))
                   : throw Unclear{};
    }

    Json top_;
    std::string binary_;
    FaceList faces_;
    std::set<std::size_t> shown_;
    bool moved_ = false;
};

// --- What assimp reads --------------------------------------------------------------------------

std::size_t timesIn(std::string_view bytes, std::string_view words) {
    std::size_t times = 0;
    for (std::size_t at = bytes.find(words); at != std::string_view::npos;
         at = bytes.find(words, at + 1)) {
        ++times;
    }
    return times;
}

/// The triangles of polygons with these numbers of corners.
std::size_t trianglesOf(const Words& corners) {
    std::size_t triangles = 0;
    for (const std::string& word : corners) {
        triangles += static_cast<std::size_t>(std::max(wholeOf(word) - 2, 0LL));
    }
    return triangles;
}

/// What stands in a text between two words, from `at` on.
std::string between(std::string_view text, std::size_t at, std::string_view from,
                    std::string_view to) {
    const std::size_t begin = text.find(from, at);
    if (begin == std::string_view::npos) {
        throw Unclear{};
    }
    const std::string_view rest = text.substr(begin + from.size());
    return std::string(rest.substr(0, rest.find(to)));
}

/// One mesh of triangles, or of polygons with a list of their corners, that is shown once.
FileCount countOfDae(std::string_view bytes) {
    for (const char* word : {"<!", "<polygons", "<tristrips", "<trifans", "instance_node",
                             "instance_controller", "nan"}) {
        if (timesIn(bytes, word) > 0) {
            throw Unclear{};
        }
    }
    if (timesIn(bytes, "<geometry ") != 1 || timesIn(bytes, "<instance_geometry ") != 1) {
        throw Unclear{};
    }
    FileCount count;
    for (std::size_t at = bytes.find("<triangles "); at != std::string_view::npos;
         at = bytes.find("<triangles ", at + 1)) {
        const long long triangles = wholeOf(between(bytes, at, " count=\"", "\""));
        count.least += static_cast<std::size_t>(std::max(triangles, 0LL));
    }
    count.triangles = count.least;
    for (std::size_t at = bytes.find("<polylist "); at != std::string_view::npos;
         at = bytes.find("<polylist ", at + 1)) {
        const std::size_t all = trianglesOf(wordsOf(between(bytes, at, "<vcount>", "<")));
        count.triangles += all;
        count.least += all / 2;
    }
    return count;
}

/// The faces of all meshes, each shown once.
void count3ds(std::string_view bytes, FileCount& count) {
    for (std::size_t at = 0; at + 6 <= bytes.size();) {
        const auto kind = valueAt<std::uint16_t>(bytes, at);
        const auto length = valueAt<std::uint32_t>(bytes, at + 2);
        if (length < 6 || length > bytes.size() - at) {
            throw Unclear{};
        }
        std::string_view inner = bytes.substr(at + 6, length - 6);
        if (kind == 0x4D4D || kind == 0x3D3D || kind == 0x4100) {
            count3ds(inner, count);
        } else if (kind == 0x4000) {
            count3ds(inner.substr(std::min(inner.find('\0'), inner.size() - 1) + 1), count);
        } else if (kind == 0x4120) {
            count.triangles += valueAt<std::uint16_t>(inner, 0);
            count.least = count.triangles;
        } else if (kind == 0xB000) {
            throw Unclear{};  // It may show a mesh several times.
        }
        at += length;
    }
}

/// Numbers of corners, of which the last of each face is negative.
std::size_t trianglesOf(const std::vector<long long>& corners) {
    std::size_t triangles = 0;
    std::size_t face = 0;
    for (const long long corner : corners) {
        ++face;
        if (corner < 0) {
            triangles += face > 2 ? face - 2 : 0;
            face = 0;
        }
    }
    return face == 0 ? triangles : throw Damaged{"its last face does not end"};
}

std::vector<long long> binaryCorners(std::string_view bytes) {
    std::vector<long long> corners;
    const auto count = valueAt<std::uint32_t>(bytes, 1);
    if (bytes[0] != 'i' || valueAt<std::uint32_t>(bytes, 5) != 0) {
        throw Unclear{};
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        corners.push_back(valueAt<std::int32_t>(bytes, 13 + 4 * std::size_t{i}));
    }
    return corners;
}

/// As "*36 { a: 0,1,-3, ... }".
std::vector<long long> textCorners(std::string_view bytes) {
    std::string text(bytes.substr(0, bytes.find('}')));
    std::ranges::replace(text, ',', ' ');
    const Words words = wordsOf(text);
    if (words.size() < 4 || !words[1].starts_with('*') || words[2] != "{" || words[3] != "a:") {
        throw Unclear{};
    }
    std::vector<long long> corners;
    for (std::size_t i = 4; i < words.size(); ++i) {
        corners.push_back(wholeOf(words[i]));
    }
    return corners;
}

/// As "*2 { a: 0,1 }", whose length is told.
void requireLengths(std::string_view text) {
    for (std::size_t at = text.find('*'); at != std::string_view::npos; at = text.find('*', at)) {
        const std::string list(text.substr(at + 1, text.find('}', at) - at - 1));
        ++at;
        const Words words = wordsOf(list);
        const bool told =
            !words.empty() && words[0].find_first_not_of("0123456789") == words[0].npos;
        if (told && words.size() > 3 && words[1] == "{" && words[2] == "a:" &&
            numberOf(words[0]) != static_cast<double>(1 + std::ranges::count(list, ','))) {
            throw Damaged{"a list has another length than " + words[0]};
        }
    }
}

/// One mesh that is shown once.
FileCount countOfFbx(std::string_view bytes) {
    constexpr std::string_view kCorners = "PolygonVertexIndex";
    const std::size_t at = bytes.find(kCorners);
    using namespace std::string_view_literals;
    if (timesIn(bytes, kCorners) != 1 ||
        timesIn(bytes, "\"Model::") + timesIn(bytes, "\0\1Model"sv) != 1) {
        throw Unclear{};
    }
    const std::string_view behind = bytes.substr(at + kCorners.size());
    const bool binary = bytes.starts_with("Kaydara FBX Binary");
    if (!binary) {
        requireLengths(bytes);
    }
    const std::size_t all = trianglesOf(binary ? binaryCorners(behind) : textCorners(behind));
    return {all, all / 2, {}, {}};
}

FileCount counted(std::string_view ending, std::string_view bytes) {
    if (ending == ".obj") {
        return countOf(facesOfObj(bytes));
    }
    if (ending == ".off") {
        return countOf(facesOfOff(bytes));
    }
    if (ending == ".stl") {
        return countOf(facesOfStl(bytes));
    }
    if (ending == ".ply") {
        return countOf(PlyCounter(bytes).faces());
    }
    if (ending == ".gltf" || ending == ".glb") {
        return GltfCounter(bytes).count();
    }
    if (ending == ".3ds") {
        FileCount count;
        count3ds(bytes, count);
        return count;
    }
    if (ending == ".fbx") {
        return countOfFbx(bytes);
    }
    if (ending == ".dae") {
        return countOfDae(bytes);
    }
    throw Unclear{};
}

}  // namespace

std::optional<FileCount> countOf(std::string_view ending, std::string_view bytes) {
    try {
        return counted(ending, bytes);
    } catch (const Unclear&) {
        return std::nullopt;
    } catch (const Damaged& damaged) {
        return FileCount{0, 0, {}, damaged.why};
    } catch (const std::out_of_range&) {  // of std::string::substr
        return FileCount{0, 0, {}, "a part of it is not there"};
    }
}

}  // namespace kerf::test
