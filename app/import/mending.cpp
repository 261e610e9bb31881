#include "app/import/mending.h"

#include <spdlog/fmt/fmt.h>

#include <iostream>

#include "app/files/import/import_process.h"
#include "app/files/io/errors.h"
#include "app/import/piece_union.h"
#include "app/import/repair/soup_repair.h"
#include "app/import/repair/surface_meshing.h"
#include "app/import/repair/thickening.h"
#include "app/import/repair/vertex_parting.h"
#include "sim/base/text.h"
#include "sim/mesh/triangle_quality.h"

namespace kerf::app {

namespace {

/// Edges too short for the memory that there is are refused before any of it is taken.
void requireMemoryForEdges(const TriangleSoup& soup, double edge) {
    constexpr double kBytesOfTriangle = 400;  // 345 were seen, with 700,000 of them
    const double triangles = trianglesOf(figuresOf(soup), edge);
    requireFree(
        fmt::format("Edges of {:g} make about {:.1e} triangles", edge, std::min(triangles, 1e18)),
        kBytesOfTriangle * triangles, "ask for longer ones with --edge");
}

/// A model under repair, and the report on it as it is now.
class Mender {
  public:
    Mender(TriangleSoup& soup, const ImportOrder& order)
        : soup_(soup), order_(order), found_(inspectTriangles(soup)) {}

    MeshReport run() {
        repair();
        if (order_.thicken && !thicken()) {
            return report();
        }
        fillHoles();
        turn();
        unite();
        remesh();
        roundToFile();
        return report();
    }

    /// That sheets were given [file units]; 0 for none.
    double thickness() const { return thickness_; }

  private:
    void repair() {
        if (order_.repair && !found_.cuttable) {
            repairs_ = repairSoup(soup_, !order_.thicken);
            look();
        }
    }

    bool thicken() {
        Thickening done = app::thicken(soup_, *order_.thicken);
        if (done.sheets > 0) {
            note("gave {} a thickness of {:g}", counted(done.sheets, "sheet", "sheets"),
                 done.thickness);
        }
        problem_ = std::move(done.problem);
        thickness_ = done.thickness;
        return problem_.empty();
    }

    void fillHoles() {
        if (order_.fillHoles && found_.openEdges > 0) {
            const HoleFilling filled = app::fillHoles(soup_);
            note("filled {} with {}", counted(filled.holes, "hole", "holes"),
                 counted(filled.triangles, "triangle", "triangles"));
        }
    }

    /// What is inside out.
    void turn() {
        const int pieces = found_.insideOutPieces;
        const int cavities = found_.outwardCavities;
        if (pieces + cavities == 0) {
            return;
        }
        turnOutward(soup_);
        if (pieces > 0) {
            note("turned {}", counted(pieces, "inside-out piece", "inside-out pieces"));
        }
        if (cavities > 0) {
            note("turned {} inside another one inwards, around {}",
                 counted(cavities, "shell", "shells"), cavities == 1 ? "a cavity" : "cavities");
        }
    }

    /// What moves apart may cross then, and what is united may touch itself. What is sound stays.
    void unite() {
        if (!order_.repair || !found_.cuttable) {
            return;
        }
        uniteOnce();
        const int rounds = repairs_.empty() ? 0 : 4;
        for (int i = 0; i < rounds && moveApart(soup_) > 0; ++i) {
            look();
            uniteOnce();
        }
    }

    void uniteOnce() {
        PieceUnion became = uniteCrossingPieces(soup_);
        left_ = std::move(became.left);
        if (!became.done.empty()) {
            std::ranges::move(became.done, std::back_inserter(repairs_));
            look();
        }
    }

    void remesh() {
        if (!order_.remesh || !found_.cuttable) {
            return;
        }
        const TriangleFigures figures = figuresOf(soup_);
        const double edge = order_.edge.value_or(
            order_.toFile ? proposedEdge(figures, found_.bounds.diagonal()) : evenEdge(figures));
        requireMemoryForEdges(soup_, edge);
        const std::size_t before = soup_.triangles.size();
        app::remesh(soup_, edge, [](int round) {
            tellStage(fmt::format("Evening out the triangles, round {}", round + 1));
        });
        note("remeshed {} triangles to {}", before, soup_.triangles.size());
        if (!found_.cuttable) {
            found_.problem = "with even triangles it has " + found_.problem;
        }
    }

    /// What was sound in doubles may fall together where edges are short.
    void roundToFile() {
        if (!order_.toFile) {
            return;
        }
        if (!found_.cuttable) {
            const bool plain = !order_.thicken && !order_.remesh;
            problem_ = (plain ? "after the repair still " : "") + found_.problem;
            return;
        }
        roundToFloats(soup_);
        look();
        if (!found_.cuttable) {
            problem_ = fmt::format(
                "once mended and rounded to the 32-bit numbers of a file, it has {}{}",
                found_.problem, order_.remesh ? ", or ask for longer edges with --edge" : "");
        }
    }

    template <class... Arguments>
    void note(fmt::format_string<Arguments...> done, Arguments&&... arguments) {
        repairs_.push_back(fmt::format(done, std::forward<Arguments>(arguments)...));
        look();
    }

    void look() { found_ = inspectTriangles(soup_); }

    MeshReport report() {
        MeshReport report = found_;
        report.repairs = repairs_;
        report.left = left_;
        report.problem = problem_.empty() ? report.problem : problem_;
        return report;
    }

    TriangleSoup& soup_;
    const ImportOrder& order_;
    MeshReport found_;                  ///< on the soup as it is now, without repairs
    std::vector<std::string> repairs_;  ///< see MeshReport, as of the others
    std::vector<std::string> left_;
    std::string problem_;   ///< why it was given up; empty for not
    double thickness_ = 0;  ///< that sheets were given
};

/// 0 where none helps.
int holesThatHelp(TriangleSoup soup) {
    const int holes = fillHoles(soup).holes;
    return holes > 0 && mend(soup, {}).cuttable ? holes : 0;
}

}  // namespace

MeshReport mend(TriangleSoup& soup, const ImportOrder& order) {
    return Mender(soup, order).run();
}

ModelHelp helpFor(const TriangleSoup& soup, const MeshReport& found) {
    ModelHelp help;
    if (found.cuttable && found.crossingTriangles == 0) {
        return help;
    }
    tellStage("Looking for a repair");
    ImportOrder order{{.repair = true}};
    order.toFile = true;
    TriangleSoup mended = soup;
    if (const MeshReport became = mend(mended, order); became.cuttable) {
        help.repairs = became.repairs;
    }
    if (!found.cuttable) {
        help.holes = holesThatHelp(soup);
        TriangleSoup sheets = soup;
        repairSoup(sheets, false);
        help.isSheet = isSheet(sheets);
        order.thicken = 0;
        mended = soup;
        Mender thickening(mended, order);
        help.thickness = thickening.run().cuttable ? thickening.thickness() : 0;
    }
    return help;
}

void tellStage(const std::string& stage) {
    std::cerr << kStageMark << stage << std::endl;  // At once, since somebody waits.
}

}  // namespace kerf::app
