#include "app/regression/judgement.h"

#include <spdlog/fmt/fmt.h>

#include <cstdio>
#include <nlohmann/json.hpp>

#include "app/files/io/errors.h"
#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "app/session/session_json.h"
#include "sim/base/math.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr std::uintmax_t kMaxSummaryBytes = 1u << 30;

/// The parts of an expectation that are compared with a run.
struct Expected {
    Expectation expectation;
    HashTrace hashes;
    RunTrace trace;
    PieceTrace pieces;
};

/// A table that was cut short would hold less, and nobody would know.
void requireSteps(const std::filesystem::path& file, int steps, int expected) {
    if (steps != expected) {
        throw InputError(
            fmt::format("{}: it has {} where {} says {}; make it anew with kerf test "
                        "--update.",
                        file.string(), counted(steps, "step", "steps"), kExpectedFile, expected));
    }
}

Expected readExpected(const std::filesystem::path& folder) {
    Expected expected{readExpectation(folder / kExpectedFile),
                      HashTrace::read(folder / kHashesFile), readTrace(folder / kTraceFile),
                      readPieces(folder / kPieceBoxesFile)};
    const int steps = expected.expectation.steps;
    requireSteps(folder / kHashesFile, expected.hashes.steps(), steps);
    requireSteps(folder / kTraceFile, static_cast<int>(expected.trace.size()), steps);
    requireSteps(folder / kPieceBoxesFile, lastStepOf(expected.pieces) + 1, steps);
    return expected;
}

Deviation largest(const std::vector<Deviation>& deviations) {
    const auto found = std::ranges::max_element(deviations, {}, &Deviation::value);
    return found == deviations.end() ? Deviation{} : *found;
}

// --- Positions ----------------------------------------------------------------------------------

double distance(const Bounds& a, const Bounds& b) {
    return std::max((a.low - b.low).cwiseAbs().maxCoeff(), (a.high - b.high).cwiseAbs().maxCoeff());
}

/// How far each piece is from the next of the others, at most: pieces may come in another order.
double farthest(const std::vector<PieceBox>& pieces, std::vector<PieceBox> others) {
    double far = 0;
    for (const PieceBox& piece : pieces) {
        const auto nearest = std::ranges::min_element(
            others, {}, [&](const PieceBox& other) { return distance(piece.box, other.box); });
        far = std::max(far, distance(piece.box, nearest->box));
        others.erase(nearest);
    }
    return far;
}

}  // namespace

/// Where there are more or fewer pieces than there should be, the box around all of them counts.
std::vector<Deviation> comparePositions(const PieceTrace& expected, const PieceTrace& found) {
    std::vector<Deviation> deviations;
    for (const auto& [step, pieces] : expected) {
        const auto now = found.find(step);
        if (now != found.end()) {
            deviations.push_back({step, pieces.size() == now->second.size()
                                            ? farthest(pieces, now->second)
                                            : distance(boxOf(pieces, &PieceBox::box),
                                                       boxOf(now->second, &PieceBox::box))});
        }
    }
    return deviations;
}

namespace {

double diagonalOf(const PieceTrace& pieces) {
    return pieces.empty() ? 0 : boxOf(pieces.begin()->second, &PieceBox::box).diagonal();
}

// --- Volume and counts --------------------------------------------------------------------------

/// A difference as a share of what is expected; none is none, even of nothing.
double shareOf(double difference, double whole) {
    return difference > 0 ? difference / std::abs(whole) : 0;
}

/// The largest difference of volume, as a share of that after the first step.
Deviation compareVolume(const RunTrace& expected, const RunTrace& found) {
    std::vector<Deviation> deviations;
    for (std::size_t step = 0; step < std::min(expected.size(), found.size()); ++step) {
        const double difference = std::abs(found[step].volume - expected[step].volume);
        deviations.push_back(
            {static_cast<int>(step), shareOf(difference, expected.front().volume)});
    }
    return largest(deviations);
}

/// A count that two runs can differ in.
struct Count {
    const char* one;
    const char* many;
    int TraceRow::*member;
};
constexpr Count kCounts[] = {{"piece", "pieces", &TraceRow::pieces},
                             {"vertex", "vertices", &TraceRow::vertices},
                             {"triangle", "triangles", &TraceRow::triangles}};

/// "3 pieces instead of 2", where a step has other counts than expected; else "".
std::string otherCounts(const TraceRow& expected, const TraceRow& found) {
    for (const Count& count : kCounts) {
        if (expected.*count.member != found.*count.member) {
            return counted(found.*count.member, count.one, count.many) + " instead of " +
                   std::to_string(expected.*count.member);
        }
    }
    return "";
}

/// The first step with other counts, and what they are.
std::optional<Finding> compareCounts(const RunTrace& expected, const RunTrace& found) {
    for (std::size_t step = 0; step < std::min(expected.size(), found.size()); ++step) {
        const std::string counts = otherCounts(expected[step], found[step]);
        if (!counts.empty()) {
            return Finding{"counts", static_cast<int>(step),
                           fmt::format("Step {}: {}.", step, counts)};
        }
    }
    return std::nullopt;
}

// --- The state ----------------------------------------------------------------------------------

std::optional<Finding> compareLengths(const Expected& expected, const RunResults& results) {
    const int steps = static_cast<int>(results.trace.size());
    if (steps == expected.expectation.steps) {
        return std::nullopt;
    }
    return Finding{"steps", std::min(steps, expected.expectation.steps),
                   fmt::format("The run has {} instead of {}.", counted(steps, "step", "steps"),
                               expected.expectation.steps)};
}

/// The parts that differ for the first time at a step.
struct NewParts {
    int step = 0;
    std::vector<std::string> names;
};

/// By step: what differs, and what follows from it later on. The parts `ignored` do not count.
std::vector<NewParts> compareHashes(const HashTrace& expected, const HashTrace& found,
                                    const std::set<std::string>& ignored = {}) {
    std::vector<NewParts> trace;
    std::set<std::string> known = ignored;
    for (int step = 0; step < std::min(expected.steps(), found.steps()); ++step) {
        NewParts now{step, expected.differingParts(step, found)};
        std::erase_if(now.names, [&](const auto& name) { return !known.insert(name).second; });
        if (!now.names.empty()) {
            trace.push_back(std::move(now));
        }
    }
    return trace;
}

/// "Step 0: parameters differ, from step 25 on positions and velocities".
std::string sentenceAbout(const std::vector<NewParts>& trace) {
    const std::vector<std::string>& first = trace.front().names;
    const bool one = first.size() == 1 && !first.front().ends_with('s');
    std::string text = fmt::format("Step {}: {} {}", trace.front().step, enumerated(first),
                                   one ? "differs" : "differ");
    for (std::size_t i = 1; i < trace.size(); ++i) {
        text += fmt::format(", from step {} on {}", trace[i].step, enumerated(trace[i].names));
    }
    return text;
}

/// A share as "1.25 %"; less than a thousandth of a percent is rounding, so no digits are told.
std::string percent(double share) {
    return share < 1e-5 ? "less than 0.001 %" : fmt::format("{:.2g} %", 100 * share);
}

/// How far off a run is at most, as the end of a sentence.
std::string howFar(const Judgement& judgement, const Expected& expected) {
    const Deviation position = largest(judgement.positions);
    const Deviation volume = compareVolume(expected.trace, judgement.trace);
    std::string text;
    if (position.value > 0) {
        text += fmt::format("; at most {:.3g} m away, at step {}", position.value, position.step);
    }
    if (volume.value > 0) {
        text += fmt::format("; volume off by {} at step {}", percent(volume.value), volume.step);
    }
    const auto counts = compareCounts(expected.trace, judgement.trace);
    return text + (counts ? "; " + lowerCase(counts->sentence) : ".");
}

/// On the same driver every bit counts.
void judgeBits(const Expected& expected, const RunResults& results, Judgement& judgement) {
    const std::vector<NewParts> parts = compareHashes(expected.hashes, results.hashes);
    if (!parts.empty()) {
        judgement.findings.push_back({enumerated(parts.front().names), parts.front().step,
                                      sentenceAbout(parts) + howFar(judgement, expected)});
    } else if (results.stateHash != expected.expectation.stateHash) {
        judgement.findings.push_back(
            {"state", expected.expectation.steps,
             "The state at the end differs, after the last step's events."});
    }
}

std::optional<Finding> judgePositions(const Expected& expected, const Judgement& judgement) {
    const Deviation far = largest(judgement.positions);
    const double allowed = expected.expectation.tolerances.positions * diagonalOf(expected.pieces);
    if (far.value <= allowed) {
        return std::nullopt;
    }
    return Finding{"positions", far.step,
                   fmt::format("Step {}: a piece is {:.3g} m away, {:.3g} m are allowed on another "
                               "driver.",
                               far.step, far.value, allowed)};
}

std::optional<Finding> judgeVolume(const Expected& expected, const Judgement& judgement) {
    const Deviation off = compareVolume(expected.trace, judgement.trace);
    const double allowed = expected.expectation.tolerances.volume;
    if (off.value <= allowed) {
        return std::nullopt;
    }
    return Finding{"volume", off.step,
                   fmt::format("Step {}: the volume is off by {}, {} are allowed on another "
                               "driver.",
                               off.step, percent(off.value), percent(allowed))};
}

std::optional<Finding> judgePieces(const Expected& expected, const Judgement& judgement) {
    const int last = static_cast<int>(std::min(expected.trace.size(), judgement.trace.size())) - 1;
    if (last < 0 || expected.trace[last].pieces == judgement.trace[last].pieces) {
        return std::nullopt;
    }
    return Finding{"pieces", last,
                   fmt::format("Step {}: {} instead of {}.", last,
                               counted(judgement.trace[last].pieces, "piece", "pieces"),
                               expected.trace[last].pieces)};
}

/// What goes into a run is the same on each driver.
std::optional<Finding> judgeInput(const Expected& expected, const RunResults& results) {
    const std::vector<NewParts> parts =
        compareHashes(expected.hashes, results.hashes, {"topology", "positions", "velocities"});
    if (parts.empty()) {
        return std::nullopt;
    }
    return Finding{enumerated(parts.front().names), parts.front().step, sentenceAbout(parts) + "."};
}

/// Another driver rounds otherwise, and what touches follows from that.
void judgeByTolerance(const Expected& expected, const RunResults& results, Judgement& judgement) {
    for (std::optional<Finding> finding :
         {judgeInput(expected, results), judgePieces(expected, judgement),
          judgePositions(expected, judgement), judgeVolume(expected, judgement)}) {
        if (finding) {
            judgement.findings.push_back(std::move(*finding));
        }
    }
}

// --- Pictures -----------------------------------------------------------------------------------

std::vector<TakenPicture> takenPictures(const Session& session) {
    std::vector<TakenPicture> pictures;
    for (const SessionEvent& event : session.events) {
        if (const auto* shot = std::get_if<ScreenshotEvent>(&event.action)) {
            const auto same = std::ranges::find(pictures, shot->file, &TakenPicture::file);
            if (same == pictures.end()) {
                pictures.push_back({shot->file, event.step});
            } else {
                same->step = event.step;
            }
        }
    }
    return pictures;
}

Finding findingOfPicture(const PictureCheck& check, const RunResults& results) {
    const auto taken = std::ranges::find(results.pictures, check.file, &TakenPicture::file);
    return {"picture", taken == results.pictures.end() ? -1 : taken->step, sentenceAbout(check),
            check.file};
}

render::PictureLimits limitsOf(const ExpectedPicture& picture, const Tolerances& tolerances,
                               bool otherDriver) {
    return otherDriver ? tolerances.pictures : picture.limits.value_or(render::kStrictLimits);
}

void judgePictures(const Expected& expected, const std::filesystem::path& folder,
                   const RunResults& results, const std::filesystem::path& differenceFolder,
                   Judgement& judgement) {
    OutputFolder differences(differenceFolder);
    for (const ExpectedPicture& picture : expected.expectation.pictures) {
        const PictureCheck& found = judgement.pictures.emplace_back(checkPicture(
            picture, folder, results.folder, differences,
            limitsOf(picture, expected.expectation.tolerances, judgement.otherDriver)));
        if (!found.alike) {
            judgement.findings.push_back(findingOfPicture(found, results));
        }
    }
}

PictureCheck withoutExpectation(const std::string& file) {
    PictureCheck check;
    check.file = file;
    check.unknown = true;
    return check;
}

/// A picture that nobody looks at would hold nothing.
void judgeNewPictures(const Expected& expected, const RunResults& results, Judgement& judgement) {
    for (const TakenPicture& picture : results.pictures) {
        const auto& known = expected.expectation.pictures;
        if (std::ranges::find(known, picture.file, &ExpectedPicture::file) == known.end()) {
            judgement.pictures.push_back(withoutExpectation(picture.file));
            judgement.findings.push_back(findingOfPicture(judgement.pictures.back(), results));
        }
    }
}

/// Nor would one that is left of an earlier session.
void judgeOldPictures(const Expected& expected, const std::filesystem::path& folder,
                      Judgement& judgement) {
    for (const std::string& file : unlistedPictures(folder, expected.expectation)) {
        judgement.findings.push_back({"picture", -1,
                                      "The picture " + file + " is not listed in " + kExpectedFile +
                                          "; kerf test --update removes what is not needed.",
                                      file});
    }
}

}  // namespace

Finding findingOfCheck(const std::string& failure) {
    int step = -1;
    std::sscanf(failure.c_str(), "Step %d:", &step);
    return {"check", step, failure};
}

RunResults readResults(const std::filesystem::path& folder, const Session& session) {
    const std::filesystem::path file = folder / kSummaryFile;
    const nlohmann::json summary = parseJson(readInputFile(file, kMaxSummaryBytes));
    try {
        return {folder,
                {summary.at("renderer"), summary.at("driver")},
                summary.at("state_hash"),
                summary.at("failures"),
                summary.at("messages"),
                takenPictures(session),
                HashTrace::read(folder / kHashesFile),
                readTrace(folder / kMetricsFile),
                readPieces(folder / kPiecesFile)};
    } catch (const nlohmann::json::exception&) {
        throw InputError(file.string() + ": this is no summary of a replay; run it again.");
    }
}

Judgement judge(const std::filesystem::path& expectationFolder, const RunResults& results,
                const std::filesystem::path& differences) {
    const Expected expected = readExpected(expectationFolder);
    Judgement judgement;
    judgement.otherDriver = expected.expectation.driver != results.driver;
    judgement.expectedDriver = expected.expectation.driver;
    judgement.expectedTrace = expected.trace;
    judgement.trace = results.trace;
    judgement.positions = comparePositions(expected.pieces, results.pieces);
    for (const std::string& failure : results.failures) {
        judgement.findings.push_back(findingOfCheck(failure));
    }
    if (std::optional<Finding> length = compareLengths(expected, results)) {
        judgement.findings.push_back(std::move(*length));
    }
    if (judgement.otherDriver) {
        judgeByTolerance(expected, results, judgement);
    } else {
        judgeBits(expected, results, judgement);
    }
    judgePictures(expected, expectationFolder, results, differences, judgement);
    judgeNewPictures(expected, results, judgement);
    judgeOldPictures(expected, expectationFolder, judgement);
    return judgement;
}

}  // namespace kerf::app
