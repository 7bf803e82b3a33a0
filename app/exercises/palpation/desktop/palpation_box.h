// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/session/palpation_record.h"
#include "desktop/theme/theme.h"

#include <QLocale>
#include <QWidget>
#include <vector>

class QComboBox;
class QLabel;

namespace chiron::desktop {

class PalpationMapView;

/// The results of a palpation trial, selected by its number: two maps show where and how hard the surface was
/// searched, with truth and findings, and a text lists each lump with its finding and each finding that
/// matched no lump.
/// Thread: GUI.
class PalpationBox final : public QWidget {
    Q_OBJECT
public:
    /// `records`: at least one.
    PalpationBox(const Theme& theme, const QLocale& locale, const simulation::PalpationParameters& level,
                 std::vector<session::PalpationTrialRecord> records, QWidget* parent = nullptr);

private:
    void choose(int index);

    QLocale m_locale;
    simulation::PalpationParameters m_level;
    std::vector<session::PalpationTrialRecord> m_records;
    QComboBox* m_choice;
    QLabel* m_words;
    QLabel* m_lumps;
    PalpationMapView* m_coverage;
    PalpationMapView* m_force;
};

/// "2 of 3 lumps found, 1 finding was none, 84 % searched." Pure function.
QString palpationSummary(const session::PalpationTrialRecord& record, const QLocale& locale);
/// Each lump with its reported finding, then each finding that matched no lump. Pure function.
QStringList palpationLines(const session::PalpationTrialRecord& record,
                           const simulation::PalpationParameters& level, const QLocale& locale);

} // namespace chiron::desktop
