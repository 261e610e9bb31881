#include "app/files/film/film_encoder.h"

#include <sys/mman.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <initializer_list>
#include <system_error>

#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr char kProgram[] = "ffmpeg";
constexpr std::size_t kKeptLog = 4096;

using Words = std::vector<std::string>;

/// How ffmpeg encodes what comes in; colours are those of displays, as television has them
/// (BT.709).
Words encodingOf(FilmFormat format) {
    const Words video{"-vf",
                      "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
                      "-colorspace",
                      "bt709",
                      "-color_trc",
                      "bt709",
                      "-color_range",
                      "tv",
                      "-color_primaries",
                      "bt709"};
    Words words;
    switch (format) {
        case FilmFormat::mp4:
            words = {"-c:v", "libx264", "-crf", "18", "-movflags", "+faststart", "-f", "mp4"};
            break;
        case FilmFormat::webm:
            words = {"-c:v",    "libvpx-vp9", "-crf",      "28", "-b:v", "0",
                     "-row-mt", "1",          "-cpu-used", "4",  "-f",   "webm"};
            break;
        case FilmFormat::gif:
            // Without loss, to look for the colours of all pictures once all have come.
            return {"-c:v", "libx264rgb", "-preset", "ultrafast", "-qp", "0", "-f", "matroska"};
    }
    words.insert(words.begin(), video.begin(), video.end());
    return words;
}

/// With "file:" in front no name is taken for an option or an address.
std::string address(const std::filesystem::path& file) {
    return "file:" + file.string();
}

Words commandLine(std::initializer_list<std::string> input, const Words& encoding,
                  const std::filesystem::path& file) {
    Words words{kProgram, "-nostdin", "-hide_banner", "-loglevel", "error"};
    words.insert(words.end(), input);
    words.insert(words.end(), {"-fflags", "+bitexact", "-flags:v", "+bitexact"});
    words.insert(words.end(), encoding.begin(), encoding.end());
    words.insert(words.end(), {"-y", address(file)});
    return words;
}

/// A film of raw pictures from standard input.
Words filming(const std::filesystem::path& file, FilmFormat format, int width, int height,
              int rate) {
    const std::string size = std::to_string(width).append("x").append(std::to_string(height));
    return commandLine({"-f", "rawvideo", "-pix_fmt", "rgba", "-video_size", size, "-framerate",
                        std::to_string(rate), "-i", "pipe:0"},
                       encodingOf(format), file);
}

/// A stream to a child's standard input. A pipe would end this program where the child has gone.
std::array<int, 2> socketPair() {
    std::array<int, 2> ends{-1, -1};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) {
        throw OutputError(std::string("There is no way to another process (") +
                          std::strerror(errno) + ").");
    }
    return ends;
}

/// The end of what the child said.
std::string logIn(int descriptor) {
    std::string text(kKeptLog, '\0');
    const off_t size = ::lseek(descriptor, 0, SEEK_END);
    const off_t from = size > off_t(kKeptLog) ? size - off_t(kKeptLog) : 0;
    const ssize_t count = ::pread(descriptor, text.data(), text.size(), from);
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    text.erase(text.find_last_not_of(" \r\n") + 1);
    return printable(text.substr(text.rfind('\n') + 1));
}

}  // namespace

std::span<const FilmFormatInfo> filmFormats() {
    // A GIF counts in hundredths of a second, of which a picture at 25 lasts four.
    static constexpr std::array kFormats{
        FilmFormatInfo{FilmFormat::mp4, ".mp4", "MP4", 30, true},
        FilmFormatInfo{FilmFormat::webm, ".webm", "WebM", 30, true},
        FilmFormatInfo{FilmFormat::gif, ".gif", "GIF", 25, false},
    };
    return kFormats;
}

const FilmFormatInfo* filmFormatOf(const std::filesystem::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    const auto found = std::ranges::find(filmFormats(), extension, &FilmFormatInfo::extension);
    return found == filmFormats().end() ? nullptr : &*found;
}

std::string filmEndings() {
    const std::span<const FilmFormatInfo> all = filmFormats();
    return joined(all.first(all.size() - 1), ", ", &FilmFormatInfo::extension)
        .append(" or ")
        .append(all.back().extension);
}

FilmEncoder::FilmEncoder(const std::filesystem::path& file, std::filesystem::path unfinished,
                         int width, int height, int rate)
    : name_(file),
      format_(filmFormatOf(file)->format),
      file_(file),
      unfinished_(std::move(unfinished)),
      log_(::memfd_create("film", MFD_CLOEXEC)),
      pictures_(socketPair()) {
    start(filming(unfinished_, format_, width, height, rate));
}

FilmEncoder::~FilmEncoder() {
    child_.reset();
    for (const std::filesystem::path& file : {unfinished_, colors(), inColors()}) {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
    }
}

std::filesystem::path FilmEncoder::colors() const {
    return std::filesystem::path(unfinished_).concat(".png");
}
std::filesystem::path FilmEncoder::inColors() const {
    return std::filesystem::path(unfinished_).concat(".gif");
}

void FilmEncoder::start(const Words& words) {
    try {
        child_.emplace(
            ChildOrder{.words = words, .input = pictures_.read.get(), .log = log_.get()});
    } catch (const std::system_error& error) {
        const bool missing = error.code() == std::errc::no_such_file_or_directory;
        throw OutputError(shownPath(name_) + ": films are made by the program ffmpeg, " +
                          (missing ? "which is not there" : error.code().message()) +
                          "; install the package ffmpeg.");
    }
    pictures_.read.close();
}

void FilmEncoder::add(const render::Image& picture) {
    std::string_view bytes(reinterpret_cast<const char*>(picture.pixels.data()),
                           picture.pixels.size());
    while (!bytes.empty()) {
        const ssize_t sent =
            ::send(pictures_.write.get(), bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno != EINTR) {
            complain();
        }
        bytes.remove_prefix(sent < 0 ? 0 : static_cast<std::size_t>(sent));
    }
}

void FilmEncoder::finish() {
    pictures_.write.close();
    requireDone();
    if (format_ == FilmFormat::gif) {
        reduceColors();
    }
    file_.writeAllOf(format_ == FilmFormat::gif ? inColors() : unfinished_);
    file_.commit();
}

/// In two goes, none of which keeps more than a few pictures.
void FilmEncoder::reduceColors() {
    start(commandLine({"-i", address(unfinished_)},
                      {"-vf", "palettegen", "-update", "1", "-f", "image2", "-c:v", "png"},
                      colors()));
    requireDone();
    start(commandLine({"-i", address(unfinished_), "-i", address(colors())},
                      {"-lavfi", "paletteuse", "-loop", "0", "-f", "gif"}, inColors()));
    requireDone();
}

/// Waits for the child.
void FilmEncoder::requireDone() {
    const ChildEnd end = child_->wait();
    child_.reset();
    if (end.exitCode != 0) {
        complain();
    }
}

void FilmEncoder::complain() {
    if (child_) {
        pictures_.write.close();
        child_->wait();
        child_.reset();
    }
    const std::string said = logIn(log_.get());
    throw OutputError(shownPath(name_) + ": ffmpeg could not make the film" +
                      (said.empty() ? "" : " (" + said + ")") +
                      "; choose another format or folder.");
}

}  // namespace kerf::app
