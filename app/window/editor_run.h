#pragma once

namespace kerf::app {

class Editor;
class Window;

/// Lets an editor live in its window, which posts input to it, until `isOver` or until a person
/// quits: works and draws while something moves, and else waits, so a still picture costs nothing.
void runLoop(Window& window, Editor& editor, const std::function<bool()>& isOver = {});

}  // namespace kerf::app
