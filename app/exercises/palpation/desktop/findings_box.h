// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/theme/theme.h"
#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "modules/exercises/palpation/cues/report_word.h"

#include <QLocale>
#include <QWidget>
#include <array>
#include <span>

class QFrame;
class QLabel;
class QPushButton;

namespace chiron::desktop {

class RatingRow;
class SizeRow;

/// The findings that a person reports, by number: one of them is selected, with the ratings that the level
/// asks for, and there is a button to end the trial. The box shows the findings that the session has
/// accepted, and sends every change to the session as a request.
/// Thread: GUI.
class FindingsBox final : public QWidget {
    Q_OBJECT
public:
    FindingsBox(const Theme& theme, const QLocale& locale, const simulation::PalpationCues& asks,
                double padRadius_m, QWidget* parent = nullptr);

    void show(const simulation::PalpationCues& cues);
    void setRunning(bool running); ///< false between trials, while paused and after the end: the session then
                                   ///< accepts nothing
    /// Handles a key of kKeys: digits rate, + and − change the size, V changes which rating the digits set, N
    /// selects the next finding, Delete takes one back, D ends the trial.
    bool key(int key);
    static std::span<const int> keys();

signals:
    void reported(chiron::simulation::ReportField field, unsigned value);

private:
    void addFindings(const Theme& theme);
    void addRatings(const Theme& theme, double padRadius_m);
    void addEnd(const Theme& theme);
    void done();
    void takeBack();
    void selectNext();
    void rate(int rating);
    void keysTo(bool hardness);
    void showSelected();
    bool anySelected() const { return m_cues.selected >= 0; }

    QLocale m_locale;
    simulation::PalpationCues m_cues;
    std::array<QPushButton*, simulation::kMaxFindings> m_chips{};
    QLabel* m_none = nullptr;
    QLabel* m_about = nullptr;
    QPushButton* m_takeBack = nullptr;
    SizeRow* m_size = nullptr;         ///< null if the level does not ask for it
    RatingRow* m_hardness = nullptr;   ///< likewise
    RatingRow* m_confidence = nullptr; ///< likewise
    QFrame* m_missing = nullptr;       ///< the ratings still missing, shown once the end was requested
    QLabel* m_missingText = nullptr;
    QPushButton* m_done = nullptr;
    bool m_digitsRateHardness = false;
    bool m_running = false;
    bool m_asked = false; ///< the end was requested while ratings are missing: the next press confirms it
};

} // namespace chiron::desktop
