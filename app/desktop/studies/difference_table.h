// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "psychophysics/study/study_design.h"

#include <QLocale>
#include <QWidget>
#include <vector>

namespace chiron::desktop {

class FieldGrid;

/// A value of the attribute that studies usually compare with, SI.
double usualReference(psychophysics::Attribute attribute);
/// Gives a condition another task, with a scale and a procedure that suit it.
void takeTask(psychophysics::Condition& condition, psychophysics::Task task);

/// From, to and how many: in equal ratios, or in equal steps on both sides of the reference. D, ascending.
std::vector<double> differencesBetween(double low, double high, int count);
std::vector<double> differencesAround(double high, int count);

/// The candidates that a procedure chooses from, as differences in percent of the reference and as values; generated or typed. GUI thread.
class DifferenceTable final : public QWidget {
    Q_OBJECT
public:
    DifferenceTable(const Theme& theme, const QLocale& locale, bool readOnly, const psychophysics::StimulusDesign& stimulus, QWidget* parent = nullptr);

signals:
    void changed(const std::vector<double>& differences);

private:
    void generate();
    QString summary(const psychophysics::StimulusDesign& stimulus, const QLocale& locale) const;

    double m_low_percent = 2.0;
    double m_high_percent = 60.0;
    int m_count = 40;
    bool m_bothSides = false;
    std::vector<double> m_typed;
};

} // namespace chiron::desktop
