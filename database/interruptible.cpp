// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/interruptible.h"

#include <sqlite3.h>

namespace chiron::database {

Interruptible::Interruptible(Connection& connection, const std::atomic<bool>* cancel)
    : m_connection(connection) {
    constexpr int kAskEvery_instructions = 1000;
    if (cancel != nullptr) {
        sqlite3_progress_handler(
            connection.handle(), kAskEvery_instructions,
            [](void* flag) { return isSet(static_cast<const std::atomic<bool>*>(flag)) ? 1 : 0; },
            const_cast<std::atomic<bool>*>(cancel));
    }
}

Interruptible::~Interruptible() {
    sqlite3_progress_handler(m_connection.handle(), 0, nullptr, nullptr);
}

} // namespace chiron::database
