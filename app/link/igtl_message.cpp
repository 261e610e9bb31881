#include "app/link/igtl_message.h"

#include <spdlog/fmt/fmt.h>

#include <bit>

#include "app/files/io/errors.h"

// By the published format (github.com/openigtlink/OpenIGTLink, Documents/Protocol). Its library is
// not used: it trusts counts within a message, and its sockets can't be told on which address to
// listen.
namespace kerf::app {

namespace {

constexpr std::size_t kHeaderBytes = 58;
constexpr std::size_t kTypeBytes = 12;
constexpr std::size_t kNameBytes = 20;
constexpr std::size_t kExtendedBytes = 12;   // at least, from header version 2 on
constexpr std::size_t kMostBody = 1u << 16;  // that is read; poses and texts are shorter
constexpr std::size_t kToolBytes = 50;       // of one tool of a QTDATA
constexpr std::uint64_t kAscii = 3;          // as MIBenum
constexpr std::uint64_t kNewton = std::uint64_t{0x0B} << 54 | std::uint64_t{1} << 50;
constexpr double kFarthest = 1e9;  // of a tool [mm]

/// Appends the lowest bytes of a number, the highest of them first.
void put(std::string& bytes, std::uint64_t number, int count) {
    while (count-- > 0) {
        bytes += static_cast<char>(number >> 8 * count & 0xFF);
    }
}

void put(std::string& bytes, const Vec3& vector) {
    for (const double x : vector) {
        put(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)), 4);
    }
}

/// Numbers, each with its count of bytes.
std::string numbers(std::initializer_list<std::pair<std::uint64_t, int>> fields) {
    std::string bytes;
    std::ranges::for_each(fields,
                          [&](const auto& field) { put(bytes, field.first, field.second); });
    return bytes;
}

/// A name of fixed length, padded with zeros.
std::string padded(std::string name, std::size_t length) {
    name.resize(length, '\0');
    return name;
}

/// Of as many of these bytes as there are.
std::uint64_t numberAt(std::string_view bytes, std::size_t at, std::size_t count) {
    std::uint64_t number = 0;
    for (const char byte : bytes.substr(std::min(at, bytes.size()), count)) {
        number = number << 8 | static_cast<unsigned char>(byte);
    }
    return number;
}

double floatAt(std::string_view bytes, std::size_t at) {
    return std::bit_cast<float>(static_cast<std::uint32_t>(numberAt(bytes, at, 4)));
}

Vec3 vectorAt(std::string_view bytes, std::size_t at) {
    return {floatAt(bytes, at), floatAt(bytes, at + 4), floatAt(bytes, at + 8)};
}

std::string nameAt(std::string_view bytes, std::size_t at, std::size_t length) {
    const std::string_view name = bytes.substr(at, length);
    return std::string(name.substr(0, name.find('\0')));
}

/// The CRC of ECMA-182: 64 bits, highest first, from 0.
std::uint64_t checksumOf(std::string_view bytes) {
    static constexpr auto kTable = [] {
        std::array<std::uint64_t, 256> table{};
        for (std::uint64_t i = 0; i < table.size(); ++i) {
            table[i] = i << 56;
            for (int bit = 0; bit < 8; ++bit) {
                table[i] = table[i] << 1 ^ (table[i] >> 63 != 0 ? 0x42F0E1EBA9EA3693u : 0u);
            }
        }
        return table;
    }();
    std::uint64_t sum = 0;
    for (const char byte : bytes) {
        sum = kTable[sum >> 56 ^ static_cast<unsigned char>(byte)] ^ sum << 8;
    }
    return sum;
}

void require(bool holds, const std::string& sentence) {
    if (!holds) {
        throw InputError(sentence);
    }
}

/// A body without extended header and metadata.
std::string contentOf(std::uint64_t version, const std::string& body) {
    if (version == 1) {
        return body;
    }
    const std::size_t extended = numberAt(body, 0, 2);
    const std::size_t metadata = numberAt(body, 2, 2) + numberAt(body, 4, 4);
    require(body.size() >= kExtendedBytes && extended >= kExtendedBytes &&
                extended + metadata <= body.size(),
            "its extended header and metadata are longer than the message.");
    return body.substr(extended, body.size() - extended - metadata);
}

IgtlPose soundPose(const Vec3& position, const Vec3& zAxis) {
    require(position.norm() <= kFarthest, "its position is not finite, or too far away.");
    require(zAxis.norm() > 0.5 && zAxis.norm() < 2, "its orientation is none.");
    return {position, zAxis.normalized()};
}

/// A position and, of 6 or 7 numbers, a quaternion x, y, z, w with or without its last one.
IgtlPose poseOf(std::string_view bytes) {
    const Vec3 xyz = bytes.size() > 12 ? vectorAt(bytes, 12) : Vec3(0, 0, 0);
    const double w =
        bytes.size() > 24 ? floatAt(bytes, 24) : std::sqrt(std::max(0.0, 1 - xyz.squaredNorm()));
    return soundPose(vectorAt(bytes, 0),
                     Eigen::Quaterniond(w, xyz.x(), xyz.y(), xyz.z()).normalized() * Vec3::UnitZ());
}

void requireSize(const IgtlMessage& message, bool fits) {
    require(fits, fmt::format("a {} can't have {} bytes.", message.type, message.content.size()));
}

}  // namespace

std::string packIgtl(const IgtlMessage& message) {
    const std::string& content = message.content;
    return numbers({{1, 2}}) + padded(message.type, kTypeBytes) +
           padded(message.device, kNameBytes) +
           numbers({{0, 8}, {content.size(), 8}, {checksumOf(content), 8}}) + content;
}

std::optional<IgtlMessage> IgtlReader::next() {
    if (bytes_.size() < kHeaderBytes) {
        return std::nullopt;
    }
    const std::uint64_t version = numberAt(bytes_, 0, 2);
    const std::uint64_t size = numberAt(bytes_, 42, 8);
    require(version >= 1 && version <= 3, "this is no message of OpenIGTLink 1 to 3.");
    require(size <= kMostBody, fmt::format("its message has {} bytes, more than the {} that are "
                                           "read.",
                                           size, kMostBody));
    if (bytes_.size() < kHeaderBytes + size) {
        return std::nullopt;
    }
    const std::string body = bytes_.substr(kHeaderBytes, size);
    require(checksumOf(body) == numberAt(bytes_, 50, 8),
            "a checksum is not that of the message's bytes.");
    IgtlMessage message{nameAt(bytes_, 2, kTypeBytes), nameAt(bytes_, 14, kNameBytes),
                        contentOf(version, body)};
    bytes_.erase(0, kHeaderBytes + size);
    return message;
}

std::optional<IgtlPose> poseIn(const IgtlMessage& message, std::string_view tool) {
    const std::string_view content = message.content;
    if (message.type == "QTDATA") {
        requireSize(message, content.size() % kToolBytes == 0);
        for (std::size_t at = 0; at < content.size(); at += kToolBytes) {
            if (nameAt(content, at, kNameBytes) == tool) {
                return poseOf(content.substr(at + kNameBytes + 2, 28));
            }
        }
    } else if (message.type == "TRANSFORM" && message.device == tool) {
        requireSize(message, content.size() == 48);  // columns: x, y, z, position
        return soundPose(vectorAt(content, 36), vectorAt(content, 24));
    } else if (message.type == "POSITION" && message.device == tool) {
        requireSize(message, content.size() == 12 || content.size() == 24 || content.size() == 28);
        return poseOf(content);
    }
    return std::nullopt;
}

std::optional<std::string> textIn(const IgtlMessage& message) {
    if (message.type != "STRING") {
        return std::nullopt;
    }
    requireSize(message, message.content.size() == 4 + numberAt(message.content, 2, 2));
    return message.content.substr(4);
}

std::string transformOf(const IgtlPose& pose) {
    const Eigen::Matrix3d axes =
        Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), pose.zAxis).toRotationMatrix();
    std::string content;
    for (const Vec3& column : {Vec3(axes.col(0)), Vec3(axes.col(1)), pose.zAxis, pose.position}) {
        put(content, column);
    }
    return content;
}

std::string polyDataOf(std::span<const Vec3> points, std::span<const Triangle> triangles) {
    // Of four kinds of cells how many there are, in how many bytes; at last no attributes.
    std::string content = numbers(
        {{points.size(), 4}, {0, 16}, {triangles.size(), 4}, {16 * triangles.size(), 4}, {0, 12}});
    content.reserve(content.size() + 12 * points.size() + 16 * triangles.size());
    for (const Vec3& point : points) {
        put(content, point);
    }
    for (const Triangle& triangle : triangles) {
        put(content, 3, 4);
        std::ranges::for_each(triangle, [&](int corner) { put(content, corner, 4); });
    }
    return content;
}

std::string sensorOf(const Vec3& force) {
    const auto bits = [&](int i) { return std::bit_cast<std::uint64_t>(force[i]); };
    return numbers({{3, 1}, {0, 1}, {kNewton, 8}, {bits(0), 8}, {bits(1), 8}, {bits(2), 8}});
}

std::string stringOf(const std::string& text) {
    const std::string kept = text.substr(0, 0xFFFF);
    return numbers({{kAscii, 2}, {kept.size(), 2}}) + kept;
}

std::string statusOf(const std::string& text) {
    return numbers({{1, 2}, {0, 8}}) + padded("OK", kNameBytes) + text + '\0';
}

}  // namespace kerf::app
