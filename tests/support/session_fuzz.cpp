#include "tests/support/session_fuzz.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <nlohmann/json.hpp>
#include <set>

#include "app/session/session_schema.h"
#include "app/session/session_table.h"
#include "tests/support/session_samples.h"

namespace kerf::test {

namespace {

using app::Session;
using nlohmann::json;

// Where the sessions lie whose texts are read here.
constexpr const char* kFolder = "/models/sessions";
// No text of the file is quoted whole where it is long.
constexpr std::size_t kLongestError = 800;

// Texts of values that are equal where all bits are.

std::string textOf(bool value) {
    return value ? "true" : "false";
}
std::string textOf(int value) {
    return std::to_string(value);
}
std::string textOf(double value) {
    return std::to_string(std::bit_cast<std::uint64_t>(value));
}
std::string textOf(const std::string& value) {
    return "'" + value + "'";
}
std::string textOf(const std::filesystem::path& value) {
    return textOf(value.string());
}
std::string textOf(const Vec3& value) {
    return textOf(value.x()) + " " + textOf(value.y()) + " " + textOf(value.z());
}
template <class Enum>
requires std::is_enum_v<Enum> std::string textOf(Enum value) {
    return textOf(static_cast<int>(value));
}
std::string textOf(std::monostate) {
    return "null";
}
std::string textOf(const ParamValue& value) {
    return std::visit([](const auto& held) { return textOf(held); }, value);
}
template <class Value>
std::string textOf(const std::optional<Value>& value) {
    return value ? textOf(*value) : "none";
}

/// Every field of a session by the tables, whether it was given or not.
class Fields : public app::NoFields {
  public:
    const std::string& text() const { return text_; }

    void type(const app::Word& word) { note(app::kTypeKey, std::string(word.name)); }
    void type(const app::Word& word, const app::Word& otherwise, bool flag) {
        type(flag ? word : otherwise);
    }
    void required(const app::Word& word, auto& value, const auto&... rule) {
        field(word, value, rule...);
    }
    void optional(const app::Word& word, auto& value, const auto&... rule) {
        field(word, value, rule...);
    }
    void optional(const app::Word& word, app::SessionView& view) {
        note(word.name, view.camera.has_value());
        if (view.camera) {
            describe(*this, view);
        }
    }
    void oneOf(Region& region, std::string_view) {
        std::visit([this](auto& shape) { describe(*this, shape); }, region);
    }
    void param(const app::Word& nameWord, const std::string& name, const app::Word& valueWord,
               const ParamValue& value) {
        note(nameWord.name, name);
        note(valueWord.name, value);
    }
    void ignored(const app::Word&) {}
    void format(const app::Word&, const app::Word&) {}
    void params(const app::Word&, const Params& params) {
        for (const ParamInfo& info : paramTable()) {
            note(std::string(info.name), getParam(params, info.name));
        }
    }
    void list(const app::Word& word, auto& items, std::size_t) {
        for (auto& item : items) {
            field(word, item);
        }
    }
    void events(const app::Word& word, std::vector<app::SessionEvent>& events,
                const app::Limits& steps) {
        for (app::SessionEvent& event : events) {
            field(word, event, steps);
        }
    }
    void action(const app::Word&, app::SessionAction& action) {
        std::visit([this](auto& event) { describe(*this, event); }, action);
    }

  private:
    void note(const std::string& name, const auto& value) {
        text_ += name + ": " + textOf(value) + "\n";
    }
    template <class Value, class... Rule>
    void field(const app::Word& word, Value& value, const Rule&... rule) {
        if constexpr (requires { describe(*this, value, rule...); }) {
            text_ += std::string(word.name) + ":\n";
            describe(*this, value, rule...);
        } else {
            note(word.name, value);
        }
    }

    std::string text_;
};

std::string fieldsOf(Session session) {
    Fields fields;
    describe(fields, session);
    return fields.text();
}

std::string brokenByWriting(const Session& session) {
    const std::string text = app::formatSession(session, kFolder);
    const Session again = app::parseSession(text, kFolder);
    for (const std::string& warning : again.warnings) {
        if (warning.find("unknown key") != std::string::npos) {
            return "What was written has an unknown key: " + warning;
        }
    }
    if (fieldsOf(again) != fieldsOf(session)) {
        return "It reads back as another session: " + text;
    }
    return app::formatSession(again, kFolder) == text ? "" : "It is written otherwise: " + text;
}

/// Collects what a person may write by the schema.
void collectWords(const json& schema, std::set<std::string>& words) {
    for (const auto& [keyword, value] : schema.items()) {
        if (keyword == "properties") {
            for (const auto& [key, each] : value.items()) words.insert(json(key).dump() + ": ");
        }
        if (keyword == "enum") {
            for (const json& each : value) words.insert(each.dump());
        }
        if (keyword == "const" || keyword == "default" || keyword == "minimum" ||
            keyword == "maximum") {
            words.insert(value.dump());
        }
        if (value.is_structured()) {
            collectWords(value, words);
        }
    }
}

bool isPartOfWord(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '.' || c == '-';
}

}  // namespace

std::string brokenPromise(const std::string& text) {
    Session session;
    try {
        session = app::parseSession(text, kFolder);
    } catch (const app::InputError& error) {
        const std::string sentence = error.what();
        return sentence.ends_with('.') && sentence.size() < kLongestError
                   ? ""
                   : "Its error is no sentence: " + sentence;
    }
    return brokenByWriting(session);
}

std::vector<std::string> sessionTexts() {
    std::vector<std::string> texts{sessionWith(""), sessionWithEveryKey(), sessionWithEveryEvent()};
    for (const BrokenSession& broken : brokenSessions()) {
        texts.push_back(broken.text);
    }
    return texts;
}

std::vector<std::string> sessionWords() {
    std::set<std::string> words{"{",    "}",      "[",         "]",     ",",     ":",
                                "\"",   "null",   "true",      "false", "-0.0",  "1e308",
                                "1e-5", "5e-324", "[0, 1, 2]", "{},",   "\\u00", "../"};
    collectWords(json::parse(app::sessionSchema()), words);
    return {words.begin(), words.end()};
}

TextMutator::TextMutator(std::vector<std::string> texts, std::uint32_t seed)
    : random_(seed), texts_(std::move(texts)), words_(sessionWords()) {}

std::string TextMutator::next() {
    std::string text = oneOf(texts_);
    for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
        change(text);
    }
    return text;
}

/// Not std::uniform_int_distribution, which differs between libraries.
std::size_t TextMutator::below(std::size_t count) {
    return random_() % count;
}

const std::string& TextMutator::oneOf(const std::vector<std::string>& list) {
    return list[below(list.size())];
}

void TextMutator::change(std::string& text) {
    constexpr std::array kChanges{&TextMutator::changeByte,  &TextMutator::insertWord,
                                  &TextMutator::replaceWord, &TextMutator::eraseRange,
                                  &TextMutator::repeatRange, &TextMutator::crossOver};
    (this->*kChanges[below(kChanges.size())])(text);
}

void TextMutator::changeByte(std::string& text) {
    if (!text.empty()) {
        text[below(text.size())] = static_cast<char>(below(256));
    }
}

void TextMutator::insertWord(std::string& text) {
    text.insert(below(text.size() + 1), oneOf(words_));
}

/// A number, or the letters of a key or a name.
void TextMutator::replaceWord(std::string& text) {
    const std::size_t place = below(text.size() + 1);
    const auto first = std::find_if(text.begin() + place, text.end(), isPartOfWord);
    const auto last = std::find_if_not(first, text.end(), isPartOfWord);
    std::string word = oneOf(words_);
    std::erase(word, '"');
    text.replace(first, last, word);
}

void TextMutator::eraseRange(std::string& text) {
    const std::size_t place = below(text.size() + 1);
    text.erase(place, below(30));
}

void TextMutator::repeatRange(std::string& text) {
    const std::size_t place = below(text.size() + 1);
    text.insert(below(text.size() + 1), text.substr(place, below(60)));
}

/// Goes on as another text does.
void TextMutator::crossOver(std::string& text) {
    const std::string& other = oneOf(texts_);
    text.resize(below(text.size() + 1));
    text += other.substr(below(other.size() + 1));
}

}  // namespace kerf::test
