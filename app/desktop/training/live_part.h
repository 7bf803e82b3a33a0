// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/scene3d/scene_note.h"
#include "desktop/scene3d/scene_state.h"
#include "desktop/theme/theme.h"
#include "desktop/training/control_guide.h"
#include "desktop/training/hand_control.h"
#include "haptics/display_state.h"
#include "session/level_cues.h"
#include "session/live_sample.h"
#include "session/live_training.h"

#include <QCoreApplication>
#include <QLocale>
#include <QString>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace chiron::desktop {

class InfoView;

/// The context that a part of the training screen receives, and the requests that it can make.
struct LiveSurroundings {
    const Theme& theme;
    QLocale locale;
    session::LevelCues cues;
    bool ownHand = false; ///< the person's own; otherwise a demonstration is watched
    devices::HandKind hand = devices::HandKind::mouseAndKeyboard; ///< what it holds
    bool leftHanded = false;
    bool practises = false;
    /// Sends a report to the running session: a word whose meaning the exercise defines.
    std::function<void(std::uint16_t word)> report;
    /// Frees the pointer while the trial runs; a click in the scene captures it again.
    std::function<void()> freePointer;
};

/// What a key does, besides those that move the tool.
struct LiveCommand {
    QString text; ///< for the list of commands; empty: it is not in the list, only LiveGuide::keys names it
    int key = 0;  ///< Qt::Key
    std::function<void()> run; ///< valid as long as the part
};

/// What a person is told of the controls. Where one is empty, the words for this kind of tool apply.
struct LiveGuide {
    std::vector<ControlHint> begin; ///< the movements that are needed to begin
    QString keys;                   ///< all keys
};

inline constexpr double kPanelWidth_px = 290.0;
/// For panels with more measurements; a round picture beside it has the same size.
inline constexpr double kWidePanel_px = 372.0;

/// The part of the training screen that is specific to one exercise: measurements, hand, keys, messages over
/// the scene.
/// Thread: GUI.
class LivePart {
public:
    explicit LivePart(LiveSurroundings around) : m_around(std::move(around)) {}
    LivePart(const LivePart&) = delete;
    LivePart& operator=(const LivePart&) = delete;
    virtual ~LivePart() = default;

    /// Creates the panel with the measurements. Called once, before any other function. The caller's layout
    /// owns the panel.
    virtual InfoView* makePanel() = 0;
    virtual double panelWidth_px() const { return kPanelWidth_px; }

    /// Creates the control for the tools that the running session offers; by default for a point or an
    /// endoscope. Null if the person does not move the tool. `chosen` is called with the newly active tool if
    /// there are several.
    virtual std::unique_ptr<HandControl> takeHand(session::LiveTraining& training,
                                                  std::function<void(int)> chosen) const;
    /// Names the active tool; empty if there is only one.
    virtual QString activeText(int /*tool*/) const { return {}; }
    virtual LiveGuide guide() const { return {}; }
    /// Its own keys, each once.
    virtual std::vector<LiveCommand> commands() const { return {}; }

    /// Called every frame: adds to the drawn scene. What it points to stays valid until the next frame.
    virtual void show(const haptics::DisplayState&, std::span<const session::LiveSample>,
                      scene3d::SceneState& /*drawn*/) {}
    /// The angle between the force on a tool and the normal of what it touches, if the level shows it; the
    /// force tone becomes brighter with it.
    virtual double lean_rad(const haptics::DisplayState&, std::size_t /*tool*/) const { return 0.0; }
    /// The message over the scene, shown if there is nothing more urgent.
    virtual scene3d::SceneNote note(std::int64_t /*now_ns*/) const { return {}; }

protected:
    const LiveSurroundings& around() const { return m_around; }

private:
    LiveSurroundings m_around;
};

/// The part for a tool with a point, without additions.
class PointPart final : public LivePart {
public:
    PointPart(const catalogue::ExerciseLevel& level, LiveSurroundings around);
    InfoView* makePanel() override;

private:
    double m_limit_N;
};

/// The translation context of the texts of the training screen and its parts.
struct TrainingTexts {
    Q_DECLARE_TR_FUNCTIONS(chiron::desktop::TrainingScreen)
};

} // namespace chiron::desktop
