#include "app/session/metrics.h"

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

std::string textOf(const MetricsValue& value) {
    if (const auto* number = std::get_if<double>(&value)) return formatNumber(*number);
    if (const auto* count = std::get_if<long>(&value)) return std::to_string(*count);
    if (const auto* flag = std::get_if<bool>(&value)) return *flag ? "1" : "0";
    return "";
}

MetricsValue valueOf(const std::optional<double>& value) {
    return value ? MetricsValue(*value) : MetricsValue();
}
template <class Value>
MetricsValue valueOf(const Value& value) {
    return value;
}

/// A member of the report, or of a part of it.
template <auto... members>
MetricsValue reported(const MetricsRow& row) {
    return valueOf((row.report.*....*members));
}
template <auto member>
MetricsValue measured(const MetricsRow& row) {
    return valueOf(row.*member);
}
template <SubdivisionPattern pattern>
MetricsValue divided(const MetricsRow& row) {
    return valueOf(row.report.subdivisions[static_cast<std::size_t>(pattern)]);
}
MetricsValue dividedOtherwise(const MetricsRow& row) {
    return valueOf(otherPatterns(row.report.subdivisions));
}
/// What no stage counts: measuring the body, masses of a cut, reading back, events.
MetricsValue otherMsOf(const MetricsRow& row) {
    return valueOf(std::max(0.0, row.frameMs - row.report.times.sum()));
}
MetricsValue realTimeFactorOf(const MetricsRow& row) {
    return valueOf(realTimeFactor(row.simulatedSeconds, row.frameMs));
}
MetricsValue fractureEnergyOf(const MetricsRow& row) {
    return row.namesToughness ? valueOf(row.report.fractureEnergy) : MetricsValue();
}
template <auto member>
MetricsValue torn(const MetricsRow& row) {
    return row.report.tear ? valueOf(std::invoke(member, *row.report.tear)) : MetricsValue();
}
template <Vec3 BladeLoad::*part, int axis>
MetricsValue felt(const MetricsRow& row) {
    const std::optional<BladeLoad>& load = row.report.bladeLoad;
    return load ? valueOf(((*load).*part)[axis]) : MetricsValue();
}

/// The columns in their order (docs/session-format.md).
constexpr MetricsColumn kColumns[] = {
    {"step", reported<&StepReport::step>, "Number of the step, from 0."},
    {"time", reported<&StepReport::time>, "Simulated time at its end [s]."},
    {"volume", reported<&StepReport::volume>, "Total volume of all pieces [m³]."},
    {"volume_ratio", reported<&StepReport::volumeRatio>,
     "The volume over that of the uncut shape at rest."},
    {"pieces", reported<&StepReport::pieces>, "Number of pieces after the step."},
    {"vertices", reported<&StepReport::vertices>, "Number of vertices after the step."},
    {"triangles", reported<&StepReport::triangles>, "Number of triangles after the step."},
    {"ispcs", reported<&StepReport::ispcs>,
     "Number of internal shape-preserving constraints after the step."},
    {"touched_triangles", reported<&StepReport::touchedTriangles>,
     "Triangles that the cut divided in the step."},
    {"closed", reported<&StepReport::closed>,
     "Whether the mesh is a closed, oriented 2-manifold after the step."},
    {"deform_ms", reported<&StepReport::times, &StageTimes::deform>,
     "Wall-clock time of the solver [ms]."},
    {"collide_ms", reported<&StepReport::times, &StageTimes::collide>,
     "Wall-clock time of contact [ms]."},
    {"cut_ms", reported<&StepReport::times, &StageTimes::cut>, "Wall-clock time of the cut [ms]."},
    {"render_ms", measured<&MetricsRow::renderMs>,
     "Wall-clock time of the pictures before the step [ms]."},
    {"frame_ms", measured<&MetricsRow::frameMs>,
     "Wall-clock time of the step with its events [ms]."},
    {"contacts", reported<&StepReport::contacts>,
     "Contacts of the body with itself in the last implicit step, or sweep of pbd."},
    {"one_to_four", divided<SubdivisionPattern::oneToFour>,
     "Touched triangles that were divided by the paper's pattern 1:4."},
    {"one_to_three_a", divided<SubdivisionPattern::oneToThreeA>,
     "Touched triangles that were divided by the paper's pattern 1:3A."},
    {"one_to_two", divided<SubdivisionPattern::oneToTwo>,
     "Touched triangles that were divided by the paper's pattern 1:2."},
    {"one_to_three_b", divided<SubdivisionPattern::oneToThreeB>,
     "Touched triangles that were divided by the paper's pattern 1:3B."},
    {"other_patterns", dividedOtherwise,
     "Touched triangles that were divided by none of the paper's patterns."},
    {"seeds", reported<&StepReport::seeds>, "Groups of neighbours among the touched triangles."},
    {"kinetic_energy", reported<&StepReport::kineticEnergy>,
     "Of the vertices that are not pinned [J]."},
    {"potential_energy", reported<&StepReport::potentialEnergy>,
     "In the field of gravity, above the floor, or above 0 without one [J]."},
    {"debris_pieces", reported<&StepReport::debris, &Debris::pieces>,
     "Pieces removed in the step, being smaller than debris_volume."},
    {"debris_volume", reported<&StepReport::debris, &Debris::volume>, "Their volume at rest [m³]."},
    {"strain_energy", reported<&StepReport::strainEnergy>,
     "Of the strained material [J]; None with the solver \"pbd\"."},
    {"lost_pieces", reported<&StepReport::lostPieces>,
     "Pieces that diverged in the step and were reset to its start."},
    {"search_ms", reported<&StepReport::search, &SearchWork::milliseconds>,
     "Part of cut_ms: finding the triangles near the blade [ms]."},
    {"search_walk_ms", reported<&StepReport::search, &SearchWork::walkMilliseconds>,
     "Part of search_ms, with cut_search \"adjacency\": until the first walk was over [ms]."},
    {"search_seeds", reported<&StepReport::search, &SearchWork::seeds>,
     "With cut_search \"adjacency\": groups of neighbours near the blade."},
    {"search_tests", reported<&StepReport::search, &SearchWork::tests>,
     "Triangles that were tested in the search."},
    {"swept_area", reported<&StepReport::swept, &SweptArea::asItLay>,
     "Area that the blade swept inside the deformed body, one side [m²]."},
    {"swept_area_at_rest", reported<&StepReport::swept, &SweptArea::atRest>,
     "The same, at rest [m²]."},
    {"fracture_energy", fractureEnergyOf,
     "Of the new surface of the step, by the toughness [J]; None where none is given or used."},
    {"blade_force_x", felt<&BladeLoad::force, 0>},
    {"blade_force_y", felt<&BladeLoad::force, 1>},
    {"blade_force_z", felt<&BladeLoad::force, 2>},
    {"blade_moment_x", felt<&BladeLoad::moment, 0>},
    {"blade_moment_y", felt<&BladeLoad::moment, 1>},
    {"blade_moment_z", felt<&BladeLoad::moment, 2>},
    {"blade_work", reported<&StepReport::heldEdge, &HeldEdge::work>,
     "Of moving the blade against its edge in the step [J]; 0 unless the blade feels."},
    {"blade_energy", reported<&StepReport::heldEdge, &HeldEdge::energy>,
     "Stored in the spring that holds the edge back [J]."},
    {"blade_lag", reported<&StepReport::heldEdge, &HeldEdge::lag>,
     "Mean lag of the edge behind the commanded blade [m]."},
    {"iterations", reported<&StepReport::iterations>,
     "Of the step: the parameter, or as chosen where that is \"auto\"."},
    {"other_ms", otherMsOf, "Part of frame_ms outside deform, collide and cut [ms]."},
    {"tears", torn<&TearReport::advanced>, "Whether anything tore; None while nothing can tear."},
    {"tear_refused", torn<&TearReport::failed>, "Whether it should have, but the mesh held it."},
    {"tear_opening", torn<&TearReport::opening>, "Of the widest slit, over what its end needs."},
    {"tear_stress", torn<&TearReport::stress>, "The largest, over the strength of the skin."},
    {"real_time_factor", realTimeFactorOf,
     "Simulated time of the step over frame_ms; None while time is paused."},
    {"implicit_steps", reported<&StepReport::implicitSteps>,
     "Number of implicit steps that the time step was made of; 1 with other solvers."},
    {"residual", reported<&StepReport::residual>,
     "What the iterations left unsolved, as a share of the motion; None with plain PBD or asleep."},
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
    return now.bladeFeels != 0 || now.tearing != 0 || now.toughness != Params{}.toughness ||
           !session.material.empty() || std::ranges::any_of(session.events, setsIt);
}

std::span<const MetricsColumn> metricsColumns() {
    return kColumns;
}

std::string metricsHeader() {
    return joined(kColumns, ",", &MetricsColumn::name) + "\n";
}

std::string formatMetrics(const MetricsRow& row) {
    std::string line;
    for (const MetricsColumn& column : kColumns) {
        line += (line.empty() ? "" : ",") + textOf(column.value(row));
    }
    return line + "\n";
}

std::string formatJsonLine(const MetricsRow& row) {
    std::string line;
    for (const MetricsColumn& column : kColumns) {
        const std::string text = textOf(column.value(row));
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
    deformMs.add(row.report.times.deform);
    collideMs.add(row.report.times.collide);
    cutMs.add(row.report.times.cut);
    searchMs.add(row.report.search.milliseconds);
    realTime.add(row.simulatedSeconds, row.frameMs, row.renderMs);
    addTo(subdivisions, row.report.subdivisions);
    closedEveryStep = closedEveryStep && row.report.closed;
    lostPieces += row.report.lostPieces;
    debris.add(row.report.debris);
    if (row.namesToughness) {
        fractureEnergy = fractureEnergy.value_or(0) + row.report.fractureEnergy;
    }
    if (row.report.tear) {
        tears = tears.value_or(0) + (row.report.tear->advanced ? 1 : 0);
    }
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
    json["real_time_factor"] = toJson(run.realTime);
    json["stages_ms"] = {{"deform", toJson(run.deformMs)},
                         {"collide", toJson(run.collideMs)},
                         {"cut", toJson(run.cutMs)},
                         {"search", toJson(run.searchMs)}};
    json["subdivisions"] = toJson(run.subdivisions);
    json["closed_every_step"] = run.closedEveryStep;
    json["lost_pieces"] = run.lostPieces;
    json["debris"] = {{"pieces", run.debris.pieces}, {"volume", run.debris.volume}};
    json["tears"] = run.tears ? Json(*run.tears) : Json();
    json["fracture_energy"] = run.fractureEnergy ? Json(*run.fractureEnergy) : Json();
    json["cut_report"] = summary.cuts ? toJson(*summary.cuts) : Json();
    if (summary.score) {
        json["score"] = toJson(*summary.score, *summary.task);
    }
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
