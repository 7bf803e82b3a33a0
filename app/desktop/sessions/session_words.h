// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/session_types.h"
#include "desktop/theme/theme_colour.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// The outcome of a session as lists show it. Only a completed and scored session is passed or not passed.
enum class Outcome { passed, notPassed, notScored, practice };

/// An icon that accompanies a word, so that neither stands alone.
struct WordSign {
    const char* icon; ///< Breeze name
    Colour ink;
};

/// Translated descriptions of sessions for lists and cards.
/// Thread: any that has the translators (the GUI thread).
class SessionWords {
    Q_DECLARE_TR_FUNCTIONS(SessionWords)
public:
    static QString state(database::SessionState state);
    static WordSign sign(database::SessionState state);
    static Outcome outcomeOf(const database::SessionSummary& session);
    static QString outcome(Outcome outcome);
    static WordSign sign(Outcome outcome);
    /// The outcome in one word: passed or not, or how the session ended if it was not completed.
    static QString cameTo(const database::SessionSummary& session);
    static WordSign cameToSign(const database::SessionSummary& session);
    static QString moved(const database::SessionSummary& session); ///< who moved the tool
    static QString device(bool felt);
    /// "3 of 5"; empty if there are none.
    static QString gates(const database::SessionSummary& session, const QLocale& locale);
    /// "Attempt 3 at level 2"; empty if the session is not an attempt (SessionSummary::attempt).
    static QString attempt(const database::SessionSummary& session, const QLocale& locale);
    /// "Find the apex, attempt 3 at level 2", or "Find the apex, level 2" if it is not an attempt; `exercise`
    /// is the title.
    static QString what(const database::SessionSummary& session, const QString& exercise,
                        const QLocale& locale);
    /// "Find the apex, attempt 3 at level 2 · 28/11/2026 09:46:12 · Not passed".
    static QString which(const database::SessionSummary& session, const QString& exercise,
                         const QLocale& locale);
    static QString review(const database::SessionSummary& session);
    /// Local date and time at the place of recording; empty if the time stamp cannot be read.
    static QString started(const database::SessionSummary& session, const QLocale& locale);
    /// The date only.
    static QString startedOn(const database::SessionSummary& session, const QLocale& locale);
    static QString length(std::uint64_t ticks, const QLocale& locale); ///< one tick is one millisecond
    /// "5 minutes ago"; from one month on the date.
    static QString ago(const QDateTime& then, const QDateTime& now, const QLocale& locale);
    static QString bytes(std::uint64_t bytes, const QLocale& locale);
    /// What lists call a session whose exercise only studies present (ExerciseKind::onlyInStudies): it has no
    /// title of its own.
    static QString study();
    static QDateTime timeOf(const std::string& utc); ///< in UTC; invalid if it cannot be read
};

} // namespace chiron::desktop
