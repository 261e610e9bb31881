#pragma once

#include <pybind11/pybind11.h>

#include "python/scripted_run.h"

namespace kerf::python {

/// Numbers in memory, with what keeps them there, for Python's buffer protocol. NumPy reads that in
/// all its versions, so the module is compiled for none of them.
class NumberBlock {
  public:
    /// Read-only: others may have the same numbers.
    template <class Number>
    explicit NumberBlock(const SharedArray<Number>& owner)
        : owner_(owner), info_([data = owner->data(), size = owner->size()] {
              return pybind11::buffer_info(data, static_cast<pybind11::ssize_t>(size));
          }) {}
    explicit NumberBlock(std::vector<std::uint8_t>&& bytes) {
        const auto owner = std::make_shared<std::vector<std::uint8_t>>(std::move(bytes));
        owner_ = owner;
        info_ = [data = owner->data(), size = owner->size()] {
            return pybind11::buffer_info(data, static_cast<pybind11::ssize_t>(size));
        };
    }

    pybind11::buffer_info info() const { return info_(); }

  private:
    std::shared_ptr<const void> owner_;
    std::function<pybind11::buffer_info()> info_;
};

/// An array of NumPy on these numbers, without a copy. One length of -1 follows from the others.
template <class... Lengths>
pybind11::object arrayOf(NumberBlock block, Lengths... shape) {
    return pybind11::module_::import("numpy")
        .attr("asarray")(std::move(block))
        .attr("reshape")(shape...);
}

/// One entry each.
template <class Number>
pybind11::object listOf(const SharedArray<Number>& owner) {
    return arrayOf(NumberBlock(owner), -1);
}

/// Three entries each.
template <class Number>
pybind11::object tableOf(const SharedArray<Number>& owner) {
    return arrayOf(NumberBlock(owner), -1, 3);
}

}  // namespace kerf::python
