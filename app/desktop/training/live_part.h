// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "core/report_word.h"
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

/// What a part of the training screen may know and ask of it.
struct LiveSurroundings {
    const Theme& theme;
    QLocale locale;
    session::LevelCues cues;
    bool ownHand = false;    ///< a person's; else somebody is watched
    bool leftHanded = false;
    bool practises = false;
    std::function<void(core::ReportField, unsigned)> report; ///< of what was found, to the session that runs
    std::function<void()> freePointer; ///< while the trial runs; a click in the scene takes it again
};

/// Something that a key does.
struct LiveCommand {
    QString text;
    int key = 0; ///< Qt::Key
};

inline constexpr double kPanelWidth_px = 290.0;
inline constexpr double kWidePanel_px = 372.0; ///< more is measured, and a round picture is as large beside it

/// What the training screen has for one exercise alone while a level is trained: measurements, hand, keys, what is said over the scene.
/// GUI thread.
class LivePart {
public:
    explicit LivePart(LiveSurroundings around) : m_around(std::move(around)) {}
    LivePart(const LivePart&) = delete;
    LivePart& operator=(const LivePart&) = delete;
    virtual ~LivePart() = default;

    /// The measurements; once, before anything else is asked. Whoever lays them out owns them.
    virtual InfoView* makePanel() = 0;
    virtual double panelWidth_px() const { return kPanelWidth_px; }

    /// The hand that moves what the session offers, once it runs: as it stands here a point or an endoscope. Null: it is somebody else's.
    /// `chosen`: of several tools, which one moves now.
    virtual std::unique_ptr<HandControl> takeHand(session::LiveTraining& training, std::function<void(int)> chosen) const;
    /// Which of several tools moves; empty where there is one.
    virtual QString activeText(int /*tool*/) const { return {}; }
    /// Whether "here it is" is said by the hand that moves, and not of the one tool that there is.
    virtual bool handMarks() const { return false; }
    /// The movements without which nobody can begin, and all keys in words; empty: as of every tool of its kind.
    virtual std::vector<ControlHint> controls() const { return {}; }
    virtual QString keysText() const { return {}; }

    /// Keys beside those that move the tool (Qt::Key), and what they do; false: not one of them.
    virtual std::vector<int> keys() const { return {}; }
    virtual bool key(int /*key*/) { return false; }
    virtual std::vector<LiveCommand> commands() const { return {}; }

    /// Each frame: adds to what is drawn. What it points to stays valid until the next frame.
    virtual void show(const haptics::DisplayState&, std::span<const session::LiveSample>, scene3d::SceneState& /*drawn*/) {}
    /// How far the force on a tool leans, where the level shows it: what sounds brighter.
    virtual double lean_rad(const haptics::DisplayState&, std::size_t /*tool*/) const { return 0.0; }
    /// What is said over the scene, where nothing more urgent is.
    virtual scene3d::SceneNote note(std::int64_t /*now_ns*/) const { return {}; }

protected:
    const LiveSurroundings& around() const { return m_around; }

private:
    LiveSurroundings m_around;
};

/// Of a tool with a point, and nothing more.
class PointPart final : public LivePart {
public:
    PointPart(const catalogue::ExerciseLevel& level, LiveSurroundings around);
    InfoView* makePanel() override;

private:
    double m_limit_N;
};

/// The translation context of what the training screen and its parts say.
struct TrainingTexts {
    Q_DECLARE_TR_FUNCTIONS(chiron::desktop::TrainingScreen)
};

} // namespace chiron::desktop
