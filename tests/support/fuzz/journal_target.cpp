#include "app/files/io/errors.h"
#include "app/journal/journal_text.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/fuzz/text_mutator.h"
#include "tests/support/session_samples.h"
#include "tests/support/small_sessions.h"
#include "tests/support/temporary_folder.h"

namespace kerf::test {

namespace {

// Where relative paths of models would lead.
constexpr const char* kFolder = "/models";

app::KeptWork workOf(const std::string& text) {
    static const TemporaryFolder folder;
    writeText(folder / "x.journal", text);
    return app::readJournal(folder / "x.journal");
}

/// A journal of that name in which all events happen at once.
std::string journalOf(const std::string& name, const app::Session& session) {
    app::Session blank = session;
    blank.events.clear();
    app::SessionChange change;
    change.steps = session.steps;
    change.added.assign(session.events.begin(), session.events.end());
    return app::journalStart(name, blank) + app::journalLine(change, true);
}

std::string brokenByWriting(const app::KeptWork& work, const app::Session& session) {
    const app::KeptWork again = workOf(journalOf(work.name, session));
    const std::string text = app::formatSession(session);
    if (again.name != work.name || !again.unsaved ||
        app::formatSession(app::parseSession(again.session, kFolder)) != text) {
        return "It reads back otherwise: " + text;
    }
    return "";
}

bool isPlain(const std::string& name) {
    return !name.empty() && name != "." && name != ".." &&
           name.find_first_of(std::string("/\0\n", 3)) == std::string::npos;
}

}  // namespace

FuzzOutcome readJournalText(const std::string& text) {
    app::KeptWork work;
    try {
        work = workOf(text);
    } catch (const app::InputError& error) {
        return refusedWith(error.what());
    }
    if (!isPlain(work.name)) {
        return {true, "Files could not be called by its name: " + work.name};
    }
    app::Session session;
    try {
        session = app::parseSession(work.session, kFolder);
    } catch (const app::InputError& error) {
        return refusedWith(error.what());
    }
    return {true, session.events.empty() ? "" : brokenByWriting(work, session)};
}

std::vector<std::string> journalTexts() {
    std::vector<std::string> texts;
    for (const std::string& session :
         {sessionWithEveryKey(), sessionWithEveryEvent(), smallSession()}) {
        texts.push_back(journalOf("ball", app::parseSession(session, kFolder)));
    }
    const std::string line = R"({"steps":9,"unsaved":false,"at":1,"dropped":2,"events":[null,)"
                             R"({"step":3,"type":"lift"}]})"
                             "\n";
    texts.push_back(texts.back() + line);
    texts.push_back(texts.back() + texts.front().substr(0, texts.front().find('\n') + 1));
    return texts;
}

std::vector<std::string> journalWords() {
    std::vector<std::string> words = jsonWordsOf(journalTexts());
    words.emplace_back("\n");
    words.emplace_back("\"../../x\"");
    return words;
}

}  // namespace kerf::test
