// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/session_list_filter.h"

#include "session/exercise_kind.h"

#include <algorithm>

namespace chiron::desktop {

namespace {

constexpr const char* kOutcomes[] = {"passed", "not_passed", "not_scored", "practice"};

/// Converts a UTC time stamp into the local day as a Julian day number. It avoids QDateTime, because one key
/// press compares the dates of thousands of rows.
std::optional<qint64> dayOf(const std::string& utc, int offset_min) {
    if (utc.size() < 16)
        return std::nullopt;
    const auto number = [&utc](std::size_t at, std::size_t count) {
        int value = 0;
        for (std::size_t i = at; i < at + count; ++i)
            value = value * 10 + (utc[i] - '0');
        return value;
    };
    const QDate date(number(0, 4), number(5, 2), number(8, 2));
    if (!date.isValid())
        return std::nullopt;
    const int minutes = number(11, 2) * 60 + number(14, 2) + offset_min;
    return date.toJulianDay() + (minutes < 0 ? -1 : minutes / (24 * 60));
}

/// What only studies present has no level, whatever is stored.
bool isOfLevel(const database::SessionSummary& session, int level) {
    return session.level == level && !session::isOnlyInStudies(session.exercise);
}

} // namespace

QVariantMap SessionListFilter::toMap() const {
    QVariantMap map;
    if (!text.isEmpty())
        map.insert(QStringLiteral("text"), text);
    if (person != 0)
        map.insert(QStringLiteral("person"), person);
    if (!exercise.isEmpty())
        map.insert(QStringLiteral("exercise"), exercise);
    if (level != 0)
        map.insert(QStringLiteral("level"), level);
    if (state)
        map.insert(QStringLiteral("state"), QString::fromStdString(std::string(database::token(*state))));
    if (felt)
        map.insert(QStringLiteral("device"), *felt ? QStringLiteral("felt") : QStringLiteral("shown"));
    if (outcome)
        map.insert(QStringLiteral("outcome"), QLatin1String(kOutcomes[static_cast<int>(*outcome)]));
    if (from.isValid())
        map.insert(QStringLiteral("from"), from.toString(Qt::ISODate));
    if (to.isValid())
        map.insert(QStringLiteral("to"), to.toString(Qt::ISODate));
    if (review)
        map.insert(QStringLiteral("review"), *review == ReviewState::toReview ? QStringLiteral("to_review")
                                                                              : QStringLiteral("reviewed"));
    if (commented)
        map.insert(QStringLiteral("commented"), true);
    if (archived)
        map.insert(QStringLiteral("archived"), true);
    return map;
}

SessionListFilter SessionListFilter::fromMap(const QVariantMap& map) {
    SessionListFilter filter;
    filter.text = map.value(QStringLiteral("text")).toString();
    filter.person = map.value(QStringLiteral("person")).toLongLong();
    filter.exercise = map.value(QStringLiteral("exercise")).toString();
    filter.level = map.value(QStringLiteral("level")).toInt();
    filter.state =
        database::sessionStateFromToken(map.value(QStringLiteral("state")).toString().toStdString());
    const QString device = map.value(QStringLiteral("device")).toString();
    if (device == QLatin1String("felt") || device == QLatin1String("shown"))
        filter.felt = device == QLatin1String("felt");
    const QString outcome = map.value(QStringLiteral("outcome")).toString();
    for (int i = 0; i < static_cast<int>(std::size(kOutcomes)); ++i)
        if (outcome == QLatin1String(kOutcomes[i]))
            filter.outcome = static_cast<Outcome>(i);
    filter.from = QDate::fromString(map.value(QStringLiteral("from")).toString(), Qt::ISODate);
    filter.to = QDate::fromString(map.value(QStringLiteral("to")).toString(), Qt::ISODate);
    const QString review = map.value(QStringLiteral("review")).toString();
    if (review == QLatin1String("to_review") || review == QLatin1String("reviewed"))
        filter.review = review == QLatin1String("to_review") ? ReviewState::toReview : ReviewState::reviewed;
    filter.commented = map.value(QStringLiteral("commented")).toBool();
    filter.archived = map.value(QStringLiteral("archived")).toBool();
    return filter;
}

SessionMatcher::SessionMatcher(const SessionListFilter& filter)
    : m_filter(filter), m_words(filter.text.toCaseFolded().split(QLatin1Char(' '), Qt::SkipEmptyParts)),
      m_exercise(filter.exercise.toStdString()) {}

bool SessionMatcher::matchesDay(const database::SessionSummary& session) const {
    if (!m_filter.from.isValid() && !m_filter.to.isValid())
        return true;
    const auto day = dayOf(session.startedUtc, session.utcOffset_min);
    if (!day)
        return false;
    return (!m_filter.from.isValid() || *day >= m_filter.from.toJulianDay()) &&
           (!m_filter.to.isValid() || *day <= m_filter.to.toJulianDay());
}

bool SessionMatcher::matches(const SessionRow& row) const {
    const database::SessionSummary& session = row.summary;
    const bool inReview =
        !m_filter.review || (*m_filter.review == ReviewState::toReview ? session.toReview : session.reviewed);
    if (!inReview || (m_filter.commented && session.comments == 0) ||
        (session.archived && !m_filter.archived) ||
        (m_filter.person != 0 && session.person != m_filter.person) ||
        (!m_exercise.empty() && session.exercise != m_exercise) ||
        (m_filter.level != 0 && !isOfLevel(session, m_filter.level)) ||
        (m_filter.state && session.state != *m_filter.state) ||
        (m_filter.felt && session.felt != *m_filter.felt) ||
        (m_filter.outcome && SessionWords::outcomeOf(session) != *m_filter.outcome) || !matchesDay(session))
        return false;
    return std::all_of(m_words.begin(), m_words.end(),
                       [&row](const QString& word) { return row.search.contains(word); });
}

} // namespace chiron::desktop
