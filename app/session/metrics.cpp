#include "app/session/metrics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/files/io/file_io.h"
#include "app/session/session.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

Json toJson(const Counts& counts) {
    return {
        {"vertices", counts.vertices}, {"triangles", counts.triangles}, {"ispcs", counts.ispcs}};
}

Json toJson(const Range& range) {
    return {{"mean", range.mean()}, {"min", range.min()}, {"max", range.max()}};
}

Json toJson(const std::vector<Piece>& pieces) {
    Json list = Json::array();
    for (const Piece& piece : pieces) {
        list.push_back({{"triangles", piece.triangles}, {"volume", piece.volume}});
    }
    return list;
}

Json toJson(const SubdivisionCounts& counts) {
    Json json;
    for (int i = 0; i < kPaperPatterns; ++i) {
        json[nameOf(static_cast<SubdivisionPattern>(i))] = counts[i];
    }
    json["other"] = otherPatterns(counts);
    return json;
}

std::string textOf(double value) {
    return formatNumber(value);
}
std::string textOf(int value) {
    return std::to_string(value);
}
std::string textOf(long value) {
    return std::to_string(value);
}
std::string textOf(bool value) {
    return value ? "1" : "0";
}
std::string textOf(const std::optional<double>& value) {
    return value ? textOf(*value) : "";
}

/// A column of metrics.csv.
struct Column {
    std::string_view name;
    std::string (*text)(const MetricsRow& row);
};

template <auto member>
std::string reported(const MetricsRow& row) {
    return textOf(row.report.*member);
}
template <auto member>
std::string measured(const MetricsRow& row) {
    return textOf(row.*member);
}
template <auto member>
std::string removed(const MetricsRow& row) {
    return textOf(row.report.debris.*member);
}
template <auto member>
std::string swept(const MetricsRow& row) {
    return textOf(row.report.swept.*member);
}
template <auto member>
std::string searched(const MetricsRow& row) {
    return textOf(row.report.search.*member);
}
template <SubdivisionPattern pattern>
std::string divided(const MetricsRow& row) {
    return textOf(row.report.subdivisions[static_cast<std::size_t>(pattern)]);
}
std::string dividedOtherwise(const MetricsRow& row) {
    return textOf(otherPatterns(row.report.subdivisions));
}

template <auto member>
std::string held(const MetricsRow& row) {
    return textOf(row.report.heldEdge.*member);
}
std::string fractureEnergyOf(const MetricsRow& row) {
    return row.namesToughness ? textOf(row.report.fractureEnergy) : "";
}
template <Vec3 BladeLoad::*part, int axis>
std::string felt(const MetricsRow& row) {
    const std::optional<BladeLoad>& load = row.report.bladeLoad;
    return load ? textOf(((*load).*part)[axis]) : "";
}

/// The columns in their order (docs/session-format.md).
constexpr Column kColumns[] = {
    {"step", reported<&StepReport::step>},
    {"time", reported<&StepReport::time>},
    {"volume", reported<&StepReport::volume>},
    {"volume_ratio", reported<&StepReport::volumeRatio>},
    {"pieces", reported<&StepReport::pieces>},
    {"vertices", reported<&StepReport::vertices>},
    {"triangles", reported<&StepReport::triangles>},
    {"ispcs", reported<&StepReport::ispcs>},
    {"touched_triangles", reported<&StepReport::touchedTriangles>},
    {"closed", reported<&StepReport::closed>},
    {"deform_ms", reported<&StepReport::deformMs>},
    {"collide_ms", reported<&StepReport::collideMs>},
    {"cut_ms", reported<&StepReport::cutMs>},
    {"render_ms", measured<&MetricsRow::renderMs>},
    {"frame_ms", measured<&MetricsRow::frameMs>},
    {"contacts", reported<&StepReport::contacts>},
    {"one_to_four", divided<SubdivisionPattern::oneToFour>},
    {"one_to_three_a", divided<SubdivisionPattern::oneToThreeA>},
    {"one_to_two", divided<SubdivisionPattern::oneToTwo>},
    {"one_to_three_b", divided<SubdivisionPattern::oneToThreeB>},
    {"other_patterns", dividedOtherwise},
    {"seeds", reported<&StepReport::seeds>},
    {"kinetic_energy", reported<&StepReport::kineticEnergy>},
    {"potential_energy", reported<&StepReport::potentialEnergy>},
    {"debris_pieces", removed<&Debris::pieces>},
    {"debris_volume", removed<&Debris::volume>},
    {"strain_energy", reported<&StepReport::strainEnergy>},
    {"lost_pieces", reported<&StepReport::lostPieces>},
    {"search_ms", searched<&SearchWork::milliseconds>},
    {"search_walk_ms", searched<&SearchWork::walkMilliseconds>},
    {"search_seeds", searched<&SearchWork::seeds>},
    {"search_tests", searched<&SearchWork::tests>},
    {"swept_area", swept<&SweptArea::asItLay>},
    {"swept_area_at_rest", swept<&SweptArea::atRest>},
    {"fracture_energy", fractureEnergyOf},
    {"blade_force_x", felt<&BladeLoad::force, 0>},
    {"blade_force_y", felt<&BladeLoad::force, 1>},
    {"blade_force_z", felt<&BladeLoad::force, 2>},
    {"blade_moment_x", felt<&BladeLoad::moment, 0>},
    {"blade_moment_y", felt<&BladeLoad::moment, 1>},
    {"blade_moment_z", felt<&BladeLoad::moment, 2>},
    {"blade_work", held<&HeldEdge::work>},
    {"blade_energy", held<&HeldEdge::energy>},
    {"blade_lag", held<&HeldEdge::lag>},
};

}  // namespace

void Range::add(double value) {
    min_ = count_ == 0 ? value : std::min(min_, value);
    max_ = count_ == 0 ? value : std::max(max_, value);
    sum_ += value;
    ++count_;
}

bool namesToughness(const Session& session, const Params& now) {
    const auto setsIt = [](const SessionEvent& event) {
        const auto* set = std::get_if<SetParam>(&event.action);
        return set != nullptr && set->name == "toughness";
    };
    return now.bladeFeels != 0 || now.toughness != Params{}.toughness ||
           !session.material.empty() || std::ranges::any_of(session.events, setsIt);
}

std::string metricsHeader() {
    return joined(kColumns, ",", &Column::name) + "\n";
}

std::string formatMetrics(const MetricsRow& row) {
    std::string line;
    for (const Column& column : kColumns) {
        line += (line.empty() ? "" : ",") + column.text(row);
    }
    return line + "\n";
}

std::string formatJsonLine(const MetricsRow& row) {
    std::string line;
    for (const Column& column : kColumns) {
        const std::string text = column.text(row);
        line.append(line.empty() ? "{\"" : ",\"").append(column.name).append("\":");
        line += Json::accept(text) ? text : "null";
    }
    return line + "}\n";
}

std::string piecesHeader() {
    return "step,piece,triangles,volume,low_x,low_y,low_z,high_x,high_y,high_z\n";
}

std::string formatPieces(int step, const std::vector<Piece>& pieces,
                         const std::vector<Bounds>& boxes, const Vec3& from) {
    const auto number = [&](const Vec3& corner, int axis) {
        const auto own = static_cast<float>(corner[axis]);
        return from[axis] == 0 ? formatNumber(own) : formatNumber(own + from[axis]);
    };
    std::string lines;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        lines += std::to_string(step) + "," + std::to_string(p) + "," +
                 std::to_string(pieces[p].triangles) + "," + formatNumber(pieces[p].volume);
        for (const Vec3& corner : {boxes[p].low, boxes[p].high}) {
            for (int i = 0; i < 3; ++i) {
                lines += "," + number(corner, i);
            }
        }
        lines += "\n";
    }
    return lines;
}

void RunStatistics::add(const MetricsRow& row) {
    ++steps;
    volumeRatio.add(row.report.volumeRatio);
    finalVolumeRatio = row.report.volumeRatio;
    frameMs.add(row.frameMs);
    fps.add(row.frameMs > 0 ? 1000 / row.frameMs : 0);
    deformMs.add(row.report.deformMs);
    collideMs.add(row.report.collideMs);
    cutMs.add(row.report.cutMs);
    searchMs.add(row.report.search.milliseconds);
    addTo(subdivisions, row.report.subdivisions);
    closedEveryStep = closedEveryStep && row.report.closed;
    lostPieces += row.report.lostPieces;
    debris.pieces += row.report.debris.pieces;
    debris.volume += row.report.debris.volume;
}

nlohmann::ordered_json toJson(const RunSummary& summary) {
    const RunStatistics& run = summary.statistics;
    Json json;
    json["model"] = summary.model;
    json["renderer"] = summary.renderer;
    json["driver"] = summary.driver;
    json["steps"] = run.steps;
    json["state_hash"] = summary.stateHash;
    json["before"] = toJson(summary.before);
    json["after"] = toJson(summary.after);
    json["pieces"] = toJson(summary.pieces);
    json["volume_ratio"] = {{"mean", run.volumeRatio.mean()},
                            {"min", run.volumeRatio.min()},
                            {"final", run.finalVolumeRatio}};
    json["fps"] = {{"mean", run.meanFps()}, {"min", run.fps.min()}, {"max", run.fps.max()}};
    json["stages_ms"] = {{"deform", toJson(run.deformMs)},
                         {"collide", toJson(run.collideMs)},
                         {"cut", toJson(run.cutMs)},
                         {"search", toJson(run.searchMs)}};
    json["subdivisions"] = toJson(run.subdivisions);
    json["closed_every_step"] = run.closedEveryStep;
    json["lost_pieces"] = run.lostPieces;
    json["debris"] = {{"pieces", run.debris.pieces}, {"volume", run.debris.volume}};
    json["cut_report"] = summary.cuts ? toJson(*summary.cuts) : Json();
    json["failures"] = summary.failures;
    json["messages"] = summary.messages;
    json["remarks"] = summary.remarks;
    return json;
}

std::string formatSummary(const RunSummary& summary) {
    // A file's name need not be UTF-8; anything else is an error.
    return toJson(summary).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kerf::app
