// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sessions/session_row.h"
#include "desktop/sessions/session_words.h"

#include <QDate>
#include <QStringList>
#include <QVariantMap>
#include <optional>

namespace chiron::desktop {

/// Whether a session was looked at by somebody else, or is to be.
enum class ReviewState { toReview, reviewed };

/// What the list of sessions is narrowed to. A value; travels in a Place as a map, so that going back returns to it.
struct SessionListFilter {
    QString text;            ///< every word of it must occur in number, person, exercise or operator
    qint64 person = 0;       ///< 0: anybody
    QString exercise;        ///< id; empty: any
    int level = 0;           ///< 0: any
    std::optional<database::SessionState> state;
    std::optional<bool> felt;
    std::optional<Outcome> outcome;
    QDate from;              ///< days where the session was recorded; invalid: open
    QDate to;
    bool archived = false;   ///< archived ones too
    std::optional<ReviewState> review;
    bool commented = false;  ///< only those that somebody commented on

    bool operator==(const SessionListFilter&) const = default;
    bool isEmpty() const { return *this == SessionListFilter{}; }
    QVariantMap toMap() const;
    /// What is missing or unknown in the map stays open.
    static SessionListFilter fromMap(const QVariantMap& map);
};

/// A filter made ready to be asked thousands of times.
class SessionMatcher {
public:
    explicit SessionMatcher(const SessionListFilter& filter);
    bool matches(const SessionRow& row) const;

private:
    bool matchesDay(const database::SessionSummary& session) const;

    SessionListFilter m_filter;
    QStringList m_words;
    std::string m_exercise;
};

} // namespace chiron::desktop
