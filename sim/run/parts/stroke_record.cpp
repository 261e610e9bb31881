#include "sim/run/parts/stroke_record.h"

namespace kerf {

void StrokeRecord::add(const CutResult& step) {
    const CutStatistics& statistics = step.statistics;
    cutSteps += step.outcome == CutOutcome::cut ? 1 : 0;
    refusedSteps += statistics.refusedPieces > 0 ? 1 : 0;
    retriedSteps += statistics.tries > 1 ? 1 : 0;
    cutAnew += statistics.resumed;
    swept.add(statistics.swept);
    debris.add(statistics.debris);
}

void StrokeRecord::add(const StrokeRecord& other) {
    cutSteps += other.cutSteps;
    refusedSteps += other.refusedSteps;
    retriedSteps += other.retriedSteps;
    cutAnew += other.cutAnew;
    swept.add(other.swept);
    debris.add(other.debris);
}

}  // namespace kerf
