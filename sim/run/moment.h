#pragma once

#include <memory>

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

}  // namespace kerf
