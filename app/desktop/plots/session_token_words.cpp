// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/plots/session_token_words.h"

#include "desktop/sessions/session_words.h"
#include "desktop/station/station_words.h"
#include "desktop/training/training_words.h"
#include "devices/driver_catalogue.h"
#include "session/exercise_kind.h"

#include <QCoreApplication>
#include <QDateTime>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

using database::SessionState;

namespace {

QString words(const char* text) {
    return QCoreApplication::translate("Sessions", text);
}

} // namespace

QString stateTitle(SessionState state) {
    switch (state) {
    case SessionState::running:
        return words(QT_TRANSLATE_NOOP("Sessions", "Running"));
    case SessionState::completed:
        return words(QT_TRANSLATE_NOOP("Sessions", "Completed"));
    case SessionState::stopped:
        return words(QT_TRANSLATE_NOOP("Sessions", "Stopped"));
    case SessionState::interrupted:
        return words(QT_TRANSLATE_NOOP("Sessions", "Interrupted"));
    case SessionState::incomplete:
        return words(QT_TRANSLATE_NOOP("Sessions", "Incomplete"));
    case SessionState::faulted:
        return words(QT_TRANSLATE_NOOP("Sessions", "Faulted"));
    case SessionState::voided:
        return words(QT_TRANSLATE_NOOP("Sessions", "Voided"));
    }
    return {};
}

QString stateIcon(SessionState state) {
    switch (state) {
    case SessionState::running:
        return QStringLiteral("media-playback-start");
    case SessionState::completed:
        return QStringLiteral("dialog-ok-apply");
    case SessionState::stopped:
        return QStringLiteral("media-playback-stop");
    case SessionState::interrupted:
        return QStringLiteral("dialog-warning");
    case SessionState::incomplete:
        return QStringLiteral("dialog-warning");
    case SessionState::faulted:
        return QStringLiteral("dialog-error");
    case SessionState::voided:
        return QStringLiteral("dialog-cancel");
    }
    return {};
}

QString outcomeText(const database::SessionSummary& session) {
    if (session.familiarisation && session.state == SessionState::completed)
        return words(QT_TRANSLATE_NOOP("Sessions", "Not counted"));
    if (session.state != SessionState::completed || !session.passed)
        return stateTitle(session.state);
    return *session.passed ? words(QT_TRANSLATE_NOOP("Sessions", "Passed"))
                           : words(QT_TRANSLATE_NOOP("Sessions", "Not passed"));
}

QString outcomeIcon(const database::SessionSummary& session) {
    if (session.familiarisation || session.state != SessionState::completed || !session.passed)
        return stateIcon(session.state);
    return *session.passed ? QStringLiteral("dialog-ok-apply") : QStringLiteral("dialog-close");
}

QString feltText(bool felt) {
    return felt ? words(QT_TRANSLATE_NOOP("Sessions", "Felt"))
                : words(QT_TRANSLATE_NOOP("Sessions", "Shown, not felt"));
}

QString forceText(const database::SessionSummary& session) {
    if (!session.felt)
        return words(QT_TRANSLATE_NOOP("Sessions", "Force shown, not felt"));
    return session.operatorName.empty()
               ? words(QT_TRANSLATE_NOOP("Sessions", "Force felt"))
               : words(QT_TRANSLATE_NOOP("Sessions", "Force rendered to a scripted hand"));
}

QString whoText(const database::SessionSummary& session) {
    const QString person = session.person == database::Actor::kSimulatedPerson
                               ? QString()
                               : QString::fromStdString(session.personName);
    if (session.operatorName.empty())
        return QString::fromStdString(session.personName);
    const QString script =
        words(QT_TRANSLATE_NOOP("Sessions", "%1 (scripted)")).arg(operatorTitle(session.operatorName));
    return person.isEmpty() ? script : person + QStringLiteral(" · ") + script;
}

QString deviceText(const devices::DeviceDescriptor& device) {
    const devices::Driver* driver = devices::findDriver(device.driver);
    const QString name = driver ? StationWords::device(*driver, device.kinematics) : QString();
    return name.isEmpty() ? QString::fromStdString(device.model) : name;
}

QString whenText(const database::SessionSummary& session, const QLocale& locale) {
    const QDateTime utc =
        QDateTime::fromString(QString::fromStdString(session.startedUtc), Qt::ISODateWithMs);
    if (!utc.isValid())
        return QString::fromStdString(session.startedUtc);
    return locale.toString(utc.toOffsetFromUtc(session.utcOffset_min * 60), QLocale::ShortFormat);
}

QString exerciseTitle(const catalogue::Catalogue& catalogue, const std::string& exercise,
                      const QString& language) {
    for (const catalogue::Exercise& entry : catalogue.exercises())
        if (entry.id == exercise)
            return QString::fromStdString(catalogue::textIn(entry.title, language.toStdString()));
    return session::isOnlyInStudies(exercise)
               ? SessionWords::study()
               : QString::fromStdString(exercise).replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString levelTitle(const catalogue::Catalogue& catalogue, const std::string& exercise, int level,
                   const QString& language) {
    const catalogue::ExerciseLevel* entry = catalogue.find(exercise, level);
    const QString number = QLocale().toString(level);
    if (!entry)
        return words(QT_TRANSLATE_NOOP("Sessions", "Level %1")).arg(number);
    return words(QT_TRANSLATE_NOOP("Sessions", "Level %1: %2"))
        .arg(number, QString::fromStdString(catalogue::textIn(entry->title, language.toStdString())));
}

QString clockText(double t_s, const QLocale& locale) {
    const double tenths = std::floor(std::max(0.0, t_s) * 10.0 + 1e-6);
    const int minutes = static_cast<int>(tenths / 600.0);
    const double seconds = tenths / 10.0 - 60.0 * minutes;
    QString text = locale.toString(seconds, 'f', 1);
    if (seconds < 10.0)
        text.prepend(locale.zeroDigit());
    return QStringLiteral("%1:%2").arg(locale.toString(minutes), text);
}

} // namespace chiron::desktop
