#include <bit>
#include <nlohmann/json.hpp>

#include "app/files/io/errors.h"
#include "app/session/session.h"
#include "app/session/session_table.h"
#include "tests/support/fuzz/refusal.h"
#include "tests/support/fuzz/targets.h"
#include "tests/support/session_samples.h"
#include "tests/support/session_schema.h"

namespace kerf::test {

namespace {

using app::Session;
using nlohmann::json;

// Where the sessions lie whose texts are read here.
constexpr const char* kSessionFolder = "/models/sessions";

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

template <class Item>
std::string textOf(const std::vector<Item>& items) {
    std::string text;
    for (const Item& item : items) {
        text += textOf(item) + "; ";
    }
    return text;
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
    void format(const app::Word&, const app::Word&, const app::FileFormat&) {}
    void material(const app::Word&, const app::Session&) {}  // taken over into the parameters
    void params(const app::Word&, const app::Session& session) {
        for (const ParamInfo& info : paramTable()) {
            note(std::string(info.name), getParam(session.params, info.name));
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
        } else if constexpr (requires { describe(*this, *value, rule...); }) {
            note(word.name, value.has_value());
            if (value) {
                describe(*this, *value, rule...);
            }
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
    const std::string text = app::formatSession(session, kSessionFolder);
    const Session again = app::parseSession(text, kSessionFolder);
    for (const std::string& warning : again.warnings) {
        if (warning.find("unknown key") != std::string::npos) {
            return "What was written has an unknown key: " + warning;
        }
    }
    if (fieldsOf(again) != fieldsOf(session)) {
        return "It reads back as another session: " + text;
    }
    return app::formatSession(again, kSessionFolder) == text ? ""
                                                             : "It is written otherwise: " + text;
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

}  // namespace

FuzzOutcome readSessionText(const std::string& text) {
    Session session;
    try {
        session = app::parseSession(text, kSessionFolder);
    } catch (const app::InputError& error) {
        return refusedWith(error.what());
    }
    return {true, brokenByWriting(session)};
}

std::vector<std::string> sessionTexts() {
    return {sessionWith(""), sessionWithEveryKey(), sessionWithEveryEvent()};
}

std::vector<std::string> refusedSessionTexts() {
    std::vector<std::string> texts(brokenSessions().size());
    std::ranges::transform(brokenSessions(), texts.begin(), &BrokenSession::text);
    return texts;
}

std::vector<std::string> sessionWords() {
    std::set<std::string> words{"{",    "}",      "[",         "]",     ",",     ":",
                                "\"",   "null",   "true",      "false", "-0.0",  "1e308",
                                "1e-5", "5e-324", "[0, 1, 2]", "{},",   "\\u00", "../"};
    collectWords(json::parse(app::sessionSchema()), words);
    return {words.begin(), words.end()};
}

}  // namespace kerf::test
