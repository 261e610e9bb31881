#pragma once

#include "app/session/session.h"

namespace kerf::app {

/// A journal keeps the session that a window has open as text: a line of JSON says how it begins,
/// and each further line what has become of it. A line counts once its end is there. Lines in
/// order, read up to the last that is whole, give an ordinary session.

/// Journals beyond this size are not written and not read [bytes].
inline constexpr std::uintmax_t kMaxJournalBytes = kMaxSessionBytes;

/// The sha256 of the models' files that were read so far.
using ModelHashes = std::map<std::filesystem::path, std::string>;
/// Adds the missing sha256 of a session's models, so that another file of the name is noticed
/// later. Files that are not `known` are read.
void addHashes(Session& session, ModelHashes& known);

/// The first line: the name of the scene, and its session without events.
std::string journalStart(const std::string& name, const Session& session);
/// A line for the same session with another view or other colours.
std::string journalView(const Session& session);
/// A line for a change of the events. `unsaved`: whether there is unsaved work.
std::string journalLine(const SessionChange& change, bool unsaved);

/// The content of a journal.
struct KeptWork {
    std::string name;      ///< of the scene
    std::string session;   ///< text of a session file, with whole paths
    int cuts = 0;          ///< strokes, including undone ones
    bool unsaved = false;  ///< there is unsaved work
};

/// Whether a file has the name of a journal; it need not exist.
inline bool isJournal(const std::filesystem::path& file) {
    return file.extension() == ".journal";
}

/// Reads a journal up to the last complete and valid line. Throws InputError if there is nothing to
/// recover.
KeptWork readJournal(const std::filesystem::path& file);

}  // namespace kerf::app
