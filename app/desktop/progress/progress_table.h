// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/catalogue.h"
#include "desktop/plots/fitted_table.h"
#include "desktop/sessions/session_row.h"
#include "session/group_standing.h"

#include <QLocale>
#include <vector>

namespace chiron::desktop {

/// Shows a group at a glance: one row per person and one column per exercise, with the lowest level that is
/// not passed.
/// Thread: GUI.
class ProgressTable final : public FittedTable {
    Q_OBJECT
public:
    enum Column { name, latest, toReview, firstExercise };

    ProgressTable(const Theme& theme, QLocale locale, const catalogue::Catalogue& catalogue,
                  ExerciseTitles titles, QWidget* parent = nullptr);

    /// The pointers must outlive the table's use of them.
    void show(std::vector<const session::PersonStanding*> people);
    const session::PersonStanding* chosen() const; ///< null if nobody is chosen
    std::string chosenExercise() const;            ///< of the chosen cell; empty for all exercises
    void choose(database::PersonId person, const std::string& exercise);
    QString chosenInWords() const; ///< person and cell that are chosen, level by level

signals:
    void openAsked();

private:
    void fillRow(int row, const session::PersonStanding& person);
    QTableWidgetItem& put(int row, int column, const QString& text);
    void putStanding(int row, int column, const session::ExerciseStanding& standing);
    QString openWords(const session::ExerciseStanding& standing) const;
    QString nextWords(const session::PersonStanding& person) const;

    const Theme& m_theme;
    QLocale m_locale;
    ExerciseTitles m_titles;
    std::vector<std::string> m_exercises; ///< exercises of the columns
    std::vector<const session::PersonStanding*> m_people;
};

} // namespace chiron::desktop
