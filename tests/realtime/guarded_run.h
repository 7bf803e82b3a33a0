// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/api/endoscope_mailbox.h"
#include "devices/api/pointer_mailbox.h"
#include "realtime/tick_guard.h"
#include "support/haptic_bench.h"

#include <QByteArray>

namespace chiron::tests {

inline constexpr int kTicks = 10'000;

/// One loop for 10,000 ticks with commands on the way; only the ticks themselves are counted.
inline ForbiddenCounts guardedRun(haptics::HapticLoop& loop, haptics::LiveInputs& inputs,
                                  devices::PointerMailbox* pointer,
                                  devices::EndoscopeMailbox* endoscope = nullptr) {
    realtime::TickSource ticks;
    resetForbiddenCounts();
    for (int n = 0; n < kTicks; ++n) {
        switch (n) {
        case 0:
            inputs.post({core::CommandKind::start});
            break;
        case 4'000:
            inputs.post({core::CommandKind::pause});
            break;
        case 4'700:
            inputs.post({core::CommandKind::resume});
            inputs.post({core::CommandKind::confirmHold});
            break;
        case 6'000:
            inputs.post({core::CommandKind::stopForce});
            break;
        case 6'100:
            inputs.post({core::CommandKind::rearm});
            break;
        case 8'000:
            inputs.post({core::CommandKind::mark});
            break;
        default:
            break;
        }
        if (pointer != nullptr)
            pointer->move(1e-6 * (n % 7 - 3), 1e-6 * (n % 5 - 2), n < 3000 ? -20e-6 : 0.0);
        if (endoscope != nullptr)
            endoscope->move({.advance_m = n < 3000 ? 25e-6 : 0.0,
                             .turnUp_rad = n < 2000 ? -3e-4 : 0.0,
                             .spin_rad = 1e-5 * (n % 5 - 1)});
        inputs.beat(static_cast<std::int64_t>(n) * 1'000'000);
        const realtime::HapticTick now = ticks.next(static_cast<std::int64_t>(n) * 1'000'000);
        const TickGuard guard;
        loop.tick(now);
        loop.timing({n * 10, n, 0});
    }
    return forbiddenCounts();
}

inline QByteArray words(const ForbiddenCounts& counts) {
    QByteArray text;
    for (std::size_t i = 0; i < kForbiddenNames.size(); ++i)
        text += QByteArray(kForbiddenNames[i]) + "=" + QByteArray::number(counts.count[i]) + " ";
    return text;
}

} // namespace chiron::tests
