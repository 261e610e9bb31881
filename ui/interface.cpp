#include "ui/interface.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include <algorithm>
#include <array>

#include "ui/axes_widget.h"
#include "ui/boxes_panel.h"
#include "ui/changes_panel.h"
#include "ui/help_overlay.h"
#include "ui/hint.h"
#include "ui/item_places.h"
#include "ui/layout.h"
#include "ui/menu_bar.h"
#include "ui/overlay.h"
#include "ui/parameters_panel.h"
#include "ui/pieces_panel.h"
#include "ui/plots_panel.h"
#include "ui/stages_panel.h"
#include "ui/status_bar.h"
#include "ui/theme.h"
#include "ui/toast.h"
#include "ui/tools_panel.h"
#include "ui/transport_panel.h"
#include "ui/widgets.h"
#include "ui/work_box.h"

namespace kerf::ui {
namespace {

void mapKeys(ImGuiIO& io) {
    static constexpr std::array<std::pair<int, Key>, 21> kKeys{{
        {ImGuiKey_Tab, Key::tab},
        {ImGuiKey_LeftArrow, Key::left},
        {ImGuiKey_RightArrow, Key::right},
        {ImGuiKey_UpArrow, Key::up},
        {ImGuiKey_DownArrow, Key::down},
        {ImGuiKey_PageUp, Key::pageUp},
        {ImGuiKey_PageDown, Key::pageDown},
        {ImGuiKey_Home, Key::home},
        {ImGuiKey_End, Key::end},
        {ImGuiKey_Insert, Key::insert},
        {ImGuiKey_Delete, Key::del},
        {ImGuiKey_Backspace, Key::backspace},
        {ImGuiKey_Space, Key::space},
        {ImGuiKey_Enter, Key::enter},
        {ImGuiKey_Escape, Key::escape},
        {ImGuiKey_A, Key::a},
        {ImGuiKey_C, Key::c},
        {ImGuiKey_V, Key::v},
        {ImGuiKey_X, Key::x},
        {ImGuiKey_Y, Key::y},
        {ImGuiKey_Z, Key::z},
    }};
    for (const auto& [imguiKey, key] : kKeys) {
        io.KeyMap[imguiKey] = static_cast<int>(key);
    }
}

void applyModifiers(ImGuiIO& io, const Modifiers& modifiers) {
    io.KeyShift = modifiers.shift;
    io.KeyCtrl = modifiers.control;
    io.KeyAlt = modifiers.alt;
}

struct Feed {
    ImGuiIO& io;

    void operator()(const PointerMove& e) const {
        io.MousePos = {static_cast<float>(e.x), static_cast<float>(e.y)};
        applyModifiers(io, e.modifiers);
    }
    void operator()(const ButtonChange& e) const {
        io.MouseDown[static_cast<int>(e.button)] = e.down;
        applyModifiers(io, e.modifiers);
    }
    void operator()(const Wheel& e) const {
        io.MouseWheelH += static_cast<float>(e.x);
        io.MouseWheel += static_cast<float>(e.y);
    }
    void operator()(const KeyChange& e) const {
        io.KeysDown[static_cast<int>(e.key)] = e.down;
        applyModifiers(io, e.modifiers);
    }
    void operator()(const Character& e) const { io.AddInputCharacter(e.code); }
    void operator()(const FileDrop&) const {}
    void operator()(const FocusLost&) const {
        std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
        std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
        applyModifiers(io, {});
    }
};

void drawControls(const PanelModel& model, const Rect& rect, std::vector<Action>& actions) {
    beginPanel("controls", rect, true);
    drawMenuBar(model, actions);
    drawTransport(model, actions);
    drawTools(model, actions);
    drawParameters(model, actions);
    drawPieces(model);
    ImGui::End();
}

void drawReadings(const PanelModel& model, const Rect& rect, std::vector<Action>& actions) {
    beginPanel("plots", rect);
    drawPlots(model, 0.62F * ImGui::GetContentRegionAvail().y);
    if (ImGui::BeginTabBar("readings")) {
        if (ImGui::BeginTabItem("Times")) {
            drawStages(model.stages, model.subdivisions);
            ImGui::EndTabItem();
        }
        if (ImGui::BeginTabItem("History")) {
            drawChanges(model, actions);
            ImGui::EndTabItem();
        }
        const bool boxesOpen = ImGui::BeginTabItem("Boxes");
        noteItem("tab.Boxes");
        if (boxesOpen) {
            drawBoxes(model, actions);
            ImGui::EndTabItem();
        }
        ImGui::EndTabBar();
    }
    ImGui::End();
}

}  // namespace

Interface::Interface(float scale) : context_(scale), scale_(scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.BackendPlatformName = "kerf input queue";
    io.ConfigInputTextCursorBlink = false;
    mapKeys(io);
}

std::vector<Action> Interface::pass(std::span<const InputEvent> events, const PanelModel& model,
                                    int width, int height, double elapsedSeconds) {
    context_.makeCurrent();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    io.DeltaTime = std::max(1e-4F, static_cast<float>(elapsedSeconds));
    for (const InputEvent& event : events) {
        std::visit(Feed{io}, event);
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();

    std::vector<Action> actions;
    const ItemNotes notes(places_);
    const Layout layout = layoutPanels(io.DisplaySize.x, io.DisplaySize.y, scale_);
    drawOverlay(model.overlay, scale_);
    drawControls(model, layout.controls, actions);
    drawReadings(model, layout.plots, actions);
    if (!model.name.empty()) {
        drawAxes(model.axes, layout.view, scale_, actions);
    }
    drawStatusBar(model, layout.status);
    drawHint(model, layout.view);
    drawWork(model.work, layout.view, actions);
    drawHelp(model, layout.view, actions);
    drawToast(model, layout.view);
    ImGui::Render();
    return actions;
}

void Interface::draw(const gpu::Framebuffer& picture) {
    context_.makeCurrent();
    picture.bind();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool Interface::ownsPointer() const {
    context_.makeCurrent();
    return ImGui::GetIO().WantCaptureMouse;
}

bool Interface::ownsKeyboard() const {
    context_.makeCurrent();
    return ImGui::GetIO().WantTextInput;
}

}  // namespace kerf::ui
