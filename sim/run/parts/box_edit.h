#pragma once

#include "sim/run/parts/command.h"

namespace kerf {

/// The change of the boxes that a command makes.
struct BoxEdit {
    std::string error;             ///< "" or one sentence; then the rest is invalid
    std::string name;              ///< as the history shows it: "Box 2 added"
    std::vector<StaticBox> after;  ///< all boxes
    int changed = -1;              ///< number of the box that was changed; -1 for none
    bool continues = false;        ///< see ChangeBox
};
BoxEdit edited(const std::vector<StaticBox>& boxes, const AddBox& add);
BoxEdit edited(const std::vector<StaticBox>& boxes, const ChangeBox& change);
BoxEdit edited(const std::vector<StaticBox>& boxes, const RemoveBox& remove);

}  // namespace kerf
