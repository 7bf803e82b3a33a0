// SPDX-License-Identifier: GPL-3.0-or-later
// Does what tick code must not, so that the symbol test can show that it would be found.
#include <cstddef>
#include <mutex>

std::mutex g_mutex;

int* offendByAllocation(int n) {
    return new int[static_cast<std::size_t>(n)];
}

void offendByLock() {
    const std::lock_guard<std::mutex> lock(g_mutex);
}

void offendByException(int n) {
    if (n > 0)
        throw n;
}
