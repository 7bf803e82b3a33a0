// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exercises/urethra_insertion/desktop/insertion_values.h"
#include "app/exercises/urethra_insertion/desktop/stage_words.h"
#include "desktop/training/info_view.h"

#include <array>

class QGridLayout;
class QLabel;
class QProgressBar;
class QVBoxLayout;

namespace chiron::desktop {

class ForceBar;
class LivePlot;
class SignedBar;

/// P1's Info window for an endoscope: stage, elapsed time, forces and torques against their limits, tip
/// coordinates, and the last ten seconds, each as far as the level allows it.
/// Thread: GUI.
class InsertionPanel final : public InfoView {
    Q_OBJECT
public:
    InsertionPanel(const Theme& theme, const QLocale& locale, const session::LevelCues& cues,
                   const simulation::UrethraInsertionParameters& parameters, QWidget* parent = nullptr);

protected:
    void showMoving(const haptics::DisplayState& state,
                    std::span<const session::LiveSample> samples) override;
    void showReadings(const haptics::DisplayState& state) override;

private:
    void addStage();
    void addForces(const simulation::UrethraInsertionParameters& parameters);
    void addComponents(QVBoxLayout& column, std::array<SignedBar*, 3>& into, std::array<SignedBar*, 3> bars);
    SignedBar* component(const char* name, const QString& sign, const QString& spoken, const QString& unit,
                         double limit, int decimals);
    void addNumbers();
    QLabel* addNumber(const QString& name, const char* objectName, QGridLayout& grid, int column);
    void addPlots(const simulation::UrethraInsertionParameters& parameters);
    LivePlot* plot(const char* name, const QString& title, double top, std::optional<double> limit = {});

    void showStage(const simulation::EndoscopeCues& cues);
    void showForces();
    void showNumbers();
    void addSamples(std::span<const session::LiveSample> samples);

    const Theme& m_theme;
    QLocale m_locale;
    session::LevelCues m_cues;
    InsertionGauge m_gauge;
    InsertionValues m_values; ///< of this frame
    StageTelling m_telling;
    QLabel* m_stage = nullptr;
    QProgressBar* m_progress = nullptr;
    ForceBar* m_resistance = nullptr;
    ForceBar* m_lateral = nullptr;
    std::array<SignedBar*, 3> m_force{};
    std::array<SignedBar*, 3> m_torque{};
    std::array<QLabel*, 6> m_numbers{}; ///< x, y, z, depth, off-centre, alignment
    LivePlot* m_forcePlot = nullptr;
    LivePlot* m_lateralPlot = nullptr;
    LivePlot* m_offsetPlot = nullptr;
    LivePlot* m_alignmentPlot = nullptr;
};

} // namespace chiron::desktop
