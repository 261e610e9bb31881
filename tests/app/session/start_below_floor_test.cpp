// A model that starts below the floor is told.
#include <gmock/gmock.h>

#include "app/files/import/model_source.h"
#include "app/session/session.h"

namespace kerf::app {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> remarksOn(const std::string& rest) {
    return loadSessionModel(parseSession(R"({"format": "kerf-session", "version": 1, "steps": 1,
                                             "model": {"builtin": "sphere80"}, )" +
                                             rest + "}",
                                         {}))
        .remarks;
}

TEST(StartBelowFloor, IsTold) {
    const std::string sentence =
        "sphere80 starts 25 cm below the floor and will be pushed up; raise it by \"placement\".";
    EXPECT_THAT(remarksOn(R"("params": {"floor": 0}, "placement": {"scale": 0.5})"),
                ElementsAre(sentence));
    EXPECT_THAT(remarksOn(R"("params": {"floor": -0.25}, "placement": {"scale": 0.5})"), IsEmpty());
    EXPECT_THAT(remarksOn(R"("params": {"floor": null}, "placement": {"scale": 0.5})"), IsEmpty());
}

TEST(StartBelowFloor, IsMeasuredFarFromTheOriginToo) {
    EXPECT_THAT(
        remarksOn(R"("params": {"floor": 1e6}, "placement": {"translate": [0, 1000002, 0]})"),
        testing::Each(testing::Not(testing::HasSubstr("below the floor"))));
}

}  // namespace
}  // namespace kerf::app
