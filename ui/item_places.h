#pragma once

#include <map>
#include <string>

#include "ui/layout.h"

namespace kerf::ui {

/// Where named items of the panels were drawn in the last pass [px]: what a test clicks on, so that
/// it does not depend on the layout.
using ItemPlaces = std::map<std::string, Rect, std::less<>>;

/// Notes the last item under a name ("transport.play") in the places of the pass that runs.
void noteItem(const std::string& name);

/// While one lives, noteItem() writes into its places.
class ItemNotes {
  public:
    explicit ItemNotes(ItemPlaces& places);
    ~ItemNotes();
    ItemNotes(const ItemNotes&) = delete;
    ItemNotes& operator=(const ItemNotes&) = delete;
};

}  // namespace kerf::ui
