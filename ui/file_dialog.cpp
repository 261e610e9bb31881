#include "ui/file_dialog.h"

#include <imgui.h>
#include <spdlog/fmt/fmt.h>

#include "ui/base/layout.h"
#include "ui/base/theme.h"
#include "ui/base/widgets.h"

namespace kerf::ui {
namespace {

constexpr char kFilesWindow[] = "###files";
constexpr std::size_t kMaxName = 4000;  // longer than any path of Linux that can be opened

/// The text that the name field edits, and what it is to show instead where that changed elsewhere.
struct NameEdit {
    const std::string* replacement = nullptr;
};

int replaceText(ImGuiInputTextCallbackData* data) {
    const auto* edit = static_cast<const NameEdit*>(data->UserData);
    if (edit->replacement != nullptr) {
        data->DeleteChars(0, data->BufTextLen);
        data->InsertChars(0, edit->replacement->c_str());
    }
    return 0;
}

void drawPreview(const FileDialogState& state) {
    for (std::size_t i = 0; i < state.preview.size(); ++i) {
        textWrapped(state.preview[i], i > 0);
    }
}

/// What a dialog says.
struct DialogText {
    const char* title = "";
    const char* verb = "";  ///< on the button that accepts the file
    const char* advice = "";
};
constexpr const char* kFindingAdvice =
    "Type to search, Enter to open, Backspace to go up a folder.";
constexpr DialogText kAdding{"Add model", "Add", kFindingAdvice};
/// By purpose.
constexpr std::array<DialogText, 7> kDialogs{{
    {},
    {"Open model or session", "Open", kFindingAdvice},
    {"Save session", "Save"},
    {"Save as test", "Save", "The expected results are saved beside it, in NAME.expected."},
    {"Export model", "Export"},
    {"Export video", "Export"},
    {"Save material", "Save", "Materials in this folder appear in the list of materials."},
}};

const DialogText& textOf(const FileDialogState& dialog) {
    return dialog.adds && dialog.purpose == FilePurpose::open
               ? kAdding
               : kDialogs[static_cast<std::size_t>(dialog.purpose)];
}

/// Something that a film may have, as people call it.
template <class Value>
struct FilmChoice {
    Value value;
    const char* label;
};
using FilmSize = std::array<int, 2>;
constexpr std::array kFilmSpeeds{
    FilmChoice<double>{1, "Real time"}, FilmChoice<double>{0.5, "Half speed"},
    FilmChoice<double>{0.25, "Quarter speed"}, FilmChoice<double>{0.1, "1/10 speed"}};
/// The first one is what suits the format.
constexpr std::array kFilmSizes{FilmChoice<FilmSize>{{0, 0}, "1280 x 720"},
                                FilmChoice<FilmSize>{{640, 360}, "640 x 360"},
                                FilmChoice<FilmSize>{{1280, 720}, "1280 x 720"},
                                FilmChoice<FilmSize>{{1920, 1080}, "1920 x 1080"},
                                FilmChoice<FilmSize>{{3840, 2160}, "3840 x 2160"},
                                FilmChoice<FilmSize>{{1080, 1080}, "1080 x 1080"}};
constexpr std::array kFilmRates{FilmChoice<int>{0, "30 fps"},  FilmChoice<int>{15, "15 fps"},
                                FilmChoice<int>{24, "24 fps"}, FilmChoice<int>{25, "25 fps"},
                                FilmChoice<int>{30, "30 fps"}, FilmChoice<int>{50, "50 fps"},
                                FilmChoice<int>{60, "60 fps"}};

/// A row of `choices` to choose from, the first one under the name `usual`. True where another one
/// was chosen.
template <class Value, std::size_t kCount>
bool drawFilmChoice(const std::string& item, std::array<FilmChoice<Value>, kCount> choices,
                    const char* usual, Value& value, const char* tip) {
    choices.front().label = usual;
    const auto* const now = std::ranges::find(choices, value, &FilmChoice<Value>::value);
    bool changed = false;
    ImGui::SetNextItemWidth((item == "rate" ? 6 : 8.6F) * ImGui::GetFontSize());
    const bool open =
        ImGui::BeginCombo(("##" + item).c_str(), now == choices.end() ? "" : now->label);
    if (!open) {
        describeItem("file." + item, tip);
        return false;
    }
    for (const FilmChoice<Value>& choice : choices) {
        if (choice.value != choices.front().value && std::string_view(choice.label) == usual) {
            continue;
        }
        if (ImGui::Selectable(choice.label, choice.value == value)) {
            value = choice.value;
            changed = true;
        }
        noteItem("file." + item + "." + choice.label);
    }
    ImGui::EndCombo();
    return changed;
}

void drawFilmLook(const FileDialogState& state, std::vector<Action>& actions) {
    FilmLook look = state.film;
    const std::string& kind = state.kinds[state.kind];
    const bool isGif = kind.find(".gif") != std::string::npos;
    if (kind.find(".abc") != std::string::npos || kind.find(".pvd") != std::string::npos) {
        if (drawFilmChoice("rate", kFilmRates, "30 fps", look.rate, "Samples per second")) {
            actions.emplace_back(FileAction(SetFilmLook{look}));
        }
        return;
    }
    bool changed =
        checkbox("Captions", look.captions, "file.captions", "Show the time and what happens");
    ImGui::SameLine();
    changed |=
        checkbox("Turntable", look.turntable, "file.turntable", "The camera orbits the scene once");
    ImGui::SameLine();
    changed |= drawFilmChoice("speed", kFilmSpeeds, kFilmSpeeds.front().label, look.speed,
                              "Playback speed");
    ImGui::SameLine();
    FilmSize size{look.width, look.height};
    changed |= drawFilmChoice("size", kFilmSizes, isGif ? "640 x 360" : "1280 x 720", size,
                              "Size in pixels");
    look.width = size[0];
    look.height = size[1];
    ImGui::SameLine();
    changed |= drawFilmChoice("rate", kFilmRates, isGif ? "25 fps" : "30 fps", look.rate,
                              "Frames per second");
    if (changed) {
        actions.emplace_back(FileAction(SetFilmLook{look}));
    }
}

}  // namespace

std::string sizeText(std::uintmax_t bytes) {
    constexpr double kKilo = 1000;
    const auto size = static_cast<double>(bytes);
    return size < kKilo           ? fmt::format("{} bytes", bytes)
           : size < kKilo * kKilo ? fmt::format("{:.1f} kB", size / kKilo)
                                  : fmt::format("{:.1f} MB", size / (kKilo * kKilo));
}

void FileDialog::draw(const FileDialogState& state, std::vector<Action>& actions) {
    const bool wanted = state.purpose != FilePurpose::none;
    justOpened_ = wanted && !open_;
    const bool wasOpen = std::exchange(open_, wanted);
    if (!wanted && !wasOpen) {
        return;
    }
    if (justOpened_) {
        ImGui::OpenPopup(kFilesWindow);
        scrolledTo_ = -1;
        lastName_.clear();
        text_.clear();
    }
    const ImVec2 display = ImGui::GetIO().DisplaySize;
    const float line = ImGui::GetFontSize();
    if (!beginModal(std::string(textOf(state).title) + kFilesWindow,
                    std::min(60 * line, 0.94F * display.x), std::min(36 * line, 0.92F * display.y),
                    wanted)) {
        return;
    }
    takeKeys(state, actions);
    drawCrumbs(state, actions);
    drawBookmarks(state, actions);
    ImGui::SameLine();
    drawRows(state, actions);
    drawName(state, actions);
    drawOptions(state, actions);
    drawButtons(state, actions);
    ImGui::EndPopup();
}

/// Keys that decide something don't repeat: a held Enter must not answer the question that it
/// raised.
void FileDialog::takeKeys(const FileDialogState& state, std::vector<Action>& actions) {
    if (justOpened_) {
        return;  // The key that opened it is still down.
    }
    if (keyPressed(ImGuiKey_Escape)) {
        if (state.asksToOverwrite) {
            actions.emplace_back(FileAction(KeepFile{}));
        } else {
            actions.emplace_back(FileAction(CloseFileDialog{}));
        }
    } else if (keyPressed(ImGuiKey_Enter)) {
        actions.emplace_back(FileAction(AcceptFile{state.asksToOverwrite}));
    } else if (keyPressed(ImGuiKey_DownArrow, true)) {
        actions.emplace_back(FileAction(MoveFileSelection{1}));
    } else if (keyPressed(ImGuiKey_UpArrow, true)) {
        actions.emplace_back(FileAction(MoveFileSelection{-1}));
    } else if (keyPressed(ImGuiKey_PageDown, true)) {
        actions.emplace_back(FileAction(MoveFileSelection{10}));
    } else if (keyPressed(ImGuiKey_PageUp, true)) {
        actions.emplace_back(FileAction(MoveFileSelection{-10}));
    } else if (keyPressed(ImGuiKey_Backspace) && text_.empty()) {
        actions.emplace_back(FileAction(GoToParentFolder{}));
    }
}

void FileDialog::drawCrumbs(const FileDialogState& state, std::vector<Action>& actions) {
    const float width = ImGui::GetContentRegionAvail().x;
    // The innermost folders are the ones that matter, so outer ones give way.
    std::size_t first = 0;
    const auto lengthFrom = [&](std::size_t from) {
        float length = 0;
        for (std::size_t i = from; i < state.crumbs.size(); ++i) {
            length += buttonWidth(state.crumbs[i].label) + ImGui::GetFontSize();
        }
        return length;
    };
    while (first + 1 < state.crumbs.size() && lengthFrom(first) > width) {
        ++first;
    }
    for (std::size_t i = first; i < state.crumbs.size(); ++i) {
        if (i > first) {
            ImGui::SameLine(0, 2);
            textColored(palette().dimText, "/");
            ImGui::SameLine(0, 2);
        }
        ImGui::PushID(static_cast<int>(i));
        if (ImGui::SmallButton(state.crumbs[i].label.c_str())) {
            actions.emplace_back(FileAction(GoToFolder{state.crumbs[i].folder}));
        }
        ImGui::PopID();
    }
}

void FileDialog::drawBookmarks(const FileDialogState& state, std::vector<Action>& actions) {
    const float line = ImGui::GetFontSize();
    const float below = 3.2F * ImGui::GetFrameHeightWithSpacing() +
                        (state.asksToOverwrite ? ImGui::GetFrameHeightWithSpacing() : 0);
    ImGui::BeginChild("places", {13 * line, -below}, true);
    for (const FolderLink& bookmark : state.bookmarks) {
        ImGui::PushID(bookmark.folder.c_str());
        if (ImGui::Selectable(bookmark.label.c_str(), bookmark.folder == state.folder)) {
            actions.emplace_back(FileAction(GoToFolder{bookmark.folder}));
        }
        describeItem("file.place." + bookmark.label, bookmark.folder.string());
        ImGui::PopID();
    }
    if (!state.preview.empty()) {
        ImGui::Spacing();
        ImGui::TextDisabled("Selected");
        ImGui::Separator();
        drawPreview(state);
    }
    ImGui::EndChild();
}

void FileDialog::drawRow(const FileDialogState& state, int i, std::vector<Action>& actions) {
    const FileRow& row = state.rows[i];
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    ImGui::PushID(i);
    const float start = ImGui::GetCursorPosX();
    // The name is no label: "##" may stand in it.
    const bool hit = ImGui::Selectable(
        "##row", i == state.selected,
        ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowDoubleClick);
    noteItem("file.row." + row.name);
    if (hit) {
        actions.emplace_back(FileAction(SelectFile{i}));
        if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) {
            actions.emplace_back(FileAction(AcceptFile{}));
        }
    }
    if (i == state.selected && scrolledTo_ != i) {
        scrolledTo_ = i;
        ImGui::SetScrollHereY();
    }
    ImGui::SameLine(start);
    textColored(row.isFolder ? palette().of(Hue::blue) : palette().text,
                row.isFolder ? row.name + "/" : row.name);
    ImGui::PopID();
    ImGui::TableNextColumn();
    textColored(palette().dimText, row.isFolder ? "" : sizeText(row.bytes));
    ImGui::TableNextColumn();
    textColored(palette().dimText, row.modified);
}

void FileDialog::drawRows(const FileDialogState& state, std::vector<Action>& actions) {
    const float line = ImGui::GetFontSize();
    const float below = 3.2F * ImGui::GetFrameHeightWithSpacing() +
                        (state.asksToOverwrite ? ImGui::GetFrameHeightWithSpacing() : 0);
    const ImVec2 size{0, ImGui::GetContentRegionAvail().y - below};
    if (!ImGui::BeginTable(
            "rows", 3,
            ImGuiTableFlags_ScrollY | ImGuiTableFlags_RowBg | ImGuiTableFlags_BordersOuter, size)) {
        return;
    }
    ImGui::TableSetupScrollFreeze(0, 1);
    ImGui::TableSetupColumn("Name", ImGuiTableColumnFlags_WidthStretch);
    ImGui::TableSetupColumn("Size", ImGuiTableColumnFlags_WidthFixed, 5 * line);
    ImGui::TableSetupColumn("Modified", ImGuiTableColumnFlags_WidthFixed, 9 * line);
    ImGui::TableHeadersRow();
    // Of a folder with thousands of files only those in view are drawn, and the one to scroll to.
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(state.rows.size()));
    if (state.selected >= 0 && state.selected != scrolledTo_) {
        clipper.ForceDisplayRangeByIndices(state.selected, state.selected + 1);
    }
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i) {
            drawRow(state, i, actions);
        }
    }
    ImGui::EndTable();
}

void FileDialog::drawName(const FileDialogState& state, std::vector<Action>& actions) {
    NameEdit edit;
    if (state.name != lastName_ && state.name != text_) {
        edit.replacement = &state.name;
        text_ = state.name;
    }
    lastName_ = state.name;
    char buffer[kMaxName];
    const std::size_t length = text_.copy(buffer, sizeof buffer - 1);
    buffer[length] = 0;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Name");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-ImGui::GetFontSize() * 14);
    const bool comboOpen = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId);
    if (justOpened_ || (!ImGui::IsAnyItemActive() && !comboOpen && !ImGui::IsMouseDown(0))) {
        ImGui::SetKeyboardFocusHere();
    }
    // Whenever it gets the keys, what is typed takes the place of what stood there.
    ImGui::InputText("##name", buffer, sizeof buffer,
                     ImGuiInputTextFlags_CallbackAlways | ImGuiInputTextFlags_AutoSelectAll,
                     replaceText, &edit);
    noteItem("file.name");
    if (edit.replacement == nullptr && text_ != buffer) {
        text_ = buffer;
        actions.emplace_back(FileAction(NameFile{text_}));
    }
    ImGui::SameLine();
    ImGui::SetNextItemWidth(-1);
    if (ImGui::BeginCombo("##kind", state.kinds.empty() ? "" : state.kinds[state.kind].c_str())) {
        for (int i = 0; i < static_cast<int>(state.kinds.size()); ++i) {
            if (ImGui::Selectable(state.kinds[i].c_str(), i == state.kind)) {
                actions.emplace_back(FileAction(ChooseFileKind{i}));
            }
        }
        ImGui::EndCombo();
    }
    noteItem("file.kind");
}

void FileDialog::drawOptions(const FileDialogState& state, std::vector<Action>& actions) {
    if (state.asksToOverwrite) {
        ImGui::AlignTextToFramePadding();
        textColored(palette().of(Hue::orange),
                    state.purpose == FilePurpose::saveTest
                        ? "A test with this name already exists. Replace it?"
                        : "A file with this name already exists. Replace it?");
        return;
    }
    if (!state.problem.empty()) {
        ImGui::AlignTextToFramePadding();
        textColored(palette().of(Hue::vermillion), state.problem);
        return;
    }
    if (state.purpose == FilePurpose::exportMesh) {
        bool perPiece = state.filePerPiece;
        if (state.onePiece) {
            ImGui::AlignTextToFramePadding();
            textColored(palette().dimText, "The selected piece");
        } else if (checkbox("One file per piece", perPiece, "file.per_piece")) {
            actions.emplace_back(FileAction(SetFilePerPiece{perPiece}));
        }
        ImGui::SameLine();
        bool inScene = state.inScene;
        if (checkbox(
                "Scene units (m)", inScene, "file.in_scene",
                "On: in metres, placed as in the scene, +Y up. Off: unit, axes and position of the "
                "model's own file")) {
            actions.emplace_back(FileAction(SetExportInScene{inScene}));
        }
        return;
    }
    if (state.purpose == FilePurpose::makeFilm) {
        drawFilmLook(state, actions);
        return;
    }
    ImGui::AlignTextToFramePadding();
    textColored(palette().dimText, textOf(state).advice);
}

void FileDialog::drawButtons(const FileDialogState& state, std::vector<Action>& actions) {
    const std::string verb(state.asksToOverwrite ? "Replace" : textOf(state).verb);
    const char* const leave = state.asksToOverwrite ? "Keep existing" : "Cancel";
    const float spacing = ImGui::GetStyle().ItemSpacing.x;
    ImGui::SameLine(ImGui::GetContentRegionMax().x - buttonWidth(verb) - buttonWidth(leave) -
                    spacing);
    if (button(leave, "file.cancel")) {
        actions.emplace_back(state.asksToOverwrite ? FileAction(KeepFile{})
                                                   : FileAction(CloseFileDialog{}));
    }
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    if (button(verb.c_str(), "file.accept")) {
        actions.emplace_back(FileAction(AcceptFile{state.asksToOverwrite}));
    }
    ImGui::PopStyleColor();
}

}  // namespace kerf::ui
