#include <gtest/gtest.h>

#include "sim/run/parts/step_report.h"

namespace kerf {
namespace {

/// A step that cut at its second try, with two fronts cut anew.
CutResult aStep() {
    CutResult step;
    step.outcome = CutOutcome::cut;
    step.statistics.tries = 2;
    step.statistics.resumed = 2;
    step.statistics.debris = {.pieces = 3, .volume = 0.25};
    return step;
}

/// A step that one group of pieces refused.
CutResult refusedStep() {
    CutResult step;
    step.outcome = CutOutcome::refused;
    step.statistics.tries = 1;
    step.statistics.refusedPieces = 1;
    return step;
}

void expectSums(const StrokeRecord& record, int times) {
    EXPECT_EQ(record.cutSteps, times);
    EXPECT_EQ(record.refusedSteps, times);
    EXPECT_EQ(record.retriedSteps, times);
    EXPECT_EQ(record.cutAnew, 2 * times);
    EXPECT_EQ(record.debris.pieces, 3 * times);
    EXPECT_DOUBLE_EQ(record.debris.volume, 0.25 * times);
}

TEST(StrokeRecord, SumsUpItsSteps) {
    StrokeRecord record;
    EXPECT_FALSE(record.metBody());
    record.add(aStep());
    record.add(refusedStep());
    EXPECT_TRUE(record.metBody());
    expectSums(record, 1);
}

TEST(StrokeRecord, SumsUpOtherStrokes) {
    StrokeRecord one;
    one.add(aStep());
    one.add(refusedStep());
    StrokeRecord all;
    all.add(one);
    all.add(one);
    expectSums(all, 2);
}

}  // namespace
}  // namespace kerf
