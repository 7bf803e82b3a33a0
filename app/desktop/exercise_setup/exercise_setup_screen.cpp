// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/exercise_setup/exercise_setup_screen.h"

#include "database/repositories/session_reader.h"
#include "desktop/exercise_setup/device_chooser.h"
#include "desktop/exercise_setup/gate_words.h"
#include "desktop/exercise_setup/level_chooser.h"
#include "desktop/exercise_setup/level_facts.h"
#include "desktop/exercise_setup/workspace_box.h"
#include "desktop/frame/app_context.h"
#include "desktop/home/exercise_picture.h"
#include "desktop/training/training_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"
#include "session/exercise_kind.h"
#include "session/level_standing.h"

#include <QCheckBox>
#include <QKeyEvent>
#include <QResizeEvent>

namespace chiron::desktop {

namespace {

constexpr QSize kPicture_px(320, 170);
constexpr double kTwoColumns_px = 820; // below this width there is one column

using Standings = std::vector<session::LevelStanding>;

core::Result<Standings> readStandings(const database::Database& database, const database::Actor& actor,
                                      const catalogue::Catalogue& catalogue) {
    auto connection = database.openReader();
    CHIRON_TRY(connection);
    database::SessionFilter filter;
    filter.person = actor.personId();
    auto sessions = database::SessionReader(**connection, actor).listSessions(filter);
    CHIRON_TRY(sessions);
    return session::levelStandings(catalogue, *sessions);
}

} // namespace

ExerciseSetupScreen::ExerciseSetupScreen(AppContext& context, const Place& place)
    : Screen(context, place),
      m_exercise(context.site().catalogue().find(
          place.parameters.value(QStringLiteral("exercise")).toString().toStdString())) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_panel = new StatePanel(context.theme());
    column->addWidget(m_panel, 1);
    if (!m_exercise)
        return;
    m_panel->setContent(buildPage());
    column->addWidget(buildStart());
    takePlan();
    connect(m_levels, &LevelChooser::chosen, this, [this] {
        m_levelChosen = true;
        showLevel();
        noteChoices();
    });
    const auto changed = [this] {
        showStart();
        noteChoices();
    };
    connect(m_devices, &DeviceChooser::changed, this, changed);
    connect(m_workspace, &WorkspaceBox::changed, this, changed);
    connect(m_familiarisation, &QCheckBox::toggled, this, changed);
    showLevel();
    m_panel->showContent();
}

void ExerciseSetupScreen::enter() {
    if (!m_exercise) {
        m_panel->showEmpty(tr("This exercise does not exist"),
                           tr("The content on this station has no exercise of that name."), tr("Home"),
                           [this] { context().navigator().go(QStringLiteral("home")); });
        return;
    }
    m_start->setFocus();
    loadStandings();
}

void ExerciseSetupScreen::takePlan() {
    const QVariantMap& given = place().parameters;
    const auto person = context().actor().personId();
    const auto remembered = [&](const char* key, const QVariant& otherwise) {
        return context().settings().ofPerson(person, QLatin1String(key), otherwise);
    };
    QVariantMap map{{QStringLiteral("scale"), remembered("workspace_scale", 1.0)},
                    {QStringLiteral("left_handed"), remembered("left_handed", false)},
                    {QStringLiteral("origin_x_m"), remembered("workspace_x_m", 0.0)},
                    {QStringLiteral("origin_y_m"), remembered("workspace_y_m", 0.0)},
                    {QStringLiteral("origin_z_m"), remembered("workspace_z_m", 0.0)},
                    {QStringLiteral("base_turn_rad"), remembered("base_turn_rad", 0.0)},
                    {QStringLiteral("base_tilt_rad"), remembered("base_tilt_rad", 0.0)},
                    {QStringLiteral("base_roll_rad"), remembered("base_roll_rad", 0.0)}};
    map.insert(given);
    const TrainingPlan plan = TrainingPlan::fromMap(map);
    m_levelChosen = given.contains(QStringLiteral("level"));
    m_levels->setLevel(plan.level);
    if (!level())
        m_levels->setLevel(1);
    m_devices->setPlan(plan);
    m_workspace->setChoice(plan.workspace);
    m_familiarisation->setChecked(plan.familiarisation);
}

TrainingPlan ExerciseSetupScreen::plan() const {
    TrainingPlan plan;
    plan.exercise = QString::fromStdString(m_exercise->id);
    plan.level = m_levels->level();
    m_devices->fillPlan(plan);
    plan.workspace = m_workspace->choice();
    plan.familiarisation = m_familiarisation->isChecked() && plan.ownHand();
    return plan;
}

void ExerciseSetupScreen::loadStandings() {
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(),
         &catalogue = context().site().catalogue()](WorkToken&) {
            return readStandings(database, actor, catalogue);
        },
        [this](core::Result<Standings> standings) {
            if (!standings) {
                m_standing->setText(tr("Your earlier results could not be read. You can still train."));
                m_standing->show();
                return;
            }
            Standings own;
            for (const session::LevelStanding& standing : *standings)
                if (standing.exercise == m_exercise->id)
                    own.push_back(standing);
            const auto next = session::nextStep(own);
            m_levels->setStandings(own, next ? next->level : 0);
            if (next && !m_levelChosen) {
                m_levels->setLevel(next->level);
                showLevel();
            }
        });
}

const catalogue::ExerciseLevel* ExerciseSetupScreen::level() const {
    return context().site().catalogue().find(m_exercise->id, m_levels->level());
}

QString ExerciseSetupScreen::textOf(const catalogue::Translated& text) const {
    return QString::fromStdString(catalogue::textIn(text, context().language().toStdString()));
}

void ExerciseSetupScreen::showLevel() {
    const catalogue::ExerciseLevel* shown = level();
    while (QLayoutItem* old = m_picture->takeAt(0)) {
        delete old->widget();
        delete old;
    }
    m_picture->addWidget(new ExercisePicture(context().theme(), *shown, kPicture_px), 0, Qt::AlignHCenter);
    if (const auto kind = session::exerciseKind(shown->exercise))
        m_devices->setTools((*kind)->toolCount(*shown));
    m_objective->setText(textOf(shown->objective));
    const QStringList facts = levelFacts(*shown, context().locale());
    m_facts->setVisible(!facts.isEmpty());
    m_facts->setText(facts.isEmpty() ? QString()
                                     : QStringLiteral("•  ") + facts.join(QStringLiteral("\n•  ")));
    m_measured->setText(textOf(shown->measured));
    const QStringList gates = gatesInWords(*shown, context().locale());
    m_gates->setText(gates.isEmpty() ? tr("This level has no pass mark.")
                                     : QStringLiteral("•  ") + gates.join(QStringLiteral("\n•  ")));
    if (shown->shownForce)
        m_note->setText(textOf(shown->shownForce->note));
    showStart();
}

void ExerciseSetupScreen::showStart() {
    const TrainingPlan chosen = plan();
    const auto kind = session::exerciseKind(m_exercise->id);
    const bool mountable =
        chosen.movedBy(devices::MovedBy::scriptedOperator) && kind && (*kind)->operatorsKnowTheirPlace();
    m_workspace->setHasBase(mountable);
    m_workspace->setVisible(chosen.ownHand() || mountable);
    m_familiarisation->setVisible(chosen.ownHand());
    const catalogue::ExerciseLevel* shown = level();
    m_note->setVisible(shown && shown->needsForce && shown->shownForce && !chosen.feltByPerson());
    const QString hindrance = m_devices->hindrance();
    m_summary->setText(
        hindrance.isEmpty()
            ? tr("Level %1. %2").arg(context().locale().toString(chosen.level), deviceTitle(chosen))
            : hindrance);
    m_start->setText(chosen.ownHand() ? tr("Start") : tr("Watch"));
    m_start->setEnabled(hindrance.isEmpty());
    m_watch->setVisible(chosen.ownHand() && expertPlan(m_exercise->id, chosen.level));
}

void ExerciseSetupScreen::watchFirst() {
    if (const auto expert = expertPlan(m_exercise->id, m_levels->level()))
        context().navigator().go(QStringLiteral("training"), expert->toMap());
}

void ExerciseSetupScreen::noteChoices() {
    context().navigator().note(plan().toMap());
}

void ExerciseSetupScreen::start() {
    if (!m_exercise || !m_start->isEnabled())
        return;
    const TrainingPlan chosen = plan();
    const auto person = context().actor().personId();
    Settings& settings = context().settings();
    settings.setOfPerson(person, QStringLiteral("workspace_scale"), chosen.workspace.scale);
    settings.setOfPerson(person, QStringLiteral("left_handed"), chosen.workspace.leftHanded);
    settings.setOfPerson(person, QStringLiteral("workspace_x_m"), chosen.workspace.origin_m[0]);
    settings.setOfPerson(person, QStringLiteral("workspace_y_m"), chosen.workspace.origin_m[1]);
    settings.setOfPerson(person, QStringLiteral("workspace_z_m"), chosen.workspace.origin_m[2]);
    settings.setOfPerson(person, QStringLiteral("base_turn_rad"), chosen.workspace.turn_rad[0]);
    settings.setOfPerson(person, QStringLiteral("base_tilt_rad"), chosen.workspace.turn_rad[1]);
    settings.setOfPerson(person, QStringLiteral("base_roll_rad"), chosen.workspace.turn_rad[2]);
    context().navigator().go(QStringLiteral("training"), chosen.toMap());
}

void ExerciseSetupScreen::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
        start();
    else
        Screen::keyPressEvent(event);
}

void ExerciseSetupScreen::resizeEvent(QResizeEvent* event) {
    Screen::resizeEvent(event);
    if (m_columns)
        m_columns->setDirection(width() < context().theme().px(kTwoColumns_px) ? QBoxLayout::TopToBottom
                                                                               : QBoxLayout::LeftToRight);
}

} // namespace chiron::desktop
