#pragma once

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

/// A folder or a file in the list.
struct FileRow {
    std::string name;
    bool isFolder = false;
    std::uintmax_t bytes = 0;  ///< of a file
    std::string modified;      ///< local time, "2026-11-20 14:05"
};

/// A link to a folder.
struct FolderLink {
    std::string label;
    std::filesystem::path folder;
};

/// Options of a film.
struct FilmLook {
    int width = 0;           ///< [px]; 0: what suits the format
    int height = 0;          ///< [px]; 0: what suits the format
    int rate = 0;            ///< pictures in a second; 0: what suits the format
    double speed = 1;        ///< simulated seconds in a second of the film
    bool captions = true;    ///< with time and events
    bool turntable = false;  ///< the camera turns about the scene once
};

/// All that a file dialog shows; nothing if the purpose is none.
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
    bool asksToOverwrite = false;      ///< the file exists
    bool filePerPiece = false;         ///< of an export
    bool onePiece = false;             ///< of an export: the selected one
    bool inScene = false;              ///< of an export: in metres of the scene
    FilmLook film;                     ///< of a film
    bool adds = false;                 ///< adds the file to the scene instead of replacing it
    std::vector<std::filesystem::path> recent;  ///< files that were opened last
};

// What a person does in a file dialog.

/// Goes to a folder.
struct GoToFolder {
    std::filesystem::path folder;
};
/// Goes to the parent folder.
struct GoToParentFolder {};
/// Selects a row of the list, -1 for none.
struct SelectFile {
    int row = -1;
};
/// Moves the selection `steps` rows down; up where negative.
struct MoveFileSelection {
    int steps = 0;
};
/// Changes the name.
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
/// Changes the options of a film.
struct SetFilmLook {
    FilmLook look;
};
/// Accepts the name: enters a folder, or ends the dialog with the file. Asks before overwriting a
/// file.
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

/// A size in a suitable unit: "1.5 MB".
std::string sizeText(std::uintmax_t bytes);

}  // namespace kerf::ui
