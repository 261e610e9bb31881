#pragma once

namespace kerf::python {

/// Keeps what is logged from now on, on whatever thread, for Python's logger "kerf".
void catchLog();

/// Hands over what was logged until its end. To be made and to end with Python's lock.
class LogDelivery {
  public:
    LogDelivery() = default;
    ~LogDelivery();
    LogDelivery(const LogDelivery&) = delete;
    LogDelivery& operator=(const LogDelivery&) = delete;
};

}  // namespace kerf::python
