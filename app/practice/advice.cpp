#include "app/practice/advice.h"

#include <spdlog/fmt/fmt.h>

#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr std::size_t kSentences = 2;
constexpr double kBend = 0.99;  // cosine: a line that turns less is straight

bool isBroken(const Score& score, const Task& task, const char* key) {
    const auto rows = figureRows();
    const auto row = std::ranges::find(rows, std::string_view(key), &FigureRow::key);
    return !isKept(*row, score, task);
}

bool bends(const TaskLine& line) {
    const auto way = [&](std::size_t i) {
        return (line.points[i + 1] - line.points[i]).normalized();
    };
    for (std::size_t i = 0; i + 2 < line.points.size(); ++i) {
        if (way(i).dot(way(i + 1)) < kBend) {
            return true;
        }
    }
    return false;
}

bool isClosed(const TaskLine& line) {
    return line.closed;
}

double lengthOf(const TaskLine& line) {
    double length = 0;
    for (std::size_t i = 0; i + 1 < line.points.size(); ++i) {
        length += (line.points[i + 1] - line.points[i]).norm();
    }
    return length;
}

std::string setDepth(const Score& score, const Task& task) {
    const double depth = *task.depth;
    const std::string wanted = millimetreText(depth);
    return std::abs(score.depthMean.value_or(0) - depth) > task.band
               ? "Set Depth to " + wanted + "."
               : "Keep the depth at " + wanted + " from end to end.";
}

std::string cutAll(const Score& score, const Task& task) {
    const bool skipped = task.lines.size() > 1 && std::ranges::any_of(task.lines, [&](auto& line) {
                             return score.lengthUnder.value_or(0) > 0.5 * lengthOf(line);
                         });
    return skipped ? fmt::format("Cut all {} lines.", task.lines.size())
           : std::ranges::any_of(task.lines, isClosed)
               ? "Go all the way round."
               : "Begin at one end of the line, and go on to the other.";
}

std::string stayOnLine(const Score& /*score*/, const Task& task) {
    return std::ranges::any_of(task.lines, isClosed) ? "Stay on the line all the way round."
           : task.depth ? "Begin on the line, and lift the blade at its end."
                        : "Stay on the line from its one end to the other.";
}

std::string keepNear(const Score& score, const Task& task) {
    return std::ranges::any_of(task.lines, bends)
               ? "Slow down at the bend."
               : "Slow down, and stay between the thin lines: you were up to " +
                     millimetreText(score.deviationMax.value_or(0)) + " beside it.";
}

std::string takeOut(const Score& /*score*/, const Task& task) {
    return std::ranges::any_of(task.lines, isClosed)
               ? "Cut right through; begin outside the line, and end there across your first cut."
               : "Cut right through, so that it comes out whole.";
}

/// What to do about a figure beyond its limit.
struct Advice {
    const char* key;
    std::string (*say)(const Score& score, const Task& task);
};

template <char const* sentence>
std::string always(const Score& /*score*/, const Task& /*task*/) {
    return sentence;
}
constexpr char kNoUndo[] = "Press Try again instead of undoing a cut.";
constexpr char kNoChange[] = "Leave the parameters as the task sets them.";
constexpr char kSteady[] = "Hold the blade more steadily: it shook from side to side.";
constexpr char kSpare[] = "Stay away from the orange outlines.";
constexpr char kFaster[] = "Be quicker: know the way before you begin.";
constexpr char kNoRest[] = "Don't stop on the way.";
constexpr char kStraight[] = "Take the shortest way.";
constexpr char kEven[] = "Draw each stroke in one even motion.";
constexpr char kGently[] = "Cut more slowly, with less force.";

/// What spoils most comes first; a wrong depth, too, since much follows from it.
constexpr Advice kAdvice[] = {
    {"undos", always<kNoUndo>},
    {"changes", always<kNoChange>},
    {"depth_in_band", setDepth},
    {"length_under", cutAll},
    {"taken", takeOut},
    {"length_over", stayOnLine},
    {"deviation_max", keepNear},
    {"deviation_mean", stayOnLine},
    {"wobble", always<kSteady>},
    {"spared_cut", always<kSpare>},
    {"margin_least", always<kSpare>},
    {"time", always<kFaster>},
    {"idle_time", always<kNoRest>},
    {"economy", always<kStraight>},
    {"smoothness", always<kEven>},
    {"force_max", always<kGently>},
};

}  // namespace

std::string adviceOn(const Score& score, const Task& task) {
    std::vector<std::string> sentences;
    for (const Advice& advice : kAdvice) {
        if (sentences.size() < kSentences && isBroken(score, task, advice.key)) {
            std::string sentence = advice.say(score, task);
            if (std::ranges::find(sentences, sentence) == sentences.end()) {
                sentences.push_back(std::move(sentence));
            }
        }
    }
    return joined(sentences, " ");
}

}  // namespace kerf::app
