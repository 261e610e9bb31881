#pragma once

#include <pybind11/numpy.h>

#include "python/scripted_run.h"

namespace kerf::python {

/// The numbers of `owner` as an array of NumPy that keeps them and copies nothing. It is read-only:
/// others may have the same ones.
template <class Number>
pybind11::array_t<Number> arrayOf(const SharedArray<Number>& owner,
                                  std::vector<pybind11::ssize_t> shape) {
    namespace py = pybind11;
    auto* const kept = new SharedArray<Number>(owner);
    const py::capsule base(kept, [](void* it) { delete static_cast<SharedArray<Number>*>(it); });
    py::array_t<Number> array(std::move(shape), owner->data(), base);
    array.attr("flags").attr("writeable") = false;
    return array;
}

/// One entry each.
template <class Number>
pybind11::array_t<Number> listOf(const SharedArray<Number>& owner) {
    return arrayOf(owner, {static_cast<pybind11::ssize_t>(owner->size())});
}

/// Three entries each.
template <class Number>
pybind11::array_t<Number> tableOf(const SharedArray<Number>& owner) {
    return arrayOf(owner, {static_cast<pybind11::ssize_t>(owner->size() / 3), 3});
}

}  // namespace kerf::python
