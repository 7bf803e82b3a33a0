// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/connection.h"

#include <atomic>

namespace chiron::database {

/// Returns whether cancellation was requested; null: it cannot be requested.
inline bool isSet(const std::atomic<bool>* cancel) noexcept {
    return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

/// While this object lives, SQLite interrupts this connection's work once `cancel` is set.
/// Thread: that of the connection.
class Interruptible {
public:
    Interruptible(Connection& connection, const std::atomic<bool>* cancel);
    Interruptible(const Interruptible&) = delete;
    Interruptible& operator=(const Interruptible&) = delete;
    ~Interruptible();

private:
    Connection& m_connection;
};

} // namespace chiron::database
