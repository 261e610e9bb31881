#include "app/files/file_io.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <fstream>

#include "app/files/model_source.h"

namespace kerf::app {

namespace {

constexpr std::size_t kWriteBlock = 1 << 16;

std::filesystem::path hiddenNameBeside(const std::filesystem::path& file) {
    const std::string name =
        "." + file.filename().string() + "." + std::to_string(::getpid()) + ".part";
    return file.parent_path() / name;
}

void requireReadableSize(const std::filesystem::path& file, std::uintmax_t limit) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (status.type() == std::filesystem::file_type::none) {
        throw InputError(file.string() + ": it can't be read (" + error.message() + ").");
    }
    if (!std::filesystem::exists(status)) {
        throw InputError(file.string() + ": there is no such file; check the name.");
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw InputError(file.string() + ": this is not a regular file; name one to read.");
    }
    const auto size = std::filesystem::file_size(file, error);
    if (!error && size > limit) {
        throw InputError(file.string() + ": " + std::to_string(size) +
                         " bytes are more than the limit of " + std::to_string(limit) + ".");
    }
}

/// The file that a result takes the place of. A link stays, and what it leads to is replaced; a
/// device or a pipe must not be.
std::filesystem::path replaceable(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status)) {
        return file;
    }
    if (!std::filesystem::is_regular_file(status)) {
        throw OutputError(file.string() +
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

std::string readInputFile(const std::filesystem::path& file, std::uintmax_t limit) {
    requireReadableSize(file, limit);
    std::ifstream stream(file, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(stream)), std::istreambuf_iterator<char>());
    if (!stream) {
        throw InputError(file.string() + ": it could not be read; check its permissions.");
    }
    return bytes;
}

AtomicFile::AtomicFile(const std::filesystem::path& file)
    : file_(replaceable(file)),
      hidden_(hiddenNameBeside(file_)),
      out_(hidden_, O_WRONLY | O_CREAT | O_TRUNC, 0666, file_) {}

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

void writeOutputFile(const std::filesystem::path& file, std::string_view bytes) {
    AtomicFile output(file);
    output.write(bytes);
    output.commit();
}

render::Image readPicture(const std::filesystem::path& file) {
    try {
        return render::readPng(file);
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
        throw OutputError(file.string() + ": " + error.what());
    }
}

std::string formatNumber(double value) {
    return shortestText(value);
}
std::string formatNumber(float value) {
    return shortestText(value);
}

}  // namespace kerf::app
