// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/desktop/findings_box.h"
#include "desktop/training/info_view.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <array>
#include <vector>

class QCheckBox;
class QLabel;
class QVBoxLayout;

namespace chiron::desktop {

class LeanDial;
class LivePlot;
class TargetBar;

/// What is measured and said while fingers palpate: the findings with their ratings, how hard each finger presses with the band to
/// press in, how the platform leans, how much was searched, numbers and plots, as far as the level allows each. GUI thread.
class PalpationPanel final : public InfoView {
    Q_OBJECT
public:
    PalpationPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues, const simulation::PalpationParameters& level,
                   QWidget* parent = nullptr);

    void show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) override;
    FindingsBox& findings() { return *m_findings; }
    bool showsForceMap() const; ///< the live map shows how hard was pressed, not where
    void switchMap();           ///< to the other one

private:
    struct FingerRow {
        std::array<QLabel*, 3> number{}; ///< displayed force, lean, depth
    };
    void addHead();
    void addBars();
    void addNumbers();
    void addPlots();
    void addCoverage();
    LivePlot* plot(const char* name, const QString& title, double top, double limit);
    void showFingers(const haptics::DisplayState& state);
    void showNumbers(const haptics::DisplayState& state);
    void addSamples(const haptics::DisplayState& state, std::span<const session::LiveSample> samples);
    int tools() const { return m_level.tools(); }

    const Theme& m_theme;
    QLocale m_locale;
    session::LevelCues m_cues;
    const simulation::PalpationParameters& m_level; ///< the catalogue's
    QVBoxLayout* m_column;
    FindingsBox* m_findings = nullptr;
    QLabel* m_elapsed = nullptr;
    QLabel* m_coverage = nullptr;
    QCheckBox* m_forceMap = nullptr;
    std::vector<TargetBar*> m_force;
    std::vector<TargetBar*> m_squeeze; ///< one a hand; none where the level has no pinch
    LeanDial* m_lean = nullptr;
    std::vector<FingerRow> m_rows;
    LivePlot* m_forcePlot = nullptr;
    LivePlot* m_leanPlot = nullptr;
    std::int64_t m_worked_ms = 0;
    int m_frame = 0;
};

} // namespace chiron::desktop
