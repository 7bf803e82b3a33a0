// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/frame/screen.h"
#include "desktop/scene3d/scene_view.h"
#include "desktop/training/answer_note.h"
#include "desktop/training/control_bar.h"
#include "desktop/training/force_words.h"
#include "desktop/training/live_feed.h"
#include "desktop/training/live_part.h"
#include "desktop/training/hand_control.h"
#include "desktop/training/ready_card.h"
#include "desktop/training/scene_pointer.h"
#include "desktop/training/session_control.h"
#include "desktop/training/sound_cue_player.h"
#include "desktop/training/training_plan.h"
#include "session/exercise_kind.h"
#include "session/level_cues.h"
#include "session/level_limits.h"

#include <QTimer>

#include <optional>

class QCheckBox;
class QLabel;
class QStackedWidget;

namespace chiron::desktop {

class ExerciseFace;
class ForceNotice;
class HeaderBar;
class InfoView;
class KeyFilter;
class SoundSign;
class StatePanel;

/// A running session: control, graphics, info. Its place is a TrainingPlan. It prepares the session after it has been painted
/// itself, shows the ready card to whoever works with their own hand, begins the session when the scene has been drawn, and goes to the
/// debrief when it is stored; or, where somebody starts again or has practised, to a new one of the same plan. GUI thread.
class TrainingScreen final : public Screen {
    Q_OBJECT
public:
    TrainingScreen(AppContext& context, const Place& place);
    ~TrainingScreen() override;

    QString title() const override;
    void enter() override;
    bool mayLeave() override;
    bool isBusy() const override { return running(); }
    std::vector<ScreenCommand> commands() override;
    QString help() const override;
    bool helpItself() override;

    LiveFeed* feed() const { return m_feed.get(); } ///< null before the session begins
    scene3d::ISceneView* scene() const { return m_scene.get(); }
    const scene3d::SceneState& drawn() const { return m_drawn; } ///< the last state that was drawn

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    // training_screen_build.cpp
    void build();
    void makeHeader();
    QWidget* buildSide();
    QWidget* buildDetailsSwitch();
    QWidget* buildFoot();
    LiveSurroundings surroundings();
    InfoView* makeInfo();
    QString keysText() const;
    void addPartCommands(std::vector<ScreenCommand>& list);
    void buildKeys();
    /// What is asked before a running session is ended: question, what will be, and the button that does it.
    struct Ask {
        QString question;
        QString then;
        QString endText;
    };
    void askToEnd(const Ask& ask, const std::function<void()>& end);
    static QString keptText();

    // training_screen_ready.cpp: the card before the clock starts, and on F1
    bool hasCard() const { return m_plan.ownHand() && !m_plan.practises(); }
    ReadyFacts readyFacts() const;
    QStringList markWords() const;
    void showCard(ReadyCard::Kind kind);
    void showCardAgain(); ///< while a session waits
    void takeCardAway();
    void go();
    void practise();
    scene3d::SceneNote practiceNote() const; ///< of its last seconds
    scene3d::SceneNote pointerNote() const;  ///< of the first seconds, to whoever has never freed the pointer

    // training_screen.cpp: from prepared to stored
    void prepare();
    void take(core::Result<session::TrainingRequest> request);
    void loadScene();
    void begin();
    void connectPointer();
    std::vector<int> handKeys() const; ///< of the hand, and of what is said beside it
    void onFrame();
    void takeAnswer(scene3d::SceneState& drawn);
    scene3d::SceneNote noteNow() const; ///< over the scene
    void showControls();
    void showPointer(); ///< whose it is: the scene's or the buttons'
    void beginLastLook();
    static QString storingText();
    void onFinished();
    void showOutcome(); ///< the debrief, or what comes instead
    void fail(const core::Error& error);
    bool running() const { return m_feed && !m_over; }
    bool isEndoscope() const { return m_tool == session::PointerTool::endoscope; }
    bool isGrasper() const { return m_tool == session::PointerTool::grasper; }

    // training_screen_actions.cpp
    void stopForce();
    void pauseOrResume();
    void rearm();
    void mark();
    void end();
    void startAgain();   ///< the attempt so far is kept as stopped, then a new one begins
    void askToStartAgain();
    void setDepthOfField(bool on);
    void hold();   ///< frees pointer and keys: paused or stopped
    void goOn();   ///< takes them again
    void toggleMute();

    static constexpr char kPointerKnown[] = "pointer_freed"; ///< a person's setting: they have paused by themselves

    TrainingPlan m_plan;
    std::optional<catalogue::ExerciseLevel> m_tried;   ///< with the plan's fewer trials
    const catalogue::ExerciseLevel* m_level = nullptr; ///< the catalogue's, or m_tried; null: no such level
    const ExerciseFace* m_face = nullptr;              ///< of the level's exercise
    std::unique_ptr<LivePart> m_live;                  ///< of the level; null without one
    session::LevelCues m_cues;
    session::LevelLimits m_limits;
    session::PointerTool m_tool = session::PointerTool::point;
    int m_tools = 1; ///< instruments of the level

    StatePanel* m_stage = nullptr;
    QStackedWidget* m_pages = nullptr; ///< of the stage: the ready card, the scene
    ReadyCard* m_card = nullptr;       ///< null while none is shown
    bool m_wentAhead = false;          ///< "Go", or nothing to wait for
    bool m_practised = false;          ///< the card comes after a practice
    HeaderBar* m_header = nullptr;
    InfoView* m_info = nullptr;
    std::optional<AnswerNote> m_answer;    ///< once the session is prepared
    ForceNotice* m_notice = nullptr;
    SoundSign* m_soundSign = nullptr; ///< levels with sound and without bars
    ControlBar* m_controls = nullptr;
    KeyFilter* m_keys = nullptr;
    QWidget* m_side = nullptr;
    QLabel* m_keysText = nullptr;
    QLabel* m_pointerText = nullptr; ///< how the buttons are reached, or the scene again; null where nobody works with the pointer
    QLabel* m_activeText = nullptr; ///< which of several instruments is moved; null where there is one
    QCheckBox* m_depthOfField = nullptr; ///< null where the exercise has no such switch
    QCheckBox* m_details = nullptr; ///< all that is measured, or what somebody needs who learns
    QWidget* m_foot = nullptr;

    bool m_painted = false;
    bool m_over = false;    ///< stored or failed: nothing keeps anybody here
    bool m_storing = false;
    QTimer m_lastLook;      ///< runs: the session has ended, and its last trial's truth is still looked at
    bool m_asking = false;
    bool m_again = false;   ///< a new attempt begins when this one is stored
    std::int64_t m_start_ns = 0;
    scene3d::SceneSetup m_setup;
    std::unique_ptr<scene3d::ISceneView> m_scene;
    scene3d::SceneState m_drawn;
    std::optional<session::TrainingRequest> m_request; ///< prepared, waits for the scene
    SoundCuePlayer m_sound;
    // In this order: the session outlives what talks to it.
    std::unique_ptr<LiveFeed> m_feed;
    std::optional<SessionControl> m_control;
    std::unique_ptr<HandControl> m_hand;
    std::unique_ptr<ScenePointer> m_pointer;
};

} // namespace chiron::desktop
