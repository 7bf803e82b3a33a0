// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/sessions/session_row.h"
#include "desktop/sessions/session_words.h"

#include <QDate>
#include <QStringList>
#include <QVariantMap>
#include <optional>

namespace chiron::desktop {

/// Whether another person has reviewed a session, or still has to.
enum class ReviewState { toReview, reviewed };

/// The filter of the session list. A value; a Place carries it as a map, so that going back restores it.
struct SessionListFilter {
    QString text;      ///< every word must occur in number, person, exercise or operator
    qint64 person = 0; ///< 0: anybody
    QString exercise;  ///< id; empty: any
    int level = 0;     ///< 0: any
    std::optional<database::SessionState> state;
    std::optional<bool> felt;
    std::optional<Outcome> outcome;
    QDate from; ///< local days at the place of recording; invalid: open
    QDate to;
    bool archived = false; ///< include archived sessions
    std::optional<ReviewState> review;
    bool commented = false; ///< only sessions with comments

    bool operator==(const SessionListFilter&) const = default;
    bool isEmpty() const { return *this == SessionListFilter{}; }
    QVariantMap toMap() const;
    /// Missing or unknown entries of the map stay open.
    static SessionListFilter fromMap(const QVariantMap& map);
};

/// A filter prepared for matching thousands of rows.
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
