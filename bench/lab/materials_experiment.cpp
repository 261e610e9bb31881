#include "bench/lab/materials_experiment.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "app/cli/replay/replay.h"
#include "app/files/import/model_source.h"
#include "app/files/io/exit_codes.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/files/jobs/progress_line.h"
#include "app/session/material.h"
#include "gpu/context.h"
#include "gpu/data_path.h"
#include "render/scene/image.h"
#include "ui/plots/picture_strip.h"

namespace kerf::app {

namespace {

constexpr const char* kSession = "assets/sessions/material.kerf.json";
constexpr const char* kStripFile = "strip.png";
constexpr const char* kSheetFile = "materials.png";

/// "pulled open" of "pulled-open.png".
std::string captionOf(const std::string& file) {
    std::string caption = std::filesystem::path(file).stem().string();
    std::ranges::replace(caption, '-', ' ');
    return caption;
}

render::Image stripOf(ui::PicturePainter& painter, const Material& material,
                      const std::vector<std::string>& files, const std::filesystem::path& folder) {
    std::vector<ui::StripPicture> pictures;
    pictures.reserve(files.size());
    for (const std::string& file : files) {
        pictures.push_back({readPicture(folder / file), captionOf(file)});
    }
    std::string title = material.label;
    for (const char* name : {"youngs_modulus", "toughness"}) {
        const auto property = std::ranges::find_if(
            materialProperties(),
            [&](const MaterialProperty& p) { return std::string_view(p.name) == name; });
        title.append(", ").append(describeProperty(material, *property));
    }
    return ui::drawStrip(painter, title, pictures);
}

/// One below the other.
render::Image sheetOf(const std::vector<render::Image>& strips) {
    render::Image sheet;
    for (const render::Image& strip : strips) {
        sheet.width = std::max(sheet.width, strip.width);
        sheet.height += strip.height;
    }
    constexpr std::size_t kBytesPerPixel = 4;
    sheet.pixels.assign(kBytesPerPixel * static_cast<std::size_t>(sheet.width) *
                            static_cast<std::size_t>(sheet.height),
                        255);
    int top = 0;
    for (const render::Image& strip : strips) {
        render::paste(sheet, strip, 0, top);
        top += strip.height;
    }
    return sheet;
}

Session sessionWith(const Material& material) {
    Session session = readSession(gpu::dataPath(kSession));
    applyMaterial(session, material);
    return session;
}

}  // namespace

int runMaterialsExperiment(const std::filesystem::path& folder, bool json, std::ostream& out,
                           std::ostream& errors) {
    const gpu::EglContext context;
    OutputFolder own(folder / kMaterialsExperiment);
    own.remove(kSheetFile);
    ui::PicturePainter painter(ui::Theme::light);
    nlohmann::ordered_json summaries;
    std::vector<render::Image> strips;
    std::string failure;
    for (const Material& material : builtinMaterials()) {
        const Session session = sessionWith(material);
        const std::filesystem::path place = folder / kMaterialsExperiment / material.name;
        ProgressLine line(material.name + ": ");
        const RunSummary summary =
            replaySession(session, loadSessionModel(session), place,
                          {[&line](int done, int total) { line.show(done, total); }, {}})
                .summary;
        if (failure.empty() && !summary.failures.empty()) {
            failure = material.name + ": " + summary.failures.front();
        }
        summaries["materials"][material.name] = toJson(summary);
        strips.push_back(stripOf(painter, material, pictureFiles(session), place));
        writePicture(strips.back(), place / kStripFile);
    }
    const std::filesystem::path sheet = own.pathOf(kSheetFile);
    writePicture(sheetOf(strips), sheet);
    out << (json ? summaries.dump() : "written to " + sheet.string()) << "\n";
    if (!failure.empty()) {
        errors << failure << "\n";
        return kExitCheckFailed;
    }
    return kExitDone;
}

}  // namespace kerf::app
