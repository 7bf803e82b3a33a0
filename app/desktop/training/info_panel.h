// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/info_view.h"

#include <array>

class QGridLayout;
class QLabel;

namespace chiron::desktop {

class ForceBar;
class LivePlot;

/// The panel for a tool with a point: bars, numbers and plots as far as the level allows them.
/// Thread: GUI.
class InfoPanel final : public InfoView {
    Q_OBJECT
public:
    struct Limits {
        double force_N = 4.0;
        double torque_Nm = 0.150;
    };
    InfoPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues, Limits limits,
              QWidget* parent = nullptr);

protected:
    void showMoving(const haptics::DisplayState& state,
                    std::span<const session::LiveSample> samples) override;
    void showReadings(const haptics::DisplayState& state) override;

private:
    void addBars();
    void addNumbers();
    void addPlots();
    QLabel* addNumber(const QString& name, const QString& objectName, QGridLayout& grid, int column);

    const Theme& m_theme;
    QLocale m_locale;
    session::LevelCues m_cues;
    Limits m_limits;
    ForceBar* m_force = nullptr;
    ForceBar* m_torque = nullptr;
    std::array<QLabel*, 3> m_tip{};
    LivePlot* m_forcePlot = nullptr;
    LivePlot* m_speedPlot = nullptr;
};

} // namespace chiron::desktop
