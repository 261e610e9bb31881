#include "bench/lab/experiment/report_figures.h"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <array>
#include <span>

#include "app/files/io/file_io.h"
#include "app/files/io/output_folder.h"
#include "bench/lab/experiment/report_markdown.h"
#include "ui/plots/bar_chart.h"
#include "ui/plots/picture_strip.h"
#include "ui/plots/plot_picture.h"

namespace kerf::app {

namespace {

constexpr int kSpheres = 3;          ///< experiments of figures 5 and 7; the others are in 6 and 8
constexpr float kStripScale = 1.8F;  ///< strips are shown at half of their size, or less
constexpr float kChartScale = 1.4F;
constexpr int kPlotWidth = 900;
constexpr int kPlotHeight = 560;
constexpr int kChartWidth = 1400;
constexpr int kChartHeight = 620;
constexpr int kVolumeHeight = 260;  ///< of each of the plots of figure 10

int placeOf(const PaperExperiment& experiment) {
    return static_cast<int>(&experiment - paperExperiments().data());
}

FigurePart partOf(const PaperExperiment& experiment, int ofSpheres, int ofOthers) {
    const int place = placeOf(experiment);
    const bool isSphere = place < kSpheres;
    return {isSphere ? ofSpheres : ofOthers,
            static_cast<char>('a' + (isSphere ? place : place - kSpheres))};
}

std::string settingsOf(const Session& session) {
    return fmt::format("time step {} s, {} iterations", session.params.timeStep,
                       session.params.iterations);
}

/// Draws the figures of one report.
class FigureArtist {
  public:
    FigureArtist(const ReportData& data, const std::filesystem::path& out)
        : data_(data),
          folder_(out),
          strips_(ui::Theme::light, kStripScale),
          charts_(ui::Theme::light, kChartScale),
          plots_(ui::Theme::light),
          volumes_(ui::Theme::light, kChartScale) {}

    void drawAll() {
        for (const ExperimentResult& result : data_.results) {
            drawRun(result);
        }
        if (data_.figure2) {
            drawPair(*data_.figure2);
        }
        write(ui::drawBarChart(charts_, rates(), kChartWidth, kChartHeight), kFigure9File);
        write(ui::drawBarChart(charts_, searchTimes(), kChartWidth, kChartHeight), kSearchFile);
        drawVolumes();
    }

  private:
    void write(const render::Image& picture, const std::string& file) {
        writePicture(picture, folder_.pathOf(file));
    }

    render::Image read(const std::string& file) { return readPicture(folder_.pathOf(file)); }

    void drawRun(const ExperimentResult& result) {
        drawStrip(cuttingFigure(*result.paper), result, result.cutting);
        drawStrip(fallFigure(*result.paper), result, result.falling);
        write(drawCurves(result), std::string(result.paper->name) + "/" + kPlotFile);
    }

    void drawStrip(const FigurePart& part, const ExperimentResult& result,
                   const std::vector<ReportPicture>& pictures) {
        std::vector<ui::StripPicture> shown;
        shown.reserve(pictures.size());
        for (const ReportPicture& picture : pictures) {
            const double time = picture.step * result.session.params.timeStep;
            shown.push_back(
                {read(std::string(result.paper->name) + "/" + picture.file),
                 fmt::format("{}\nstep {}, {:.2f} s", picture.caption, picture.step, time)});
        }
        write(ui::drawStrip(
                  strips_,
                  part.label() + " " + result.paper->label + ": " + settingsOf(result.session),
                  shown),
              part.file());
    }

    void drawPair(const Figure2& figure) {
        const auto show = [&](const char* label, const HollowRun& run) {
            return ui::StripPicture{read(run.picture), fmt::format("{}\nvolume {} %", label,
                                                                   percent(run.pictureVolume))};
        };
        write(ui::drawStrip(strips_, fmt::format("Sphere 768, step {}", kFigure2Step),
                            std::array{show("(a) without ISPCs", figure.without),
                                       show("(b) with ISPCs", figure.with)}),
              kFigure2File);
    }

    render::Image drawCurves(const ExperimentResult& result) {
        ui::PlotSpec volume = volumePlot(result, "Volume, % of rest");
        ui::PlotSpec frames;
        frames.id = "frames";
        frames.title = "Time of a frame, ms";
        frames.curves = {{.label = "frame", .series = &result.curves.frames}};
        frames.marks = result.curves.marks;
        const double paper = 1000 / result.paper->meanFps;
        frames.reference = {paper, fmt::format("paper's mean {:.1f}", paper)};
        frames.minSpan = 10;
        return plots_.draw(std::array{volume, frames}, {}, kPlotWidth, kPlotHeight);
    }

    static ui::PlotSpec volumePlot(const ExperimentResult& result, std::string_view title) {
        ui::PlotSpec plot;
        plot.id = result.paper->name;
        plot.title = title;
        plot.curves = {{.label = "volume", .hue = ui::Hue::green, .series = &result.curves.volume}};
        plot.marks = result.curves.marks;
        plot.reference = {result.paper->meanVolume,
                          fmt::format("paper's mean {:.1f}", result.paper->meanVolume)};
        plot.showsReference = true;
        plot.readoutDecimals = 2;
        return plot;
    }

    void drawVolumes() {
        std::vector<std::string> titles;
        titles.reserve(data_.results.size());  // the plots see them
        std::vector<ui::PlotSpec> plots;
        for (const ExperimentResult& result : data_.results) {
            titles.push_back(volumeFigure(*result.paper).label() + " " + result.paper->label +
                             ": volume, % of rest");
            plots.push_back(volumePlot(result, titles.back()));
        }
        write(volumes_.draw(plots, {}, kChartWidth, kVolumeHeight * static_cast<int>(plots.size())),
              kFigure10File);
    }

    ui::BarChart rates() const {
        ui::BarChart chart;
        chart.title = "Average frames per second";
        chart.kinds = {{"paper", ui::Hue::gray},
                       {"Kerf, while the blade cuts", ui::Hue::blue},
                       {"Kerf, whole run", ui::Hue::orange}};
        for (const ExperimentResult& result : data_.results) {
            const StrokeRates rates = strokeRates(result);
            chart.groups.push_back({result.paper->label,
                                    {ui::Bar{result.paper->meanFps, {}},
                                     ui::Bar{rates.mean, ui::Bar::Spread{rates.least, rates.most}},
                                     ui::Bar{result.summary.statistics.meanFps(), {}}}});
        }
        return chart;
    }

    ui::BarChart searchTimes() const {
        ui::BarChart chart;
        chart.title = "Finding the triangles near the blade, ms of a step, mean";
        chart.decimals = 3;
        constexpr std::array kHues{ui::Hue::blue, ui::Hue::green, ui::Hue::vermillion};
        for (const SearchRun& run : data_.results.front().searches) {
            chart.kinds.push_back({run.way, kHues[chart.kinds.size() % kHues.size()]});
        }
        for (const ExperimentResult& result : data_.results) {
            ui::BarGroup group{result.paper->label, {}};
            for (const SearchRun& run : result.searches) {
                group.bars.emplace_back(ui::Bar{run.times.searchMs.mean(), {}});
            }
            chart.groups.push_back(std::move(group));
        }
        return chart;
    }

    const ReportData& data_;
    OutputFolder folder_;
    ui::PicturePainter strips_;
    ui::PicturePainter charts_;
    ui::PlotPainter plots_;
    ui::PlotPainter volumes_;
};

}  // namespace

std::string FigurePart::file() const {
    return fmt::format("figures/figure-{}{}.png", figure, letter);
}

std::string FigurePart::label() const {
    return std::string("(") + letter + ")";
}

FigurePart cuttingFigure(const PaperExperiment& experiment) {
    return partOf(experiment, 5, 6);
}

FigurePart fallFigure(const PaperExperiment& experiment) {
    return partOf(experiment, 7, 8);
}

FigurePart volumeFigure(const PaperExperiment& experiment) {
    return {10, static_cast<char>('a' + placeOf(experiment))};
}

void drawFigures(const ReportData& data, const std::filesystem::path& out) {
    FigureArtist(data, out).drawAll();
}

}  // namespace kerf::app
