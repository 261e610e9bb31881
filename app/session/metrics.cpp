#include "app/session/metrics.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/files/file_io.h"

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

}  // namespace

void Range::add(double value) {
    min_ = count_ == 0 ? value : std::min(min_, value);
    max_ = count_ == 0 ? value : std::max(max_, value);
    sum_ += value;
    ++count_;
}

std::string metricsHeader() {
    return "step,time,volume,volume_ratio,pieces,vertices,triangles,ispcs,touched_triangles,"
           "closed,deform_ms,collide_ms,cut_ms,render_ms,frame_ms,contacts,one_to_four,one_to_"
           "three_a,"
           "one_to_two,one_to_three_b,other_patterns,seeds,kinetic_energy,potential_energy,"
           "debris_pieces,debris_volume,strain_energy,lost_pieces\n";
}

std::string formatMetrics(const MetricsRow& row) {
    const StepReport& r = row.report;
    std::string line = std::to_string(r.step);
    for (const double value : {r.time, r.volume, r.volumeRatio}) {
        line += "," + formatNumber(value);
    }
    for (const int value : {r.pieces, r.vertices, r.triangles, r.ispcs, r.touchedTriangles,
                            static_cast<int>(r.closed)}) {
        line += "," + std::to_string(value);
    }
    for (const double value : {r.deformMs, r.collideMs, r.cutMs, row.renderMs, row.frameMs}) {
        line += "," + formatNumber(value);
    }
    line += "," + std::to_string(r.contacts);
    for (int i = 0; i < kPaperPatterns; ++i) {
        line += "," + std::to_string(r.subdivisions[i]);
    }
    for (const int value : {otherPatterns(r.subdivisions), r.seeds}) {
        line += "," + std::to_string(value);
    }
    for (const double value : {r.kineticEnergy, r.potentialEnergy}) {
        line += "," + formatNumber(value);
    }
    line += "," + std::to_string(r.debris.pieces) + "," + formatNumber(r.debris.volume);
    line += "," + (r.strainEnergy ? formatNumber(*r.strainEnergy) : "");
    return line + "," + std::to_string(r.lostPieces) + "\n";
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
                         {"cut", toJson(run.cutMs)}};
    json["subdivisions"] = toJson(run.subdivisions);
    json["closed_every_step"] = run.closedEveryStep;
    json["lost_pieces"] = run.lostPieces;
    json["debris"] = {{"pieces", run.debris.pieces}, {"volume", run.debris.volume}};
    json["failures"] = summary.failures;
    json["remarks"] = summary.remarks;
    return json;
}

std::string formatSummary(const RunSummary& summary) {
    // A file's name need not be UTF-8; anything else is an error.
    return toJson(summary).dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace kerf::app
