#pragma once

namespace kerf {

/// The state of a simulation between two steps, with its undo history and what the blade is told
/// for the coming step. Only for the simulation that made it, which must outlive it.
class Checkpoint {
  public:
    struct Content;
    explicit Checkpoint(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
    const Content& content() const { return *content_; }

  private:
    std::shared_ptr<const Content> content_;
};

/// A checkpoint as bytes, without its undo history, from which Simulation::goTo() continues bit for
/// bit: in another process, too, of the same program and with the same models. They hold the state
/// hash, by which they are checked. Nothing while a blade is placed. On any thread.
std::optional<std::vector<std::byte>> bytesOf(const Checkpoint& checkpoint);

}  // namespace kerf
