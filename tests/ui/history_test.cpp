#include "ui/plots/history.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "tests/paths.h"

namespace kerf::ui {
namespace {

bool isPlotted(Reading reading) {
    const auto shows = [reading](const PlotKind& plot) {
        return std::ranges::any_of(plot.curves, [reading](const CurveKind& curve) {
            return curve.label != nullptr && curve.reading == reading;
        });
    };
    return std::ranges::any_of(kPlots, shows) || std::ranges::any_of(kPointPlots, shows);
}

TEST(Plots, ShowEveryReadingButThatOfTheStatusBar) {
    for (int i = 0; i < static_cast<int>(Reading::count); ++i) {
        const auto reading = static_cast<Reading>(i);
        EXPECT_EQ(isPlotted(reading), reading != Reading::lostPieces) << "reading " << i;
    }
}

TEST(Plots, HaveNamesOfTheirOwn) {
    std::set<std::string> names;
    for (const PlotKind& plot : kPlots) {
        EXPECT_TRUE(names.insert(plot.id).second) << plot.id;
        for (const CurveKind& curve : plot.curves) {
            EXPECT_EQ(curve.label == nullptr, curve.reading == Reading::count) << plot.id;
        }
    }
}

TEST(Plots, TheDocsHaveTheirNames) {
    std::string row = "| `plots` | list of ";
    for (const PlotKind& plot : kPlots) {
        row.append(&plot == &kPlots.front() ? "`" : ", `").append(plot.id).append("`");
    }
    std::ifstream file(KERF_SOURCE_DIR "/docs/editor.md");
    std::stringstream text;
    text << file.rdbuf();
    EXPECT_NE(text.str().find(row + " |"), std::string::npos) << "docs/editor.md needs " << row;
}

}  // namespace
}  // namespace kerf::ui
