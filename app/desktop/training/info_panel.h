// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/info_view.h"

#include <array>

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace chiron::desktop {

class ForceBar;
class LivePlot;

/// The panel for a tool with a point: bars, numbers and plots as far as the level allows them, and the state
/// of the loop.
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

    void show(const haptics::DisplayState& state, std::span<const session::LiveSample> samples) override;

    /// Texts that every kind of panel shares.
    static QString elapsedText(std::int64_t second); ///< "Elapsed: 1:05"
    /// Whether everything is recorded, and the force on time.
    static QString loopText(const haptics::DisplayState& state);

private:
    void addBars();
    void addNumbers();
    void addPlots();
    QLabel* addNumber(const QString& name, const QString& objectName, QGridLayout& grid, int column);
    void showNumbers(const haptics::ToolDisplay& tool);

    const Theme& m_theme;
    QLocale m_locale;
    session::LevelCues m_cues;
    Limits m_limits;
    QVBoxLayout* m_column;
    QLabel* m_elapsed = nullptr;
    ForceBar* m_force = nullptr;
    ForceBar* m_torque = nullptr;
    std::array<QLabel*, 3> m_tip{};
    LivePlot* m_forcePlot = nullptr;
    LivePlot* m_speedPlot = nullptr;
    std::int64_t m_worked_ms = 0; ///< since the first trial, without pauses
    std::int64_t m_shownSecond = -1;
    int m_frame = 0;
};

} // namespace chiron::desktop
