#include <imgui.h>

#include "ui/base/layout.h"
#include "ui/panels/panels.h"

namespace kerf::ui {

bool beginSection(const char* id, const char* title, const Settings& chosen,
                  std::vector<Action>& actions) {
    const std::vector<std::string>& folded = chosen.folded;
    const bool open = std::ranges::find(folded, id) == folded.end();
    ImGui::SetNextItemOpen(open, ImGuiCond_Always);
    const bool wanted = ImGui::CollapsingHeader((std::string(title) + "###" + id).c_str());
    noteItem(std::string("section.") + id);
    if (wanted != open) {
        Settings settings = chosen;
        std::erase(settings.folded, id);
        if (!wanted) {
            settings.folded.emplace_back(id);
        }
        actions.emplace_back(SetSettings{settings});
    }
    return open;
}

}  // namespace kerf::ui
