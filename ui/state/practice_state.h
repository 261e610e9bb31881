#pragma once

#include <string>
#include <vector>

namespace kerf::ui {

/// A figure of a score, as text with its unit; "" where there is none.
struct ScoreRow {
    std::string figure;
    std::string now;
    std::string last;    ///< of one's own last try
    std::string expert;  ///< of the session that shows it
    std::string limit;   ///< "at most 2.00 mm"
    bool broken = false;
};

/// The task of the open session, and the score once the try is finished.
struct PracticeState {
    std::string name;  ///< empty: the session has no task
    std::string about;
    bool hasExpert = false;
    bool hasLast = false;
    bool finished = false;
    std::vector<ScoreRow> rows;
    std::vector<std::string> violations;  ///< of the finished try; it passed without any
};

}  // namespace kerf::ui
