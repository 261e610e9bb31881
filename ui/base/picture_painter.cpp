#include "ui/base/picture_painter.h"

#include <backends/imgui_impl_opengl3.h>
#include <glad/gl.h>
#include <imgui.h>

#include "gpu/framebuffer.h"
#include "ui/base/widgets.h"

namespace kerf::ui {

PicturePainter::PicturePainter(Theme theme, float scale) : context_(theme, scale) {
    draw(1, 1, [] {});  // fonts can be measured after a first frame
}

render::Image PicturePainter::draw(int width, int height, const std::function<void()>& content) {
    context_.makeCurrent();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(width), static_cast<float>(height)};
    const gpu::Framebuffer picture(GL_RGBA8, GL_DEPTH_COMPONENT24, width, height);
    // A new window is laid out in its first frame and shown from the second on.
    for (int frame = 0; frame < 2; ++frame) {
        ImGui_ImplOpenGL3_NewFrame();
        ImGui::NewFrame();
        beginPanel("picture", {0, 0, io.DisplaySize.x, io.DisplaySize.y});
        content();
        ImGui::End();
        ImGui::Render();
    }
    glUseProgram(0);  // ImGui brings back the one in use, which its owner may have deleted
    picture.bind();
    const ImVec4 ground = ImGui::GetStyleColorVec4(ImGuiCol_WindowBg);  // behind round corners
    glClearColor(ground.x, ground.y, ground.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    return {width, height, picture.readColor()};
}

}  // namespace kerf::ui
