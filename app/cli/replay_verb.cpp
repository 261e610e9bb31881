#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include <iostream>
#include <nlohmann/json.hpp>

#include "app/cli/option_checks.h"
#include "app/cli/replay/replay.h"
#include "app/cli/replay_arguments.h"
#include "app/cli/verb.h"
#include "app/files/import/model_source.h"
#include "app/files/io/errors.h"
#include "app/files/jobs/progress_line.h"
#include "app/journal/journal.h"
#include "app/regression/expectation.h"
#include "app/regression/picture_check.h"
#include "app/session/material.h"
#include "gpu/context.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr PictureSize kGifSize{640, 360};

ReplayListener listenerFor(const ReplayArguments& arguments, ProgressLine& line,
                           std::ostream& out) {
    ReplayListener listener;
    listener.progress = [&line](int done, int total) { line.show(done, total); };
    if (arguments.jsonl) {
        listener.row = [&out](const MetricsRow& row) { out << formatJsonLine(row) << std::flush; };
    }
    return listener;
}

/// A size that nobody named suits the format.
void sizeFilm(ReplayArguments& arguments) {
    FilmOptions& film = arguments.film;
    if (film.file.empty()) {
        return;
    }
    const FilmFormatInfo* const format = filmFormatOf(film.file);
    if (format == nullptr) {
        throw UsageError("--movie " + film.file.string() + ": a film ends in " + filmEndings());
    }
    const PictureSize usual = format->format == FilmFormat::gif ? kGifSize : PictureSize{};
    film.size = arguments.pictureSize.value_or(usual);
    if (format->evenSides && (film.size.width % 2 != 0 || film.size.height % 2 != 0)) {
        throw UsageError("--size: the sides of a film in the format " + std::string(format->name) +
                         " are even");
    }
}

void sizeStrip(ReplayArguments& arguments) {
    StripOptions& strip = arguments.strip;
    if (strip.file.empty()) {
        return;
    }
    if (lowerCase(strip.file.extension().string()) != ".png") {
        throw UsageError("--strip " + strip.file.string() + ": a strip ends in .png");
    }
    strip.size = arguments.pictureSize.value_or(strip.size);
    const int most = mostStripPictures(strip.size);
    if (strip.pictures < kFewestStripPictures || strip.pictures > most) {
        throw UsageError("--strip: of pictures " + std::to_string(strip.size.width) +
                         " pixels wide a strip has at least " +
                         std::to_string(kFewestStripPictures) + " and at most " +
                         std::to_string(most) + "; --size makes them smaller");
    }
}

/// Files beside the results that a person named.
void takeFilms(ReplayArguments& arguments) {
    sizeFilm(arguments);
    sizeStrip(arguments);
    if (arguments.pictureSize && arguments.film.file.empty() && arguments.strip.file.empty()) {
        throw UsageError("--size is that of a film or a strip: name one by --movie or --strip");
    }
}

ReplayResult runHeadless(const Session& session, const ReplayArguments& arguments,
                         std::ostream& out) {
    ReplayOptions options = arguments;
    HashTrace expected;
    if (!options.verifyName.empty()) {
        expected = HashTrace::read(options.verifyName);
        options.verify = &expected;
    }
    ReadOptions reading;
    reading.means = memoryMeans();
    ModelMesh model = loadSessionModel(session, reading);
    gpu::EglContext context;
    gpu::enableDebugOutput();
    ProgressLine line;
    return replaySession(session, std::move(model), arguments.out,
                         listenerFor(arguments, line, out), options);
}

std::string percent(double ratio) {
    return fmt::format("{:.2f} %", 100 * ratio);
}

/// What came of comparing the screenshots with a folder of references.
struct ReferenceOutcome {
    std::vector<std::string> sentences;  ///< for each that is not as the reference has it
    std::vector<std::string> renewed;    ///< files in the folder
};

/// "written to DIR: a.png b.png".
void printFiles(const std::filesystem::path& folder, const std::vector<std::string>& files,
                std::ostream& out) {
    out << "written to " << folder.string() << ": " << joined(files, " ") << "\n";
}

void printForPeople(const ReplayResult& result, const ReplayArguments& arguments,
                    std::ostream& out) {
    const RunSummary& summary = result.summary;
    const RunStatistics& run = summary.statistics;
    out << summary.model << ": " << run.steps << " steps, "
        << counted(summary.pieces.size(), "piece", "pieces") << ", " << summary.before.triangles
        << " triangles before and " << summary.after.triangles << " after\n";
    out << "volume: mean " << percent(run.volumeRatio.mean()) << ", min "
        << percent(run.volumeRatio.min()) << ", final " << percent(run.finalVolumeRatio)
        << " of rest\n";
    out << "cuts: " << (summary.cuts ? describeCuts(*summary.cuts) : "none") << "\n";
    if (summary.score) {
        const std::size_t broken = summary.score->violations.size();
        out << "score: " << (broken == 0 ? "passed" : joined(summary.score->violations, " "))
            << "\n";
    }
    out << "state: " << summary.stateHash << "\n";
    printFiles(arguments.out, result.files, out);
    if (result.film) {
        out << "film: " << arguments.film.file.string() << ", "
            << counted(result.film->frames, "picture", "pictures") << ", "
            << fmt::format("{:.4g} s\n", result.film->seconds);
    }
    if (!arguments.strip.file.empty()) {
        out << "strip: " << arguments.strip.file.string() << "\n";
    }
    if (!arguments.cache.file.empty()) {
        out << "cache: " << arguments.cache.file.string() << ", "
            << counted(result.cacheSamples, "sample", "samples") << "\n";
    }
    out << "time: " << run.realTime.sentence() << "\n";
}

void printJson(const ReplayResult& result, const ReplayArguments& arguments,
               const ReferenceOutcome& reference, std::ostream& out) {
    nlohmann::ordered_json json = toJson(result.summary);
    json["files"] = result.files;
    if (result.film) {
        json["movie"] = {{"file", arguments.film.file.string()},
                         {"frames", result.film->frames},
                         {"seconds", result.film->seconds}};
    }
    if (!arguments.strip.file.empty()) {
        json["strip"] = arguments.strip.file.string();
    }
    if (!arguments.cache.file.empty()) {
        json["cache"] = {{"file", arguments.cache.file.string()}, {"samples", result.cacheSamples}};
    }
    if (!reference.renewed.empty()) {
        json["renewed"] = reference.renewed;
    }
    out << json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";
}

/// The pictures that the session takes until a step, which is the last one of the run.
std::vector<std::string> picturesUntil(Session session, int step) {
    std::erase_if(session.events, [step](const SessionEvent& event) { return event.step > step; });
    return pictureFiles(session);
}

/// With --update, what differs becomes the reference.
ReferenceOutcome judgeScreenshots(const Session& session, const ReplayArguments& arguments) {
    if (arguments.reference.empty()) {
        return {};
    }
    const std::vector<std::string> pictures = picturesUntil(session, arguments.until);
    if (pictures.empty()) {
        spdlog::warn("--reference {} compares nothing: this replay takes no screenshot.",
                     arguments.reference.string());
    }
    std::vector<ReferenceDifference> differences =
        compareWithReference(pictures, arguments.reference, arguments.out);
    ReferenceOutcome outcome;
    if (arguments.update) {
        outcome.renewed = renewReference(differences, arguments.reference, arguments.out);
        std::erase_if(differences, [](const auto& found) { return !found.missingInRun; });
    }
    std::ranges::transform(differences, std::back_inserter(outcome.sentences),
                           &ReferenceDifference::sentence);
    return outcome;
}

/// Where the run ended because of them, that is said, and how to see the rest.
int complainAboutFailures(const RunSummary& summary, const ReplayArguments& arguments,
                          const Session& session, std::ostream& errors) {
    const auto& failures = summary.failures;
    if (failures.empty()) {
        return kExitDone;
    }
    errors << failures.front();
    if (failures.size() > 1) {
        errors << " (" << failures.size() - 1 << " more in summary.json.)";
    }
    const int steps = std::min(session.steps, arguments.until);
    if (summary.statistics.steps < steps) {
        errors << " The replay ended there; --keep-going runs all " << steps << " steps.";
    }
    errors << "\n";
    return kExitCheckFailed;
}

/// What a test expects would be taken for results of an earlier replay, and removed.
void requireNoExpectations(const std::filesystem::path& folder) {
    if (std::filesystem::exists(folder / kExpectedFile)) {
        throw UsageError("--out " + folder.string() +
                         ": this folder holds what a test expects; choose another");
    }
}

/// A session file, or a journal that a window left behind.
Session sessionIn(const std::filesystem::path& file) {
    return isJournal(file) ? parseSession(readJournal(file).text(), {}) : readSession(file);
}

/// Replaces parameters of a session at its start. Each of `settings` is NAME=VALUE with a value as
/// JSON, or a bare word.
void setParameters(Session& session, const std::vector<std::string>& settings) {
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        if (equals == std::string::npos) {
            throw UsageError("--set " + setting + ": expected NAME=VALUE");
        }
        try {
            setParamFromText(session.params, setting.substr(0, equals), setting.substr(equals + 1));
            requireModelsOfParams(session);
        } catch (const InputError& error) {
            throw UsageError(std::string("--set ") + error.what());
        }
    }
}

int runReplay(ReplayArguments arguments, std::ostream& out, std::ostream& errors) {
    refuseFileAsFolder(arguments.out);
    takeFilms(arguments);
    requireNoExpectations(arguments.out);
    Session session = sessionIn(arguments.session);
    if (!arguments.material.empty()) {
        applyMaterial(session, findMaterial(arguments.material, {}));
    }
    setParameters(session, arguments.set);
    checkReplayTargets(session, arguments);
    for (const std::string& warning : session.warnings) {
        spdlog::warn(warning);
    }
    std::optional<LinkServer> server;
    if (arguments.serve) {
        arguments.link = &server.emplace(*arguments.serve);
    }
    const ReplayResult result = runHeadless(session, arguments, out);
    const ReferenceOutcome reference = judgeScreenshots(session, arguments);
    if (arguments.json) {
        printJson(result, arguments, reference, out);
    } else if (!arguments.jsonl) {
        printForPeople(result, arguments, out);
        if (!reference.renewed.empty()) {
            printFiles(arguments.reference, reference.renewed, out);
        }
    }
    const int exitCode = complainAboutFailures(result.summary, arguments, session, errors);
    for (const std::string& sentence : reference.sentences) {
        errors << sentence << "\n";
    }
    return reference.sentences.empty() ? exitCode : kExitCheckFailed;
}

std::function<int()> describeReplayVerb(CLI::App& verb) {
    const auto arguments = std::make_shared<ReplayArguments>();
    describeReplay(verb, *arguments);
    return [arguments] { return runReplay(*arguments, std::cout, std::cerr); };
}

}  // namespace

const Verb kReplayVerb{"replay",
                       "Run a session headless, as fast as possible, and write its results",
                       describeReplayVerb};

}  // namespace kerf::app
