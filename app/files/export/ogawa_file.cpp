#include "app/files/export/ogawa_file.h"

#include <nettle/md5.h>
#include <spdlog/fmt/fmt.h>

#include <bit>

namespace kerf::app {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they lie");

constexpr std::uint64_t kNoData = std::uint64_t{1} << 63;  // the mark of data among places
constexpr std::uint64_t kNoGroup = 0;

// Parts of the word that a property's header begins with, beside those of its type.
constexpr unsigned kWideCounts = 2 << 2;  // of 32 bits
constexpr unsigned kTimed = 1 << 8;
constexpr unsigned kConstant = 3 << 10;  // in size and value
constexpr unsigned kOwnMetadata = 0xFF << 20;

constexpr std::int32_t kFormatVersion = 0;
constexpr std::int32_t kLibraryVersion = 10805;  // of an Alembic with this format: 1.8.5
constexpr std::string_view kWriter = "_ai_AlembicVersion=Alembic 1.8.5;_ai_Application=Kerf";
constexpr std::size_t kOurTimes = 1;  // of the list of time samplings
constexpr double kEachTimeItsOwn = std::numeric_limits<double>::max() / 32;

/// A count, as headers have it.
std::string word(std::size_t count) {
    return rawBytes(static_cast<std::uint32_t>(count));
}

std::string sized(std::string_view text) {
    return word(text.size()).append(text);
}

/// `done`: nothing comes any more.
std::string fileHeader(bool done, std::uint64_t root) {
    return std::string("Ogawa") + (done ? '\xFF' : '\0') + std::string("\0\1", 2) + rawBytes(root);
}

/// The list of ways in which samples have times: one that is always there, and ours.
std::string timeSamplings(std::span<const double> times) {
    const double interval = times.size() > 1 ? times[1] - times[0] : 1;
    bool even = true;
    for (std::size_t i = 0; i < times.size(); ++i) {
        even = even && std::abs(times[i] - times[0] - double(i) * interval) < 1e-6 * interval;
    }
    const auto told = times.first(even ? 1 : times.size());
    return word(1) + rawBytes(1.0) + word(1) + rawBytes(0.0) + word(times.size()) +
           rawBytes(even ? interval : kEachTimeItsOwn) + word(told.size()) +
           std::string(rawBytesOf(told));
}

}  // namespace

ContentDigest digestOf(std::string_view bytes) {
    static_assert(sizeof(ContentDigest) == MD5_DIGEST_SIZE);
    ContentDigest digest;
    md5_ctx context;
    md5_init(&context);
    md5_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    md5_digest(&context, digest.size(), digest.data());
    return digest;
}

OgawaFile::OgawaFile(const std::filesystem::path& file) : file_(file) {
    const std::string header = fileHeader(false, kNoGroup);
    file_.write(header);
    end_ = header.size();
}

std::uint64_t OgawaFile::add(std::string_view bytes, std::string_view head) {
    if (bytes.empty()) {
        return kNoData;
    }
    const std::uint64_t size = head.size() + bytes.size();
    file_.write(rawBytes(size));
    file_.write(head);
    file_.write(bytes);
    return std::exchange(end_, end_ + sizeof size + size) | kNoData;
}

std::uint64_t OgawaFile::addGroup(std::span<const std::uint64_t> places) {
    const std::uint64_t count = places.size();
    file_.write(rawBytes(count));
    file_.write(rawBytesOf(places));
    return std::exchange(end_, end_ + sizeof count + places.size_bytes());
}

void OgawaFile::put(Property& property, std::string_view bytes) {
    const ContentDigest now = digestOf(bytes);
    const bool isNew = property.samples.empty() || now != property.digest;
    property.samples.push_back(isNew ? add(bytes, rawBytesOf(now)) : property.samples.back());
    property.digest = now;
}

OgawaMember OgawaFile::close(const Property& property) {
    const std::vector<std::uint64_t>& samples = property.samples;
    const bool constant = std::ranges::count(samples, samples[0]) == std::ssize(samples);
    std::vector<std::uint64_t> places;
    for (const std::uint64_t sample : std::span(samples).first(constant ? 1 : samples.size())) {
        places.push_back(sample);
        if ((property.type & ogawa::kArray) != 0) {
            places.push_back(kNoData);  // of dimensions: there is one
        }
    }
    return {addGroup(places), rawBytes(property.type | kWideCounts | kTimed | kOwnMetadata |
                                       (constant ? kConstant : 0)) +
                                  word(samples.size()) + word(kOurTimes) + sized(property.name) +
                                  sized(property.metadata)};
}

OgawaMember OgawaFile::compound(std::string_view name, std::string_view metadata,
                                std::span<const OgawaMember> properties) {
    std::vector<std::uint64_t> places;
    std::string headers;
    for (const OgawaMember& property : properties) {
        places.push_back(property.place);
        headers += property.header;
    }
    places.push_back(add(headers));
    return {addGroup(places), rawBytes(kWideCounts | kOwnMetadata) + sized(name) + sized(metadata)};
}

std::uint64_t OgawaFile::addObject(std::uint64_t properties, std::span<const OgawaMember> children,
                                   const ContentDigest& digest) {
    std::vector<std::uint64_t> places{properties};
    std::string headers;
    for (const OgawaMember& child : children) {
        places.push_back(child.place);
        headers += child.header;
    }
    // One digest of the properties, one of the children.
    places.push_back(add(headers.append(rawBytesOf(digest)).append(rawBytesOf(digest))));
    return addGroup(places);
}

OgawaMember OgawaFile::object(std::string_view name, const Schema& schema,
                              std::span<const OgawaMember> properties,
                              std::span<const OgawaMember> children, const ContentDigest& digest) {
    const OgawaMember inside =
        compound(schema.property,
                 fmt::format("schema={}{}", schema.name,
                             schema.isGeometry ? ";schemaBaseType=AbcGeom_GeomBase_v1" : ""),
                 properties);
    const std::uint64_t all = compound("", "", {&inside, 1}).place;
    return {
        addObject(all, children, digest),
        sized(name) + '\xFF' +
            sized(fmt::format("schema={0};schemaObjTitle={0}:{1}", schema.name, schema.property))};
}

void OgawaFile::finish(const OgawaMember& object, std::span<const double> times,
                       const ContentDigest& digest) {
    const std::array root{add(rawBytes(kFormatVersion)),
                          add(rawBytes(kLibraryVersion)),
                          addObject(kNoGroup, {&object, 1}, digest),
                          add(kWriter),
                          add(timeSamplings(times)),
                          kNoData};
    file_.writeAtStart(fileHeader(true, addGroup(root)));
    file_.commit();
}

}  // namespace kerf::app
