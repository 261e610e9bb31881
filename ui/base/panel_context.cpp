#include "ui/base/panel_context.h"

#include <backends/imgui_impl_opengl3.h>

#include <stdexcept>

#include "ui/base/widgets.h"

namespace kerf::ui {

PanelContext::PanelContext(Theme theme, float scale)
    : context_(ImGui::CreateContext()), theme_(theme), scale_(scale) {
    makeCurrent();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    applyTheme(theme, scale);
    loadFont(scale, letters_);
    if (!ImGui_ImplOpenGL3_Init("#version 450 core")) {
        ImGui::DestroyContext(context_);
        throw std::runtime_error("the interface cannot use this OpenGL driver: update it");
    }
}

PanelContext::~PanelContext() {
    makeCurrent();
    ImGui_ImplOpenGL3_Shutdown();
    ImGui::DestroyContext(context_);
}

void PanelContext::makeCurrent() const {
    ImGui::SetCurrentContext(context_);
    usePalette(theme_);
}

void PanelContext::restyle(Theme theme, float scale) {
    if (theme == theme_ && scale == scale_) {
        return;
    }
    const bool otherSize = scale != scale_;
    theme_ = theme;
    scale_ = scale;
    makeCurrent();
    applyTheme(theme, scale);
    if (otherSize) {
        reloadFont();
    }
}

void PanelContext::loadNoted() {
    if (letters_.wanted()) {
        reloadFont();
    }
}

void PanelContext::reloadFont() {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    do {
        loadFont(scale_, letters_);
    } while (!letters_.build(*ImGui::GetIO().Fonts));
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

PicturePainter::PicturePainter(Theme theme, float scale) : context_(theme, scale) {
    draw(1, 1, [] {});  // fonts can be measured after a first frame
}

render::Image PicturePainter::draw(int width, int height, const std::function<void()>& content) {
    context_.makeCurrent();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    const gpu::Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, width, height);
    // A new window is laid out in its first frame and shown from the second on.
    for (int frame = 0; frame < 2; ++frame) {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        beginPanel("picture", {0, 0, io.DisplaySize.x, io.DisplaySize.y});
        content();
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

render::Image drawCaption(PicturePainter& painter, const std::string& text) {
    painter.makeCurrent();
    const ImVec2 padding = ImGui::GetStyle().WindowPadding;
    const ImVec2 size = ImGui::CalcTextSize(text.c_str());
    return painter.draw(static_cast<int>(std::ceil(size.x + 2 * padding.x)),
                        static_cast<int>(std::ceil(size.y + 2 * padding.y)),
                        [&] { ImGui::TextUnformatted(text.c_str()); });
}

}  // namespace kerf::ui
