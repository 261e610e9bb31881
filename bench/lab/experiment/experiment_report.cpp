#include "bench/lab/experiment/experiment_report.h"

#include "bench/lab/experiment/report_markdown.h"
#include "bench/lab/experiment/report_sections.h"

namespace kerf::app {

namespace {

std::string methodSentence(bool published) {
    return published
               ? "Solver, contact between pieces and course of the cut are the paper's as well "
                 "(`solver` pbd, `paper_contact`, `open_cut`): the body is open while the blade is "
                 "in it. What that leaves open is seen in the pictures of the cut where two hands "
                 "draw the lips apart, for the picture alone. Stiffness factors, which the paper "
                 "does not give, are our sessions'."
               : "Solver, contact and cut are Kerf's own; with `--published` they are the paper's.";
}

std::string headSection(const ReportData& data) {
    return "# The paper's experiments, remade\n\n"
           "The blade comes down through each body at rest, then gravity acts and the pieces fall "
           "on the floor (the paper's sections 3.1 and 3.2). Time steps and iterations are the "
           "paper's, the models are our own of the same kinds and names. " +
           methodSentence(data.published) +
           "\n\nTables and figures have the paper's numbers. A dash stands where its text, all "
           "that is known of its tables, gives no figure. Renderer: " +
           data.results.front().summary.renderer + ".\n\n";
}

/// One list of sentences for all experiments; nothing where no experiment has any.
std::string sentencesSection(const char* title, const ReportData& data,
                             std::vector<std::string> RunSummary::*sentences) {
    std::vector<std::string> items;
    for (const ExperimentResult& result : data.results) {
        for (const std::string& sentence : result.summary.*sentences) {
            items.push_back(std::string(result.paper->label) + ": " + sentence);
        }
    }
    return items.empty() ? "" : std::string("## ") + title + "\n\n" + markdownList(items);
}

}  // namespace

std::string formatExperimentReport(const ReportData& data, const ShaderInventory& shaders) {
    return headSection(data) + sentencesSection("What did not hold", data, &RunSummary::failures) +
           sentencesSection("Remarks", data, &RunSummary::remarks) + differencesSection(data) +
           methodSection(data, shaders) + cuttingSection(data) + deformationSection(data) +
           performanceSection(data) + searchSection(data) + settingsSection(data);
}

}  // namespace kerf::app
