#include "app/practice/score_table.h"

#include "app/files/io/csv.h"
#include "app/files/io/data_page.h"
#include "app/practice/score.h"
#include "sim/base/text.h"

namespace kerf::app {

namespace {

using Json = nlohmann::ordered_json;

std::string cellOf(const Json& value) {
    if (value.is_array()) {
        return joined(value, " ", cellOf);
    }
    return value.is_null() ? "" : value.is_string() ? std::string(value) : value.dump();
}

/// The keys of a score that have a column.
std::vector<std::string> columns() {
    std::vector<std::string> keys;
    const Json score = toJson(Score{}, Task{});
    for (const auto& [key, value] : score.items()) {
        keys.push_back(key);
    }
    std::erase(keys, "limits");
    return keys;
}

/// What the page must know of the figures.
Json figuresAsJson() {
    Json figures = Json::array();
    for (const FigureRow& row : figureRows()) {
        figures.push_back({{"key", row.key},
                           {"label", row.label},
                           {"unit", row.unit.name},
                           {"factor", row.unit.factor},
                           {"digits", row.unit.digits},
                           {"flag", row.unit.isFlag},
                           {"better", row.better}});
    }
    return figures;
}

}  // namespace

bool isScore(const Json& json) {
    const Json empty = toJson(Score{}, Task{});
    const auto isAlike = [&](const auto& item) {
        const Json found = json.value(item.key(), Json(Json::value_t::discarded));
        return item.value().is_null() ? found.is_null() || found.is_number() || found.is_boolean()
                                      : found.type() == item.value().type();
    };
    const auto items = empty.items();
    return json.is_object() && std::all_of(items.begin(), items.end(), isAlike);
}

void sortTries(std::vector<Scored>& tries) {
    std::ranges::sort(tries, {}, [](const Scored& scored) {
        const Json& score = scored.score;
        return std::vector<std::string>{score["person"], score["task"], score["date"], scored.file};
    });
}

std::string scoresAsCsv(const std::vector<Scored>& tries) {
    std::string text = "file," + joined(columns(), ",") + "\n";
    for (const Scored& scored : tries) {
        text += csvCell(scored.file);
        for (const std::string& key : columns()) {
            text += "," + csvCell(cellOf(scored.score[key]));
        }
        text += "\n";
    }
    return text;
}

std::string scoresAsHtml(const std::vector<Scored>& tries) {
    Json scores = Json::array();
    for (const Scored& scored : tries) {
        scores.push_back(scored.score);
        scores.back()["file"] = scored.file;
    }
    return dataPage("score.html", {{"figures", figuresAsJson()}, {"tries", scores}});
}

}  // namespace kerf::app
