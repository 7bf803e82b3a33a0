// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/exercises_screen.h"

#include "database/repositories/session_reader.h"
#include "desktop/frame/app_context.h"
#include "desktop/home/exercise_card.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

namespace chiron::desktop {

namespace {

core::Result<std::vector<database::SessionSummary>> ownSessions(const database::Database& database,
                                                                const database::Actor& actor) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    database::SessionFilter filter;
    filter.person = actor.personId();
    return database::SessionReader(**reader, actor).listSessions(filter);
}

} // namespace

ExercisesScreen::ExercisesScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_panel(new StatePanel(context.theme())) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_panel);
}

QString ExercisesScreen::title() const {
    return tr("Exercises");
}

QString ExercisesScreen::help() const {
    return tr("All exercises of this site and their levels.\n\nEach level says whether you have passed it. "
              "Choose one to see what is "
              "measured and what counts as passed, choose a device, and start.");
}

void ExercisesScreen::enter() {
    load();
}

void ExercisesScreen::load() {
    m_panel->showLoading(tr("Loading the exercises …"));
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor()](WorkToken&) {
            return ownSessions(database, actor);
        },
        [this](const core::Result<std::vector<database::SessionSummary>>& own) {
            if (!own) {
                m_panel->showError(tr("The exercises could not be loaded."), own.error(), [this] { load(); });
                return;
            }
            const catalogue::Catalogue& catalogue = context().site().catalogue();
            if (catalogue.exercises().empty()) {
                m_panel->showEmpty(tr("There are no exercises"),
                                   tr("The content folder of this site contains no exercises. Ask an "
                                      "administrator."));
                return;
            }
            const auto standings = session::levelStandings(catalogue, *own);
            auto* page = new ScrollPage(context().theme(), 1100);
            page->column()->addWidget(kit::label(context().theme(), title(), TextStyle::heading));
            for (const catalogue::Exercise& exercise : catalogue.exercises())
                page->column()->addWidget(new ExerciseCard(context(), exercise, standings));
            page->column()->addStretch();
            delete m_panel->content();
            m_panel->setContent(page);
            m_panel->showContent();
            if (auto* first = page->findChild<QPushButton*>())
                first->setFocus(Qt::OtherFocusReason);
        });
}

} // namespace chiron::desktop
