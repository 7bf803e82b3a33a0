// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/session_table_model.h"

#include "desktop/sessions/plain_cell_delegate.h"
#include "session/exercise_kind.h"

#include <algorithm>
#include <compare>

namespace chiron::desktop {

namespace {

std::strong_ordering byText(const QString& a, const QString& b) {
    return a.compare(b, Qt::CaseInsensitive) <=> 0;
}

std::strong_ordering compare(const SessionRow& a, const SessionRow& b, int column) {
    switch (column) {
    // This sorts by the time stamp, which may run backwards; the number gives the order of recording.
    case SessionTableModel::started:
        return a.summary.startedUtc <=> b.summary.startedUtc;
    case SessionTableModel::person:
        return byText(a.person, b.person);
    case SessionTableModel::exercise:
        return byText(a.exercise, b.exercise);
    case SessionTableModel::level:
        return a.summary.level <=> b.summary.level;
    case SessionTableModel::attempt:
        return a.summary.attempt <=> b.summary.attempt;
    case SessionTableModel::operatorName:
        return a.summary.operatorName <=> b.summary.operatorName;
    case SessionTableModel::result:
        return std::pair(a.summary.state, SessionWords::outcomeOf(a.summary)) <=>
               std::pair(b.summary.state, SessionWords::outcomeOf(b.summary));
    case SessionTableModel::score:
        // The scores are compared as shares of the pass marks that were met.
        return a.summary.gatesMet * std::max(1, b.summary.gates) <=>
               b.summary.gatesMet * std::max(1, a.summary.gates);
    case SessionTableModel::comments:
        return a.summary.comments <=> b.summary.comments;
    case SessionTableModel::review:
        // Sessions that await a review come first.
        return std::pair(!a.summary.toReview, a.summary.reviewed) <=>
               std::pair(!b.summary.toReview, b.summary.reviewed);
    case SessionTableModel::device:
        return b.summary.felt <=> a.summary.felt;
    case SessionTableModel::length:
        return a.summary.ticks <=> b.summary.ticks;
    default:
        return a.summary.id <=> b.summary.id;
    }
}

} // namespace

SessionTableModel::SessionTableModel(const Theme& theme, QLocale locale, QObject* parent)
    : QAbstractTableModel(parent), m_theme(theme), m_locale(std::move(locale)) {}

int SessionTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_shown.size());
}

int SessionTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columns;
}

QVariant SessionTableModel::data(const QModelIndex& index, int role) const {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const SessionRow& row = at(index.row());
    switch (role) {
    case Qt::DisplayRole:
        return text(row, index.column());
    case Qt::DecorationRole:
        return picture(row, index.column());
    case PlainCellDelegate::kSecondLine:
        return operatorWith(row, index.column());
    case Qt::AccessibleTextRole: {
        const QString moved = operatorWith(row, index.column());
        return moved.isEmpty() ? QVariant() : QVariant(row.person + QStringLiteral(", ") + moved);
    }
    case Qt::ToolTipRole:
        return tip(row);
    case Qt::TextAlignmentRole:
        if (index.column() == number || index.column() == level || index.column() == attempt ||
            index.column() == length || index.column() == comments)
            return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
        return QVariant::fromValue(Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::ForegroundRole:
        return row.summary.archived ? QVariant(m_theme.color(Colour::muted)) : QVariant();
    default:
        return {};
    }
}

QString SessionTableModel::text(const SessionRow& row, int column) const {
    const database::SessionSummary& session = row.summary;
    switch (column) {
    case number:
        return m_locale.toString(static_cast<qlonglong>(session.id));
    case started:
        return SessionWords::started(session, m_locale);
    case person:
        return row.person;
    case exercise:
        return row.exercise;
    case level:
        return session::isOnlyInStudies(session.exercise) ? QStringLiteral("–")
                                                          : m_locale.toString(session.level);
    case attempt:
        return session.attempt > 0 ? m_locale.toString(session.attempt) : QString();
    case operatorName:
        return SessionWords::moved(session);
    case result:
        return session.archived ? tr("%1, archived").arg(SessionWords::cameTo(session))
                                : SessionWords::cameTo(session);
    case score:
        return SessionWords::gates(session, m_locale);
    case comments:
        return session.comments > 0 ? m_locale.toString(session.comments) : QString();
    case review:
        return SessionWords::review(session);
    case device:
        return SessionWords::device(session.felt);
    case length:
        return session.sealed ? tr("sealed") : SessionWords::length(session.ticks, m_locale);
    default:
        return {};
    }
}

QString SessionTableModel::operatorWith(const SessionRow& row, int column) const {
    return column == person && m_operatorWithPerson && !row.summary.operatorName.empty()
               ? SessionWords::moved(row.summary)
               : QString();
}

QString SessionTableModel::tip(const SessionRow& row) const {
    const QString took =
        row.summary.sealed
            ? tr("The length of a session in a blinded study is shown once the study is unblinded.")
            : tr("Length: %1.").arg(SessionWords::length(row.summary.ticks, m_locale));
    const QString gates = SessionWords::gates(row.summary, m_locale);
    const QString which = SessionWords::attempt(row.summary, m_locale);
    return (which.isEmpty() ? QString() : which + QLatin1Char('\n')) +
           (gates.isEmpty() ? QString() : tr("Pass marks met: %1.").arg(gates) + QLatin1Char('\n')) +
           tr("Session %1. %2").arg(m_locale.toString(static_cast<qlonglong>(row.summary.id)), took);
}

QVariant SessionTableModel::picture(const SessionRow& row, int column) const {
    return column == result ? QVariant(icon(SessionWords::cameToSign(row.summary))) : QVariant();
}

QIcon SessionTableModel::icon(const WordSign& sign) const {
    const std::pair key{QString::fromLatin1(sign.icon), sign.ink};
    const auto known = m_icons.find(key);
    return known != m_icons.end() ? known->second
                                  : m_icons.emplace(key, m_theme.icon(key.first, key.second)).first->second;
}

QVariant SessionTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case number:
        return tr("No."); // short, so that it fits the column
    case started:
        return tr("Started");
    case person:
        return tr("Person");
    case exercise:
        return tr("Exercise");
    case level:
        return tr("Level");
    case attempt:
        return tr("Attempt");
    case operatorName:
        return tr("Operator");
    case result:
        return tr("Result");
    case score:
        return tr("Score");
    case comments:
        return tr("Comments");
    case review:
        return tr("Review");
    case device:
        return tr("Force");
    case length:
        return tr("Length");
    default:
        return {};
    }
}

void SessionTableModel::setOperatorWithPerson(bool with) {
    if (m_operatorWithPerson == with)
        return;
    m_operatorWithPerson = with;
    if (rowCount() > 0)
        emit dataChanged(index(0, person), index(rowCount() - 1, person));
}

void SessionTableModel::setRows(std::vector<SessionRow> rows) {
    beginResetModel();
    m_rows = std::move(rows);
    show();
    endResetModel();
}

void SessionTableModel::append(std::vector<SessionRow> rows) {
    if (rows.empty())
        return;
    // Older sessions come after newer ones. Most often they are simply appended, and the selection stays.
    const bool onlyFollows = m_sortColumn == number && m_sortOrder == Qt::DescendingOrder;
    const SessionMatcher matcher(m_filter);
    std::vector<std::size_t> more;
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (matcher.matches(rows[i]))
            more.push_back(m_rows.size() + i);
    std::move(rows.begin(), rows.end(), std::back_inserter(m_rows));
    if (!onlyFollows) {
        emit layoutAboutToBeChanged();
        show();
        emit layoutChanged();
        return;
    }
    if (more.empty())
        return;
    beginInsertRows({}, rowCount(), rowCount() + static_cast<int>(more.size()) - 1);
    m_shown.insert(m_shown.end(), more.begin(), more.end());
    endInsertRows();
}

void SessionTableModel::replace(std::vector<SessionRow> rows) {
    beginResetModel(); // rows may leave the list or move within it
    for (SessionRow& row : rows) {
        const auto found = std::find_if(m_rows.begin(), m_rows.end(), [&row](const SessionRow& r) {
            return r.summary.id == row.summary.id;
        });
        if (found != m_rows.end())
            *found = std::move(row);
    }
    show();
    endResetModel();
}

void SessionTableModel::replace(SessionRow row) {
    std::vector<SessionRow> one;
    one.push_back(std::move(row));
    replace(std::move(one));
}

void SessionTableModel::setFilter(const SessionListFilter& filter) {
    if (filter == m_filter)
        return;
    beginResetModel();
    m_filter = filter;
    show();
    endResetModel();
}

void SessionTableModel::show() {
    const SessionMatcher matcher(m_filter);
    m_shown.clear();
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        if (matcher.matches(m_rows[i]))
            m_shown.push_back(i);
    sortShown();
}

void SessionTableModel::sortShown() {
    if (m_sortColumn == number && m_sortOrder == Qt::DescendingOrder) {
        std::sort(m_shown.begin(), m_shown.end()); // the rows are stored newest first
        return;
    }
    const auto before = [this](std::size_t a, std::size_t b) {
        const auto order = compare(m_rows[a], m_rows[b], m_sortColumn);
        if (order == 0)
            return a < b; // newest first if equal
        return m_sortOrder == Qt::AscendingOrder ? order < 0 : order > 0;
    };
    std::sort(m_shown.begin(), m_shown.end(), before);
}

void SessionTableModel::sort(int column, Qt::SortOrder order) {
    m_sortColumn = column < 0 ? static_cast<int>(number) : column;
    m_sortOrder = column < 0 ? Qt::DescendingOrder : order;
    beginResetModel();
    sortShown();
    endResetModel();
}

int SessionTableModel::rowOf(database::SessionId session) const {
    const auto found = std::find_if(m_shown.begin(), m_shown.end(),
                                    [&](std::size_t i) { return m_rows[i].summary.id == session; });
    return found == m_shown.end() ? -1 : static_cast<int>(found - m_shown.begin());
}

} // namespace chiron::desktop
