#pragma once

#include <map>
#include <string>

#include "ui/base/layout.h"

namespace kerf::ui {

/// The rectangles in which named items of the panels were drawn in the last update [px]. Tests
/// click on them, so that they do not depend on the layout.
using ItemRects = std::map<std::string, Rect, std::less<>>;

/// Records the last item under a name ("transport.play") in the rectangles of the current update.
void noteItem(const std::string& name);

/// A scope in which noteItem() writes into the given rectangles.
class ItemNotes {
  public:
    explicit ItemNotes(ItemRects& rects);
    ~ItemNotes();
    ItemNotes(const ItemNotes&) = delete;
    ItemNotes& operator=(const ItemNotes&) = delete;
};

}  // namespace kerf::ui
