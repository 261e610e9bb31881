#include "ui/base/panel_context.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <stdexcept>

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

}  // namespace kerf::ui
