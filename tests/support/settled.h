// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "support/clipping.h"

#include <QtTest>

namespace chiron::tests {

/// What is cut off or without a name on this page, once its layouts are at rest: words that came just now, of
/// a worker or of a running session, ask for another layout, and a busy machine takes its time for it.
inline QStringList settledFindings(const QWidget* page, int first_ms = 50) {
    QStringList found;
    for (const int wait_ms : {first_ms, 50, 100, 300, 900}) {
        QTest::qWait(wait_ms);
        found = clippedOn(page) + unnamedOn(page);
        if (found.isEmpty())
            break;
    }
    return found;
}

} // namespace chiron::tests
