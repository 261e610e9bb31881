#include "app/practice/score_table.h"

namespace kerf::app {
namespace {

using nlohmann::ordered_json;

Scored tryOf(const std::string& person, const std::string& task, const std::string& date) {
    Task asked;
    asked.name = task;
    asked.person = person;
    asked.date = date;
    asked.limits.seconds = 20;
    Score score;
    score.time = 12.5;
    score.taken = 0;
    return {person + ".json", toJson(score, asked)};
}

TEST(ScoreTable, IsSortedByPersonTaskAndDate) {
    std::vector<Scored> tries{
        tryOf("b", "Incision", "2026-11-02"), tryOf("a", "Lump", "2026-11-01"),
        tryOf("a", "Incision", "2026-11-03"), tryOf("a", "Incision", "2026-11-02")};
    sortTries(tries);
    std::vector<std::string> order;
    order.reserve(tries.size());
    for (const Scored& scored : tries) {
        order.push_back(scored.score["person"].get<std::string>() +
                        scored.score["task"].get<std::string>() +
                        scored.score["date"].get<std::string>());
    }
    EXPECT_THAT(order, ElementsAre("aIncision2026-11-02", "aIncision2026-11-03", "aLump2026-11-01",
                                   "bIncision2026-11-02"));
}

TEST(ScoreTable, CsvHasALineForEachTryAndNothingForWhatWasNotMeasured) {
    Scored scored = tryOf("O'Neil, \"Pat\"", "Incision", "2026-11-02");
    scored.score["violations"] = {"Time: 25.00 s (at most 20.00 s).", "Undone, once."};
    EXPECT_EQ(
        scoresAsCsv({scored}),
        "file,task,person,date,deviation_mean,deviation_max,depth_mean,depth_in_band,"
        "length_under,length_over,margin_least,spared_cut,taken,excised_volume,time,path,"
        "economy,smoothness,tremor,wobble,idle_time,force_max,force_mean,undos,changes,violations,"
        "passed\n"
        "\"O'Neil, \"\"Pat\"\".json\",Incision,\"O'Neil, \"\"Pat\"\"\",2026-11-02,,,,,,,,,"
        "false,,12.5,,,,,,,,,,,\"Time: 25.00 s (at most 20.00 s). Undone, once.\",true\n");
}

TEST(ScoreTable, TheHeaderHasTheKeysOfAllFigures) {
    const std::string header = scoresAsCsv({});
    for (const FigureRow& row : figureRows()) {
        EXPECT_THAT(header, HasSubstr("," + std::string(row.key) + ",")) << row.key;
    }
}

/// The data of a page.
ordered_json dataOf(const std::string& page) {
    const std::string before = "type=\"application/json\">";
    const std::size_t begin = page.find(before) + before.size();
    return ordered_json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(ScoreTable, ThePageHasFiguresTriesAndLimits) {
    const std::string page = scoresAsHtml({tryOf("</script><b>", "Incision", "2026-11-02")});
    EXPECT_THAT(page, StartsWith("<!DOCTYPE html>"));
    EXPECT_THAT(page, Not(HasSubstr("<b>"))) << "a name is no markup";
    EXPECT_THAT(page, Not(HasSubstr("src="))) << "self-contained";
    const ordered_json data = dataOf(page);
    ASSERT_EQ(data["figures"].size(), figureRows().size());
    EXPECT_EQ(data["figures"][1].dump(),
              R"({"key":"deviation_max","label":"Largest deviation","unit":"mm",)"
              R"("factor":1000.0,"digits":2,"flag":false,"better":-1})");
    ASSERT_EQ(data["tries"].size(), 1U);
    EXPECT_EQ(data["tries"][0]["person"], "</script><b>");
    EXPECT_EQ(data["tries"][0]["limits"]["time"], 20);
    EXPECT_EQ(data["tries"][0]["file"], "</script><b>.json");
}

TEST(ScoreTable, KnowsAScoreFromOtherJson) {
    const ordered_json score = tryOf("a", "Incision", "").score;
    EXPECT_TRUE(isScore(score));
    EXPECT_FALSE(isScore(nullptr));
    EXPECT_FALSE(isScore(ordered_json::array()));
    for (const auto& [key, value] : score.items()) {
        ordered_json without = score;
        without.erase(key);
        EXPECT_FALSE(isScore(without)) << key;
        ordered_json other = score;
        other[key] = key == "violations" ? ordered_json("") : ordered_json::array({1});
        EXPECT_FALSE(isScore(other)) << key;
    }
}

}  // namespace
}  // namespace kerf::app
