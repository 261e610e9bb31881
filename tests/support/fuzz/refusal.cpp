#include "tests/support/fuzz/refusal.h"

#include "sim/base/text.h"

namespace kerf::test {

namespace {

// No text of a file is quoted whole where it is long.
constexpr std::size_t kLongest = 1200;

}  // namespace

FuzzOutcome refusedWith(const std::string& sentence) {
    if (!sentence.ends_with('.')) {
        return {false, "Its error is no sentence: " + sentence};
    }
    return refusedWithClause(sentence);
}

FuzzOutcome refusedWithClause(const std::string& clause) {
    if (clause.empty() || clause.size() > kLongest) {
        return {false, "Its error has " + std::to_string(clause.size()) + " bytes: " + clause};
    }
    return {false, printable(clause) == clause ? "" : "Its error has control characters."};
}

}  // namespace kerf::test
