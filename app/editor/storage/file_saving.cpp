#include "app/editor/storage/file_saving.h"

#include <fstream>

#include "app/files/export/export_alembic.h"
#include "app/files/io/encodings.h"
#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/files/jobs/child_runs.h"
#include "app/regression/test_session.h"
#include "app/session/session.h"
#include "sim/base/text.h"
#include "sim/run/checkpoint.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

namespace {

namespace fs = std::filesystem;

constexpr int kUsualRate = 30;  // samples of meshes in a second

bool isParaViewFile(const fs::path& file) {
    return lowerCase(file.extension().string()) == ".pvd";
}

std::vector<std::string> filmWords(const fs::path& film, const ui::FilmLook& look) {
    std::vector<std::string> words{"--movie", film.string(), "--speed", formatNumber(look.speed),
                                   "--fine"};
    if (look.width > 0) {
        words.insert(words.end(),
                     {"--size", std::to_string(look.width) + "x" + std::to_string(look.height)});
    }
    if (look.rate > 0) {
        words.insert(words.end(), {"--fps", std::to_string(look.rate)});
    }
    if (look.captions) {
        words.emplace_back("--captions");
    }
    if (look.turntable) {
        words.emplace_back("--turntable");
    }
    return words;
}

/// What people call it.
std::string wordFor(const fs::path& file) {
    return isCacheFile(file) || isParaViewFile(file) ? "animation" : "video";
}

/// Arguments of a replay that writes `film`, or a sequence of meshes for ParaView.
std::vector<std::string> wordsFor(const fs::path& film, const ui::FilmLook& look, double timeStep) {
    const double samples = 1 / (timeStep * (look.rate > 0 ? look.rate : kUsualRate));
    const std::string every = std::to_string(std::max(1L, std::lround(samples)));
    if (isCacheFile(film)) {
        return {"--cache", film.string(), "--cache-every", every};
    }
    return isParaViewFile(film) ? std::vector<std::string>{"--sequence", every, "--meshes", "vtp"}
                                : filmWords(film, look);
}

/// Whether a sequence has a mesh of this name.
bool isOfSequence(const std::string& name) {
    constexpr std::string_view kStep = "step-";
    return name.starts_with(kStep) && name.ends_with(".vtp") &&
           name.find_first_not_of("0123456789", kStep.size()) == name.size() - 4;
}

/// Writes the meshes of a sequence into a folder named like `file`. Returns the list of them that
/// belongs into `file`.
std::string writeSequence(const fs::path& sequence, const fs::path& file) {
    const std::string name = file.stem().string();
    OutputFolder meshes(file.parent_path() / name);
    for (const auto& entry : fs::directory_iterator(sequence)) {
        if (entry.path().extension() == ".vtp") {
            AtomicFile mesh(meshes.pathOf(entry.path().filename()));
            mesh.writeAllOf(entry.path());
            mesh.commit();
        }
    }
    for (const auto& entry : fs::directory_iterator(file.parent_path() / name)) {
        const std::string mesh = entry.path().filename();
        if (isOfSequence(mesh) && !fs::exists(sequence / mesh)) {
            meshes.remove(mesh);  // of a longer earlier run
        }
    }
    std::ifstream list(sequence / "sequence.pvd");
    std::string told;
    for (std::string line; std::getline(list, line); told += line + "\n") {
        constexpr std::string_view kFile = "file=\"";
        if (const std::size_t place = line.find(kFile); place != std::string::npos) {
            line.insert(place + kFile.size(), xmlText(name) + "/");
        }
    }
    return told;
}

/// Makes a film of a session, or meshes over time, by a replay in a separate process; the extension
/// of `file` names which. The file appears complete or not at all, and what it lists before it.
/// Throws OutputError, and WorkCancelled.
void filmSession(const Session& session, const fs::path& file, const ui::FilmLook& look,
                 WorkProgress& progress) {
    AtomicFile output(file);
    // All lies there until the end, so that nothing is left of a film that was given up.
    const TemporaryFolder folder("kerf-film");
    const fs::path copy = folder.path() / "session.kerf.json";
    const fs::path film = folder.path() / ("film" + file.extension().string());
    writeOutputFile(copy, formatSession(session, folder.path()));
    const auto tell = [&](int done) {
        progress.enter("Step " + std::to_string(std::min(done, session.steps)) + " of " +
                           std::to_string(session.steps),
                       done, session.steps);
    };
    tell(0);
    const fs::path results = folder.path() / "results";
    std::vector<std::string> words{"replay",         copy.string(),  "--out",
                                   results.string(), "--keep-going", "--jsonl"};  // a line per step
    std::ranges::move(wordsFor(film, look, session.params.timeStep), std::back_inserter(words));
    const ChildOutcome end = runChild(words, progress, tell);
    if (end.exitCode != kExitDone && end.exitCode != kExitCheckFailed) {
        throw OutputError("The " + wordFor(file) +
                          " could not be exported: " + sentenceAbout(end, folder.path()));
    }
    progress.enter("Writing");
    if (isParaViewFile(file)) {
        output.write(writeSequence(results / "sequence", file));
    } else {
        output.writeAllOf(film);
    }
    output.commit();
}

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
void keepEnd(const std::filesystem::path& file, const SceneCheckpoint& end,
             const StoredEnds& ends) {
    if (std::optional<std::vector<std::byte>> bytes = bytesOf(end.state.checkpoint)) {
        ends.keep(file, {*std::move(bytes), end.start.step, end.start.time});
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
        "Exporting " + wordFor(file) + " " + file.filename().string(),
        [file, look, saved = std::move(saved)](WorkProgress& progress) {
            filmSession(saved.session, file, look, progress);
            return "Exported " + wordFor(file) + " " + file.string() +
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
                                        std::optional<SceneCheckpoint> end,
                                        const StoredEnds& ends) {
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

std::string formatPlots(std::span<const ui::PlotSpec> plots) {
    std::string text = "plot,curve,time,mean,min,max,values\n";
    for (const ui::PlotSpec& plot : plots) {
        for (const ui::PlotCurve& curve : plot.curves) {
            const std::string head = std::string(plot.id) + "," + curve.label;
            for (const ui::SeriesBucket& bucket : curve.series->buckets()) {
                text += head;
                for (const double value : {bucket.x, bucket.mean, bucket.low, bucket.high}) {
                    text += "," + formatNumber(value);
                }
                text += "," + std::to_string(bucket.count) + "\n";
            }
        }
    }
    return text;
}

}  // namespace kerf::app
