#include "ui/plot_picture.h"

#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#include <imgui.h>

#include "gpu/framebuffer.h"
#include "ui/widgets.h"

namespace kerf::ui {
namespace {

void drawAll(std::span<const PlotSpec> plots, const PlotView& view) {
    const PlotTimeline timeline{view, newestOf(plots), false};
    const float gaps = ImGui::GetStyle().ItemSpacing.y * static_cast<float>(plots.size());
    const float room = ImGui::GetContentRegionAvail().y - gaps;
    for (const PlotSpec& plot : plots) {
        drawPlot(plot, timeline, room / static_cast<float>(plots.size()));
    }
}

// [pixels]
constexpr int kSheetMargin = 16;  // around the panels and between them
constexpr int kSheetTitle = 30;   // the line of the title

/// A panel in a child window of its own, whose width the plot fills.
void drawPanel(const PlotSheet& sheet, int number, float top, const PlotTimeline& timeline) {
    const int column = number % sheet.columns;
    const int row = number / sheet.columns;
    ImGui::SetCursorPos(
        {static_cast<float>(kSheetMargin + column * (sheet.panelWidth + kSheetMargin)),
         top + static_cast<float>(row * (sheet.panelHeight + kSheetMargin))});
    ImGui::PushID(number);
    ImGui::BeginChild(
        "panel", {static_cast<float>(sheet.panelWidth), static_cast<float>(sheet.panelHeight)});
    drawPlot(sheet.panels[static_cast<std::size_t>(number)], timeline,
             static_cast<float>(sheet.panelHeight));
    ImGui::EndChild();
    ImGui::PopID();
}

void drawSheet(const PlotSheet& sheet) {
    const PlotTimeline timeline{{}, newestOf(sheet.panels), false};
    ImGui::SetCursorPos({kSheetMargin, kSheetMargin});
    ImGui::TextUnformatted(sheet.title.c_str());
    const auto top = static_cast<float>(kSheetMargin + kSheetTitle);
    for (int number = 0; number < static_cast<int>(sheet.panels.size()); ++number) {
        drawPanel(sheet, number, top, timeline);
    }
}

}  // namespace

PlotPainter::PlotPainter(Theme theme) : context_(theme, 1) {}

render::Image PlotPainter::draw(std::span<const PlotSpec> plots, const PlotView& view, int width,
                                int height) {
    return drawPicture([&] { drawAll(plots, view); }, width, height);
}

render::Image PlotPainter::draw(const PlotSheet& sheet) {
    const auto rows = (static_cast<int>(sheet.panels.size()) + sheet.columns - 1) / sheet.columns;
    return drawPicture([&] { drawSheet(sheet); },
                       kSheetMargin + sheet.columns * (sheet.panelWidth + kSheetMargin),
                       kSheetMargin + kSheetTitle + rows * (sheet.panelHeight + kSheetMargin));
}

render::Image PlotPainter::drawPicture(const std::function<void()>& drawContent, int width,
                                       int height) {
    context_.makeCurrent();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    const gpu::Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, width, height);
    // A new window is laid out in its first frame and shown from the second on.
    for (int frame = 0; frame < 2; ++frame) {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        beginPanel("plots", {0, 0, io.DisplaySize.x, io.DisplaySize.y});
        drawContent();
        ImGui::End();
        ImGui::Render();
    }
    glUseProgram(0);  // ImGui brings back the one in use, which its owner may have deleted
    picture.bind();
    const ImVec4 ground = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);  // behind round corners
    glClearColor(ground.x, ground.y, ground.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return {width, height, picture.readColor()};
}

}  // namespace kerf::ui
