// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/palpation/desktop/findings_box.h"
#include "desktop/training/info_view.h"
#include "modules/exercises/palpation/simulation/palpation_parameters.h"

#include <array>
#include <vector>

class QCheckBox;
class QLabel;

namespace chiron::desktop {

class LeanDial;
class LivePlot;
class TargetBar;

/// The panel beside a palpation: the findings with their ratings, the force of each finger with the target
/// band, the inclination of the platform, the searched share, numbers and plots, each as far as the level
/// allows it.
/// Thread: GUI.
class PalpationPanel final : public InfoView {
    Q_OBJECT
public:
    PalpationPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues,
                   const simulation::PalpationParameters& level, QWidget* parent = nullptr);

    FindingsBox& findings() { return *m_findings; }
    bool showsForceMap() const; ///< the live map shows the force, not the coverage
    void switchMap();           ///< between the force map and the coverage map

protected:
    void showMoving(const haptics::DisplayState& state,
                    std::span<const session::LiveSample> samples) override;
    void showReadings(const haptics::DisplayState& state) override;

private:
    struct FingerRow {
        std::array<QLabel*, 3> number{}; ///< displayed force, lean, depth
    };
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
    const simulation::PalpationParameters& m_level; ///< owned by the catalogue
    FindingsBox* m_findings = nullptr;
    QLabel* m_coverage = nullptr;
    QCheckBox* m_forceMap = nullptr;
    std::vector<TargetBar*> m_force;
    std::vector<TargetBar*> m_squeeze; ///< one per hand; empty if the level has no pinch
    LeanDial* m_lean = nullptr;
    std::vector<FingerRow> m_rows;
    LivePlot* m_forcePlot = nullptr;
    LivePlot* m_leanPlot = nullptr;
};

} // namespace chiron::desktop
