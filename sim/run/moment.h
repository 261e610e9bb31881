#pragma once

#include <memory>

namespace kerf {

/// A simulation between two steps, the changes that can be undone included: what a
/// replay that is scrubbed goes back to. Of use to the simulation that made it alone, which must
/// outlive it.
class Moment {
  public:
    struct Content;
    explicit Moment(std::shared_ptr<const Content> content) : content_(std::move(content)) {}
    const Content& content() const { return *content_; }

  private:
    std::shared_ptr<const Content> content_;
};

}  // namespace kerf
