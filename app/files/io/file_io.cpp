#include "app/files/io/file_io.h"

#include <fcntl.h>
#include <spdlog/fmt/chrono.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include <charconv>
#include <climits>
#include <ctime>
#include <fstream>
#include <new>

#include "app/files/io/errors.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr std::size_t kWriteBlock = 1 << 16;

constexpr std::string_view kUnfinished = ".part";

/// A hidden name; what an earlier program of our number left there is removed.
std::filesystem::path unusedNameBeside(const std::filesystem::path& file) {
    const std::string name =
        fmt::format(".{}.{}{}", file.filename().string(), ::getpid(), kUnfinished);
    std::filesystem::path hidden = file.parent_path() / name;
    ::unlink(hidden.c_str());
    return hidden;
}

void requireReadableSize(const std::filesystem::path& file, std::uintmax_t limit) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::none) {
        throw InputError(shownPath(file) + ": it can't be read (" + error.message() + ").");
    }
    if (!std::filesystem::exists(status)) {
        throw InputError(shownPath(file) + ": there is no such file; check the name.");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw InputError(shownPath(file) + ": this is not a regular file; name one to read.");
    }
    const auto size = std::filesystem::file_size(file, error);
    if (!error && size > limit) {
        throw InputError(shownPath(file) + ": " + std::to_string(size) +
                         " bytes are more than the limit of " + std::to_string(limit) + ".");
    }
}

/// The file that a result takes the place of. A link stays, and what it leads to is replaced; one
/// that leads nowhere is replaced itself. A device or a pipe must not be.
std::filesystem::path replaceable(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        return file;
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw OutputError(shownPath(file) +
                          ": there is something else than a file; choose another name.");
    }
    return std::filesystem::is_symlink(file) ? std::filesystem::canonical(file) : file;
}

template <class T>
std::string shortestText(T value) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

}  // namespace

std::string problemWithPath(std::string_view path) {
    if (path.find('\0') != std::string_view::npos) {
        return "no file has a zero byte in its name.";
    }
    return path.size() < PATH_MAX
               ? ""
               : "no file has a name of more than " + std::to_string(PATH_MAX - 1) + " bytes.";
}

std::string shownPath(const std::filesystem::path& path) {
    constexpr std::size_t kMostOfEach = 200;
    const std::string text = path.string();
    return text.size() <= 2 * kMostOfEach
               ? text
               : beginningOf(text, kMostOfEach) + "..." + endOf(text, kMostOfEach);
}

bool isNameInside(std::string_view name) {
    const std::filesystem::path path = std::filesystem::path(name).lexically_normal();
    return problemWithPath(name).empty() && !path.empty() && !path.is_absolute() &&
           path.has_filename() && *path.begin() != ".." && *path.begin() != ".";
}

bool leadsInside(const std::filesystem::path& folder, const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path whole = std::filesystem::weakly_canonical(path, error);
    const auto [end, rest] =
        std::mismatch(folder.begin(), folder.end(), whole.begin(), whole.end());
    return !error && end == folder.end();
}

std::string readInputFile(const std::filesystem::path& file, std::uintmax_t limit) {
    requireReadableSize(file, limit);
    std::ifstream stream(file, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream) {
        throw InputError(shownPath(file) + ": it could not be read; check its permissions.");
    }
    return bytes;
}

// O_EXCL follows no link: whoever knows the hidden name could lay one there.
AtomicFile::AtomicFile(const std::filesystem::path& file)
    : file_(replaceable(file)),
      hidden_(unusedNameBeside(file_)),
      out_(hidden_, O_WRONLY | O_CREAT | O_EXCL, 0666, file_) {}

AtomicFile::~AtomicFile() {
    if (!committed_) {
        ::unlink(hidden_.c_str());
    }
}

void AtomicFile::write(std::string_view bytes) {
    pending_ += bytes;
    if (pending_.size() >= kWriteBlock) {
        flush();
    }
}

void AtomicFile::writeAllOf(const std::filesystem::path& file) {
    std::ifstream from(file, std::ios::binary);
    std::array<char, kWriteBlock> block{};
    while (from.read(block.data(), block.size()) || from.gcount() > 0) {
        write({block.data(), static_cast<std::size_t>(from.gcount())});
    }
    if (!from.eof() || from.bad()) {
        throw OutputError(shownPath(file_) + ": it could not be written, since " + shownPath(file) +
                          " can't be read; try it again.");
    }
}

void AtomicFile::writeAtStart(std::string_view bytes) {
    flush();
    out_.writeAtStart(bytes);
}

void AtomicFile::commit() {
    flush();
    out_.sync();
    out_.close();
    out_.rename(hidden_, file_);
    committed_ = true;
    syncFolder(file_.parent_path());
}

void AtomicFile::flush() {
    out_.write(pending_);
    pending_.clear();
}

bool isUnfinished(std::string_view hidden, std::string_view name) {
    const std::string start = fmt::format(".{}.", name);
    if (!hidden.starts_with(start) || !hidden.ends_with(kUnfinished) ||
        hidden.size() <= start.size() + kUnfinished.size()) {
        return false;
    }
    const std::string_view number =
        hidden.substr(start.size(), hidden.size() - start.size() - kUnfinished.size());
    return number.find_first_not_of("0123456789") == std::string_view::npos;
}

void writeOutputFile(const std::filesystem::path& file, std::string_view bytes) {
    AtomicFile output(file);
    output.write(bytes);
    output.commit();
}

render::Image readPicture(const std::filesystem::path& file) {
    try {
        return render::readPng(file);
    } catch (const std::bad_alloc&) {
        throw MemoryShortage(
            shownPath(file) +
            ": there is too little memory for this picture; close other programs.");
    } catch (const std::runtime_error& error) {
        throw InputError(error.what());
    }
}

void writePicture(const render::Image& picture, const std::filesystem::path& file) {
    try {
        const std::vector<std::uint8_t> bytes = render::encodePng(picture);
        writeOutputFile(file, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    } catch (const OutputError&) {
        throw;
    } catch (const std::runtime_error& error) {
        throw OutputError(shownPath(file) + ": " + error.what());
    }
}

std::string formatNumber(double value) {
    return shortestText(value);
}
std::string formatNumber(float value) {
    return shortestText(value);
}

std::string plainName(const std::string& name) {
    constexpr std::size_t kMost = 200;
    std::string plain = beginningOf(name.substr(name.find_last_of('/') + 1), kMost);
    std::ranges::replace_if(
        plain, [](unsigned char c) { return c < ' ' || c == 0x7f; }, '_');
    return plain.empty() || plain == "." || plain == ".." ? "_" + plain : plain;
}

std::filesystem::path numberedFile(const std::filesystem::path& folder, const std::string& stem,
                                   const std::string& ending) {
    std::filesystem::path file = folder / (stem + ending);
    std::error_code unknown;  // a folder that can't be looked into: writing will say so
    for (int n = 2; std::filesystem::exists(file, unknown); ++n) {
        std::string numbered = stem;
        file = folder / numbered.append("-").append(std::to_string(n)).append(ending);
    }
    return std::filesystem::absolute(file).lexically_normal();
}

std::filesystem::path freeFile(const std::filesystem::path& folder, const std::string& name,
                               const std::string& ending) {
    const std::tm now = fmt::localtime(std::time(nullptr));
    return numberedFile(folder, fmt::format("{}-{:%Y%m%d-%H%M%S}", plainName(name), now), ending);
}

}  // namespace kerf::app
