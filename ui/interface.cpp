#include "ui/interface.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "ui/over_view.h"
#include "ui/panels/panels.h"
#include "ui/state/overlay.h"

namespace kerf::ui {
namespace {

/// Without Y and Z: a text field of Dear ImGui 1.86 keeps what it could undo when its text changes
/// elsewhere, and to undo it then writes past the text, or aborts.
void mapKeys(ImGuiIO& io) {
    static constexpr std::array<std::pair<int, Key>, 19> kKeys{{
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
    /// A number that is typed would drop a comma: "0,5" be 5.
    void operator()(const Character& e) const {
        const bool isPoint = e.code == ',' && ImGui::TempInputIsActive(ImGui::GetActiveID());
        io.AddInputCharacter(isPoint ? '.' : e.code);
    }
    void operator()(const FileDrop&) const {}
    void operator()(const FocusLost&) const {
        std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
        std::fill(std::begin(io.MouseDown), std::end(io.MouseDown), false);
        applyModifiers(io, {});
    }
};

/// Whether the topmost popup is none of the dialogs.
bool hasOpenPopup() {
    const ImVector<ImGuiPopupData>& open = ImGui::GetCurrentContext()->OpenPopupStack;
    const ImGuiWindow* const top = open.empty() ? nullptr : open.back().Window;
    return top != nullptr && (top->Flags & ImGuiWindowFlags_Modal) == 0;
}

void closeTopPopup() {
    ImGui::ClosePopupToLevel(ImGui::GetCurrentContext()->OpenPopupStack.Size - 1, true);
}

/// A part of a panel under a heading or in a tab of its own.
struct PanelPart {
    const char* title;
    void (*draw)(const PanelModel& model, std::vector<Action>& actions);
    const char* id = "";  ///< of a section, in Settings::folded
    bool (*isShown)(const PanelModel& model) = [](const PanelModel&) { return true; };
};
using Actions = std::vector<Action>;

/// The sections of the left panel, from top to bottom.
constexpr std::array kSections{
    PanelPart{
        "Practice",
        [](const PanelModel& m, Actions& to) { drawPractice(m.session.practice, m.settings, to); },
        "practice",
        [](const PanelModel& m) {
            return !m.session.practice.name.empty() || m.session.practice.draft.has_value();
        }},
    PanelPart{
        "Model",
        [](const PanelModel& m, Actions& to) { drawModel(m.model, m.parameters, m.display, to); },
        "model"},
    PanelPart{"Tool", [](const PanelModel& m, Actions& to) { drawTools(m, to); }, "tools"},
    PanelPart{"Supports and loads",
              [](const PanelModel& m, Actions& to) { drawLoads(m.body.loads, to); }, "loads",
              [](const PanelModel& m) { return !m.body.loads.rows.empty(); }},
    PanelPart{"Simulation",
              [](const PanelModel& m, Actions& to) { drawParameters(m.parameters, to); },
              "simulation"},
    PanelPart{"Display", [](const PanelModel& m, Actions& to) { drawDisplay(m, to); }, "display"},
    PanelPart{"Cut quality", [](const PanelModel& m, Actions& /*to*/) { drawCuts(m.cuts); },
              "cuts"},
    PanelPart{"Paper experiments",
              [](const PanelModel& m, Actions& to) { drawExperiments(m.experiments, to); },
              "experiments"},
    PanelPart{"Settings", [](const PanelModel& m, Actions& to) { drawWindowRows(m.settings, to); },
              "window"},
};

/// The tabs of the right panel.
constexpr std::array kTabs{
    PanelPart{"Times",
              [](const PanelModel& m, Actions& /*to*/) {
                  ImGui::BeginChild("times");
                  drawStages(*m.plots.history, m.cuts.subdivisions);
                  ImGui::EndChild();
              }},
    PanelPart{"History", [](const PanelModel& m, Actions& to) { drawChanges(m, to); }},
    PanelPart{"Session", [](const PanelModel& m, Actions& to) { drawSessionMarks(m.session, to); }},
    PanelPart{"Boxes",
              [](const PanelModel& m, Actions& to) {
                  ImGui::BeginChild("boxes");
                  drawBoxes(m.body, to);
                  ImGui::EndChild();
              }},
    PanelPart{"Log", [](const PanelModel& m, Actions& /*to*/) { drawLog(m.log); }},
};

void drawSections(const PanelModel& model, float height, Actions& actions) {
    ImGui::BeginChild("sections", {0, height});
    for (const PanelPart& section : kSections) {
        if (section.isShown(model) &&
            beginSection(section.id, section.title, model.settings, actions)) {
            section.draw(model, actions);
        }
    }
    ImGui::EndChild();
}

/// The rest of a panel, divided by a bar that can be dragged: the height of the upper part for
/// the share that the lower one has.
struct Division {
    float top = 0;     ///< on the screen [px]
    float height = 0;  ///< of both parts [px]

    static Division ofTheRest() {
        return {ImGui::GetCursorScreenPos().y, ImGui::GetContentRegionAvail().y - splitterHeight()};
    }
    /// The upper part keeps a few lines, the lower one `lower` of them.
    float upper(double share, float lower) const {
        const float line = ImGui::GetTextLineHeightWithSpacing();
        const float least = 4 * line;
        return std::clamp(static_cast<float>(share) * height, least,
                          std::max(least, height - lower * line));
    }
};

constexpr float kLeastPieces = 6;  // lines: a heading, a slider, another heading, three rows
constexpr float kLeastTabs = 4;    // lines

void drawControls(const PanelModel& model, const Rect& rect, std::vector<Action>& actions) {
    beginPanel("controls", rect, true);
    drawMenuBar(model, actions);
    drawTransport(model, actions);
    const Division division = Division::ofTheRest();
    const float upper = std::max(division.upper(1 - model.settings.piecesShare, kLeastPieces),
                                 division.height - piecesHeight(model.pieces, model.display));
    drawSections(model, upper, actions);
    if (const auto share = horizontalSplitter("pieces", division.top, division.height)) {
        Settings settings = model.settings;
        settings.piecesShare = 1 - *share;
        actions.emplace_back(SetSettings{settings});
    }
    drawPieces(model.pieces, model.display, actions);
    ImGui::End();
}

/// Calls `begin` for one of many tabs: its name needs the room more than its sides do.
template <class Begin>
bool narrowly(Begin begin) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                        {style.FramePadding.x / 3, style.FramePadding.y});
    ImGui::PushStyleVar(ImGuiStyleVar_ItemInnerSpacing,
                        {style.ItemInnerSpacing.x / 2, style.ItemInnerSpacing.y});
    const bool open = begin();
    ImGui::PopStyleVar(2);
    return open;
}

bool beginTab(const char* name) {
    const bool open = narrowly([name] { return ImGui::BeginTabItem(name); });
    noteItem(std::string("tab.") + name);
    return open;
}

void drawTabs(const PanelModel& model, std::vector<Action>& actions) {
    if (!narrowly([] { return ImGui::BeginTabBar("readings"); })) {
        return;
    }
    for (const PanelPart& tab : kTabs) {
        if (beginTab(tab.title)) {
            tab.draw(model, actions);
            ImGui::EndTabItem();
        }
    }
    ImGui::EndTabBar();
}

void drawReadings(const PanelModel& model, const Rect& rect, std::vector<Action>& actions) {
    beginPanel("readings", rect);
    const Division division = Division::ofTheRest();
    drawPlots(model.plots, model.transport, model.settings,
              division.upper(model.settings.plotsShare, kLeastTabs), actions);
    if (const auto share = horizontalSplitter("plots", division.top, division.height)) {
        Settings settings = model.settings;
        settings.plotsShare = *share;
        actions.emplace_back(SetSettings{settings});
    }
    drawTabs(model, actions);
    ImGui::End();
}

/// Texts that may hold names of people's files, in any script.
void noteNames(const PanelModel& model, PanelContext& context) {
    const FileDialogState& files = model.files;
    context.note(model.name + model.toast.text + model.question.title + model.question.text +
                 model.work.title + files.name + files.problem + files.folder.string());
    std::ranges::for_each(files.rows, [&](const FileRow& row) { context.note(row.name); });
    for (const FolderLink& link : files.bookmarks) {
        context.note(link.label);
    }
    for (const std::filesystem::path& file : files.recent) {
        context.note(file.native());
    }
    std::ranges::for_each(model.log, [&](const LogLine& line) { context.note(line.text); });
}

/// Panels, bars, and what is drawn over the view.
void drawAroundView(const PanelModel& model, const Layout& layout, float scale,
                    std::vector<Action>& actions) {
    drawOverlay(model.view.overlay, scale);
    if (model.settings.showControls) {
        drawControls(model, layout.controls, actions);
    }
    if (model.settings.showReadings) {
        drawReadings(model, layout.plots, actions);
    }
    drawEdges(model.settings, layout, scale, actions);
    drawPanelsHint(model.settings, layout.view, actions);
    if (!model.name.empty() || model.looks.showsFaulty) {
        drawLegend(model.looks, model.display, layout.view, hasRoomForAxes(layout.view, scale),
                   scale);
        drawAxes(model.view.axes, layout.view, scale, actions);
    }
    if (layout.timeline.height > 0) {
        drawTimeline(model.session, layout.timeline, actions);
    }
    drawStatusBar(model, layout.status);
    drawHint(model, layout.view, actions);
}

}  // namespace

Interface::Interface(Theme theme, float scale) : context_(theme, scale) {
    ImGuiIO& io = ImGui::GetIO();
    io.BackendPlatformName = "kerf input queue";
    io.ConfigInputTextCursorBlink = false;
    io.ConfigDragClickToInputText = true;
    mapKeys(io);
}

std::vector<Action> Interface::update(std::span<const InputEvent> events, const PanelModel& model,
                                      int width, int height, double elapsedSeconds) {
    context_.makeCurrent();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {std::max(static_cast<float>(width), kLeastScale * kLeastWidth),
                      std::max(static_cast<float>(height), kLeastScale * kLeastHeight)};
    io.DeltaTime = std::max(1e-4F, static_cast<float>(elapsedSeconds));
    noteNames(model, context_);
    context_.loadNoted();
    closesPopup_ = false;
    for (const InputEvent& event : events) {
        feed(event);
    }
    ImGui_ImplOpenGL3_NewFrame();
    ImGui::NewFrame();
    if (closesPopup_) {
        closeTopPopup();
    }

    std::vector<Action> actions;
    const ItemNotes notes(itemRects_);
    const float scale = context_.scale();
    const bool timed = !model.name.empty() && model.settings.showsPanels();
    const Layout layout =
        layoutPanels(io.DisplaySize.x, io.DisplaySize.y, scale, model.settings, timed);
    noteCovered(model.settings, layout);
    freeView_ = layout.view;
    timeline_ = layout.timeline;
    if (model.help.start.cards != nullptr && !model.looks.showsFaulty) {
        startPage_.draw(model.help.start, model.files.recent, actions);
        covered_.clear();
    } else {
        drawAroundView(model, layout, scale, actions);
        const ImGuiWindow* const hint = ImGui::FindWindowByName("hint");
        const bool hinted = hint != nullptr && hint->Active && !model.name.empty();
        hintHeight_ = hinted ? layout.view.y + layout.view.height - hint->Pos.y : 0;
    }
    drawWork(model.work, layout.view, actions);
    drawHelp(model, actions);
    commandBox_.draw(model, actions);
    fileDialog_.draw(model.files, actions);
    questionBox_.draw(model.question, layout.view, actions);
    drawToast(model.toast, layout.view, actions);
    ImGui::Render();
    return actions;
}

/// Esc closes an open menu, list or popup, and means nothing else then. Dialogs answer it
/// themselves.
void Interface::feed(const InputEvent& event) {
    const auto* key = std::get_if<KeyChange>(&event);
    const bool escapes = key != nullptr && key->down && key->key == Key::escape;
    if (escapes && hasOpenPopup()) {
        closesPopup_ = true;
    } else {
        std::visit(Feed{ImGui::GetIO()}, event);
    }
}

void Interface::noteCovered(const Settings& settings, const Layout& layout) {
    covered_ = {layout.status};
    if (layout.timeline.height > 0) {
        covered_.push_back(layout.timeline);
    }
    if (settings.showControls) {
        covered_.push_back(layout.controls);
    }
    if (settings.showReadings) {
        covered_.push_back(layout.plots);
    }
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

bool Interface::pointsBesideQuestion() const {
    context_.makeCurrent();
    const ImVec2 at = ImGui::GetIO().MousePos;
    return freeView_.holds(at.x, at.y) && questionBox_.leavesOpen(at.x, at.y);
}

Cursor Interface::cursor() const {
    context_.makeCurrent();
    switch (ImGui::GetMouseCursor()) {
        case ImGuiMouseCursor_TextInput:
            return Cursor::text;
        case ImGuiMouseCursor_ResizeEW:
            return Cursor::resizeX;
        case ImGuiMouseCursor_ResizeNS:
            return Cursor::resizeY;
        case ImGuiMouseCursor_Hand:
            return Cursor::hand;
        default:
            return Cursor::arrow;
    }
}

bool Interface::isDragging() const {
    context_.makeCurrent();
    return ImGui::IsAnyItemActive();
}

bool Interface::ownsKeyboard() const {
    context_.makeCurrent();
    return closesPopup_ || ImGui::GetIO().WantTextInput || fileDialog_.isOpen() ||
           questionBox_.isOpen() || commandBox_.isOpen();
}

bool Interface::ownsKey(Key key) const {
    constexpr std::array kTimelineKeys{Key::home, Key::end, Key::left, Key::right};
    context_.makeCurrent();
    const ImVec2 at = ImGui::GetIO().MousePos;
    return std::ranges::count(kTimelineKeys, key) > 0 && timeline_.holds(at.x, at.y);
}

}  // namespace kerf::ui
