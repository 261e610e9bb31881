#include "app/cli/option_checks.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <thread>

#include "app/files/io/errors.h"
#include "app/session/session.h"

namespace kerf::app {

namespace {

constexpr int kMostJobs = 256;

/// "1280x720"; none where it is no size of a picture.
std::optional<PictureSize> readPictureSize(const std::string& text) {
    PictureSize size;
    const char* const end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec != std::errc() || width.ptr == end || *width.ptr != 'x') {
        return std::nullopt;
    }
    const auto height = std::from_chars(width.ptr + 1, end, size.height);
    const auto fits = [](int side) { return side >= 1 && side <= kMaxPictureSize; };
    const bool valid = height.ec == std::errc() && height.ptr == end;
    return valid && fits(size.width) && fits(size.height) ? std::optional(size) : std::nullopt;
}

std::string refuseNoSize(const std::string& text) {
    return readPictureSize(text) ? ""
                                 : "'" + text + "' is no size as 1280x720, each side 1 to " +
                                       std::to_string(kMaxPictureSize);
}

}  // namespace

std::string refuseEmpty(const std::string& text) {
    return text.empty() ? "the name is empty" : "";
}

std::string refuseNoLength(const std::string& text) {
    const std::optional<double> length = readNumber(text);
    return length && std::isfinite(*length) && *length > 0
               ? ""
               : "'" + text + "' is no length above zero, such as 0.02";
}

void refuseFileAsFolder(const std::filesystem::path& out) {
    if (std::filesystem::is_regular_file(out)) {
        throw InputError(out.string() + ": --out is a file; name a folder.");
    }
}

std::optional<double> readNumber(const std::string& text) {
    double value = 0;
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, value);
    return read.ec == std::errc() && read.ptr == end ? std::optional(value) : std::nullopt;
}

CLI::Option* addOut(CLI::App& verb, std::filesystem::path& out, const char* about) {
    return verb.add_option("--out", out, about)->check(refuseEmpty)->type_name("DIR");
}

CLI::Option* addPictureSize(CLI::App& verb, std::function<void(const PictureSize&)> take,
                            const char* about) {
    const auto read = [take = std::move(take)](const std::string& text) {
        take(*readPictureSize(text));
    };
    return verb.add_option_function<std::string>("--size", read, about)
        ->type_name("WxH")
        ->check(refuseNoSize);
}

void addJobs(CLI::App& verb, int& jobs) {
    jobs = static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
    verb.add_option("--jobs", jobs, "Parallel runs; one per core by default")
        ->check(CLI::Range(1, kMostJobs))
        ->type_name("N");
}

}  // namespace kerf::app
