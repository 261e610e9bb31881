#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kerf::ui {

/// What a file dialog is for.
enum class FilePurpose : std::uint8_t { none, open, saveSession, exportMesh };

/// A folder or a file that is offered.
struct FileRow {
    std::string name;
    bool isFolder = false;
    std::uintmax_t bytes = 0;  ///< of a file
    std::string modified;      ///< local time, "2026-11-20 14:05"
};

/// A folder that can be gone to at once.
struct FolderLink {
    std::string label;
    std::filesystem::path folder;
};

/// All that a file dialog shows; nothing where the purpose is none.
struct FileDialogState {
    FilePurpose purpose = FilePurpose::none;
    std::filesystem::path folder;
    std::vector<FolderLink> crumbs;  ///< the folder and those around it, outermost first
    std::vector<FolderLink> bookmarks;
    std::vector<std::string> kinds;
    int kind = 0;  ///< of `kinds`
    std::vector<FileRow> rows;
    int selected = -1;                 ///< of `rows`, -1 for none
    std::string name;                  ///< as typed or chosen
    std::vector<std::string> preview;  ///< lines about what is selected
    std::string problem;               ///< one sentence; empty for none
    bool asksToOverwrite = false;      ///< the name is taken
    bool filePerPiece = false;         ///< of an export
};

// What a person does in it.
struct GoToFolder {
    std::filesystem::path folder;
};
struct GoToParentFolder {};
struct SelectFile {
    int row = -1;
};
/// `steps` rows further down; up where negative.
struct MoveFileSelection {
    int steps = 0;
};
struct NameFile {
    std::string name;
};
struct ChooseFileKind {
    int kind = 0;
};
struct SetFilePerPiece {
    bool on = false;
};
/// Takes what is named: goes into a folder, or ends the dialog with the file. Where it would
/// overwrite a file that is asked first.
struct AcceptFile {
    bool overwrite = false;
};
struct KeepFile {};  ///< not to overwrite
struct CloseFileDialog {};
/// Past the dialog: a recent file.
struct OpenFile {
    std::filesystem::path file;
};

using FileAction =
    std::variant<GoToFolder, GoToParentFolder, SelectFile, MoveFileSelection, NameFile,
                 ChooseFileKind, SetFilePerPiece, AcceptFile, KeepFile, CloseFileDialog, OpenFile>;

/// "Open a model or a session".
std::string_view titleOf(FilePurpose purpose);
/// What its button says: "Open".
std::string_view verbOf(FilePurpose purpose);
/// "1.5 MB"
std::string sizeText(std::uintmax_t bytes);

}  // namespace kerf::ui
