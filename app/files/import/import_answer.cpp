#include "app/files/import/import_answer.h"

#include <cstring>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/files/io/errors.h"
#include "sim/base/math.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using Json = nlohmann::json;

constexpr char kMagic[8] = {'K', 'E', 'R', 'F', 'M', 'E', 'S', '4'};
constexpr std::uint64_t kMaxMessage = 1000;

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
    const std::string reason = cleaned(body.substr(0, size));
    // Sentences of ours say what to do, behind a semicolon.
    if (reason.find("; export it") != std::string::npos) {
        throw InputError(reason);
    }
    throw InputError("it can't be read (" + reason +
                     "); check that it is what its extension says, or export it again");
}

void checkCounts(const ImportHeader& head) {
    if (head.vertices > kMaxImportVertices || head.triangles > kMaxImportTriangles) {
        throw InputError(std::to_string(head.triangles) + " triangles and " +
                         std::to_string(head.vertices) + " vertices, of which at most " +
                         std::to_string(kMaxImportTriangles) + " and " +
                         std::to_string(kMaxImportVertices) + " are read; decimate the model");
    }
    if (head.triangles == 0) {
        throw InputError("there is no triangle in it; export the model as a triangle mesh");
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

/// Numbers that are none become 0.
template <class Values>
void clearOdd(std::vector<Values>& triangles) {
    for (Values& corners : triangles) {
        for (auto& value : corners) {
            if (!value.allFinite()) {
                value.setZero();
            }
        }
    }
}

/// Walks through the bytes of an answer.
class AnswerReader {
  public:
    explicit AnswerReader(std::string_view bytes) : rest_(bytes) {}

    template <class T>
    std::vector<T> take(std::uint64_t count) {
        const std::string_view bytes = takeBytes(count * sizeof(T));
        std::vector<T> items(count);
        if (count > 0) {
            std::memcpy(static_cast<void*>(items.data()), bytes.data(), bytes.size());
        }
        return items;
    }
    std::string_view takeBytes(std::uint64_t count) {
        if (count > rest_.size()) {
            stoppedInTheMiddle();
        }
        const std::string_view bytes = rest_.substr(0, count);
        rest_.remove_prefix(count);
        return bytes;
    }
    void end() const {
        if (!rest_.empty()) {
            stoppedInTheMiddle();
        }
    }

  private:
    [[noreturn]] static void stoppedInTheMiddle() {
        throw InputError("the model reader stopped in the middle; the file may be damaged");
    }

    std::string_view rest_;
};

TriangleSoup readSoup(const ImportHeader& head, AnswerReader& reader) {
    const auto perTriangle = [&](std::uint64_t there) { return there != 0 ? head.triangles : 0; };
    TriangleSoup soup;
    soup.positions = reader.take<Vec3>(head.vertices);
    soup.triangles = reader.take<Triangle>(head.triangles);
    soup.skin.uvs = reader.take<CornerUvs>(perTriangle(head.textured));
    soup.skin.colors = reader.take<CornerColors>(perTriangle(head.colored));
    soup.skin.materials = reader.take<int>(perTriangle(head.materials));
    soup.objects = reader.take<int>(perTriangle(head.objects));
    clearOdd(soup.skin.uvs);
    clearOdd(soup.skin.colors);
    return soup;
}

Json toJson(const ImportedModel& model) {
    Json materials = Json::array();
    for (const render::SurfaceMaterial& material : model.appearance.materials) {
        const Eigen::Vector4f& c = material.baseColor;
        materials.push_back({{"name", material.name},
                             {"color", {c.x(), c.y(), c.z(), c.w()}},
                             {"roughness", material.roughness},
                             {"metallic", material.metallic},
                             {"image", material.image}});
    }
    Json images = Json::array();
    for (const render::ModelImage& image : model.appearance.images) {
        images.push_back({{"name", image.name}, {"bytes", image.bytes.size()}});
    }
    Json units;
    if (model.facts.units) {
        units = {{"unit", static_cast<int>(model.facts.units->unit)},
                 {"up", static_cast<int>(model.facts.units->up)}};
    }
    return {{"materials", materials},
            {"images", images},
            {"objects", model.facts.objects},
            {"units", units},
            {"remarks", model.remarks}};
}

/// What a file calls something, without what would break a line.
std::string nameIn(const Json& json) {
    std::string name = json.get<std::string>().substr(0, kMaxMessage);
    std::ranges::replace_if(
        name, [](char c) { return c >= 0 && c < ' '; }, '_');
    return name;
}

/// A number of a colour or a surface; 0 where no float holds it.
float factorIn(const Json& json) {
    const double number = json.get<double>();
    return std::abs(number) <= std::numeric_limits<float>::max() ? static_cast<float>(number) : 0;
}

float shareIn(const Json& json) {
    return std::clamp(factorIn(json), 0.0F, 1.0F);
}

/// A number in a list of so many; -1 for one that is not there.
int indexIn(const Json& json, int count) {
    const bool there =
        json.is_number_unsigned() && json.get<std::uint64_t>() < std::uint64_t(count);
    return there ? json.get<int>() : -1;
}

render::SurfaceMaterial materialOf(const Json& json, int images) {
    render::SurfaceMaterial material;
    material.name = nameIn(json.at("name"));
    for (int i = 0; i < 4; ++i) {
        material.baseColor[i] = factorIn(json.at("color").at(i));
    }
    material.roughness = shareIn(json.at("roughness"));
    material.metallic = shareIn(json.at("metallic"));
    material.image = indexIn(json.at("image"), images);
    return material;
}

/// How many bytes an image has; more than there are where that is no count.
std::uint64_t countIn(const Json& json) {
    return json.is_number_unsigned() ? json.get<std::uint64_t>()
                                     : std::numeric_limits<std::uint64_t>::max();
}

void readLooks(const Json& json, AnswerReader& reader, ImportedModel& model) {
    for (const Json& image : json.at("images")) {
        const std::string_view bytes = reader.takeBytes(countIn(image.at("bytes")));
        model.appearance.images.push_back({nameIn(image.at("name")), std::string(bytes), {}});
    }
    for (const Json& material : json.at("materials")) {
        model.appearance.materials.push_back(
            materialOf(material, static_cast<int>(model.appearance.images.size())));
    }
    for (const Json& object : json.at("objects")) {
        model.facts.objects.push_back(nameIn(object));
    }
    if (const Json& units = json.at("units"); !units.is_null()) {
        const int unit = indexIn(units.at("unit"), std::size(kLengthUnitNames));
        const int up = indexIn(units.at("up"), std::size(kUpAxisNames));
        model.facts.units = {static_cast<LengthUnit>(std::max(unit, 0)),
                             static_cast<UpAxis>(std::max(up, 0))};
    }
    for (const Json& remark : json.at("remarks")) {
        model.remarks.push_back(nameIn(remark));
    }
}

void clearOddNumbers(ImportedModel& model) {
    const int objects = static_cast<int>(model.facts.objects.size());
    for (int& object : model.soup.objects) {
        object = object >= 0 && object < objects ? object : 0;
    }
    const int count = static_cast<int>(model.appearance.materials.size());
    for (int& material : model.soup.skin.materials) {
        material = material >= 0 && material < count ? material : -1;
    }
}

}  // namespace

std::uint64_t trianglesByHead(std::string_view head) {
    ImportHeader told{};
    if (head.size() < sizeof(told)) {
        return 0;
    }
    std::memcpy(&told, head.data(), sizeof(told));
    return told.failed == 0 ? std::min(told.triangles, kMaxImportTriangles) : 0;
}

std::string encodeImport(const ImportedModel& model) {
    static_assert(sizeof(Vec3) == 24 && sizeof(Triangle) == 12 && sizeof(CornerUvs) == 24 &&
                  sizeof(CornerColors) == 48);
    const TriangleSoup& soup = model.soup;
    const std::string looks = toJson(model).dump(-1, ' ', false, Json::error_handler_t::replace);
    ImportHeader head = header(0);
    head.vertices = soup.positions.size();
    head.triangles = soup.triangles.size();
    head.messageLength = looks.size();
    head.textured = soup.skin.uvs.empty() ? 0 : 1;
    head.colored = soup.skin.colors.empty() ? 0 : 1;
    head.materials = soup.skin.materials.empty() ? 0 : 1;
    head.objects = soup.objects.empty() ? 0 : 1;
    std::string bytes;
    append(bytes, &head, 1);
    append(bytes, soup.positions.data(), soup.positions.size());
    append(bytes, soup.triangles.data(), soup.triangles.size());
    append(bytes, soup.skin.uvs.data(), soup.skin.uvs.size());
    append(bytes, soup.skin.colors.data(), soup.skin.colors.size());
    append(bytes, soup.skin.materials.data(), soup.skin.materials.size());
    append(bytes, soup.objects.data(), soup.objects.size());
    bytes += looks;
    for (const render::ModelImage& image : model.appearance.images) {
        bytes += image.bytes;
    }
    return bytes;
}

std::string encodeImportFailure(std::string_view message) {
    ImportHeader head = header(1);
    head.messageLength = message.size();
    std::string bytes;
    append(bytes, &head, 1);
    return bytes.append(message);
}

ImportedModel decodeImport(std::string_view answer) {
    const ImportHeader head = readHeader(answer);
    const std::string_view body = answer.substr(sizeof(head));
    if (head.failed != 0) {
        throwFailure(head, body);
    }
    checkCounts(head);
    AnswerReader reader(body);
    ImportedModel model;
    model.soup = readSoup(head, reader);
    try {
        readLooks(Json::parse(reader.takeBytes(head.messageLength)), reader, model);
    } catch (const Json::exception&) {
        throw InputError("the model reader gave an answer of another kind; rebuild Kerf");
    }
    reader.end();
    checkIndices(model.soup);
    clearOddNumbers(model);
    return model;
}

void checkImportedPositions(const TriangleSoup& soup) {
    const auto bad =
        std::ranges::count_if(soup.positions, [](const Vec3& p) { return !p.allFinite(); });
    if (bad > 0) {
        throw InputError(
            counted(bad, "vertex has a coordinate that is", "vertices have coordinates that are") +
            " not a finite number; the file is damaged, export it again");
    }
    const Bounds bounds = boxOf(soup.positions);
    const double extent = (bounds.high - bounds.low).maxCoeff();
    const double farthest =
        std::max(bounds.high.cwiseAbs().maxCoeff(), bounds.low.cwiseAbs().maxCoeff());
    if (extent < kMinImportExtent || farthest > kMaxImportExtent) {
        std::ostringstream message;
        message << "the model is " << extent << " long and reaches " << farthest
                << " from the origin, but must be longer than " << kMinImportExtent
                << " and stay within " << kMaxImportExtent << "; scale or move it";
        throw InputError(message.str());
    }
}

}  // namespace kerf::app
