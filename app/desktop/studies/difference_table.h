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

/// The usual reference value of an attribute in studies, in SI.
double usualReference(psychophysics::Attribute attribute);
/// Changes the task of a condition, and with it scale and procedure.
void takeTask(psychophysics::Condition& condition, psychophysics::Task task);
/// Changes the attribute of a condition, and sets the usual reference for it. A change to or from an apex
/// search also replaces task, table and procedure.
void takeAttribute(psychophysics::Condition& condition, psychophysics::Attribute attribute);

/// A number of differences in equal ratios between two values, or on both sides of the reference with equal
/// ratios between the objects. Returns D, ascending.
std::vector<double> differencesBetween(double low, double high, int count);
std::vector<double> differencesAround(double high, int count);

/// The candidates that a procedure chooses from, as differences in per cent of the reference and as values.
/// They are generated from three numbers, spaced geometrically, or typed, or pasted. Every change takes
/// effect at once. Thread: GUI.
class DifferenceTable final : public QWidget {
    Q_OBJECT
public:
    /// `mayBeLess`: the task also uses objects with less of the attribute than the reference.
    DifferenceTable(const Theme& theme, const QLocale& locale, bool readOnly,
                    const psychophysics::StimulusDesign& stimulus, bool mayBeLess, QWidget* parent = nullptr);

    /// Shows the same table for another reference.
    void showObjects(const psychophysics::StimulusDesign& stimulus);

signals:
    void changed(const std::vector<double>& differences);

private:
    void addMaker(const Theme& theme, FieldGrid& grid);
    void addLevels(const Theme& theme, bool readOnly, FieldGrid& grid);
    void takeBothSides(bool both);
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
