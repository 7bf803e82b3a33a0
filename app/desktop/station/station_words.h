// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "devices/driver_catalogue.h"
#include "session/loop_report.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <string_view>

namespace chiron::desktop {

/// Texts on the state of the station, translated.
/// Thread: GUI.
class StationWords {
    Q_DECLARE_TR_FUNCTIONS(StationWords)
public:
    static QString driver(const devices::Driver& entry);
    static QString needs(const devices::Driver& entry);
    /// A text that a driver's entry marks for translation.
    static QString text(std::string_view marked);
    /// The common name of a device of this driver with these kinematics; empty: use its model.
    static QString device(const devices::Driver& entry, std::string_view kinematics);
    static QString forceClass(devices::DeviceClass deviceClass);
    static QString priority(bool granted);
    static QString howToGetPriority();
    static QString memory(bool locked);
    /// "Half of all ticks ..., 99 of 100 ..., the latest ...".
    static QString punctuality(const session::LoopReport& loop, const QLocale& locale);
    /// "good" or "warning": whether touch can be expected to be smooth (speed.md: at most 0.3 % of ticks
    /// late).
    static const char* verdictKind(const session::LoopReport& loop);
    static QString verdict(const session::LoopReport& loop, const QLocale& locale);
    static double lateShare(const session::LoopReport& loop); ///< share of all ticks
    static double mostLate() noexcept;                        ///< the limit of lateShare()
};

} // namespace chiron::desktop
