#include "sim/run/parts/box_edit.h"

#include <spdlog/fmt/fmt.h>

namespace kerf {

namespace {

std::string checkIndex(const std::vector<StaticBox>& boxes, int index) {
    if (index >= 0 && index < static_cast<int>(boxes.size())) {
        return "";
    }
    return boxes.empty() ? "There is no box yet; add one first."
                         : fmt::format("There is no box {}; they count from 0 to {}.", index,
                                       boxes.size() - 1);
}

BoxEdit refused(std::string error) {
    BoxEdit edit;
    edit.error = std::move(error);
    return edit;
}

}  // namespace

BoxEdit edited(const std::vector<StaticBox>& boxes, const AddBox& add) {
    std::string error = checkBox(add.box);
    if (error.empty() && boxes.size() >= kMostBoxes) {
        error = fmt::format("There are {} boxes already; remove one first.", boxes.size());
    }
    if (!error.empty()) {
        return refused(std::move(error));
    }
    BoxEdit edit{"", fmt::format("Box {} added", boxes.size()), boxes};
    edit.after.push_back(add.box);
    return edit;
}

BoxEdit edited(const std::vector<StaticBox>& boxes, const ChangeBox& change) {
    std::string error = checkIndex(boxes, change.index);
    error = error.empty() ? checkBox(change.box) : error;
    if (!error.empty()) {
        return refused(std::move(error));
    }
    BoxEdit edit{"", fmt::format("Box {} changed", change.index), boxes, change.index,
                 change.continues};
    edit.after[change.index] = change.box;
    return edit;
}

BoxEdit edited(const std::vector<StaticBox>& boxes, const RemoveBox& remove) {
    if (std::string error = checkIndex(boxes, remove.index); !error.empty()) {
        return refused(std::move(error));
    }
    BoxEdit edit{"", fmt::format("Box {} removed", remove.index), boxes};
    edit.after.erase(edit.after.begin() + remove.index);
    return edit;
}

}  // namespace kerf
