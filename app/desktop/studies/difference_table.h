// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QWidget>
#include <vector>

class QLabel;

namespace chiron::desktop {

class FieldGrid;
class LevelsTable;

/// A value of the attribute that studies usually compare with, SI.
double usualReference(psychophysics::Attribute attribute);
/// Gives a condition another task, with a scale and a procedure that suit it.
void takeTask(psychophysics::Condition& condition, psychophysics::Task task);
/// Gives a condition another attribute, with the reference that is usual for it; to an apex and from one also with another task, table and procedure.
void takeAttribute(psychophysics::Condition& condition, psychophysics::Attribute attribute);

/// From, to and how many: in equal ratios, or in equal steps on both sides of the reference. D, ascending.
std::vector<double> differencesBetween(double low, double high, int count);
std::vector<double> differencesAround(double high, int count);

/// The candidates that a procedure chooses from, as differences in per cent of the reference and as values; made evenly from three numbers, or typed and
/// pasted. What is changed counts at once. GUI thread.
class DifferenceTable final : public QWidget {
    Q_OBJECT
public:
    /// `mayBeLess`: the task takes objects with less of the attribute than the reference, too.
    DifferenceTable(const Theme& theme, const QLocale& locale, bool readOnly, const psychophysics::StimulusDesign& stimulus, bool mayBeLess, QWidget* parent = nullptr);

    /// The same table around another reference.
    void showObjects(const psychophysics::StimulusDesign& stimulus);

signals:
    void changed(const std::vector<double>& differences);

private:
    void addMaker(const Theme& theme, FieldGrid& grid);
    void addLevels(const Theme& theme, bool readOnly, FieldGrid& grid);
    void generate();
    void typed(const std::vector<double>& percents);
    QString summary() const;

    QLocale m_locale;
    psychophysics::StimulusDesign m_stimulus;
    double m_low_percent = 2.0;
    double m_high_percent = 60.0;
    int m_count = 40;
    bool m_mayBeLess;
    bool m_bothSides = false;
    FieldGrid* m_grid = nullptr;
    QLabel* m_summary = nullptr;
    LevelsTable* m_levels = nullptr;
};

} // namespace chiron::desktop
