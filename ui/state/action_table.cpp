#include "ui/state/action_table.h"

#include "sim/base/text.h"
#include "ui/state/panel_model.h"

namespace kerf::ui {
namespace {

// The words of the rows.
constexpr Modifiers kPlain{};
constexpr Modifiers kShift{.shift = true};
constexpr Modifiers kControl{.control = true};
constexpr Modifiers kControlShift{.shift = true, .control = true};

constexpr Shortcut at(Key key, const Modifiers& modifiers, std::string_view text) {
    return {key, modifiers, text};
}
constexpr bool always(const PanelModel& /*model*/) {
    return true;
}
bool withBody(const PanelModel& model) {
    return !model.name.empty();
}
template <ToolKind tool>
bool holds(const PanelModel& model) {
    return model.tools.tool == tool;
}
template <bool DisplaySettings::*member>
bool shows(const PanelModel& model) {
    return model.display.*member;
}
template <bool render::Overlays::*member>
bool draws(const PanelModel& model) {
    return model.display.overlays.*member;
}

/// All actions except those that select a tool, in the order of the menus.
constexpr std::array kOtherActions{
    ActionRow{ActionId::newScene, at(Key::n, kControl, "Ctrl+N"), "New...", "File", always},
    ActionRow{ActionId::openFile, at(Key::o, kControl, "Ctrl+O"), "Open...", "File", always},
    ActionRow{ActionId::addModel, at(Key::o, kControlShift, "Ctrl+Shift+O"), "Add model...", "File",
              withBody},
    ActionRow{ActionId::reloadModels, at(Key::f5, kPlain, "F5"), "Reload models", "File", withBody},
    ActionRow{ActionId::saveSession, at(Key::s, kControl, "Ctrl+S"), "Save", "File", withBody},
    ActionRow{ActionId::saveSessionAs, at(Key::s, kControlShift, "Ctrl+Shift+S"), "Save as...",
              "File", withBody},
    ActionRow{ActionId::saveTest, at(Key::t, kControl, "Ctrl+T"), "Save as test...", "File",
              withBody},
    ActionRow{ActionId::makeTask, {}, "Make a task of this cut", "File", withBody},
    ActionRow{ActionId::exportBody, at(Key::e, kControl, "Ctrl+E"), "Export model...", "File",
              withBody},
    ActionRow{ActionId::makeFilm, at(Key::m, kControl, "Ctrl+M"), "Export video...", "File",
              withBody},
    ActionRow{ActionId::screenshot, at(Key::f12, kPlain, "F12"), "Save screenshot", "File", always},
    ActionRow{ActionId::sceneScreenshot, at(Key::f12, kControl, "Ctrl+F12"),
              "Save screenshot without background", "File", withBody},
    ActionRow{ActionId::quit, at(Key::q, kControl, "Ctrl+Q"), "Quit", "File", always},
    ActionRow{ActionId::undo, at(Key::z, kControl, "Ctrl+Z"), "Undo", "Edit",
              [](const PanelModel& m) { return m.changes.done > 0 || m.changes.recallable; }},
    ActionRow{ActionId::redo, at(Key::z, kControlShift, "Ctrl+Shift+Z"), "Redo", "Edit",
              [](const PanelModel& m) { return m.changes.done < m.changes.rows.size(); }, nullptr,
              at(Key::y, kControl, "Ctrl+Y")},
    ActionRow{ActionId::cancel, at(Key::escape, kPlain, "Esc"), "Cancel", "Edit", withBody},
    ActionRow{ActionId::toggleGravity, at(Key::v, kPlain, "V"), "Gravity", "Edit", withBody,
              [](const PanelModel& m) { return m.parameters.now.gravity.norm() > 0; }},
    ActionRow{ActionId::remesh, at(Key::r, kShift, "Shift+R"), "Remesh", "Edit", withBody},
    ActionRow{ActionId::remeshCoarser, at(Key::r, kControlShift, "Ctrl+Shift+R"),
              "Remesh to about 5,000 triangles", "Edit",
              [](const PanelModel& m) { return m.body.triangles > kFewTriangles; }},
    ActionRow{ActionId::partModel, at(Key::o, kShift, "Shift+O"), "Split into models", "Edit",
              [](const PanelModel& m) { return m.model.objects > 1; }},
    ActionRow{ActionId::deleteSelected, at(Key::del, kPlain, "Delete"),
              "Delete selected, or a retractor", "Edit",
              [](const PanelModel& m) {
                  return m.body.hooks > 0 || m.body.loads.selected >= 0 || m.pieces.selected >= 0;
              }},
    ActionRow{
        ActionId::bringDown, at(Key::enter, kPlain, "Enter"), "Drop the guillotine", "Tool",
        [](const PanelModel& m) { return withBody(m) && !rowOf(m.tools.tool).trigger.empty(); }},
    ActionRow{ActionId::freePins, at(Key::p, kShift, "Shift+P"), "Unpin all", "Tool",
              [](const PanelModel& m) { return m.body.pinned > 0; }},
    ActionRow{ActionId::link, at(Key::l, kControl, "Ctrl+L"), "Link to other programs", "Tool",
              withBody, [](const PanelModel& m) { return !m.view.link.empty(); }},
    ActionRow{ActionId::playPause, at(Key::space, kPlain, "Space"), "Play or pause", "Time",
              withBody, [](const PanelModel& m) { return m.transport.playing; }},
    ActionRow{ActionId::letFall, at(Key::space, kShift, "Shift+Space"),
              "Let it fall (gravity and play)", "Time", withBody},
    ActionRow{ActionId::timeWhileCutting, at(Key::t, kShift, "Shift+T"), "Time runs while cutting",
              "Time", always, [](const PanelModel& m) { return m.settings.timeRunsWhileCutting; }},
    ActionRow{ActionId::stepOnce, at(Key::period, kPlain, "."), "Next step", "Time", withBody},
    ActionRow{ActionId::reset, at(Key::r, kPlain, "R"), "Restart", "Time", withBody},
    ActionRow{ActionId::finishTry, at(Key::enter, kShift, "Shift+Enter"), "Finish the try", "Time",
              [](const PanelModel& m) { return !m.session.practice.name.empty(); }},
    ActionRow{ActionId::slower, at(Key::minus, kPlain, "-"), "Half speed", "Time", withBody},
    ActionRow{ActionId::faster, at(Key::equal, kPlain, "="), "Double speed", "Time", withBody},
    ActionRow{ActionId::record, at(Key::r, kControl, "Ctrl+R"), "Start or stop recording", "Time",
              withBody, [](const PanelModel& m) { return m.transport.recording; }},
    ActionRow{ActionId::loop, at(Key::l, kPlain, "L"), "Loop session", "Time",
              [](const PanelModel& m) { return m.session.playback.steps > 0; },
              [](const PanelModel& m) { return m.session.playback.loop; }},
    ActionRow{ActionId::addPicture, at(Key::f12, kShift, "Shift+F12"), "Add picture of this step",
              "Time", withBody},
    ActionRow{ActionId::addCheck, at(Key::c, kShift, "Shift+C"), "Add check of this step", "Time",
              withBody},
    ActionRow{ActionId::addExport, at(Key::e, kShift, "Shift+E"), "Add export of this step", "Time",
              withBody},
    ActionRow{ActionId::addCamera, at(Key::m, kShift, "Shift+M"), "Add camera keyframe", "Time",
              withBody},
    ActionRow{ActionId::addMark, at(Key::n, kShift, "Shift+N"), "Name this step", "Time", withBody},
    ActionRow{ActionId::useView, at(Key::home, kShift, "Shift+Home"),
              "Use this view for session pictures", "Time", withBody},
    ActionRow{ActionId::frameBody, at(Key::f, kPlain, "F"), "Frame model", "View", withBody},
    ActionRow{ActionId::resetView, at(Key::home, kPlain, "Home"), "Reset view", "View", withBody},
    ActionRow{ActionId::viewFront, at(Key::digit1, kPlain, "1"), "Front view", "View", withBody},
    ActionRow{ActionId::viewBack, at(Key::digit1, kControl, "Ctrl+1"), "Back view", "View",
              withBody},
    ActionRow{ActionId::viewRight, at(Key::digit3, kPlain, "3"), "Right view", "View", withBody},
    ActionRow{ActionId::viewLeft, at(Key::digit3, kControl, "Ctrl+3"), "Left view", "View",
              withBody},
    ActionRow{ActionId::viewTop, at(Key::digit7, kPlain, "7"), "Top view", "View", withBody},
    ActionRow{ActionId::viewBottom, at(Key::digit7, kControl, "Ctrl+7"), "Bottom view", "View",
              withBody},
    ActionRow{ActionId::orthographic, at(Key::digit5, kPlain, "5"), "Orthographic", "View",
              withBody, [](const PanelModel& m) { return m.view.orthographic; }},
    ActionRow{ActionId::wireframe, at(Key::w, kPlain, "W"), "Wireframe", "View", withBody,
              shows<&DisplaySettings::wireframe>},
    ActionRow{ActionId::showCutLines, at(Key::t, kPlain, "T"), "Cut outlines", "View", withBody,
              shows<&DisplaySettings::cutLines>},
    ActionRow{ActionId::showAhead, at(Key::w, kShift, "Shift+W"), "Cut preview", "View", withBody,
              shows<&DisplaySettings::cutAhead>},
    ActionRow{ActionId::showApart, at(Key::a, kPlain, "A"), "Show pieces apart", "View",
              [](const PanelModel& m) { return m.pieces.rows.size() > 1; },
              [](const PanelModel& m) { return m.display.apart > 0; }},
    ActionRow{ActionId::showEdges, at(Key::e, kPlain, "E"), "Edge springs", "View", withBody,
              draws<&render::Overlays::edges>},
    ActionRow{ActionId::showBends, at(Key::b, kPlain, "B"), "Bending", "View", withBody,
              draws<&render::Overlays::bends>},
    ActionRow{ActionId::showIspcs, at(Key::i, kPlain, "I"), "Internal springs", "View", withBody,
              draws<&render::Overlays::ispcs>},
    ActionRow{ActionId::showErrors, at(Key::x, kPlain, "X"), "Constraint error", "View", withBody,
              draws<&render::Overlays::errors>},
    ActionRow{ActionId::showContacts, at(Key::k, kPlain, "K"), "Contacts", "View", withBody,
              draws<&render::Overlays::contacts>},
    ActionRow{ActionId::showBoxes, at(Key::o, kPlain, "O"), "Bounding boxes", "View", withBody,
              draws<&render::Overlays::boxes>},
    ActionRow{
        ActionId::nextField, at(Key::j, kPlain, "J"), "Next colouring", "View", withBody,
        [](const PanelModel& m) { return m.display.field.field != render::SurfaceField::look; }},
    ActionRow{ActionId::section, at(Key::n, kPlain, "N"), "Section plane", "View", withBody,
              [](const PanelModel& m) { return m.display.section.has_value(); }},
    ActionRow{ActionId::fineQuality, at(Key::q, kPlain, "Q"), "High quality", "View", withBody,
              [](const PanelModel& m) { return m.display.quality == render::Quality::full; }},
    ActionRow{ActionId::togglePanels, at(Key::tab, kPlain, "Tab"), "Show panels", "View", always,
              [](const PanelModel& m) { return m.settings.showsPanels(); }},
    ActionRow{ActionId::lightTheme,
              {},
              "Light theme",
              "View",
              always,
              [](const PanelModel& m) { return m.settings.theme == Theme::light; }},
    ActionRow{ActionId::holdPlots, at(Key::h, kPlain, "H"), "Hold plots", "View", withBody,
              [](const PanelModel& m) { return m.plots.view.end.has_value(); }},
    ActionRow{ActionId::fitPlots, at(Key::h, kShift, "Shift+H"), "Show plots from the start",
              "View", withBody},
    ActionRow{ActionId::findCommand, at(Key::p, kControl, "Ctrl+P"), "Find a command...", "Help",
              always},
    ActionRow{ActionId::help, at(Key::f1, kPlain, "F1"), "Keyboard shortcuts", "Help", always,
              [](const PanelModel& m) { return m.help.open; }, at(Key::questionMark, kPlain, "?")},
    ActionRow{ActionId::manual, {}, "Manual", "Help", always},
    ActionRow{ActionId::about, {}, "About Kerf", "Help", always},
};

/// All actions in the order of the menus.
constexpr auto kActions = withTools(kOtherActions, []<ToolKind tool>() {
    const ToolRow& row = rowOf(tool);
    return ActionRow{actionOf(tool), at(row.key, kPlain, row.keyText), row.label, "Tool", withBody,
                     holds<tool>};
});

static_assert(coversActions(kActions), "an ActionId has no row in kActions, or not at its place");

/// "Right drag, Alt+left drag"
std::string dragsThat(ViewMotion motion, MouseScheme scheme) {
    std::vector<std::string> names;
    for (const ViewDrag& drag : rowOf(scheme).drags) {
        if (drag.motion == motion) {
            names.emplace_back(drag.name);
        }
    }
    return joined(names, ", ");
}

}  // namespace

std::string nameOf(Key key) {
    constexpr std::string_view kNames = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
    const auto i = static_cast<std::size_t>(key) - static_cast<std::size_t>(Key::a);
    return i < kNames.size() ? std::string(1, kNames[i])
                             : "F" + std::to_string(1 + i - kNames.size());
}

std::optional<Shortcut> shortcutOf(std::string_view text) {
    std::string_view rest = text;
    const auto strip = [&rest](std::string_view name) {
        const bool there = rest.starts_with(name);
        rest.remove_prefix(there ? name.size() : 0);
        return there;
    };
    Modifiers held;
    held.control = strip("Ctrl+");
    held.shift = strip("Shift+");
    for (const Key key : kNamedKeys) {
        if (rest == nameOf(key)) {
            return Shortcut{key, held, text};
        }
    }
    return std::nullopt;
}

namespace {

std::map<std::string, std::string> ownKeys;  // what the rows below refer to
auto actionsNow = kActions;

}  // namespace

std::span<const ActionRow> actionTable() {
    return actionsNow;
}

void takeKeys(const std::map<std::string, std::string>& keys) {
    if (keys == ownKeys) {
        return;
    }
    ownKeys = keys;
    actionsNow = kActions;
    const auto eachOwn = [](auto change) {
        for (ActionRow& row : actionsNow) {
            if (const auto own = ownKeys.find(std::string(row.label)); own != ownKeys.end()) {
                change(row, own->second);
            }
        }
    };
    eachOwn([](ActionRow& row, const std::string&) { row.shortcut = {}; });  // free for another
    eachOwn([](ActionRow& row, const std::string& text) {
        const std::optional<Shortcut> wanted = shortcutOf(text);
        if (wanted && !findAction(wanted->key, wanted->modifiers)) {
            row.shortcut = *wanted;
        }
    });
}

std::vector<PointerHint> pointerTable(MouseScheme scheme) {
    const std::string zoom = dragsThat(ViewMotion::zoom, scheme);
    return {
        {"Left drag", "Use the tool"},
        {"Shift+left drag", "Stroke: 15\u00b0 steps. Pin: box"},
        {"Ctrl+left drag", "Pin: unpin. Move: snap"},
        {"Right-click a hook", "Remove retractor"},
        {"Right-click a pin, force or hand", "Select it in the list"},
        {dragsThat(ViewMotion::orbit, scheme), "Rotate view"},
        {dragsThat(ViewMotion::pan, scheme), "Pan view"},
        {zoom.empty() ? "Wheel" : "Wheel, " + zoom, "Zoom at pointer"},
        {"Wheel while the scalpel cuts", "Change its depth"},
        {"Click a number", "Type a value, such as 5 mm: Enter accepts it, Esc keeps the old one"},
        {"Wheel, drag over a plot", "Zoom and scroll in time"},
        {"Double-click a plot", "Show from the start"},
        {"Drag a panel edge", "Resize panel"},
        {"Drop a file", "Open model or session"},
    };
}

std::optional<ActionId> findAction(Key key, Modifiers modifiers) {
    for (const ActionRow& row : actionsNow) {
        if (row.shortcut.presses(key, modifiers) || row.second.presses(key, modifiers)) {
            return row.id;
        }
    }
    return std::nullopt;
}

std::string keysOf(ActionId id) {
    const std::string_view second = rowOf(id).second.text;
    return std::string(keyOf(id)) + (second.empty() ? "" : ", " + std::string(second));
}

std::string actionsAsMarkdown() {
    std::string text = "| keys | what they do |\n|---|---|\n";
    const auto addRow = [&](std::string_view keys, std::string_view label) {
        text.append("| ").append(keys).append(" | ").append(label).append(" |\n");
    };
    for (const PointerHint& hint : pointerTable(MouseScheme::kerf)) {
        addRow(hint.gesture, hint.label);
    }
    for (const ActionRow& row : kActions) {
        if (!row.shortcut.text.empty()) {
            addRow(keysOf(row.id), row.label);
        }
    }
    return text;
}

std::string describeAction(ActionId id) {
    return std::string(rowOf(id).label) + " (" + std::string(keyOf(id)) + ")";
}

}  // namespace kerf::ui
