// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <sqlite3.h>

namespace chiron::tests {

/// Makes SQLite refuse statements that read or write on all connections that are opened during its lifetime,
/// on any thread, as a full or failing disk does.
class RefusingAllOpened {
public:
    static constexpr int kAll = -1;
    /// `which`: the number of the statement to refuse, from 1; 0 refuses none, kAll every one.
    explicit RefusingAllOpened(int which) {
        s_which = which;
        s_seen = 0;
        sqlite3_auto_extension(reinterpret_cast<void (*)()>(&opened));
    }
    ~RefusingAllOpened() {
        sqlite3_cancel_auto_extension(reinterpret_cast<void (*)()>(&opened));
        s_which = 0; // what was opened may live on
    }
    RefusingAllOpened(const RefusingAllOpened&) = delete;
    RefusingAllOpened& operator=(const RefusingAllOpened&) = delete;

    int seen() const { return s_seen; } ///< statements so far, the refused one included

private:
    static int opened(sqlite3* handle, const char**, const void*) {
        sqlite3_set_authorizer(
            handle,
            [](void*, int action, const char*, const char*, const char*, const char*) {
                const bool begins = action == SQLITE_SELECT || action == SQLITE_INSERT ||
                                    action == SQLITE_UPDATE || action == SQLITE_DELETE;
                if (!begins)
                    return SQLITE_OK;
                const int number = ++s_seen;
                return s_which == kAll || s_which == number ? SQLITE_DENY : SQLITE_OK;
            },
            nullptr);
        return SQLITE_OK;
    }
    static inline std::atomic<int> s_which, s_seen;
};

} // namespace chiron::tests
