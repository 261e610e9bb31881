#include <nlohmann/json.hpp>

#include "app/files/io/errors.h"
#include "app/journal/text_journal.h"
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

/// What a journal reads back of work that was kept, as the text of a session.
std::string keptText(const app::KeptWork& work) {
    static const TemporaryFolder folder;
    app::Journal journal(folder.path());
    journal.begin(work);
    const std::optional<app::KeptWork> again = journal.work();
    journal.remove();
    return again && again->name == work.name ? again->text() : "";
}

/// Lines of that name in which all events happen at once.
std::string journalOf(const std::string& name, const std::string& session) {
    nlohmann::json blank = nlohmann::json::parse(session);
    const nlohmann::json start{{"kerf_journal", 1}, {"name", name}, {"session", blank}};
    const nlohmann::json all{{"steps", blank["steps"]},
                             {"unsaved", true},
                             {"at", 0},
                             {"dropped", 0},
                             {"events", blank.value("events", nlohmann::json::array())}};
    return start.dump() + "\n" + all.dump() + "\n";
}

bool isPlain(const std::string& name) {
    return !name.empty() && name != "." && name != ".." &&
           name.find_first_of(std::string("/\0\n", 3)) == std::string::npos;
}

}  // namespace

FuzzOutcome readJournalText(const std::string& text) {
    const std::optional<app::KeptWork> work = app::workInText(text);
    if (!work) {
        return {false, ""};  // without a sentence
    }
    if (!isPlain(work->name)) {
        return {true, "Files could not be called by its name: " + work->name};
    }
    if (keptText(*work) != work->text()) {
        return {true, "It reads back otherwise: " + work->text()};
    }
    try {
        app::parseSession(work->text(), kFolder);
    } catch (const app::InputError& error) {
        return refusedWith(error.what());
    }
    return {true, ""};
}

std::vector<std::string> journalTexts() {
    std::vector<std::string> texts;
    for (const std::string& session :
         {sessionWithEveryKey(), sessionWithEveryEvent(), smallSession()}) {
        texts.push_back(journalOf("ball", session));
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
