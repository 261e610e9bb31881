#include "bench/lab/fem/fem_report.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/lab/experiment/report_markdown.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

constexpr double kMillimetres = 1000;  // in a metre

std::optional<double> deviation(const std::optional<double>& ours,
                                const std::optional<double>& theirs) {
    return ours && theirs ? std::optional(*ours / *theirs - 1) : std::nullopt;
}

bool isWithin(const std::optional<double>& deviation) {
    return !deviation || std::abs(*deviation) <= kFemBar;  // false where it is not a number
}

std::string millimetres(const std::optional<double>& length) {
    return length ? fmt::format("{:.2f}", kMillimetres * *length) : kNotGiven;
}

/// "+12.3", with an exclamation mark where it is beyond the bar.
std::string marked(const std::optional<double>& deviation) {
    return deviation ? fmt::format("{:+.1f}{}", 100 * *deviation, isWithin(deviation) ? "" : " !")
                     : kNotGiven;
}

Cells rowOf(const FemResult& r) {
    return {
        r.body,
        r.cut,
        r.setting + (r.settled ? "" : " (still moving)"),
        millimetres(r.kerf.sag),
        millimetres(r.elements.sag),
        marked(r.sagDeviation()),
        millimetres(r.kerf.opening),
        millimetres(r.elements.opening),
        marked(r.openingDeviation()),
        percent(r.kerf.volumeRatio),
        percent(r.elements.volumeRatio),
        marked(r.volumeDeviation()),
        fmt::format("{:.2f}{}", 100 * r.shapeShare(), r.shapeShare() <= kFemShapeBar ? "" : " !"),
        fmt::format("{:.2f}", 100 * r.shape.mean / r.diagonal),
        r.holds() ? "yes" : "no"};
}

std::string mainTable(const std::vector<FemResult>& results) {
    std::vector<Cells> rows;
    std::ranges::transform(results, std::back_inserter(rows), rowOf);
    return markdownTable({"body", "cut", "Kerf's setting", "sag, mm: Kerf", "elements", "%",
                          "opening, mm: Kerf", "elements", "%", "volume, %: Kerf", "elements", "%",
                          "shape, % of the diagonal: largest", "mean", "within the bars"},
                         rows);
}

/// One row of those that hold for each setting.
std::string countTable(const std::vector<FemResult>& results) {
    std::vector<std::string> settings;
    for (const FemResult& r : results) {
        if (std::ranges::find(settings, r.setting) == settings.end()) {
            settings.push_back(r.setting);
        }
    }
    std::vector<Cells> rows;
    for (const std::string& setting : settings) {
        const auto count = [&](auto has, auto holds) {
            int all = 0;
            int good = 0;
            for (const FemResult& r : results) {
                if (r.setting == setting && has(r)) {
                    ++all;
                    good += holds(r) ? 1 : 0;
                }
            }
            return fmt::format("{} of {}", good, all);
        };
        const auto always = [](const FemResult&) { return true; };
        rows.push_back(
            {setting,
             count([](const FemResult& r) { return r.sagDeviation().has_value(); },
                   [](const FemResult& r) { return isWithin(r.sagDeviation()); }),
             count([](const FemResult& r) { return r.openingDeviation().has_value(); },
                   [](const FemResult& r) { return isWithin(r.openingDeviation()); }),
             count(always, [](const FemResult& r) { return isWithin(r.volumeDeviation()); }),
             count(always, [](const FemResult& r) { return r.shapeShare() <= kFemShapeBar; }),
             count(always, [](const FemResult& r) { return r.holds(); })});
    }
    return markdownTable({"Kerf's setting", "sag within 15 %", "opening within 15 %",
                          "volume within 15 %", "shape within 5 %", "all of these"},
                         rows);
}

/// How far the elements themselves can be trusted: what the larger ones give, of each case once.
std::string elementTable(const std::vector<FemResult>& results) {
    std::vector<Cells> rows;
    std::vector<std::string> seen;
    for (const FemResult& r : results) {
        if (std::ranges::find(seen, r.name) == seen.end()) {
            seen.push_back(r.name);
            rows.push_back({r.body, r.cut, marked(deviation(r.coarse.sag, r.elements.sag)),
                            marked(deviation(r.coarse.opening, r.elements.opening))});
        }
    }
    return markdownTable({"body", "cut", "sag, %", "opening, %"}, rows);
}

std::string pictures(const std::vector<FemResult>& results) {
    std::string text;
    for (const FemResult& r : results) {
        text +=
            markdownPicture(fmt::format("{}, cut: {}, {}", r.body, r.cut, r.setting), r.picture);
    }
    return text;
}

std::string remarks(const std::vector<FemResult>& results) {
    std::vector<std::string> sentences;
    for (const FemResult& r : results) {
        if (!r.settled) {
            sentences.push_back(fmt::format(
                "{}, cut: {}, {}: it still moved when time was up, so what stands there is not "
                "final.",
                r.body, r.cut, r.setting));
        }
        if (!r.tooFew.empty()) {
            sentences.push_back(
                fmt::format("{}, cut: {}, {}: {}", r.body, r.cut, r.setting, r.tooFew));
        }
    }
    return sentences.empty() ? "" : "## Remarks\n\n" + markdownList(sentences);
}

nlohmann::ordered_json toJson(const FemFigures& figures) {
    nlohmann::ordered_json json;
    json["sag"] = figures.sag ? nlohmann::ordered_json(*figures.sag) : nullptr;
    json["opening"] = figures.opening ? nlohmann::ordered_json(*figures.opening) : nullptr;
    json["volume_ratio"] = figures.volumeRatio;
    return json;
}

}  // namespace

FemFigures figuresOf(const FemCase& each, const LoadedSurface& surface) {
    FemFigures figures;
    if (each.probe) {
        figures.sag = sagOf(surface, *each.probe);
    } else if (each.hangs) {
        figures.sag = sagOfLowest(surface);
    }
    if (each.opens) {
        figures.opening = openingOf(surface);
    }
    figures.volumeRatio = volumeRatioOf(surface);
    return figures;
}

std::optional<double> FemResult::sagDeviation() const {
    return deviation(kerf.sag, elements.sag);
}

std::optional<double> FemResult::openingDeviation() const {
    return deviation(kerf.opening, elements.opening);
}

double FemResult::volumeDeviation() const {
    return kerf.volumeRatio / elements.volumeRatio - 1;
}

bool FemResult::holds() const {
    return isWithin(sagDeviation()) && isWithin(openingDeviation()) &&
           isWithin(volumeDeviation()) && shapeShare() <= kFemShapeBar;
}

std::string formatFemReport(const std::vector<FemResult>& results) {
    return fmt::format(
               "# Kerf beside finite elements\n\n"
               "The same bodies as Kerf's and as quadratic tetrahedra of a stable neo-Hookean "
               "solid, with the same Young's modulus of 100 kPa, density, pins and load. Poisson's "
               "ratio of the elements is {}; Kerf's bodies have none, and keep their volume. Cuts "
               "are made by a blade before the load, those of the elements are there from the "
               "start. Kerf's body is compared once it rests. *Sag* is how far the free end, or "
               "the lowest point, comes "
               "down, *opening* how far the lips stand apart in the middle. *Shape* is the "
               "distance of the vertices of either surface from the other one. An exclamation "
               "mark stands beyond a bar: 15 % of what the elements say, or 5 % of the "
               "diagonal.\n\n",
               kFemPoissonRatio) +
           countTable(results) + mainTable(results) + remarks(results) +
           "## How far the elements can be trusted\n\n"
           "What elements of twice the size give, against those above. The rest of their error is "
           "smaller than that.\n\n" +
           elementTable(results) + "## Pictures\n\n" + pictures(results);
}

std::string formatFemSummary(const std::vector<FemResult>& results) {
    nlohmann::ordered_json summary;
    for (const FemResult& r : results) {
        nlohmann::ordered_json json{
            {"case", r.name},           {"body", r.body},       {"cut", r.cut},
            {"setting", r.setting},     {"settled", r.settled}, {"steps", r.steps},
            {"state_hash", r.stateHash}};
        json["kerf"] = toJson(r.kerf);
        json["elements"] = toJson(r.elements);
        json["coarse_elements"] = toJson(r.coarse);
        json["shape"] = {
            {"largest", r.shape.largest}, {"mean", r.shape.mean}, {"diagonal", r.diagonal}};
        json["within_bars"] = r.holds();
        json["picture"] = r.picture;
        json["session"] = r.session;
        summary["cases"].push_back(std::move(json));
    }
    return summary.dump(2) + "\n";
}

}  // namespace kerf::app
