// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "modules/exercises/palpation/cues/palpation_cues.h"
#include "desktop/theme/theme.h"
#include "core/report_word.h"

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

/// What a person says was found: the findings by number, one of them selected, its ratings as far as the level asks for them,
/// and the end of the trial. It shows what the session took, and asks the session for everything else. GUI thread.
class FindingsBox final : public QWidget {
    Q_OBJECT
public:
    FindingsBox(const Theme& theme, const QLocale& locale, const simulation::PalpationCues& asks, double padRadius_m, QWidget* parent = nullptr);

    void show(const simulation::PalpationCues& cues);
    void setRunning(bool running); ///< false: between trials, paused or over; the session takes nothing then
    /// A key of kKeys: digits rate, + and − size, V changes what digits rate, N selects the next, Delete takes back, D is done.
    bool key(int key);
    static std::span<const int> keys();

signals:
    void reported(chiron::core::ReportField field, unsigned value);

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
    SizeRow* m_size = nullptr;         ///< null where the level does not ask
    RatingRow* m_hardness = nullptr;   ///< likewise
    RatingRow* m_confidence = nullptr; ///< likewise
    QFrame* m_missing = nullptr;       ///< what is still to be said, once the end was asked for
    QLabel* m_missingText = nullptr;
    QPushButton* m_done = nullptr;
    bool m_digitsRateHardness = false;
    bool m_running = false;
    bool m_asked = false; ///< the end was asked for while something is missing: the next press means it
};

} // namespace chiron::desktop
