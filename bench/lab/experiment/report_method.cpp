#include <spdlog/fmt/fmt.h>

#include "bench/lab/experiment/report_figures.h"
#include "bench/lab/experiment/report_markdown.h"
#include "bench/lab/experiment/report_sections.h"

namespace kerf::app {

namespace {

std::string buffersTable(const ShaderInventory& shaders) {
    std::vector<Cells> rows;
    rows.reserve(shaders.buffers.size());
    for (const ShaderBuffer& buffer : shaders.buffers) {
        rows.push_back(
            {fmt::format("{}", buffer.binding), buffer.name, buffer.size, buffer.contents});
    }
    return markdownTable({"binding", "buffer", "entries", "what an entry holds"}, rows);
}

/// "Sphere 768: 466 vertices, 2 groups"
std::string groupsOf(const ExperimentResult& result, int threads) {
    const int vertices = result.summary.after.vertices;
    return fmt::format("{} {}", result.paper->label, (vertices + threads - 1) / threads);
}

std::string groupsSentence(const ReportData& data, int threads) {
    std::string list;
    for (const ExperimentResult& result : data.results) {
        list += (list.empty() ? "" : ", ") + groupsOf(result, threads);
    }
    return "A kernel runs as many groups as its entries need; over the vertices at the end these "
           "are at least: " +
           list + ".";
}

std::string tableOne(const ReportData& data, const ShaderInventory& shaders) {
    return buffersTable(shaders) +
           markdownCaption(
               "Table 1",
               fmt::format(
                   "GPU buffers of the solver, read from `shaders/shared/bindings.h`. Buffers that "
                   "no kernel needs together share a binding. {} kernels run with {} threads in a "
                   "group. {} A small body is solved by one group in one dispatch. The paper has "
                   "10 buffers, for N vertices, M distance and bending constraints, L ISPCs and "
                   "the "
                   "cubes, and 8 groups of 1024 threads in all kernels.",
                   shaders.kernels, shaders.threads, groupsSentence(data, shaders.threads)));
}

std::string remarkOf(const char* label, const HollowRun& run) {
    const RunStatistics& statistics = run.summary.statistics;
    std::string text = fmt::format("{} the volume is {} % in the picture and {} % after {} steps.",
                                   label, percent(run.pictureVolume),
                                   percent(statistics.finalVolumeRatio), statistics.steps);
    for (const std::string& remark : run.summary.remarks) {
        text += " " + remark;
    }
    return text;
}

std::string reasonOf(const Figure2& figure, bool published) {
    if (figure.without.pictureVolume < 0.9) {
        return "As in the paper, the halves collapse without ISPCs.";
    }
    return published ? "The paper's loss is not seen: with stiffness 1 the bends of plain PBD hold "
                       "the skin up alone. The paper does not give its stiffness of bending."
                     : "The paper's loss is not seen here.";
}

std::string figureTwo(const Figure2& figure, bool published) {
    return markdownPicture("Two halves on the floor without and with ISPCs", kFigure2File) +
           markdownCaption(
               "Figure 2",
               "Volume and shape after cutting and falling: (a) without ISPCs (`ispc_stiffness` "
               "0); (b) with ISPCs. " +
                   reasonOf(figure, published) + " " + remarkOf("(a):", figure.without) + " " +
                   remarkOf("(b):", figure.with));
}

}  // namespace

std::string methodSection(const ReportData& data, const ShaderInventory& shaders) {
    return "## Method (the paper's section 2)\n\n" +
           (data.figure2 ? figureTwo(*data.figure2, data.published) : "") + tableOne(data, shaders);
}

}  // namespace kerf::app
