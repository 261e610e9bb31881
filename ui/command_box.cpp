#include "ui/command_box.h"

#include <imgui.h>

#include <sstream>

#include "sim/base/text.h"
#include "ui/base/layout.h"
#include "ui/base/widgets.h"
#include "ui/panels/panels.h"
#include "ui/state/action_table.h"

namespace kerf::ui {
namespace {

/// Something that can be found by its name.
struct Row {
    std::string name;
    std::string aside;  ///< its keys, or what it is
    std::string why;    ///< it can't be done now; "" where it can
    Action action;
    std::string field = {};  ///< that it shows in its panel
};

/// Why nothing can be done with a body; "" where there is one.
std::string whyNoBody(const PanelModel& model) {
    const bool covered = model.help.start.cards != nullptr;
    return model.name.empty() ? "Nothing is open" : covered ? "Close the start page first" : "";
}

std::string whyNot(const PanelModel& model, const ActionRow& row) {
    static const PanelModel kNothing{};
    const std::string noBody = whyNoBody(model);
    const bool can = row.available(noBody.empty() ? model : kNothing);
    return can ? "" : noBody.empty() ? "Not available now" : noBody;
}

std::vector<Row> allRows(const PanelModel& model) {
    std::vector<Row> rows;
    for (const ActionRow& row : actionTable()) {
        rows.push_back({std::string(row.label), keysOf(row.id), whyNot(model, row), row.id});
    }
    SetSettings unfolded{model.settings};
    unfolded.settings.showControls = true;
    std::erase(unfolded.settings.folded, "simulation");
    for (const ParamInfo& info : paramTable()) {
        const bool used = isShown(info, model.parameters.now);
        rows.push_back({std::string(info.label), "Parameter",
                        used ? whyNoBody(model) : "Not used by this body", unfolded,
                        "param." + std::string(info.name)});
    }
    for (std::size_t i = 0; i < model.help.samples->size(); ++i) {
        rows.push_back({(*model.help.samples)[i].title, "Sample", "", OpenStartScene{i}});
    }
    return rows;
}

/// Whether a name holds all words, in any order.
bool holdsAll(const std::string& name, const char* words) {
    std::istringstream each(lowerCase(words));
    return std::all_of(std::istream_iterator<std::string>(each), {}, [&](const std::string& word) {
        return lowerCase(name).find(word) != std::string::npos;
    });
}

/// None of a parameter or a sample.
std::optional<ActionId> actionIn(const Row& row) {
    const auto* id = std::get_if<ActionId>(&row.action);
    return id == nullptr ? std::nullopt : std::optional(*id);
}

/// Returns whether it was clicked.
bool drawRow(const Row& row, bool chosen) {
    const int dim = row.why.empty() ? 0 : ImGuiSelectableFlags_Disabled;
    const std::string id = row.name + "###" + row.aside + row.name;
    const bool clicked =
        ImGui::Selectable(id.c_str(), chosen, dim | ImGuiSelectableFlags_DontClosePopups);
    noteItem("command." + row.name);
    ImGui::SameLine();
    ImGui::BeginDisabled();
    textRight(row.why.empty() ? row.aside : row.why);
    ImGui::EndDisabled();
    return clicked;
}

/// What is pressed, such as "Ctrl+M"; "" for none of kNamedKeys.
std::string pressedKeys() {
    const auto key = std::ranges::find_if(kNamedKeys, isPressed);
    const ImGuiIO& io = ImGui::GetIO();
    return key == kNamedKeys.end() ? ""
                                   : std::string(io.KeyCtrl ? "Ctrl+" : "") +
                                         (io.KeyShift ? "Shift+" : "") + nameOf(*key);
}

}  // namespace

void CommandBox::drawKeys(const PanelModel& model, std::vector<Action>& actions) {
    const std::string name(rowOf(*keyed_).label);
    textWrapped("Press the new keys of \u201c" + name +
                "\u201d: a letter, a digit or F1 to F12, with Ctrl, Shift or both.");
    textWrapped("Backspace restores its own. Esc keeps " +
                (keysOf(*keyed_).empty() ? "it without" : keysOf(*keyed_)) + ".");
    textWrapped(refused_);
    SetSettings wanted{model.settings};
    if (keyPressed(ImGuiKey_Escape)) {
        keyed_.reset();
    } else if (keyPressed(ImGuiKey_Backspace)) {
        wanted.settings.keys.erase(name);
        actions.emplace_back(wanted);
        keyed_.reset();
    } else if (const std::string keys = pressedKeys(); !keys.empty()) {
        const Shortcut pressed = *shortcutOf(keys);
        const std::optional<ActionId> other = findAction(pressed.key, pressed.modifiers);
        if (other && other != keyed_) {
            refused_ = keys + " belongs to \u201c" + std::string(rowOf(*other).label) + "\u201d.";
            return;
        }
        wanted.settings.keys[name] = keys;
        actions.emplace_back(wanted);
        keyed_.reset();
    }
}

void CommandBox::drawFound(const PanelModel& model, std::vector<Action>& actions) {
    std::vector<Row> rows = allRows(model);
    std::erase_if(rows, [&](const Row& row) { return !holdsAll(row.name, words_.data()); });
    const int step = int{keyPressed(ImGuiKey_DownArrow, true)} - keyPressed(ImGuiKey_UpArrow, true);
    chosen_ = std::clamp(chosen_ + step, 0, std::max(0, static_cast<int>(rows.size()) - 1));
    ImGui::BeginChild("found");
    for (int i = 0; i < static_cast<int>(rows.size()); ++i) {
        const bool enters = i == chosen_ && keyPressed(ImGuiKey_Enter);
        if ((drawRow(rows[i], i == chosen_) || enters) && rows[i].why.empty()) {
            actions.emplace_back(ActionId::findCommand);  // closes the box
            actions.push_back(rows[i].action);
            seekItem(rows[i].field);
        }
        if (i == chosen_ && isPressed(Key::f2)) {
            keyed_ = actionIn(rows[i]);
            refused_.clear();
        }
        if (step != 0 && i == chosen_) {
            ImGui::SetScrollHereY();
        }
    }
    ImGui::EndChild();
}

void CommandBox::drawSearch(bool opens) {
    if (opens || keyPressed(ImGuiKey_Enter) || isPressed(Key::f2)) {
        ImGui::SetKeyboardFocusHere();
    }
    ImGui::SetNextItemWidth(-1);
    if (ImGui::InputTextWithHint("##words", "Type words of its name; F2 changes its keys",
                                 words_.data(), words_.size()) ||
        opens) {
        chosen_ = 0;
    }
}

void CommandBox::draw(const PanelModel& model, std::vector<Action>& actions) {
    constexpr char kWindow[] = "Find a command";
    const bool wanted = model.help.samples != nullptr;
    const bool wasOpen = std::exchange(open_, wanted);
    if (wanted && !wasOpen) {
        words_ = {};
        keyed_.reset();
        ImGui::OpenPopup(kWindow);
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float line = ImGui::GetFontSize();
    if (!beginModal(kWindow, std::min(32 * line, 0.9F * display.x),
                    std::min(24 * line, 0.9F * display.y), wanted)) {
        return;
    }
    if (keyed_) {
        drawKeys(model, actions);
    } else {
        drawSearch(!wasOpen);
        drawFound(model, actions);
        if (wasOpen && keyPressed(ImGuiKey_Escape)) {
            actions.emplace_back(ActionId::findCommand);
        }
    }
    ImGui::EndPopup();
}

}  // namespace kerf::ui
