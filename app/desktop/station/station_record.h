// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/station/platform_check.h"
#include "report/check_record.h"
#include "session/loop_self_test.h"

#include <QDateTime>
#include <QLocale>
#include <optional>

namespace chiron::desktop {

/// What a laboratory has to know of a check beside its figures.
struct CheckCircumstances {
    QString who;              ///< logged in
    QDateTime when;           ///< local
    QString station;          ///< name of the computer
    QString device;
    std::optional<QString> serial; ///< of the device; empty: it does not tell one; nothing: there is no device
    QString build;
    std::int64_t entry = 0;   ///< in the audit trail; 0: it could not be written there
    QString site{};           ///< what the site is called; may be empty
};

/// "none" without a device.
QString serialWords(const std::optional<QString>& serial);

/// For the record's head: names and values. GUI thread, as all of it.
std::vector<std::pair<QString, QString>> checkHead(const CheckCircumstances& of, const QLocale& locale);
QString checkFoot(const CheckCircumstances& of, const QLocale& locale);

/// What is measured beside its limit, each passed or not; the first line are the heads.
report::CheckTable loopLimits(const session::SelfTestResult& result, const QLocale& locale);
/// The worst of all fingers.
report::CheckTable platformLimits(const PlatformCheck& check, const QLocale& locale);
/// Whether all that counts is within its limits.
bool loopHolds(const session::SelfTestResult& result);

report::CheckRecord loopRecord(const session::SelfTestResult& result, const CheckCircumstances& of, const QLocale& locale);

} // namespace chiron::desktop
