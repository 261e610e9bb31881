#include "python/log.h"

#include <pybind11/pybind11.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>

#include <mutex>

namespace kerf::python {
namespace {

namespace py = pybind11;

struct Line {
    spdlog::level::level_enum level;
    std::string text;
};

class Collector : public spdlog::sinks::base_sink<std::mutex> {
  public:
    std::vector<Line> take() {
        const std::lock_guard lock(mutex_);
        return std::exchange(lines_, {});
    }

  protected:
    void sink_it_(const spdlog::details::log_msg& message) override {
        lines_.push_back(
            {message.level, std::string(message.payload.data(), message.payload.size())});
    }
    void flush_() override {}

  private:
    std::vector<Line> lines_;
};

const std::shared_ptr<Collector>& collector() {
    static const auto one = std::make_shared<Collector>();
    return one;
}

/// The number that Python's logging gives to a level.
int pythonLevel(spdlog::level::level_enum level) {
    constexpr int kStep = 10;  // from DEBUG to CRITICAL
    return kStep * std::max(1, static_cast<int>(level));
}

void deliver(const std::vector<Line>& lines) {
    const py::object logger = py::module_::import("logging").attr("getLogger")("kerf");
    for (const Line& line : lines) {
        logger.attr("log")(pythonLevel(line.level), "%s", line.text);
    }
}

}  // namespace

void catchLog() {
    spdlog::set_default_logger(std::make_shared<spdlog::logger>("kerf", collector()));
}

// NOLINTNEXTLINE(bugprone-exception-escape): without memory for a line there is no way on
LogDelivery::~LogDelivery() {
    const std::vector<Line> lines = collector()->take();
    if (lines.empty()) {
        return;
    }
    const py::error_scope kept;  // what is on its way to Python stays
    try {
        deliver(lines);
    } catch (py::error_already_set& error) {
        error.discard_as_unraisable("kerf");  // a handler of the script's failed
    }
}

}  // namespace kerf::python
