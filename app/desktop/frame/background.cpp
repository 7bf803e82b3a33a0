// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/background.h"

namespace chiron::desktop {

Background::~Background() {
    cancelAndWait();
}

void Background::cancelAndWait() {
    for (const auto& weak : m_tokens)
        if (const auto token = weak.lock())
            token->cancel();
    m_tokens.clear();
    m_pool.waitForDone();
}

} // namespace chiron::desktop
