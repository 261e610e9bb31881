#include "app/session/cut_report.h"

#include <spdlog/fmt/fmt.h>

#include <nlohmann/json.hpp>

#include "sim/base/text.h"
#include "sim/body/rest_geometry.h"
#include "sim/cut/wall_copies.h"
#include "sim/mesh/invariants.h"
#include "sim/mesh/triangle.h"
#include "sim/repair/crossings.h"
#include "sim/repair/surface_contact.h"
#include "sim/run/start/prepared_body.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMostPairs = 1'000'000;
// Of the largest coordinate, which floats round by as much.
constexpr double kRounding = 0x1p-22;
// Of an edge, by which the two sides of a wall differ where a later stroke has divided them
// differently.
constexpr double kOtherwiseDivided = 1e-3;

/// Adds up the triangles of a body, for each stroke that made some.
class CutMeasure {
  public:
    explicit CutMeasure(const CutBodyView& body) : body_(body) {
        for (const StrokeRecord& stroke : body.strokes) {
            if (stroke.metBody()) {
                begin(stroke);
            }
        }
    }

    std::vector<CutFigures> measure() {
        for (int t = 0; t < body_.mesh.triangleSlots(); ++t) {
            if (body_.mesh.present(t)) {
                add(t);
            }
        }
        return std::move(strokes_);
    }

  private:
    void begin(const StrokeRecord& stroke) {
        if (stroke.cutSteps > 0) {
            placeOfNumber_[stroke.number] = strokes_.size();
        }
        CutFigures figures;
        figures.steps = stroke;
        strokes_.push_back(figures);
    }

    void add(int t) {
        if (body_.mesh.kind(t) == SurfaceKind::wall) {
            addWall(t);
        } else if (t >= body_.uncut.triangleSlots()) {
            strokeOfSlot(t).skin.add(restCornersOf(body_.mesh, t));
        }
    }

    void addWall(int t) {
        CutFigures& stroke = strokes_[placeOfNumber_.at(body_.mesh.wallLabel(t) / 2)];
        const Corners corners = restCornersOf(body_.mesh, t);
        stroke.walls.add(corners);
        stroke.woundArea += triangleArea(corners);
        for (int i = 0; i < 3; ++i) {
            if (endsSlit(3 * t + i)) {
                ++stroke.slitEdges;
                stroke.slitLength += (corners[(i + 1) % 3] - corners[i]).norm();
            }
        }
    }

    /// Both walls of a stroke meet there. Told on one side, W+.
    bool endsSlit(int h) const {
        const int label = body_.mesh.wallLabel(SurfaceMesh::triangleOf(h));
        const int across = body_.mesh.wallLabel(SurfaceMesh::triangleOf(body_.mesh.twin(h)));
        return label % 2 == 0 && across == label + 1;
    }

    /// The last one that had begun when the slot was made.
    CutFigures& strokeOfSlot(int t) {
        const auto later = std::ranges::upper_bound(
            strokes_, t, {}, [](const CutFigures& f) { return f.steps.firstTriangle; });
        return later == strokes_.begin() ? *later : *std::prev(later);
    }

    const CutBodyView& body_;
    std::vector<CutFigures> strokes_;
    std::map<int, std::size_t> placeOfNumber_;  ///< in strokes_, by the number in wall labels
};

CutFigures sumOf(const std::vector<CutFigures>& strokes) {
    CutFigures sum;
    for (const CutFigures& stroke : strokes) {
        sum.steps.add(stroke.steps);
        sum.walls.add(stroke.walls);
        sum.skin.add(stroke.skin);
        sum.woundArea += stroke.woundArea;
        sum.slitEdges += stroke.slitEdges;
        sum.slitLength += stroke.slitLength;
    }
    return sum;
}

/// The rest shape of what is present, with the slot of each of its triangles.
struct RestSoup {
    TriangleSoup soup;
    std::vector<int> slots;

    explicit RestSoup(const SurfaceMesh& mesh) {
        soup.positions = mesh.restPositions();
        for (int t = 0; t < mesh.triangleSlots(); ++t) {
            if (mesh.present(t)) {
                soup.triangles.push_back(mesh.triangle(t));
                slots.push_back(t);
            }
        }
    }
};

/// The depth of a crossing that is none [m]: of triangles of the model, and where a cut made one.
struct LeastDepths {
    double ofModel = 0;
    double ofCuts = 0;
};

LeastDepths leastDepths(const SurfaceMesh& uncut) {
    const Bounds box = meshBounds(uncut);
    const double largest = box.low.cwiseAbs().cwiseMax(box.high.cwiseAbs()).maxCoeff();
    const double edge = wallEdgeFor(meanRestEdgeLength(uncut), box.diagonal());
    const double rounding = kRounding * largest;
    return {rounding, std::max(rounding, kOtherwiseDivided * edge)};
}

CrossingPairs countCrossings(const CutBodyView& body) {
    const RestSoup rest(body.mesh);
    const TriangleSoup soup = weldExactly(rest.soup);
    const LeastDepths least = leastDepths(body.uncut);
    const auto isMade = [&](int t) { return rest.slots[t] >= body.uncut.triangleSlots(); };
    CrossingPairs count;
    for (const auto& [a, b] : repair::findCrossings(soup, kMostPairs)) {
        const bool ofCuts = isMade(a) || isMade(b);
        if (repair::crossingDepth(repair::cornersOf(soup, a), repair::cornersOf(soup, b)) >
            (ofCuts ? least.ofCuts : least.ofModel)) {
            ++count.all;
            count.ofCuts += ofCuts ? 1 : 0;
        }
    }
    return count;
}

double volumeError(const CutBodyView& body, const Debris& debris) {
    const double before = meshRestVolume(body.uncut);
    return (meshRestVolume(body.mesh) + debris.volume - before) / before;
}

Json optional(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json anglesOf(const ShapeFigures& shapes) {
    if (shapes.triangles == 0) {
        return nullptr;
    }
    return {{"worst", shapes.worstAngle}, {"mean", shapes.meanAngle()}};
}

Json toJson(const CutFigures& figures) {
    const StrokeRecord& steps = figures.steps;
    const ShapeFigures made = figures.triangles();
    return {{"steps",
             {{"cut", steps.cutSteps},
              {"refused", steps.refusedSteps},
              {"retried", steps.retriedSteps},
              {"anew", steps.cutAnew}}},
            {"triangles", {{"walls", figures.walls.triangles}, {"skin", figures.skin.triangles}}},
            {"smallest_angle", anglesOf(made)},
            {"slivers", {{"below_0_02", made.slivers}, {"below_0_001", made.bareSlivers}}},
            {"area",
             {{"wound", figures.woundArea},
              {"swept", steps.swept.asItLay},
              {"swept_at_rest", steps.swept.atRest},
              {"wound_to_swept", optional(figures.woundToSwept())}}},
            {"slit_ends", {{"edges", figures.slitEdges}, {"length", figures.slitLength}}}};
}

}  // namespace

ShapeFigures CutFigures::triangles() const {
    ShapeFigures made = walls;
    made.add(skin);
    return made;
}

std::optional<double> CutFigures::woundToSwept() const {
    const double both = 2 * steps.swept.atRest;
    return both > 0 ? std::optional(woundArea / both) : std::nullopt;
}

std::optional<CutReport> reportOn(const CutBodyView& body) {
    CutReport report;
    report.strokes = CutMeasure(body).measure();
    if (report.strokes.empty()) {
        return std::nullopt;
    }
    report.all = sumOf(report.strokes);
    report.volumeError = volumeError(body, report.all.steps.debris);
    report.crossings = countCrossings(body);
    return report;
}

std::optional<CutReport> reportOnCuts(const Simulation& simulation) {
    return reportOn({simulation.meshAsRead(), simulation.uncut()->mesh, simulation.strokes()});
}

int countSkinCrossings(const SurfaceMesh& mesh, const SurfaceMesh& uncut) {
    TriangleSoup now{mesh.positions(), {}};
    for (int t = 0; t < uncut.triangleSlots(); ++t) {
        if (mesh.present(t)) {
            now.triangles.push_back(mesh.triangle(t));
        }
    }
    const TriangleSoup rest{mesh.restPositions(), now.triangles};
    const double least = leastDepths(mesh).ofModel;
    return static_cast<int>(
        std::ranges::count_if(repair::findCrossings(now, kMostPairs), [&](const auto& pair) {
            const auto deep = [&](const TriangleSoup& soup) {
                const Corners a = repair::cornersOf(soup, pair.first);
                const Corners b = repair::cornersOf(soup, pair.second);
                return repair::passThrough(a, b) && repair::crossingDepth(a, b) > least;
            };
            return deep(now) && !deep(rest);
        }));
}

std::string remarkOnCrossings(Simulation& simulation) {
    const int pairs = countSkinCrossings(simulation.mesh(), simulation.uncut()->mesh);
    return pairs == 0 ? ""
                      : fmt::format(
                            "At the end {} of the skin {} through each other. A gentler "
                            "load, a higher youngs_modulus or more iterations leave fewer.",
                            counted(pairs, "pair of triangles", "pairs of triangles"),
                            pairs == 1 ? "passes" : "pass");
}

nlohmann::ordered_json toJson(const CutReport& report) {
    Json json = toJson(report.all);
    json["volume_error"] = report.volumeError;
    json["self_intersections"] = {{"pairs", report.crossings.all},
                                  {"of_cuts", report.crossings.ofCuts}};
    json["strokes"] = Json::array();
    for (const CutFigures& stroke : report.strokes) {
        json["strokes"].push_back(toJson(stroke));
    }
    return json;
}

std::string describeCuts(const CutReport& report) {
    const ShapeFigures made = report.all.triangles();
    const std::string angles =
        made.triangles == 0
            ? ""
            : fmt::format(", smallest angle {:.1f} degrees at worst and {:.1f} in the mean",
                          made.worstAngle, made.meanAngle());
    return fmt::format("{}: {} made{}, {}, {} refused, {}",
                       counted(report.strokes.size(), "stroke", "strokes"),
                       counted(made.triangles, "triangle", "triangles"), angles,
                       counted(made.slivers, "sliver", "slivers"),
                       counted(report.all.steps.refusedSteps, "step", "steps"),
                       counted(report.crossings.all, "self-intersection", "self-intersections"));
}

}  // namespace kerf::app
