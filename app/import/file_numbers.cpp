#include "app/import/file_numbers.h"

#include <bit>
#include <cstring>
#include <type_traits>

#include "app/files/io/errors.h"
#include "app/files/io/text_lines.h"

namespace kerf::app {
namespace {

constexpr std::string_view kSpace = " \t\r\n\v\f";

template <class T>
double numberIn(const char* bytes) {
    T number{};
    std::memcpy(&number, bytes, sizeof(number));
    return static_cast<double>(number);
}

template <class T>
constexpr Scalar scalar(std::string_view name, std::string_view other) {
    const double most = std::is_integral_v<T> && sizeof(T) < 4
                            ? static_cast<double>(std::numeric_limits<T>::max())
                            : 1;
    return {name, other, sizeof(T), most, numberIn<T>};
}
constexpr std::array<Scalar, 10> kScalars{
    scalar<std::int8_t>("char", "int8"),    scalar<std::uint8_t>("uchar", "uint8"),
    scalar<std::int16_t>("short", "int16"), scalar<std::uint16_t>("ushort", "uint16"),
    scalar<std::int32_t>("int", "int32"),   scalar<std::uint32_t>("uint", "uint32"),
    scalar<std::int64_t>("long", "int64"),  scalar<std::uint64_t>("ulong", "uint64"),
    scalar<float>("float", "float32"),      scalar<double>("double", "float64")};

void requireThere(bool there) {
    if (!there) {
        throw InputError("it ends too early");
    }
}

}  // namespace

const Scalar* findScalar(std::string_view name) {
    const auto found = std::ranges::find_if(
        kScalars, [&](const Scalar& s) { return name == s.name || name == s.other; });
    return found == kScalars.end() ? nullptr : &*found;
}

std::vector<double> FileNumbers::list(const Scalar& type, double count) {
    requireThere(count <= static_cast<double>(rest_.size()));  // Each is a byte at least.
    std::vector<double> numbers;
    while (static_cast<double>(numbers.size()) < count) {
        numbers.push_back(next(type));
    }
    return numbers;
}

std::vector<double> FileNumbers::all(const Scalar& type) {
    std::vector<double> numbers;
    while (encoding_ == Encoding::text ? !isAtEnd() : !rest_.empty()) {
        numbers.push_back(next(type));
    }
    return numbers;
}

std::string_view FileNumbers::word() {
    skip(std::min(rest_.find_first_not_of(kSpace), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(kSpace));
    skip(word.size());
    return word;
}

std::string_view FileNumbers::line() {
    const std::string_view line = rest_.substr(0, rest_.find_first_of("\r\n"));
    skip(line.size());
    skip(rest_.starts_with("\r\n") ? 2 : 1);
    return withoutBlanks(line);
}

bool FileNumbers::isAtEnd() const {
    constexpr std::string_view kNothing(" \t\r\n\v\f\0", 7);
    return rest_.find_first_not_of(kNothing) == std::string_view::npos;
}

std::string FileNumbers::place() const {
    const std::string_view read = bytes_.substr(0, bytes_.size() - rest_.size());
    std::size_t lines = 1;
    for (std::size_t i = 0; i < read.size(); ++i) {
        lines += read[i] == '\n' || (read[i] == '\r' && bytes_.substr(i, 2) != "\r\n") ? 1 : 0;
    }
    return encoding_ == Encoding::text ? "line " + std::to_string(lines)
                                       : "byte " + std::to_string(read.size());
}

double FileNumbers::textNumber() {
    const std::string_view text = word();
    requireThere(!text.empty());
    return numberOf(text);
}

double FileNumbers::binaryNumber(const Scalar& type) {
    requireThere(rest_.size() >= type.bytes);
    std::array<char, 8> bytes{};
    std::memcpy(bytes.data(), rest_.data(), type.bytes);
    skip(type.bytes);
    const bool swapped =
        (encoding_ == Encoding::bigEndian) == (std::endian::native == std::endian::little);
    if (swapped) {
        std::reverse(bytes.begin(), bytes.begin() + std::ptrdiff_t(type.bytes));
    }
    return type.number(bytes.data());
}

void namingPlace(const FileNumbers& numbers, const std::function<void()>& read) {
    try {
        read();
    } catch (const InputError& error) {
        throw InputError(numbers.place() + ": " + error.what());
    }
}

}  // namespace kerf::app
