#include "ui/panel_context.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <stdexcept>

#include "ui/theme.h"

namespace kerf::ui {

PanelContext::PanelContext(float scale) : context_(ImGui::CreateContext()) {
    makeCurrent();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    applyTheme(scale);
    loadFont(scale);
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
}

}  // namespace kerf::ui
