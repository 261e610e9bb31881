#include <gmock/gmock.h>

#include <random>

#include "app/editor/view/input_queue.h"

namespace kerf::app {
namespace {

using ui::Button;
using ui::ButtonChange;
using ui::InputEvent;
using ui::Key;
using ui::KeyChange;
using ui::PointerMove;
using ui::Wheel;

const InputEvent kMove = PointerMove{1, 2, {}};
const InputEvent kDown = ButtonChange{Button::left, true, {}};
const InputEvent kUp = ButtonChange{Button::left, false, {}};

InputEvent key(Key k, bool down) {
    return KeyChange{k, down, {}};
}

std::vector<std::size_t> batchSizes(const std::vector<InputEvent>& events) {
    InputQueue queue;
    for (const InputEvent& event : events) {
        queue.push(event);
    }
    std::vector<std::size_t> sizes;
    while (!queue.empty()) {
        sizes.push_back(queue.takeBatch().size());
    }
    return sizes;
}

using ::testing::ElementsAre;

TEST(InputQueue, MovesShareABatch) {
    EXPECT_THAT(batchSizes({kMove, kMove, kMove}), ElementsAre(3));
}

TEST(InputQueue, AMoveAndAButtonNeverShare) {
    EXPECT_THAT(batchSizes({kMove, kDown, kMove, kMove, kUp, kMove}), ElementsAre(1, 1, 2, 1, 1));
}

TEST(InputQueue, AFastClickIsTwoBatches) {
    EXPECT_THAT(batchSizes({kDown, kUp, kDown, kUp}), ElementsAre(1, 1, 1, 1));
}

TEST(InputQueue, AWheelTurnsWhereThePointerIs) {
    EXPECT_THAT(batchSizes({kMove, Wheel{0, 1}, Wheel{0, 1}, kDown}), ElementsAre(3, 1));
}

TEST(InputQueue, AKeyGoesDownAndUpInTwoBatches) {
    EXPECT_THAT(batchSizes({key(Key::a, true), key(Key::a, false)}), ElementsAre(1, 1));
    EXPECT_THAT(batchSizes({key(Key::a, false), key(Key::b, true), kMove}), ElementsAre(3));
    EXPECT_THAT(batchSizes({key(Key::a, true), key(Key::b, true), kMove}), ElementsAre(1, 2));
}

TEST(InputQueue, LosingTheFocusCountsAsAButton) {
    EXPECT_THAT(batchSizes({kMove, ui::FocusLost{}, kMove}), ElementsAre(1, 1, 1));
}

TEST(InputQueue, NothingIsLostAndTheOrderIsKept) {
    const unsigned seed = 7;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    InputQueue queue;
    for (int i = 0; i < 1000; ++i) {
        // The x of moves and the code of characters number the events.
        switch (random() % 3) {
            case 0:
                queue.push(PointerMove{double(i), 0, {}});
                break;
            case 1:
                queue.push(ButtonChange{Button::left, i % 2 == 0, {}});
                break;
            default:
                queue.push(ui::Character{static_cast<std::uint32_t>(i)});
        }
    }
    std::size_t taken = 0;
    double last = -1;
    while (!queue.empty()) {
        const std::vector<InputEvent> batch = queue.takeBatch();
        ASSERT_FALSE(batch.empty());
        int moves = 0;
        int buttons = 0;
        for (const InputEvent& event : batch) {
            if (const auto* move = std::get_if<PointerMove>(&event)) {
                ASSERT_GT(move->x, last);
                last = move->x;
                ++moves;
            } else if (const auto* typed = std::get_if<ui::Character>(&event)) {
                ASSERT_GT(typed->code, last);
                last = typed->code;
            } else {
                ++buttons;
            }
        }
        ASSERT_TRUE(buttons == 0 || (buttons == 1 && moves == 0));
        taken += batch.size();
    }
    EXPECT_EQ(taken, 1000U);
}

}  // namespace
}  // namespace kerf::app
