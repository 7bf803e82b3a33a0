// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/progress/progress_table.h"

#include "desktop/home/exercise_card.h"
#include "desktop/sessions/plain_cell_delegate.h"
#include "desktop/sessions/session_words.h"

#include <QFontMetrics>
#include <QHeaderView>
#include <algorithm>
#include <cstdlib>

namespace chiron::desktop {

namespace {

/// Breaks a heading at the space nearest to its middle, so that the columns of all exercises fit the smallest
/// window in every language.
QString inTwoLines(QString heading) {
    qsizetype best = -1;
    for (qsizetype at = heading.indexOf(u' '); at >= 0; at = heading.indexOf(u' ', at + 1))
        if (best < 0 || std::abs(2 * at - heading.size()) < std::abs(2 * best - heading.size()))
            best = at;
    if (best >= 0)
        heading[best] = u'\n';
    return heading;
}

} // namespace

ProgressTable::ProgressTable(const Theme& theme, QLocale locale, const catalogue::Catalogue& catalogue,
                             ExerciseTitles titles, QWidget* parent)
    : FittedTable(theme, firstExercise + static_cast<int>(catalogue.exercises().size()), parent),
      m_theme(theme), m_locale(std::move(locale)), m_titles(std::move(titles)) {
    setObjectName(QStringLiteral("progress.table"));
    setAccessibleName(tr("Progress of the group"));
    setFont(theme.font(TextStyle::body));
    setItemDelegate(new PlainCellDelegate(theme, this)); // draws a frame around the chosen cell
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setMinimumHeight(theme.px(190));
    horizontalHeader()->setHighlightSections(false);
    QStringList heads{tr("Person"), tr("Last session"), tr("To review")};
    for (const catalogue::Exercise& exercise : catalogue.exercises()) {
        m_exercises.push_back(exercise.id);
        const QString id = QString::fromStdString(exercise.id);
        heads << m_titles.value(id, id);
    }
    for (int column = 0; column < heads.size(); ++column) {
        auto* head = new QTableWidgetItem(inTwoLines(heads[column]));
        head->setData(Qt::AccessibleTextRole, heads[column]);
        setHorizontalHeaderItem(column, head);
    }
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setFixedHeight(2 * QFontMetrics(theme.font(TextStyle::strong)).lineSpacing() +
                                       theme.px(14));
    connect(this, &QTableWidget::activated, this, &ProgressTable::openAsked);
}

void ProgressTable::show(std::vector<const session::PersonStanding*> people) {
    const session::PersonStanding* before = chosen();
    const database::PersonId person = before ? before->person : 0;
    const std::string exercise = chosenExercise();
    const QSignalBlocker quiet(this);
    m_people = std::move(people);
    setRowCount(0);
    setRowCount(static_cast<int>(m_people.size()));
    for (std::size_t row = 0; row < m_people.size(); ++row)
        fillRow(static_cast<int>(row), *m_people[row]);
    choose(person, exercise);
}

QTableWidgetItem& ProgressTable::put(int row, int column, const QString& text) {
    auto* item = new QTableWidgetItem(text);
    item->setToolTip(text);
    setItem(row, column, item);
    return *item;
}

void ProgressTable::fillRow(int row, const session::PersonStanding& person) {
    put(row, name, QString::fromStdString(person.name));
    if (person.latest)
        put(row, latest, SessionWords::startedOn(*person.latest, m_locale))
            .setToolTip(SessionWords::started(*person.latest, m_locale));
    else
        put(row, latest, tr("None yet"));
    put(row, toReview, person.toReview > 0 ? m_locale.toString(person.toReview) : QStringLiteral("–"));
    for (std::size_t i = 0; i < person.exercises.size(); ++i)
        putStanding(row, firstExercise + static_cast<int>(i), person.exercises[i]);
}

/// The cell is short, so that every exercise is visible in the smallest window; the tool tip says how often
/// the level was tried.
void ProgressTable::putStanding(int row, int column, const session::ExerciseStanding& standing) {
    const QString whole = openWords(standing);
    const bool begun = standing.open && standing.attempts > 0;
    QTableWidgetItem& cell =
        put(row, column, begun ? tr("Level %1").arg(m_locale.toString(standing.open->level)) : whole);
    cell.setToolTip(whole);
    cell.setData(Qt::AccessibleTextRole, whole);
    if (!standing.open)
        cell.setIcon(m_theme.icon(QStringLiteral("dialog-ok-apply"), Colour::good));
    else if (standing.open->attempts > 0)
        cell.setIcon(m_theme.icon(QStringLiteral("window-close"), Colour::bad));
}

QString ProgressTable::openWords(const session::ExerciseStanding& standing) const {
    if (!standing.open)
        return tr("All passed");
    if (standing.attempts == 0)
        return tr("Not begun");
    const QString level = m_locale.toString(standing.open->level);
    return standing.open->attempts > 0
               ? tr("Level %1, %n attempt(s)", nullptr, standing.open->attempts).arg(level)
               : tr("Level %1, not tried").arg(level);
}

QString ProgressTable::nextWords(const session::PersonStanding& person) const {
    if (!person.next)
        return tr("every level is passed");
    const QString id = QString::fromStdString(person.next->exercise);
    return tr("%1, level %2").arg(m_titles.value(id, id), m_locale.toString(person.next->level));
}

const session::PersonStanding* ProgressTable::chosen() const {
    const int row = currentRow();
    return row >= 0 && row < static_cast<int>(m_people.size()) ? m_people[static_cast<std::size_t>(row)]
                                                               : nullptr;
}

std::string ProgressTable::chosenExercise() const {
    const int column = currentColumn() - firstExercise;
    return column >= 0 && column < static_cast<int>(m_exercises.size())
               ? m_exercises[static_cast<std::size_t>(column)]
               : std::string();
}

void ProgressTable::choose(database::PersonId person, const std::string& exercise) {
    if (m_people.empty())
        return;
    const auto row = std::find_if(m_people.begin(), m_people.end(),
                                  [person](const auto* each) { return each->person == person; });
    const auto column = std::find(m_exercises.begin(), m_exercises.end(), exercise);
    setCurrentCell(row == m_people.end() ? 0 : static_cast<int>(row - m_people.begin()),
                   column == m_exercises.end()
                       ? static_cast<int>(name)
                       : firstExercise + static_cast<int>(column - m_exercises.begin()));
}

QString ProgressTable::chosenInWords() const {
    const session::PersonStanding* person = chosen();
    if (!person)
        return {};
    const QString who = QString::fromStdString(person->name);
    const std::string exercise = chosenExercise();
    if (exercise.empty())
        return person->next ? tr("%1 – next step: %2").arg(who, nextWords(*person))
                            : tr("%1 – %2").arg(who, nextWords(*person));
    QStringList levels;
    for (const session::ExerciseStanding& standing : person->exercises)
        if (standing.exercise == exercise)
            for (const session::LevelStanding& level : standing.levels)
                levels << tr("level %1: %2").arg(m_locale.toString(level.level), standingWords(level));
    const QString id = QString::fromStdString(exercise);
    return tr("%1, %2 – %3").arg(who, m_titles.value(id, id), levels.join(QStringLiteral(" · ")));
}

} // namespace chiron::desktop
