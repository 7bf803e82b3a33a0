// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/station/platform_check.h"
#include "report/check_record.h"
#include "session/loop_self_test.h"

#include <QDateTime>
#include <QLocale>
#include <optional>

namespace chiron::desktop {

/// Everything that a laboratory needs to know about a check besides its figures.
struct CheckCircumstances {
    QString who;     ///< the person who was logged in
    QDateTime when;  ///< local time
    QString station; ///< name of the computer
    QString device;
    std::optional<QString> serial; ///< of the device; empty: it reports none; no value: there is no device
    QString build;
    std::int64_t entry = 0; ///< in the audit trail; 0: it could not be written there
    QString site{};         ///< name of the site; may be empty
};

/// Returns "none" if there is no device.
QString serialWords(const std::optional<QString>& serial);

/// The head of the record as pairs of name and value.
/// Thread: GUI, as for all functions here.
std::vector<std::pair<QString, QString>> checkHead(const CheckCircumstances& of, const QLocale& locale);
QString checkFoot(const CheckCircumstances& of, const QLocale& locale);

/// Measured values beside their limits, each passed or failed; the first line contains the headings.
report::CheckTable loopLimits(const session::SelfTestResult& result, const QLocale& locale);
/// The worst value over all fingers.
report::CheckTable platformLimits(const PlatformCheck& check, const QLocale& locale);
/// Whether everything that counts is within its limits.
bool loopHolds(const session::SelfTestResult& result);

report::CheckRecord loopRecord(const session::SelfTestResult& result, const CheckCircumstances& of,
                               const QLocale& locale);

} // namespace chiron::desktop
