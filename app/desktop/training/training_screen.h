// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "catalogue/exercise.h"
#include "desktop/frame/screen.h"
#include "desktop/scene3d/scene_view.h"
#include "desktop/training/answer_note.h"
#include "desktop/training/control_bar.h"
#include "desktop/training/early_marks.h"
#include "desktop/training/force_words.h"
#include "desktop/training/hand_control.h"
#include "desktop/training/live_feed.h"
#include "desktop/training/live_part.h"
#include "desktop/training/ready_card.h"
#include "desktop/training/scene_pointer.h"
#include "desktop/training/session_control.h"
#include "desktop/training/sound_cue_player.h"
#include "desktop/training/training_plan.h"
#include "session/exercise_kind.h"
#include "session/level_cues.h"
#include "session/level_limits.h"

#include <QElapsedTimer>
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
class SidePanel;
class SoundSign;
class StatePanel;

/// Runs a session, with controls, graphics and measurements. Its place is a TrainingPlan. It prepares the
/// session after its own first paint, shows the ready card to people who work with their own hand, and starts
/// the session when the scene has been drawn. When the session is stored it goes to the debrief, or after a
/// restart or a practice to a new session of the same plan.
/// Thread: GUI.
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

    LiveFeed* feed() const { return m_feed.get(); } ///< null before the session starts
    scene3d::ISceneView* scene() const { return m_scene.get(); }
    const scene3d::SceneState& drawn() const { return m_drawn; } ///< the last state drawn
    /// Whether a mark now would be taken for a second press of what came before (EarlyMarks), and not sent.
    bool marksAreEarly() const { return m_early.areEarly(m_clock.elapsed()); }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    bool event(QEvent* event) override;

private:
    // training_screen_build.cpp
    void build();
    void makeHeader();
    void buildSide();
    QWidget* buildDetailsSwitch();
    QWidget* buildFoot();
    void giveSceneRoom(); ///< the other parts give way, in a fixed order
    void giveMoreRoom();
    int sceneHeight_px() const;
    LiveSurroundings surroundings();
    InfoView* makeInfo();
    QString keysText() const;
    void addPartCommands(std::vector<ScreenCommand>& list);
    bool runPartKey(int key);
    void buildKeys();
    /// The question before a running session is ended: its text, the consequences, and the label of the
    /// confirming button.
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
    QString pausedClock() const;
    QStringList markWords() const;
    void showCard(ReadyCard::Kind kind);
    void showCardAgain(); ///< while the session is paused
    void takeCardAway();
    void go();
    void practise();
    scene3d::SceneNote practiceNote() const; ///< announces the end of a practice in its last seconds
    /// For the first seconds, to people who have never freed the pointer.
    scene3d::SceneNote pointerNote() const;

    // training_screen.cpp: from preparing to storing
    void prepare();
    void take(core::Result<session::TrainingRequest> request);
    void loadScene();
    void begin();
    void connectPointer();
    std::vector<int> handKeys() const; ///< of the hand control and of the exercise's part
    void onFrame();
    void takeAnswer(scene3d::SceneState& drawn);
    scene3d::SceneNote noteNow() const; ///< the note over the scene
    void showControls();
    void showPointer(); ///< says whether the pointer controls the scene or the buttons
    void beginLastLook();
    static QString storingText();
    void onFinished();
    void showOutcome(); ///< the debrief, or its replacement
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
    void startAgain(); ///< stores the present attempt as stopped and starts a new one
    void askToStartAgain();
    void setDepthOfField(bool on);
    void hold(); ///< when paused or stopped: frees pointer and keys
    void goOn(); ///< captures them again
    void toggleMute();

    /// Name of a person's setting: they have paused by themselves.
    static constexpr char kPointerKnown[] = "pointer_freed";

    TrainingPlan m_plan;
    std::optional<catalogue::ExerciseLevel> m_tried; ///< with the plan's smaller number of trials
    /// From the catalogue, or m_tried; null: no such level.
    const catalogue::ExerciseLevel* m_level = nullptr;
    const ExerciseFace* m_face = nullptr; ///< of the level's exercise
    std::unique_ptr<LivePart> m_live;     ///< for the level; null without one
    session::LevelCues m_cues;
    session::LevelLimits m_limits;
    session::PointerTool m_tool = session::PointerTool::point;
    int m_tools = 1; ///< number of instruments of the level

    StatePanel* m_stage = nullptr;
    QStackedWidget* m_pages = nullptr; ///< pages of the stage: the ready card, the scene
    ReadyCard* m_card = nullptr;       ///< null while none is shown
    bool m_wentAhead = false;          ///< "Go" was pressed, or is not needed
    bool m_practised = false;          ///< the card follows a practice
    HeaderBar* m_header = nullptr;
    InfoView* m_info = nullptr;
    std::optional<AnswerNote> m_answer; ///< set once the session is prepared
    ForceNotice* m_notice = nullptr;
    SoundSign* m_soundSign = nullptr; ///< for levels with sound and without bars
    ControlBar* m_controls = nullptr;
    KeyFilter* m_keys = nullptr;
    SidePanel* m_side = nullptr;
    QLabel* m_keysText = nullptr;
    /// How to get from the scene to the buttons and back; null if nobody uses the pointer.
    QLabel* m_pointerText = nullptr;
    QLabel* m_activeText = nullptr;      ///< names the active instrument; null if there is only one
    QCheckBox* m_depthOfField = nullptr; ///< null if the exercise has no such setting
    QCheckBox* m_details = nullptr;      ///< switches between all measurements and the default set
    QWidget* m_foot = nullptr;

    bool m_painted = false;
    bool m_over = false; ///< stored or failed: the screen may be left
    bool m_storing = false;
    /// Runs after the end of the session, while the true answer of its last trial is still shown.
    QTimer m_lastLook;
    bool m_asking = false;
    EarlyMarks m_early;
    QElapsedTimer m_clock; ///< runs since the screen was made
    bool m_again = false;  ///< a new attempt starts when this one is stored
    std::int64_t m_start_ns = 0;
    scene3d::SceneSetup m_setup;
    std::unique_ptr<scene3d::ISceneView> m_scene;
    scene3d::SceneState m_drawn;
    std::optional<session::TrainingRequest> m_request; ///< prepared, waiting for the scene
    SoundCuePlayer m_sound;
    // In this order, because the session must outlive the objects that use it.
    std::unique_ptr<LiveFeed> m_feed;
    std::optional<SessionControl> m_control;
    std::unique_ptr<HandControl> m_hand;
    std::unique_ptr<ScenePointer> m_pointer;
};

} // namespace chiron::desktop
