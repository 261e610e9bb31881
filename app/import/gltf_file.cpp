#include "app/import/gltf_file.h"

#include <cctype>
#include <cstring>

#include "app/files/io/encodings.h"
#include "app/files/io/file_io.h"
#include "app/files/io/text_lines.h"
#include "app/import/appearance_reader.h"
#include "sim/base/text.h"

namespace kerf::app {
namespace {

using Json = GltfFile::Json;

constexpr std::size_t kHead = 12;
constexpr std::size_t kChunkHead = 8;
constexpr std::uint32_t kJsonChunk = 0x4E4F534A;
constexpr std::uint32_t kBinaryChunk = 0x004E4942;
constexpr std::uint64_t kMostNumbers = 500'000'000;  // of an accessor

template <class T>
T numberAt(std::string_view bytes, std::size_t at) {
    T value;
    std::memcpy(&value, bytes.data() + at, sizeof value);
    return value;
}

/// A type of numbers: its code, how many bytes it has, and what it reads.
struct Component {
    int code;
    std::size_t bytes;
    double (*number)(std::string_view bytes, std::size_t at);
    double most;  ///< that stands for 1 where numbers are normalized
};
template <class T>
constexpr Component component(int code) {
    return {code, sizeof(T),
            [](std::string_view bytes, std::size_t at) {
                return static_cast<double>(numberAt<T>(bytes, at));
            },
            std::numeric_limits<T>::is_integer ? static_cast<double>(std::numeric_limits<T>::max())
                                               : 1};
}
constexpr std::array kComponents{component<std::int8_t>(5120),   component<std::uint8_t>(5121),
                                 component<std::int16_t>(5122),  component<std::uint16_t>(5123),
                                 component<std::uint32_t>(5125), component<float>(5126)};

const Component& componentOf(const Json& object) {
    const auto code = valueOf<int>(object, "componentType", 0);
    const auto* const found = std::ranges::find(kComponents, code, &Component::code);
    if (found == kComponents.end()) {
        throw InputError("it has numbers of the unknown type " + std::to_string(code));
    }
    return *found;
}

/// How many numbers an item of a type has.
struct ItemWidth {
    std::string_view type;
    std::size_t numbers;
};
constexpr std::array kWidths{ItemWidth{"SCALAR", 1}, ItemWidth{"VEC2", 2}, ItemWidth{"VEC3", 3},
                             ItemWidth{"VEC4", 4}, ItemWidth{"MAT4", 16}};

std::string_view partOf(std::string_view bytes, std::uint64_t at, std::uint64_t length,
                        const char* what) {
    if (at > bytes.size() || length > bytes.size() - at) {
        throw InputError("it ends within " + std::string(what));
    }
    return bytes.substr(at, length);
}

void requireVersion(const std::string& version) {
    if (!version.starts_with('2')) {
        throw InputError("it is glTF of version " + printable(version.substr(0, 20)) +
                         ", and 2 is read; export it again as 2.0");
    }
}

Json parsed(std::string_view text) {
    text = text.substr(0, text.find_last_not_of('\0') + 1);  // zeros where blanks should fill up
    Json json = Json::parse(withoutMark(text), nullptr, false);
    if (!json.is_object()) {
        throw InputError("its description is no JSON object");
    }
    requireVersion(valueOf<std::string>(json.value("asset", Json::object()), "version", "2.0"));
    return json;
}

/// The chunks of a GLB. Older programs leave out the bytes that fill one up to a multiple of four.
struct Chunks {
    std::string_view json;
    std::string_view binary;

    explicit Chunks(std::string_view bytes) {
        requireVersion(std::to_string(numberAt<std::uint32_t>(bytes, 4)));
        for (std::size_t at = kHead; at + kChunkHead <= bytes.size();) {
            const std::uint64_t length = numberAt<std::uint32_t>(bytes, at);
            const auto type = numberAt<std::uint32_t>(bytes, at + 4);
            const std::string_view content = partOf(bytes, at + kChunkHead, length, "a chunk");
            json = type == kJsonChunk && json.empty() ? content : json;
            binary = type == kBinaryChunk && binary.empty() ? content : binary;
            at += kChunkHead + length;
            const bool follows = at + kChunkHead <= bytes.size() &&
                                 numberAt<std::uint32_t>(bytes, at + 4) == kBinaryChunk;
            at = follows ? at : (at + 3) / 4 * 4;
        }
    }
};

int hexDigit(char c) {
    const auto digit = std::string_view("0123456789abcdef")
                           .find(static_cast<char>(std::tolower(static_cast<unsigned char>(c))));
    return digit == std::string_view::npos ? -1 : static_cast<int>(digit);
}

}  // namespace

std::string unescaped(std::string_view uri) {
    std::string name;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        const bool escape = uri[i] == '%' && i + 2 < uri.size();
        const int high = escape ? hexDigit(uri[i + 1]) : -1;
        const int low = escape ? hexDigit(uri[i + 2]) : -1;
        const bool valid = high >= 0 && low >= 0;
        name += valid ? static_cast<char>(16 * high + low) : uri[i];
        i += valid ? 2 : 0;
    }
    return name;
}

GltfFile::GltfFile(const std::filesystem::path& file) : file_(file) {
    const std::string bytes = readInputFile(file, kMaxModelBytes);
    if (bytes.starts_with("glTF") && bytes.size() >= kHead) {
        const Chunks chunks(bytes);
        binary_ = chunks.binary;
        top_ = parsed(chunks.json);
    } else {
        top_ = parsed(bytes);
    }
}

void GltfFile::openBuffers() {
    const Json none = Json::array();
    for (const Json& buffer : top_.contains("buffers") ? top_["buffers"] : none) {
        const auto uri = valueOf<std::string>(buffer, "uri", "");
        const bool within = uri.empty() && buffers_.empty();
        buffers_.push_back(within ? binary_ : uri.empty() ? "" : bytesOf(uri));
    }
}

const Json& GltfFile::item(const char* list, std::uint64_t index) const {
    const auto found = top_.find(list);
    if (found == top_.end() || !found->is_array() || index >= found->size() ||
        !(*found)[index].is_object()) {
        throw InputError("it names number " + std::to_string(index) + " of its " + list +
                         ", which is not there");
    }
    return (*found)[index];
}

std::string_view GltfFile::view(std::uint64_t index) const {
    const Json& view = item("bufferViews", index);
    const auto buffer = valueOf<std::uint64_t>(view, "buffer", 0);
    if (buffer >= buffers_.size()) {
        throw InputError("it names a buffer that is not there");
    }
    return partOf(buffers_[buffer], valueOf<std::uint64_t>(view, "byteOffset", 0),
                  valueOf<std::uint64_t>(view, "byteLength", 0), "a buffer");
}

std::string GltfFile::bytesOf(const std::string& uri) const {
    if (uri.starts_with("data:")) {
        const std::size_t comma = std::min(uri.find(','), uri.size() - 1);
        const std::string_view data = std::string_view(uri).substr(comma + 1);
        return std::string_view(uri).substr(0, comma).ends_with(";base64") ? bytesOfBase64(data)
                                                                           : unescaped(data);
    }
    const std::optional<std::filesystem::path> file = fileBeside(file_, unescaped(uri));
    if (!file) {
        throw InputError("its file \"" + printable(uri.substr(0, 100)) +
                         "\" is not there, in its folder or below");
    }
    return readInputFile(*file, kMaxModelBytes);
}

std::vector<double> GltfFile::numbers(std::uint64_t index, std::size_t width) const {
    const Json& accessor = item("accessors", index);
    const auto count = valueOf<std::uint64_t>(accessor, "count", 0);
    const auto type = valueOf<std::string>(accessor, "type", "");
    const auto* const kind = std::ranges::find(kWidths, type, &ItemWidth::type);
    if (kind == kWidths.end() || kind->numbers != width) {
        throw InputError("a list of it is of the type \"" + printable(type.substr(0, 20)) +
                         "\", which does not belong there");
    }
    if (count > kMostNumbers / width) {
        throw InputError("it has a list of " + std::to_string(count) + " items");
    }
    std::vector<double> numbers;
    if (accessor.contains("bufferView")) {
        addNumbers(accessor, accessor, width, count, numbers);
    }
    numbers.resize(count * width);  // zeros without a bufferView
    replaceSparse(accessor, width, numbers);
    return numbers;
}

/// `from` has the place of the numbers, `type` what they are like.
void GltfFile::addNumbers(const Json& from, const Json& type, std::size_t width,
                          std::uint64_t count, std::vector<double>& numbers) const {
    const auto viewIndex = valueOf<std::uint64_t>(from, "bufferView", 0);
    const std::string_view bytes = view(viewIndex);
    const Component& part = componentOf(type);
    const bool normalized = valueOf<bool>(type, "normalized", false);
    const auto given = valueOf<std::uint64_t>(item("bufferViews", viewIndex), "byteStride", 0);
    const std::uint64_t stride = given == 0 ? width * part.bytes : given;
    const auto first = valueOf<std::uint64_t>(from, "byteOffset", 0);
    if (count > 0) {
        constexpr std::uint64_t kMostStride = 1 << 20;
        partOf(bytes, first, std::min(stride, kMostStride) * (count - 1) + width * part.bytes,
               "a list of numbers");
    }
    numbers.reserve(count * width);
    for (std::uint64_t i = 0; i < count; ++i) {
        for (std::size_t k = 0; k < width; ++k) {
            const double number = part.number(bytes, first + i * stride + k * part.bytes);
            numbers.push_back(normalized ? std::max(number / part.most, -1.0) : number);
        }
    }
}

void GltfFile::replaceSparse(const Json& accessor, std::size_t width,
                             std::vector<double>& numbers) const {
    const auto sparse = accessor.find("sparse");
    if (sparse == accessor.end()) {
        return;
    }
    const auto count = valueOf<std::uint64_t>(*sparse, "count", 0);
    std::vector<double> indices;
    std::vector<double> values;
    if (!sparse->contains("indices") || !sparse->contains("values")) {
        throw InputError("a sparse list of it lacks its numbers");
    }
    addNumbers((*sparse)["indices"], (*sparse)["indices"], 1, count, indices);
    addNumbers((*sparse)["values"], accessor, width, count, values);
    for (std::size_t i = 0; i < indices.size(); ++i) {
        const auto at = static_cast<std::size_t>(std::max(indices[i], 0.0));
        if (at >= numbers.size() / width) {
            throw InputError("a sparse list of it names an item that is not there");
        }
        std::copy_n(values.begin() + std::ptrdiff_t(i * width), width,
                    numbers.begin() + std::ptrdiff_t(at * width));
    }
}

}  // namespace kerf::app
