#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace kerf::ui {

/// The purpose of a file dialog.
enum class FilePurpose : std::uint8_t {
    none,
    open,
    saveSession,
    saveTest,
    exportMesh,
    makeFilm,
    saveMaterial
};

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

/// How a film is to look.
struct FilmLook {
    int width = 0;           ///< [px]; 0: what suits the format
    int height = 0;          ///< [px]; 0: what suits the format
    int rate = 0;            ///< pictures in a second; 0: what suits the format
    double speed = 1;        ///< simulated seconds in a second of the film
    bool captions = true;    ///< with the time, and what happens
    bool turntable = false;  ///< the camera turns about the scene once
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
    bool inScene = false;              ///< of an export: in metres of the scene
    FilmLook film;                     ///< of a film
    bool adds = false;  ///< what is opened is added to the scene instead of opened in its place
    std::vector<std::filesystem::path> recent;  ///< files that were opened last
};

// What a person does in a file dialog.

/// Goes to a folder.
struct GoToFolder {
    std::filesystem::path folder;
};
/// Goes to the folder around the one that is shown.
struct GoToParentFolder {};
/// Selects a row of the list, -1 for none.
struct SelectFile {
    int row = -1;
};
/// Moves the selection `steps` rows down; up where negative.
struct MoveFileSelection {
    int steps = 0;
};
/// Types another name.
struct NameFile {
    std::string name;
};
/// Chooses another kind of files.
struct ChooseFileKind {
    int kind = 0;
};
/// Exports a file per piece, or one of all.
struct SetFilePerPiece {
    bool on = false;
};
/// Exports in metres of the scene, or in the coordinates of the model's own file.
struct SetExportInScene {
    bool on = false;
};
/// Gives a film another look.
struct SetFilmLook {
    FilmLook look;
};
/// Takes the name: goes into a folder, or ends the dialog with the file. Before it overwrites a
/// file it asks.
struct AcceptFile {
    bool overwrite = false;
};
/// Does not overwrite the file.
struct KeepFile {};
/// Closes the dialog without a file.
struct CloseFileDialog {};
/// Opens a recent file without the dialog.
struct OpenFile {
    std::filesystem::path file;
};

using FileAction = std::variant<GoToFolder, GoToParentFolder, SelectFile, MoveFileSelection,
                                NameFile, ChooseFileKind, SetFilePerPiece, SetExportInScene,
                                SetFilmLook, AcceptFile, KeepFile, CloseFileDialog, OpenFile>;

/// The title of the dialog: "Open a model or a session".
std::string_view titleOf(const FileDialogState& dialog);
/// The label of the button that accepts the file: "Open".
std::string_view verbOf(const FileDialogState& dialog);
/// A size in the unit that suits it: "1.5 MB".
std::string sizeText(std::uintmax_t bytes);

}  // namespace kerf::ui
