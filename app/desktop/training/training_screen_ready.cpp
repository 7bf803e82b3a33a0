// SPDX-License-Identifier: GPL-3.0-or-later
// The card that a person reads before the clock starts, and again on F1.
#include "desktop/exercise_setup/gate_words.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/help_dialogs.h"
#include "desktop/scene3d/scene_marks.h"
#include "desktop/training/ready_card.h"
#include "desktop/training/scene_feed.h"
#include "desktop/training/side_panel.h"
#include "desktop/training/training_screen.h"
#include "desktop/training/training_words.h"
#include "desktop/widgets/state_panel.h"

#include <QStackedWidget>
#include <algorithm>
#include <cmath>

namespace chiron::desktop {

namespace {
constexpr double kPractice_s = 60.0;     // long enough to try every control once, short enough to be accepted
constexpr double kPracticeEnds_s = 10.0; // announced this long before the end, to finish the current action
} // namespace

/// Explains everything that this level's scene may draw as guidance.
QStringList TrainingScreen::markWords() const {
    QStringList words;
    const catalogue::Exercise* exercise = context().site().catalogue().find(m_level->exercise);
    if (!exercise)
        return words;
    const scene3d::SceneSetup setup =
        sceneSetupOf(*m_level, m_cues, context().theme(), m_plan.workspace.leftHanded, m_plan.depthOfField);
    const std::vector<std::string> drawn = scene3d::marksOf({setup, m_cues.coverage, m_level->feedback});
    for (const catalogue::LegendLine& line : exercise->legend)
        if (std::find(drawn.begin(), drawn.end(), line.mark) != drawn.end())
            words << QString::fromStdString(catalogue::textIn(line.text, context().language().toStdString()));
    return words;
}

ReadyFacts TrainingScreen::readyFacts() const {
    const std::string language = context().language().toStdString();
    const auto text = [&](const catalogue::Translated& words) {
        return QString::fromStdString(catalogue::textIn(words, language));
    };
    ReadyFacts facts;
    facts.exercise = title();
    facts.level = text(m_level->title);
    facts.goal = text(m_level->goal.empty() ? m_level->objective : m_level->goal);
    facts.controls = m_live ? m_live->guide().begin : std::vector<ControlHint>();
    if (facts.controls.empty())
        facts.controls = controlGuide(m_tool, m_plan.driver->hand, m_tools);
    facts.keys = keysText();
    facts.limit = tr("%1. %2.").arg(limitsInWords(*m_level, context().locale()).join(QStringLiteral(". ")),
                                    deviceTitle(m_plan));
    facts.gates = gatesInWords(*m_level, context().locale());
    facts.marks = markWords();
    if (m_feed) { // on request: what began cannot be announced again
        facts.clock = pausedClock();
        return facts;
    }
    const auto kind = session::exerciseKind(m_level->exercise);
    const int trials = kind ? (*kind)->trialCount(*m_level) : 1;
    facts.clock = m_practised ? tr("%n trial(s). The clock starts when you press Continue.", nullptr, trials)
                  : m_plan.byPointer()
                      ? tr("%n trial(s). The clock starts when you press Go or move the tool with a key.",
                           nullptr, trials)
                      : tr("%n trial(s). The clock starts when you press Go.", nullptr, trials);
    if (m_plan.trials > 0) {
        facts.offersPractice = false; // it is a practice itself
        facts.clock = tr("%1 Nothing counts yet.").arg(facts.clock);
    }
    facts.offersLeave = context().navigator().canGoBack();
    facts.offersDemonstration = !m_practised && expertPlan(m_level->exercise, m_level->number).has_value();
    if (m_practised)
        facts.practised = m_plan.familiarisation ? tr("The practice is over. The familiarisation begins when "
                                                      "you press Continue; it does not count either.")
                                                 : tr("The practice is over and does not count. The trials "
                                                      "that count begin when you press Continue.");
    return facts;
}

/// What the card on request says about the clock: the session has been paused for it.
QString TrainingScreen::pausedClock() const {
    if (m_control->stopped())
        return tr("The clock is stopped. Press Re-arm or R to go on.");
    if (m_plan.practises())
        return tr("The practice is paused. Press Resume or Space to go on.");
    return tr("The trial is paused and its clock is stopped. Press Resume or Space to go on.");
}

void TrainingScreen::showCard(ReadyCard::Kind kind) {
    takeCardAway();
    m_card = new ReadyCard(context().theme(), readyFacts(), kind);
    m_card->setToolKeys(movementKeys(m_tool, m_plan.driver->hand));
    connect(m_card, &ReadyCard::goAsked, this, &TrainingScreen::go);
    connect(m_card, &ReadyCard::practiceAsked, this, &TrainingScreen::practise);
    connect(m_card, &ReadyCard::watchAsked, this, [this] {
        if (const auto expert = expertPlan(m_level->exercise, m_level->number))
            // Its debrief offers "Now you".
            context().navigator().replace({QStringLiteral("training"), expert->toMap()});
    });
    connect(m_card, &ReadyCard::leaveAsked, this, [this] { context().navigator().back(); });
    connect(m_card, &ReadyCard::wholeAsked, this, [this] { showCard(ReadyCard::Kind::whole); });
    connect(m_card, &ReadyCard::helpAsked, this, [this] { showHelp(context().theme(), *this, window()); });
    m_pages->addWidget(m_card);
    m_pages->setCurrentWidget(m_card);
    m_stage->showContent();
    for (QWidget* part : {static_cast<QWidget*>(m_side), m_foot, static_cast<QWidget*>(m_controls)})
        part->hide(); // nothing is running that could be measured or stopped, so the card gets the space
    m_card->takeFocus();
}

void TrainingScreen::showCardAgain() {
    if (m_card)
        return;
    m_card = new ReadyCard(context().theme(), readyFacts(), ReadyCard::Kind::paused);
    connect(m_card, &ReadyCard::goAsked, this, [this] {
        if (m_control->stopped())
            takeCardAway(); // only Re-arm restores force
        else
            pauseOrResume();
    });
    connect(m_card, &ReadyCard::helpAsked, this, [this] { showHelp(context().theme(), *this, window()); });
    m_pages->addWidget(m_card);
    m_pages->setCurrentWidget(m_card);
    for (QWidget* part : {static_cast<QWidget*>(m_side), m_foot})
        part->hide(); // the controls stay, so that force can be stopped at any time
    showControls();
    m_card->takeFocus();
}

void TrainingScreen::takeCardAway() {
    if (!m_card)
        return;
    if (m_scene)
        m_pages->setCurrentWidget(m_scene->widget());
    for (QWidget* part : {static_cast<QWidget*>(m_side), m_foot, static_cast<QWidget*>(m_controls)})
        part->show();
    m_card->hide();
    m_card->deleteLater(); // deferred, because the card itself may have requested this
    m_card = nullptr;
}

void TrainingScreen::go() {
    if (m_wentAhead)
        return;
    m_wentAhead = true;
    // People who only tried the level still need the explanation of each movement.
    if (!m_plan.familiarisation && !m_plan.practises())
        context().settings().setOfPerson(context().actor().personId(), readyKey(m_plan), true);
    m_stage->showLoading(tr("Preparing the scene …"));
    takeCardAway();
    setFocus();
    if (m_request)
        loadScene();
}

void TrainingScreen::practise() {
    TrainingPlan plan = m_plan;
    plan.practice_s = kPractice_s;
    context().navigator().replace({QStringLiteral("training"), plan.toMap()});
}

scene3d::SceneNote TrainingScreen::practiceNote() const {
    const double left_s = m_plan.practice_s - m_feed->worked_s();
    if (!m_plan.practises() || m_storing || left_s > kPracticeEnds_s)
        return {};
    return {scene3d::SceneNote::Kind::said,
            tr("Practice ends in %1 s")
                .arg(context().locale().toString(std::max(1, static_cast<int>(std::ceil(left_s))))),
            {}};
}

bool TrainingScreen::helpItself() {
    if (!running() || m_storing || !m_plan.ownHand() || m_card)
        return false;
    m_control->pause();
    hold();
    showControls();
    showCardAgain();
    return true;
}

} // namespace chiron::desktop
