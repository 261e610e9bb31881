#pragma once

#include "app/files/io/file_io.h"

namespace kerf::app {

/// A number as it lies in memory.
template <class T>
std::string rawBytes(const T& value) {
    return {reinterpret_cast<const char*>(&value), sizeof value};
}
/// A view of many numbers, or vectors, as they lie in memory.
template <class Range>
std::string_view rawBytesOf(const Range& values) {
    return {reinterpret_cast<const char*>(values.data()), values.size() * sizeof(*values.data())};
}

/// 128 bits that tell contents apart.
using ContentDigest = std::array<std::uint8_t, 16>;
ContentDigest digestOf(std::string_view bytes);

/// What stands in a group of an OgawaFile: its place, and its entry in the list of the members.
struct OgawaMember {
    std::uint64_t place = 0;
    std::string header;
};

/// The type of a property: the word of its header, without what depends on its values.
namespace ogawa {
constexpr unsigned kScalar = 1;  ///< one value a sample
constexpr unsigned kArray = 2;   ///< any number of them
constexpr unsigned kBool = 0 << 4;
constexpr unsigned kUint8 = 1 << 4;
constexpr unsigned kUint32 = 5 << 4;
constexpr unsigned kInt32 = 6 << 4;
constexpr unsigned kFloat32 = 10 << 4;
constexpr unsigned kFloat64 = 11 << 4;
/// How many numbers a value has.
constexpr unsigned extent(unsigned numbers) {
    return numbers << 12;
}
}  // namespace ogawa

/// Writes the container of Alembic caches, Ogawa: a tree of objects with properties, which have
/// samples over time. Samples are written as they come, what lists them comes last. The file
/// appears complete or not at all.
class OgawaFile {
  public:
    /// A property, with its samples so far.
    struct Property {
        std::string name;
        unsigned type = 0;  ///< of namespace ogawa
        std::string metadata{};
        std::vector<std::uint64_t> samples{};  ///< their places
        ContentDigest digest{};                ///< of the last one
    };
    /// What a kind of objects is called, and its compound property.
    struct Schema {
        std::string_view name;
        std::string_view property;
        bool isGeometry = true;
    };

    /// Throws OutputError, like all functions here.
    explicit OgawaFile(const std::filesystem::path& file);

    /// Writes the next sample of a property, unless it is the same as the last one.
    void put(Property& property, std::string_view bytes);

    /// Once it has all of its samples.
    OgawaMember close(const Property& property);
    OgawaMember compound(std::string_view name, std::string_view metadata,
                         std::span<const OgawaMember> properties);
    /// `digest`: of all that is in it.
    OgawaMember object(std::string_view name, const Schema& schema,
                       std::span<const OgawaMember> properties,
                       std::span<const OgawaMember> children, const ContentDigest& digest);
    /// Completes the file of one outermost object, whose samples are of these times [s].
    void finish(const OgawaMember& object, std::span<const double> times,
                const ContentDigest& digest);

  private:
    std::uint64_t add(std::string_view bytes, std::string_view head = {});
    std::uint64_t addGroup(std::span<const std::uint64_t> places);
    std::uint64_t addObject(std::uint64_t properties, std::span<const OgawaMember> children,
                            const ContentDigest& digest);

    AtomicFile file_;
    std::uint64_t end_ = 0;
};

}  // namespace kerf::app
