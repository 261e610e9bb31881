#include "app/editor/storage/file_preview.h"

#include <cstring>
#include <fstream>
#include <sstream>

#include "app/files/import/model_source.h"
#include "app/session/material.h"
#include "app/session/session.h"
#include "sim/base/text.h"
#include "sim/mesh/triangle_soup.h"
#include "sim/repair/soup_inspection.h"
#include "ui/state/file_dialog_state.h"

namespace kerf::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t kReadWhole = 40'000'000;  // models up to this size are read for a preview
constexpr std::size_t kMostHead = 1 << 16;

/// A head of text may have no end.
std::string beginningOf(const fs::path& file) {
    std::string bytes(kMostHead, '\0');
    std::ifstream in(file, std::ios::binary);
    in.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(in.gcount()));
    return bytes;
}

/// The number of triangles as the header of a PLY file has it.
std::optional<std::uint64_t> facesOfPly(const fs::path& file) {
    std::istringstream in(beginningOf(file));
    std::string line;
    for (int n = 0; n < 100 && std::getline(in, line) && !line.starts_with("end_header"); ++n) {
        std::uint64_t count = 0;
        std::istringstream words(line);
        std::string element;
        std::string kind;
        if (words >> element >> kind >> count && element == "element" && kind == "face") {
            return count;
        }
    }
    return std::nullopt;
}

/// The number of triangles of a binary STL file, which has a count that fits its size.
std::optional<std::uint64_t> facesOfStl(const fs::path& file) {
    constexpr std::size_t kHeader = 80;
    constexpr std::uint64_t kFace = 50;  // [bytes]
    std::array<char, kHeader + 4> bytes{};
    std::ifstream in(file, std::ios::binary);
    if (!in.read(bytes.data(), bytes.size())) {
        return std::nullopt;
    }
    std::uint32_t count = 0;
    std::memcpy(&count, bytes.data() + kHeader, sizeof count);
    const bool fits = bytes.size() + kFace * count == fs::file_size(file);
    return fits ? std::optional<std::uint64_t>(count) : std::nullopt;
}

std::optional<std::uint64_t> facesInHeader(const fs::path& file) {
    const std::string extension = lowerCase(file.extension().string());
    if (extension == ".ply") {
        return facesOfPly(file);
    }
    return extension == ".stl" ? facesOfStl(file) : std::nullopt;
}

void describeSession(const fs::path& file, std::vector<std::string>& lines) {
    const Session session = readSession(file);
    lines.push_back("Session of " + session.model.name());
    lines.push_back(counted(session.steps, "step", "steps") + ", " +
                    counted(session.events.size(), "event", "events"));
}

void describeMaterial(const fs::path& file, std::vector<std::string>& lines) {
    const Material material = readMaterial(file);
    lines.push_back("Material: " + printable(material.label));
    for (const MaterialProperty& property : materialProperties()) {
        if (std::string line = describeProperty(material, property); !line.empty()) {
            lines.push_back(std::move(line));
        }
    }
}

void describeModel(const fs::path& file, WorkProgress& progress, std::vector<std::string>& lines) {
    const std::optional<std::uint64_t> faces = facesInHeader(file);
    if (fs::file_size(file) > kReadWhole) {
        lines.push_back(faces ? counted(*faces, "face", "faces") : "Too large for a preview");
        return;
    }
    const MeshReport report = importModel(file, {}, &progress).report;
    lines.push_back(counted(report.triangles, "triangle", "triangles") + ", " +
                    counted(report.vertices, "vertex", "vertices"));
    if (report.cuttable) {
        lines.push_back("Closed: " + counted(report.pieces, "piece", "pieces"));
    } else {
        lines.push_back(report.problem.substr(0, report.problem.find(':')));
    }
}

std::string formatName(const fs::path& file) {
    std::string name = file.extension().string();
    std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::toupper(c); });
    return name.empty() ? "File" : name.substr(1);
}

}  // namespace

std::vector<std::string> describeFile(const fs::path& file, WorkProgress& progress) {
    std::vector<std::string> lines{file.filename().string()};
    std::error_code error;
    if (!fs::is_regular_file(file, error)) {
        lines.emplace_back("This file can't be read");
        return lines;
    }
    try {
        lines.push_back(formatName(file) + ", " + ui::sizeText(fs::file_size(file)));
        if (isMaterialFile(file)) {
            describeMaterial(file, lines);
        } else if (lowerCase(file.extension().string()) == ".json") {
            describeSession(file, lines);
        } else {
            describeModel(file, progress, lines);
        }
    } catch (const std::exception& problem) {
        lines.emplace_back(problem.what());
    }
    return lines;
}

void FilePreview::select(const fs::path& file) {
    job_.forgetEnded();
    if (file == file_) {
        return;
    }
    file_ = file;
    lines_.clear();
    changed_ = true;
    job_.cancel();
    if (!file.empty()) {
        job_.start(std::make_unique<Job>(
            [file](WorkProgress& progress) { return describeFile(file, progress); }));
    }
}

bool FilePreview::advance() {
    if (working() && job_.now()->done()) {
        lines_ = job_.take()->take();
        changed_ = true;
    }
    return std::exchange(changed_, false);
}

}  // namespace kerf::app
