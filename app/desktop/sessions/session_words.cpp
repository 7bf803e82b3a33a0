// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/session_words.h"

#include "desktop/training/training_words.h"
#include "session/exercise_kind.h"

namespace chiron::desktop {

using database::SessionState;

namespace {

/// A stopped practice counts as ended, not as broken off.
bool saysOutcome(const database::SessionSummary& session) {
    return session.state == SessionState::completed ||
           (session.familiarisation && session.state == SessionState::stopped);
}

/// The start in the local time of the place of recording; invalid if the stored text cannot be read.
QDateTime localStart(const database::SessionSummary& session) {
    const QDateTime time = SessionWords::timeOf(session.startedUtc);
    return time.isValid() ? time.toOffsetFromUtc(session.utcOffset_min * 60) : time;
}

} // namespace

QString SessionWords::state(SessionState state) {
    switch (state) {
    case SessionState::running:
        return tr("Running");
    case SessionState::completed:
        return tr("Completed");
    case SessionState::stopped:
        return tr("Stopped");
    case SessionState::interrupted:
        return tr("Interrupted");
    case SessionState::incomplete:
        return tr("Incomplete");
    case SessionState::faulted:
        return tr("Faulted");
    case SessionState::voided:
        return tr("Voided");
    }
    return {};
}

WordSign SessionWords::sign(SessionState state) {
    switch (state) {
    case SessionState::running:
        return {"media-playback-start", Colour::accent};
    case SessionState::completed:
        return {"dialog-ok-apply", Colour::good};
    case SessionState::stopped:
        return {"media-playback-stop", Colour::muted};
    case SessionState::interrupted:
    case SessionState::incomplete:
        return {"dialog-warning", Colour::warning};
    case SessionState::faulted:
        return {"dialog-error", Colour::bad};
    case SessionState::voided:
        return {"dialog-cancel", Colour::muted};
    }
    return {"dialog-information", Colour::muted};
}

Outcome SessionWords::outcomeOf(const database::SessionSummary& session) {
    if (session.familiarisation)
        return Outcome::practice;
    if (session.state != SessionState::completed || !session.passed)
        return Outcome::notScored;
    return *session.passed ? Outcome::passed : Outcome::notPassed;
}

QString SessionWords::outcome(Outcome outcome) {
    switch (outcome) {
    case Outcome::passed:
        return tr("Passed");
    case Outcome::notPassed:
        return tr("Not passed");
    case Outcome::notScored:
        return tr("Does not count");
    case Outcome::practice:
        return tr("Familiarisation");
    }
    return {};
}

WordSign SessionWords::sign(Outcome outcome) {
    switch (outcome) {
    case Outcome::passed:
        return {"dialog-ok-apply", Colour::good};
    case Outcome::notPassed:
        return {"window-close", Colour::bad};
    case Outcome::notScored:
    case Outcome::practice:
        break;
    }
    return {"list-remove", Colour::muted};
}

QString SessionWords::cameTo(const database::SessionSummary& session) {
    return saysOutcome(session) ? outcome(outcomeOf(session)) : state(session.state);
}

WordSign SessionWords::cameToSign(const database::SessionSummary& session) {
    return saysOutcome(session) ? sign(outcomeOf(session)) : sign(session.state);
}

QString SessionWords::moved(const database::SessionSummary& session) {
    // "Unsafe": the text in brackets is only for choosing an operator.
    return session.operatorName.empty()
               ? tr("Own hand")
               : operatorTitle(session.operatorName).section(QStringLiteral(" ("), 0, 0);
}

QString SessionWords::device(bool felt) {
    return felt ? tr("Felt") : tr("Shown");
}

QString SessionWords::gates(const database::SessionSummary& session, const QLocale& locale) {
    const bool brokenOffPractice = session.familiarisation && session.state != SessionState::completed;
    return session.gates > 0 && !brokenOffPractice
               ? tr("%1 of %2").arg(locale.toString(session.gatesMet), locale.toString(session.gates))
               : QString();
}

QString SessionWords::attempt(const database::SessionSummary& session, const QLocale& locale) {
    return session.attempt > 0 ? tr("Attempt %1 at level %2")
                                     .arg(locale.toString(session.attempt), locale.toString(session.level))
                               : QString();
}

QString SessionWords::what(const database::SessionSummary& session, const QString& exercise,
                           const QLocale& locale) {
    if (session::isOnlyInStudies(session.exercise))
        return exercise;
    const QString level = locale.toString(session.level);
    return session.attempt > 0
               ? tr("%1, attempt %2 at level %3").arg(exercise, locale.toString(session.attempt), level)
               : tr("%1, level %2").arg(exercise, level);
}

QString SessionWords::which(const database::SessionSummary& session, const QString& exercise,
                            const QLocale& locale) {
    const QDateTime begun = localStart(session);
    // Includes seconds, because several attempts may have begun within one minute.
    const QString when = begun.isValid() ? locale.toString(begun.date(), QLocale::ShortFormat) +
                                               begun.time().toString(QStringLiteral(" HH:mm:ss"))
                                         : QString();
    return QStringList{what(session, exercise, locale), when, cameTo(session)}.join(QStringLiteral(" · "));
}

QString SessionWords::review(const database::SessionSummary& session) {
    return session.reviewed ? tr("Reviewed") : session.toReview ? tr("To review") : QStringLiteral("–");
}

QDateTime SessionWords::timeOf(const std::string& utc) {
    return QDateTime::fromString(QString::fromStdString(utc), Qt::ISODateWithMs);
}

QString SessionWords::started(const database::SessionSummary& session, const QLocale& locale) {
    return locale.toString(localStart(session), QLocale::ShortFormat);
}

QString SessionWords::startedOn(const database::SessionSummary& session, const QLocale& locale) {
    return locale.toString(localStart(session).date(), QLocale::ShortFormat);
}

QString SessionWords::length(std::uint64_t ticks, const QLocale& locale) {
    const auto seconds = static_cast<int>(ticks / 1000);
    if (seconds < 60)
        return tr("%1 s").arg(locale.toString(seconds));
    return tr("%1 min %2 s")
        .arg(locale.toString(seconds / 60),
             locale.toString(seconds % 60).rightJustified(2, QLatin1Char('0')));
}

QString SessionWords::ago(const QDateTime& then, const QDateTime& now, const QLocale& locale) {
    const qint64 minutes = then.secsTo(now) / 60;
    if (minutes < 1)
        return tr("just now");
    if (minutes < 60)
        return tr("%n minute(s) ago", nullptr, static_cast<int>(minutes));
    if (minutes < 48 * 60)
        return tr("%n hour(s) ago", nullptr, static_cast<int>(minutes / 60));
    const qint64 days = minutes / (24 * 60);
    return days <= 31 ? tr("%n day(s) ago", nullptr, static_cast<int>(days))
                      : locale.toString(then.toLocalTime().date(), QLocale::ShortFormat);
}

QString SessionWords::bytes(std::uint64_t bytes, const QLocale& locale) {
    return locale.formattedDataSize(static_cast<qint64>(bytes), 1, QLocale::DataSizeSIFormat);
}

QString SessionWords::study() {
    return tr("Study");
}

} // namespace chiron::desktop
