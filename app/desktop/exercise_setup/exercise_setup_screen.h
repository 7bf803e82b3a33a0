// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/frame/screen.h"
#include "desktop/training/training_plan.h"

class QCheckBox;
class QBoxLayout;
class QLabel;
class QPushButton;

namespace chiron::desktop {

class DeviceChooser;
class LevelChooser;
class StatePanel;
class WorkspaceBox;

/// Sets up an exercise: level, device and workspace. Everything has a default, so that pressing Start is
/// enough. Its place is a TrainingPlan, of which only the exercise is required.
/// Thread: GUI.
class ExerciseSetupScreen final : public Screen {
    Q_OBJECT
public:
    ExerciseSetupScreen(AppContext& context, const Place& place);

    QString title() const override;
    void enter() override;
    std::vector<ScreenCommand> commands() override;
    QString help() const override;

    TrainingPlan plan() const; ///< the plan as chosen now

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    QWidget* buildPage();
    QWidget* buildCard();
    QWidget* buildChoices();
    QWidget* buildStart();
    void takePlan();
    void loadStandings();
    void showLevel();
    void showStart();
    void noteChoices();
    void start();
    void watchFirst();
    const catalogue::ExerciseLevel* level() const;
    QString textOf(const catalogue::Translated& text) const;

    const catalogue::Exercise* m_exercise = nullptr;
    /// The place or the person chose the level, so the recommendation no longer changes it.
    bool m_levelChosen = false;
    StatePanel* m_panel = nullptr;
    QBoxLayout* m_columns = nullptr;
    QBoxLayout* m_picture = nullptr; ///< layout that holds the level's picture
    QLabel* m_objective = nullptr;
    QLabel* m_facts = nullptr; ///< hidden if the objective says everything
    QLabel* m_measured = nullptr;
    QLabel* m_gates = nullptr;
    QLabel* m_note = nullptr;
    LevelChooser* m_levels = nullptr;
    DeviceChooser* m_devices = nullptr;
    WorkspaceBox* m_workspace = nullptr;
    QCheckBox* m_familiarisation = nullptr;
    QLabel* m_standing = nullptr;
    QLabel* m_summary = nullptr;
    QPushButton* m_watch = nullptr; ///< starts a demonstration by the scripted expert
    QPushButton* m_start = nullptr;
};

} // namespace chiron::desktop
