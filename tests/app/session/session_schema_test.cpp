#include "tests/support/session_schema.h"

#include "app/session/session_json.h"
#include "tests/support/session_validator.h"

namespace kerf::app {
namespace {

using nlohmann::json;

constexpr std::uint32_t kSeed = 20261122;
constexpr int kMutations = 1500;

/// The sentence with which the reader refuses a text; empty where it does not.
std::string schemaRefusalOf(const std::string& text) {
    return inputErrorOf([&] { parseSession(text, "/folder"); });
}

/// Every session of the repository.
std::vector<std::string> sessionFiles() {
    std::vector<std::string> texts;
    for (const char* folder : {"assets", "tests"}) {
        const fs::path path = fs::path(KERF_SOURCE_DIR) / folder;
        for (const auto& entry : fs::recursive_directory_iterator(path)) {
            if (entry.path().filename().string().ends_with(".kerf.json")) {
                texts.push_back(readBytes(entry.path()));
            }
        }
    }
    return texts;
}

/// Sessions that the reader accepts: those of files, and as the writer writes them.
std::vector<std::string> validSessions() {
    std::vector<std::string> texts = sessionFiles();
    texts.push_back(sessionWith(""));
    texts.push_back(sessionWith(R"("$schema": "session.schema.json", "author": "x")"));
    texts.push_back(sessionWithEveryKey());
    texts.push_back(sessionWithEveryEvent());
    const std::size_t count = texts.size();
    for (std::size_t i = 0; i < count; ++i) {
        texts.push_back(formatSession(parseSession(texts[i], "/folder")));
    }
    return texts;
}

// What a schema can't tell, by words of the reader's sentence: comparisons of values, what some
// value needs beside it, and names that lead out of a folder, or to a file of the replay, on a
// detour.
constexpr std::array kBeyondSchemas{"a and b are the same point",
                                    "low to be no higher than high",
                                    "eye and target are the same",
                                    "up must not point along the line of sight",
                                    "not a file inside the output",
                                    "is written by the replay itself",
                                    "can't lie in",
                                    "there is nothing to do",
                                    "a line has two points at least",
                                    "two points in a row are the same",
                                    "it points along a line",
                                    "it has no direction",
                                    "it needs the `path` of an expert",
                                    "it needs a `depth` and a `band`",
                                    "material: /folder/",
                                    "material: folder/"};

/// Nor can it compare a step with the number of steps; it knows the largest number of all.
bool isOfStepWithin(const std::string& refusal, const json& session) {
    if (!refusal.starts_with("events[") || refusal.find("].step: ") == std::string::npos ||
        refusal.find("is out of range") == std::string::npos) {
        return false;
    }
    return std::ranges::none_of(session.at("events"), [](const json& event) {
        return event.is_object() && event.contains("step") && event["step"].is_number() &&
               (event["step"] < 0 || event["step"] > kMaxSteps);
    });
}

bool canBeTold(const std::string& refusal, const json& session) {
    return !isOfStepWithin(refusal, session) &&
           std::ranges::none_of(kBeyondSchemas, [&](const char* words) {
               return refusal.find(words) != std::string::npos;
           });
}

/// The place that a sentence of the reader names: "events[3].a".
std::string placeOf(const std::string& refusal) {
    return refusal.substr(0, refusal.find(": "));
}

bool lies(const std::string& place, const std::string& inside) {
    return place == inside || place.starts_with(inside + ".") || place.starts_with(inside + "[");
}

/// An editor may mark the whole that the reader names a part of, or the other way round.
bool isNear(const std::string& marked, const std::string& named) {
    return lies(named, marked.empty() ? "top level" : marked) || lies(marked, named);
}

class SessionSchema : public ::testing::Test {
  protected:
    void SetUp() override {
        if (!hasSchemaValidator()) {
            GTEST_SKIP() << "python3-jsonschema is not installed";
        }
    }
};

TEST(SessionSchemaFile, IsThatOfTheProgramAndWhatItsVerbPrints) {
    EXPECT_EQ(schemaFile("session.schema.json", sessionSchema()), sessionSchema())
        << "Renew it: KERF_RENEW=1 build/kerf_app_tests --gtest_filter='*Schema*'";
    const ProgramRun run = runKerf({"schema"});
    EXPECT_EQ(run.exitCode, 0) << run.errors;
    EXPECT_EQ(run.out, sessionSchema());
}

TEST(SessionSchemaFile, IsWhatVsCodeTakesForSessionsInThisFolder) {
    const fs::path folder(KERF_SOURCE_DIR);
    const json settings = json::parse(readBytes(folder / ".vscode/settings.json"));
    const json& mapping = settings.at("json.schemas").at(0);
    EXPECT_EQ(mapping.at("fileMatch"), json({"*.kerf.json"}));
    EXPECT_TRUE(fs::equivalent(folder / mapping.at("url").get<std::string>(),
                               folder / "docs/session.schema.json"));
}

TEST(SessionSchemaFile, PageNamesEveryKeyOfASession) {
    const std::string page = readBytes(KERF_SOURCE_DIR "/docs/session-format.md");
    const json schema = json::parse(sessionSchema());
    for (const auto& [key, value] : schema["properties"].items()) {
        EXPECT_NE(page.find("`" + key + "`"), std::string::npos) << key;
        EXPECT_TRUE(value.contains("description")) << key;
    }
}

TEST_F(SessionSchema, AcceptsWhatTheReaderAccepts) {
    const std::vector<std::string> texts = validSessions();
    ASSERT_GT(texts.size(), 60u);
    const auto places = placesWrongBySchema(texts);
    ASSERT_EQ(places.size(), texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
        EXPECT_EQ(schemaRefusalOf(texts[i]), "") << texts[i];
        EXPECT_EQ(places[i], std::vector<std::string>{}) << texts[i];
    }
}

// Of the mistakes that the tests of the reader know, those that are none by the schema.
const std::set<std::string> kComparisons{"BoxUpsideDown",     "NoLength",
                                         "EyeAtTarget",       "UpAlongView",
                                         "EventAfterTheEnd",  "IdleTask",
                                         "ShortTaskLine",     "TaskLineThatStands",
                                         "TaskAlongItsLine",  "TaskWithoutDirection",
                                         "TaskSparesNoModel", "TaskTakesWhatItCuts",
                                         "TaskWithoutBand",   "TaskWithoutExpertsPath"};
const std::set<std::string> kDetours{"FileAbove", "FileInFile"};
const std::set<std::string> kNoDocuments{"Empty",   "NaN",           "HugeNumber",
                                         "TwoKeys", "TwoKeysInside", "TwoKeysDeepInside",
                                         "NotUtf8", "TrailingText"};

TEST_F(SessionSchema, NamesThePlaceThatTheReaderNames) {
    std::vector<BrokenSession> broken = brokenSessions();
    std::erase_if(broken, [](const auto& session) { return kNoDocuments.contains(session.name); });
    std::vector<std::string> texts;
    std::ranges::transform(broken, std::back_inserter(texts), &BrokenSession::text);
    const auto places = placesWrongBySchema(texts);
    ASSERT_EQ(places.size(), texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::string& name = broken[i].name;
        const bool beyond = kComparisons.contains(name) || kDetours.contains(name);
        const std::string named = placeOf(schemaRefusalOf(texts[i]));
        EXPECT_EQ(std::ranges::any_of(places[i], [&](auto& p) { return isNear(p, named); }),
                  !beyond)
            << name << ": " << named << " but " << json(places[i]);
    }
}

/// What may stand in the place of any value.
const char* const kOtherValues =
    R"([null, true, -1, 0, 1, 2, 0.5, 1.5, 1.0, 1e6, 1000001, 1e7, -1e300, 1e-9, 59, 8193,
    "", "x", "pbd", "sphere20", "blade", "set", "pin", "floor", "gravity", "a.png",
    "a.PLY", ".png", "../a.png", "b/../a.obj", "final.ply", "0123456789abcdef", [], {},
    [0, 0, 0], [1, 2, 3], [0, 1], [0, 1, 2, 3], [0, -101, 0], [0, 1, "2"], [{}]])";

/// Changes sessions at random, each to a document that is still JSON.
class DocumentMutator {
  public:
    explicit DocumentMutator(std::uint32_t seed) : random_(seed) {}

    json changed(json document) {
        for (int count = 1 + below(2); count > 0; --count) {
            change(document);
        }
        return document;
    }

  private:
    int below(std::size_t count) { return static_cast<int>(random_() % count); }

    /// Walks down to some object or list, and changes one of its items.
    void change(json& container) {
        if (container.empty()) {
            return;
        }
        auto item = container.begin();
        std::advance(item, below(container.size()));
        if (item->is_structured() && below(4) != 0) {
            change(*item);
        } else if (below(4) == 0) {
            container.erase(item);
        } else if (below(4) == 0 && container.is_object()) {
            container[oneKey()] = oneValue();
        } else if (below(3) == 0 && item->is_number()) {
            *item = item->get<double>() * (below(2) == 0 ? 1.5 : -1);
        } else {
            *item = oneValue();
        }
    }

    const json& oneValue() { return values_[below(values_.size())]; }

    std::string oneKey() {
        constexpr std::array kKeys{"hand",   "continues", "radius", "low",   "high", "a",
                                   "pieces", "hash",      "path",   "width", "box",  "friction"};
        return kKeys[below(kKeys.size())];
    }

    std::mt19937 random_;
    std::vector<json> values_ = json::parse(kOtherValues).get<std::vector<json>>();
};

/// Sessions with one event each, beside those with all keys: a change shall often meet something.
std::vector<json> documentsToChange() {
    std::vector<json> documents{json::parse(sessionWithEveryKey())};
    json all = json::parse(sessionWithEveryEvent());
    const json events = all.at("events");
    for (const json& event : events) {
        all["events"] = {event};
        documents.push_back(all);
        documents.push_back(json::parse(sessionWithEvent(event.dump())));
    }
    return documents;
}

std::vector<std::string> changedSessions(std::uint32_t seed) {
    const std::vector<json> documents = documentsToChange();
    DocumentMutator mutator(seed);
    std::vector<std::string> texts;
    texts.reserve(kMutations);
    for (int i = 0; i < kMutations; ++i) {
        texts.push_back(mutator.changed(documents[i % documents.size()]).dump());
    }
    return texts;
}

TEST_F(SessionSchema, AgreesWithTheReaderOnRandomSessions) {
    const std::uint32_t seed = fuzzSeed(kSeed);
    const std::vector<std::string> texts = changedSessions(seed);
    const auto places = placesWrongBySchema(texts);
    ASSERT_EQ(places.size(), texts.size());
    int accepted = 0;
    int told = 0;
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const std::string refusal = schemaRefusalOf(texts[i]);
        if (refusal.empty()) {
            ++accepted;
            EXPECT_EQ(places[i], std::vector<std::string>{}) << "seed " << seed << ": " << texts[i];
        } else if (canBeTold(refusal, json::parse(texts[i]))) {
            ++told;
            EXPECT_FALSE(places[i].empty()) << "seed " << seed << ": " << refusal << texts[i];
        }
    }
    EXPECT_GT(accepted, kMutations / 10);
    EXPECT_GT(told, kMutations / 10);
}

}  // namespace
}  // namespace kerf::app
