// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver_catalogue.h"
#include "session/loop_report.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <string_view>

namespace chiron::desktop {

/// How the state of the station is said. Translated; GUI thread.
class StationWords {
    Q_DECLARE_TR_FUNCTIONS(StationWords)
public:
    static QString driver(const devices::Driver& entry);
    static QString needs(const devices::Driver& entry);
    /// What people call a device of the driver with these kinematics; empty: it goes by its model.
    static QString device(const devices::Driver& entry, std::string_view kinematics);
    static QString forceClass(devices::DeviceClass deviceClass);
    static QString priority(bool granted);
    static QString howToGetPriority();
    static QString memory(bool locked);
    /// "Half of all ticks ..., 99 of 100 ..., the latest ...".
    static QString punctuality(const session::LoopReport& loop, const QLocale& locale);
    /// "good", "warning": whether touch can be trusted to be smooth (speed.md: at most 0.3 % of ticks late).
    static const char* verdictKind(const session::LoopReport& loop);
    static QString verdict(const session::LoopReport& loop, const QLocale& locale);
    static double lateShare(const session::LoopReport& loop); ///< of all ticks
    static double mostLate() noexcept;                        ///< the limit on it
};

} // namespace chiron::desktop
