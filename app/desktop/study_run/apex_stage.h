// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/scene3d/scene_view.h"
#include "desktop/theme/theme.h"
#include "haptics/display_state.h"
#include "session/level_cues.h"

#include <QWidget>
#include <memory>

class QLabel;
class QPushButton;

namespace chiron::desktop {

/// The view in which a participant searches for an apex: the exercise's own scene, limited to what the study
/// lets be seen. If the sphere is hidden and no force is felt, the tool is drawn where the hand is, never at
/// the surface, and force is shown as on the exercise's hidden levels.
/// Thread: GUI.
class ApexStage final : public QWidget {
    Q_OBJECT
public:
    struct Look {
        bool felt = true; ///< the device renders force
        bool leftHanded = false;
        double forceLimit_N = 4.0; ///< the largest force allowed, marked at the force bar
    };
    ApexStage(const Theme& theme, const catalogue::ExerciseLevel& level, const Look& look,
              QWidget* parent = nullptr);
    ~ApexStage() override;

    QWidget& area() { return *m_scene->widget(); }
    QObject& source() { return *m_scene->inputSource(); }
    /// `canMark`: a mark is accepted now. `words`: what is missing, or what to do.
    void show(const haptics::DisplayState& state, bool canMark, const QString& words);
    const scene3d::SceneState& drawn() const { return m_drawn; } ///< the last state drawn

signals:
    void markAsked();

private:
    QWidget* buildFoot(const Theme& theme);

    session::LevelCues m_cues;
    std::unique_ptr<scene3d::ISceneView> m_scene;
    scene3d::SceneState m_drawn;
    std::int64_t m_start_ns = 0;
    QPushButton* m_mark = nullptr;
    QLabel* m_words = nullptr;
};

} // namespace chiron::desktop
