// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "database/repositories/session_types.h"
#include "desktop/theme/theme_colour.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// What a session came to, as lists say it. Only what was completed and scored was passed or not.
enum class Outcome { passed, notPassed, notScored, practice };

/// A picture that goes with a word, so that neither stands alone.
struct WordSign {
    const char* icon; ///< Breeze name
    Colour ink;
};

/// How lists and cards say what is known of a session. Translated; any thread that has the translators (the GUI thread).
class SessionWords {
    Q_DECLARE_TR_FUNCTIONS(SessionWords)
public:
    static QString state(database::SessionState state);
    static WordSign sign(database::SessionState state);
    static Outcome outcomeOf(const database::SessionSummary& session);
    static QString outcome(Outcome outcome);
    static WordSign sign(Outcome outcome);
    /// What became of it in one word: whether it was passed, or how it ended where it did not come to its end.
    static QString cameTo(const database::SessionSummary& session);
    static WordSign cameToSign(const database::SessionSummary& session);
    static QString moved(const database::SessionSummary& session); ///< who moved the tool
    static QString device(bool felt);
    static QString gates(const database::SessionSummary& session, const QLocale& locale); ///< "3 of 5"; empty where there are none
    /// "Attempt 3 at level 2"; empty for what is no attempt (SessionSummary::attempt).
    static QString attempt(const database::SessionSummary& session, const QLocale& locale);
    /// "Find the apex, attempt 3 at level 2", or "Find the apex, level 2" for what is no attempt; `exercise`: its title.
    static QString what(const database::SessionSummary& session, const QString& exercise, const QLocale& locale);
    /// "Find the apex, attempt 3 at level 2 · 28/11/2026 09:46:12 · Not passed".
    static QString which(const database::SessionSummary& session, const QString& exercise, const QLocale& locale);
    static QString review(const database::SessionSummary& session);
    /// Date and time where it was recorded; empty where the label cannot be read.
    static QString started(const database::SessionSummary& session, const QLocale& locale);
    static QString startedOn(const database::SessionSummary& session, const QLocale& locale); ///< the date alone
    static QString length(std::uint64_t ticks, const QLocale& locale); ///< a tick is a millisecond
    /// "5 minutes ago"; the date from a month on.
    static QString ago(const QDateTime& then, const QDateTime& now, const QLocale& locale);
    static QString bytes(std::uint64_t bytes, const QLocale& locale);
    /// The exercise of a study's trials, which no catalogue has, and which has no levels.
    static constexpr const char* kComparison = "comparison";
    static QString comparison();
    static QDateTime timeOf(const std::string& utc); ///< UTC; invalid where it cannot be read
};

} // namespace chiron::desktop
