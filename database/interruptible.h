// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/connection.h"

#include <atomic>

namespace chiron::database {

/// Whether somebody asked to stop; null: nobody can.
inline bool isSet(const std::atomic<bool>* cancel) noexcept {
    return cancel != nullptr && cancel->load(std::memory_order_relaxed);
}

/// While it lives, SQLite breaks off what this connection does once `cancel` is set. On the connection's thread.
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
