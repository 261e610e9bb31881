#pragma once

namespace kerf {

/// A checkpoint of a simulation between two steps, with its undo history, for seeking. Only for the
/// simulation that made it, which must outlive it.
class Moment {
  public:
    struct Content;
    explicit Moment(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
    const Content& content() const { return *content_; }

  private:
    std::shared_ptr<const Content> content_;
};

/// A moment as bytes, without its undo history, from which Simulation::goTo() continues bit for
/// bit: in another process, too, of the same program and with the same models. Nothing while a
/// blade is placed. On any thread.
std::optional<std::vector<std::byte>> bytesOf(const Moment& moment);

}  // namespace kerf
