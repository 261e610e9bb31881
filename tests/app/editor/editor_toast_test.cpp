#include "app/editor/view/editor_toast.h"

#include <gtest/gtest.h>

namespace kerf::app {
namespace {

bool offers(const EditorToast& toast) {
    ui::PanelModel model;
    toast.describe(model);
    return model.toast.choice.has_value();
}

TEST(EditorToast, OffersAScreenshotOnceItIsSaved) {
    EditorToast toast;
    toast.offerOnceSaved({.step = 7}, 2);
    toast.show(SavingQueue::Outcome{1, "Saved plots.csv", false});
    EXPECT_FALSE(offers(toast)) << "another file";
    toast.show(SavingQueue::Outcome{2, "Saved kerf.png", false});
    ASSERT_TRUE(offers(toast));
    const std::optional<JournalPosition> place = toast.takeOffer();
    ASSERT_TRUE(place);
    EXPECT_EQ(place->step, 7);
    EXPECT_FALSE(toast.takeOffer()) << "once only";
}

TEST(EditorToast, OffersNothingThatFailedOrHasFaded) {
    EditorToast toast;
    toast.offerOnceSaved({}, 1);
    toast.show(SavingQueue::Outcome{1, "The disk is full", true});
    EXPECT_FALSE(offers(toast));
    toast.offerOnceSaved({}, 2);
    toast.show(SavingQueue::Outcome{2, "Saved kerf.png", false});
    toast.elapse(60);
    EXPECT_FALSE(toast.takeOffer());
}

}  // namespace
}  // namespace kerf::app
