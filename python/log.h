#pragma once

namespace kerf::python {

/// Keeps what is logged from now on, on whatever thread, for Python's logger "kerf".
void catchLog();

/// Hands over, at its end, what was logged. Made and destroyed with Python's lock held.
class LogDelivery {
  public:
    LogDelivery() = default;
    ~LogDelivery();
    LogDelivery(const LogDelivery&) = delete;
    LogDelivery& operator=(const LogDelivery&) = delete;
};

}  // namespace kerf::python
