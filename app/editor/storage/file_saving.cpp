#include "app/editor/storage/file_saving.h"

#include <utility>

#include "app/editor/storage/film_making.h"
#include "app/files/io/file_io.h"
#include "app/regression/test_maker.h"
#include "sim/base/text.h"
#include "sim/run/start/prepared_body.h"
#include "sim/run/stored_moment.h"

namespace kerf::app {
namespace {

/// The data that the thread works on: copies, so that the body may go on.
struct ExportInput {
    ExportTarget target;
    SurfaceMesh uncut;
    OwnLooks own;  ///< of it
    render::BodyLook look;
    SurfaceMesh mesh;
    ExportFrame place;
};

std::string exportBody(const ExportInput& input, WorkProgress& progress) {
    progress.enter("Finding pieces");
    const PieceMap pieces = findPieces(input.mesh);
    progress.enter("Mapping textures");
    const ExportLooks looks{carried(input.own, input.uncut, input.mesh), input.look};
    progress.enter("Encoding");
    const std::vector<ExportedFile> files =
        encodeExport(input.target, input.mesh, pieces, looks, input.place);
    progress.enter("Writing");
    for (const ExportedFile& file : files) {
        writeOutputFile(file.file, file.bytes);
    }
    const std::string& first = files.front().file.string();
    return files.size() == 1 ? "Exported " + first
                             : "Exported " + first + " and " +
                                   counted(files.size() - 1, "more file", "more files");
}

/// So that the session reopens at once.
void keepEnd(const std::filesystem::path& file, const SavedEnd& end, const StoredEnds& ends) {
    if (std::optional<std::vector<std::byte>> moment = bytesOf(end.moment)) {
        ends.keep(file, {*std::move(moment), end.hash, end.start.step, end.start.time});
    }
}

}  // namespace

std::unique_ptr<FileSaving> startExport(ExportTarget target, const Document& document,
                                        Simulation& simulation, const render::BodyLook& look) {
    const bool hasLooks = !document.looks.skin.empty();
    const std::string title = "Exporting " + target.file.filename().string();
    auto input = std::make_shared<const ExportInput>(
        ExportInput{std::move(target),
                    hasLooks ? simulation.uncut()->mesh : SurfaceMesh{},
                    document.looks,
                    look,
                    simulation.mesh(),
                    {simulation.placement(), document.session.origin}});
    return std::make_unique<FileSaving>(
        title, [input](WorkProgress& progress) { return exportBody(*input, progress); });
}

std::unique_ptr<FileSaving> startFilm(const std::filesystem::path& file, const ui::FilmLook& look,
                                      SavedSession saved) {
    return std::make_unique<FileSaving>(
        "Exporting video " + file.filename().string(),
        [file, look, saved = std::move(saved)](WorkProgress& progress) {
            filmSession(saved.session, file, look, progress);
            return "Exported video " + file.string() +
                   (saved.remark.empty() ? "" : ". " + saved.remark);
        });
}

std::unique_ptr<FileSaving> startSavingTest(const std::filesystem::path& file, SavedSession saved) {
    return std::make_unique<FileSaving>(
        "Saving test " + file.filename().string(),
        [file, saved = std::move(saved)](WorkProgress& progress) {
            makeTest(saved.session, file, progress);
            const std::size_t pictures = pictureFiles(saved.session).size();
            return "Saved test " + file.string() + " with " +
                   (pictures == 0 ? "no picture" : counted(pictures, "picture", "pictures")) +
                   (saved.remark.empty() ? "" : ". " + saved.remark);
        });
}

std::unique_ptr<FileSaving> startSaving(const std::filesystem::path& file, SavedSession saved,
                                        std::optional<SavedEnd> end, const StoredEnds& ends) {
    return std::make_unique<FileSaving>(
        "Saving " + file.filename().string(),
        [file, saved = std::move(saved), end = std::move(end), ends](WorkProgress& progress) {
            progress.enter("Writing");
            writeOutputFile(file, formatSession(saved.session, file.parent_path()));
            if (end) {
                keepEnd(file, *end, ends);
            }
            return "Saved " + file.string() + (saved.remark.empty() ? "" : ". " + saved.remark);
        });
}

std::unique_ptr<FileSaving> startSavingMaterial(const std::filesystem::path& file,
                                                Material material) {
    return std::make_unique<FileSaving>(
        "Saving " + file.filename().string(),
        [file, material = std::move(material)](WorkProgress& progress) {
            progress.enter("Writing");
            writeOutputFile(file, formatMaterial(material));
            return "Saved material " + file.string();
        });
}

}  // namespace kerf::app
