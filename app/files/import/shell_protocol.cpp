#include "app/files/import/shell_protocol.h"

#include <cstring>
#include <type_traits>

namespace kerf::app {

namespace {

constexpr std::array<char, 8> kMagic{'K', 'E', 'R', 'F', 'S', 'H', 'E', 'L'};

/// In the machine's own byte order; both sides run on one machine.
struct Head {
    std::array<char, 8> magic;
    std::uint64_t failureLength;
    std::uint64_t vertices;
    std::uint64_t triangles;
};

template <typename T>
void append(std::string& bytes, const T* items, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes.append(reinterpret_cast<const char*>(items), count * sizeof(T));
}

/// Takes `count` items from the front of `bytes`, which must have them.
template <typename T>
void take(std::string_view& bytes, T* items, std::size_t count) {
    static_assert(std::is_trivially_copyable_v<T>);
    if (count > 0) {
        std::memcpy(static_cast<void*>(items), bytes.data(), count * sizeof(T));
    }
    bytes.remove_prefix(count * sizeof(T));
}

/// Whether that many bytes follow a head; counts that are absurd don't overflow.
bool fits(const Head& head, std::size_t bytes) {
    constexpr std::uint64_t kMost = std::uint64_t{1} << 32;
    return head.failureLength < kMost && head.vertices < kMost && head.triangles < kMost &&
           head.failureLength + head.vertices * sizeof(std::array<double, 3>) +
                   head.triangles * (sizeof(std::array<int, 3>) + sizeof(int)) ==
               bytes;
}

bool isValid(const ShellMessage& message) {
    const auto isFinite = [](const std::array<double, 3>& p) {
        return std::ranges::all_of(p, [](double x) { return std::isfinite(x); });
    };
    const auto isInRange = [&](const std::array<int, 3>& t) {
        return std::ranges::all_of(
            t, [&](int v) { return v >= 0 && std::size_t(v) < message.positions.size(); });
    };
    return std::ranges::all_of(message.positions, isFinite) &&
           std::ranges::all_of(message.triangles, isInRange) &&
           std::ranges::all_of(message.pieces, [&](int piece) {
               return piece >= 0 && std::size_t(piece) < message.pieces.size();
           });
}

}  // namespace

std::string encodeShells(const ShellMessage& message) {
    const Head head{kMagic, message.failure.size(), message.positions.size(),
                    message.triangles.size()};
    std::string bytes;
    append(bytes, &head, 1);
    bytes += message.failure;
    append(bytes, message.positions.data(), message.positions.size());
    append(bytes, message.triangles.data(), message.triangles.size());
    append(bytes, message.pieces.data(), message.pieces.size());
    return bytes;
}

std::optional<ShellMessage> decodeShells(std::string_view bytes) {
    Head head{};
    if (bytes.size() < sizeof(head)) {
        return std::nullopt;
    }
    take(bytes, &head, 1);
    if (head.magic != kMagic || !fits(head, bytes.size())) {
        return std::nullopt;
    }
    ShellMessage message;
    message.failure.assign(bytes.substr(0, head.failureLength));
    bytes.remove_prefix(head.failureLength);
    message.positions.resize(head.vertices);
    message.triangles.resize(head.triangles);
    message.pieces.resize(head.triangles);
    take(bytes, message.positions.data(), message.positions.size());
    take(bytes, message.triangles.data(), message.triangles.size());
    take(bytes, message.pieces.data(), message.pieces.size());
    return isValid(message) ? std::optional(std::move(message)) : std::nullopt;
}

}  // namespace kerf::app
