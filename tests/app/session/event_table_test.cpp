// docs/session-format.md names each event and its keys as the table of events has them.
#include "app/session/event_table.h"

namespace kerf::app {
namespace {

using nlohmann::json;

/// The keys of an event, with the value of those that may be left out and have one.
using KeyTable = std::map<std::string, std::optional<json>>;

/// What describe() says of one kind of event.
struct Collector : NoFields {
    std::vector<std::string> types;
    KeyTable keys;

    void type(const Word& word) { types.emplace_back(word.name); }
    void type(const Word& word, const Word& otherwise, bool) {
        types = {word.name, otherwise.name};
    }
    template <class... Rest>
    void required(const Word& word, const Rest&...) {
        add(word, std::nullopt);
    }
    template <class Value, class... Rule>
    void optional(const Word& word, const Value& value, const Rule&...) {
        add(word, value);
    }
    template <class... Rule>
    void optional(const Word& word, const Vec3& value, const Rule&...) {
        add(word, json{value.x(), value.y(), value.z()});
    }
    template <class Value, class... Rule>
    void optional(const Word& word, const std::optional<Value>&, const Rule&...) {
        add(word, std::nullopt);
    }
    void oneOf(const Region&, std::string_view) {
        Ball ball;
        describe(*this, ball);
        Bounds box;
        describe(*this, box);
    }
    void param(const Word& nameWord, const std::string&, const Word& valueWord, const ParamValue&) {
        add(nameWord, std::nullopt);
        add(valueWord, std::nullopt);
    }

    void add(const Word& word, const std::optional<json>& otherwise) {
        EXPECT_TRUE(keys.emplace(word.name, otherwise).second)
            << types.front() << " has two keys '" << word.name << "'";
    }
};

std::map<std::string, KeyTable> describedEvents() {
    std::map<std::string, KeyTable> events;
    forEachKind(std::type_identity<SessionAction>{}, [&](auto event) {
        Collector collector;
        describe(collector, event);
        for (const std::string& type : collector.types) {
            EXPECT_TRUE(events.emplace(type, collector.keys).second)
                << "two kinds of events have the type '" << type << "'";
        }
    });
    return events;
}

/// The words in backticks, each with what stands in parentheses right behind it.
KeyTable quotedWords(const std::string& cell) {
    static const std::regex kWord("`([a-z_]+)`(?: \\(([^)]*)\\))?");
    KeyTable words;
    for (std::sregex_iterator word(cell.begin(), cell.end(), kWord), end; word != end; ++word) {
        const json value = json::parse((*word)[2].str(), nullptr, false);
        words[(*word)[1]] = value.is_discarded() ? std::nullopt : std::optional(value);
    }
    return words;
}

/// The rows of the table behind "## Events".
std::map<std::string, KeyTable> documentedEvents() {
    std::istringstream page(readBytes(fs::path(KERF_SOURCE_DIR) / "docs/session-format.md"));
    std::map<std::string, KeyTable> events;
    std::string line;
    while (std::getline(page, line) && line != "## Events") {
    }
    while (std::getline(page, line) && !line.starts_with("## ")) {
        const std::size_t keys = line.find(" | ");
        if (line.starts_with("| `") && !line.starts_with("| `type`")) {
            const std::size_t meaning = line.find(" | ", keys + 1);
            for (const auto& [type, none] : quotedWords(line.substr(0, keys))) {
                events[type] = quotedWords(line.substr(keys, meaning - keys));
            }
        }
    }
    return events;
}

TEST(EventTable, NoTwoKindsShareATypeAndNoTwoFieldsAKey) {
    EXPECT_FALSE(describedEvents().empty());  // looks for both
}

TEST(EventTable, PageNamesEveryEventWithItsKeysAndWhatTheyAreWhereLeftOut) {
    const auto documented = documentedEvents();
    for (const auto& [type, keys] : describedEvents()) {
        ASSERT_TRUE(documented.contains(type)) << "docs/session-format.md has no event " << type;
        EXPECT_EQ(documented.at(type), keys) << "of event " << type;
    }
    EXPECT_EQ(documented.size(), describedEvents().size()) << "the page has an event too many";
}

TEST(EventTable, ErrorListsTheTypesInTheirOrder) {
    std::string types;
    forEachKind(std::type_identity<SessionAction>{}, [&](auto event) {
        Collector collector;
        describe(collector, event);
        types += (types.empty() ? "" : ", ") + joined(collector.types, ", ");
    });
    EXPECT_TRUE(types.starts_with("blade, lift, set, grab, ")) << types;
    try {
        parseSession(R"({"format": "kerf-session", "version": 1, "model": {"builtin": "sphere20"},
                         "steps": 1, "events": [{"step": 1, "type": "slice"}]})",
                     "/");
        FAIL() << "no error";
    } catch (const InputError& error) {
        EXPECT_EQ(error.what(),
                  "events[0].type: there is no event type 'slice'; there are " + types + ".");
    }
}

}  // namespace
}  // namespace kerf::app
