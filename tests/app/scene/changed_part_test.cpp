#include "app/scene/timeline/changed_part.h"

namespace kerf::app {
namespace {

/// A list that is changed at random, and a copy that is told of the changes alone.
class Copied {
  public:
    void change(std::mt19937& random) {
        const auto below = [&](std::size_t most) { return random() % (most + 1); };
        const std::size_t from = below(list_.size());
        const std::size_t to = from + below(list_.size() - from);
        const auto begin = list_.begin() + static_cast<std::ptrdiff_t>(from);
        if (random() % 3 == 0) {
            list_.erase(begin, list_.begin() + static_cast<std::ptrdiff_t>(to));
            part_.touch(from, from, list_.size());
        } else if (random() % 2 == 0) {
            for (std::size_t i = from; i < to; ++i) {
                list_[i] = ++last_;
            }
            part_.touch(from, to, list_.size());
        } else {
            list_.insert(begin, ++last_);
            part_.touch(from, from + 1, list_.size());
        }
    }
    void tell() {
        const ChangedPart::Splice splice = part_.take(list_.size(), false);
        const auto at = copy_.begin() + static_cast<std::ptrdiff_t>(splice.at);
        const auto next = copy_.erase(at, at + static_cast<std::ptrdiff_t>(splice.dropped));
        const auto added = list_.begin() + static_cast<std::ptrdiff_t>(splice.at);
        copy_.insert(next, added, added + static_cast<std::ptrdiff_t>(splice.added));
    }
    bool same() const { return list_ == copy_; }

  private:
    std::vector<int> list_;
    std::vector<int> copy_;
    int last_ = 0;
    ChangedPart part_;
};

TEST(ChangedPart, ACopyThatIsToldOfTheChangesAloneStaysTheSame) {
    std::mt19937 random(7);
    Copied list;
    for (int round = 0; round < 3000; ++round) {
        for (unsigned i = random() % 4; i > 0; --i) {
            list.change(random);
        }
        list.tell();
        ASSERT_TRUE(list.same()) << round;
    }
}

TEST(ChangedPart, OfAListThatStaysNothingIsTold) {
    ChangedPart part;
    part.touch(0, 3, 3);
    EXPECT_EQ(part.take(3, false).added, 3U);
    EXPECT_TRUE(part.take(3, false).empty());
    EXPECT_EQ(part.take(3, true).added, 3U);
}

}  // namespace
}  // namespace kerf::app
