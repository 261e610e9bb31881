#include "app/scene/timeline/hooks.h"

namespace kerf::app {

std::vector<Hands::Hand> hooksOf(const std::vector<Hands::Hand>& hands) {
    std::vector<Hands::Hand> hooks;
    std::ranges::copy_if(hands, std::back_inserter(hooks),
                         [](const Hands::Hand& hand) { return isHook(hand.number); });
    return hooks;
}

std::optional<int> freeRetractor(const std::vector<Hands::Hand>& hands) {
    const auto isFree = [&](int hook) {
        return std::ranges::count(hands, hook, &Hands::Hand::number) == 0;
    };
    for (int hook = kFirstHook; hook < kLastHook; hook += 2) {
        if (isFree(hook) && isFree(partnerOf(hook))) {
            return hook;
        }
    }
    return std::nullopt;
}

}  // namespace kerf::app
