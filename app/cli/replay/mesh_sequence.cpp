#include "app/cli/replay/mesh_sequence.h"

#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>

#include "app/files/export/export.h"
#include "app/files/io/file_io.h"

namespace kerf::app {
namespace {

constexpr std::string_view kStep = "step-";
constexpr std::string_view kList = "sequence.";

/// Whether a sequence has files of this name, by its letters.
bool isOfSequence(const std::string& name) {
    const std::size_t dot = name.find('.');
    if (name.starts_with(kList)) {
        return name.ends_with(".series") || name.ends_with(".pvd");
    }
    return name.starts_with(kStep) && dot != std::string::npos && dot > kStep.size() &&
           name.find_first_not_of("0123456789", kStep.size()) == dot &&
           meshFormatOf(name).has_value();
}

std::string inFolder(const std::string& name) {
    return std::string(kSequenceFolder).append("/").append(name);
}

}  // namespace

MeshSequence::MeshSequence(OutputFolder& folder, const SequenceOptions& options)
    : folder_(folder), options_(options) {
    removeEarlier();
}

void MeshSequence::removeEarlier() {
    const std::filesystem::path folder = folder_.pathOf(inFolder("x")).parent_path();
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (const std::string name = entry.path().filename(); isOfSequence(name)) {
            folder_.remove(inFolder(name));
        }
    }
}

bool MeshSequence::wants(int step, int last) const {
    return step % options_.every == 0 || step == last;
}

void MeshSequence::write(int step, double time, const SurfaceMesh& mesh, const PieceMap& pieces,
                         const ExportLooks& looks, const Vec3& from) {
    const std::string file =
        fmt::format("{}{:06}{}", kStep, step, infoOf(options_.format).extension);
    folder_.write(inFolder(file), encodeMeasured(mesh, pieces, options_.format, looks, from));
    entries_.push_back({file, time});
}

void MeshSequence::finish() {
    nlohmann::ordered_json series = {{"file-series-version", "1.0"},
                                     {"files", nlohmann::ordered_json::array()}};
    std::string collection;
    for (const Entry& entry : entries_) {
        series["files"].push_back({{"name", entry.file}, {"time", entry.time}});
        collection += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n",
                                  formatNumber(entry.time), entry.file);
    }
    const std::string extension(infoOf(options_.format).extension.substr(1));
    folder_.write(inFolder(fmt::format("{}{}.series", kList, extension)), series.dump(1) + "\n");
    if (options_.format == MeshFormat::vtp) {
        folder_.write(inFolder(std::string(kList) + "pvd"),
                      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" "
                      "byte_order=\"LittleEndian\">\n<Collection>\n" +
                          collection + "</Collection>\n</VTKFile>\n");
    }
}

}  // namespace kerf::app
