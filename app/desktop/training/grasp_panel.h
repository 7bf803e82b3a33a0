// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/grasping.h"
#include "desktop/training/info_view.h"

#include <array>
#include <optional>
#include <vector>

class QGridLayout;
class QLabel;
class QProgressBar;

namespace chiron::desktop {

class ForceBar;
class LivePlot;
class TargetBar;

/// The measurements while graspers work on a tube or on objects: step, progress of the holding time, tension
/// with its band or squeeze with its limit, the force on each instrument, their tips and jaws, and the last
/// ten seconds, each only if the level allows it.
/// Thread: GUI.
class GraspPanel final : public InfoView {
    Q_OBJECT
public:
    GraspPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues, Grasping grasping,
               QWidget* parent = nullptr);

protected:
    void showMoving(const haptics::DisplayState& state,
                    std::span<const session::LiveSample> samples) override;
    void showReadings(const haptics::DisplayState& state) override;

private:
    struct ToolRow {
        std::array<QLabel*, 4> number{}; ///< right, away, up, jaw
    };
    void addTask();
    void addBars();
    void addNumbers();
    void addPlots();
    LivePlot* plot(const char* name, const QString& title, double top, std::optional<double> limit = {});

    void showBars(const haptics::DisplayState& state);
    void showWords(const haptics::DisplayState& state);
    void showNumbers(const haptics::DisplayState& state);
    void addSamples(const haptics::DisplayState& state, std::span<const session::LiveSample> samples);

    const Theme& m_theme;
    QLocale m_locale;
    session::LevelCues m_cues;
    Grasping m_grasping;
    int m_tools;
    QLabel* m_step = nullptr;
    QProgressBar* m_dwell = nullptr;
    QLabel* m_held = nullptr;
    QLabel* m_load = nullptr; ///< stretch of the tube, or weight of the object
    TargetBar* m_target = nullptr;
    TargetBar* m_retraction = nullptr; ///< pull on a fold that is retracted
    std::vector<ForceBar*> m_force;
    std::vector<ToolRow> m_rows;
    LivePlot* m_targetPlot = nullptr;
    LivePlot* m_forcePlot = nullptr;
    LivePlot* m_speedPlot = nullptr;
};

} // namespace chiron::desktop
