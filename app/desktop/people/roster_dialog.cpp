// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/roster_dialog.h"

#include "database/accounts/account_service.h"
#include "desktop/frame/app_context.h"
#include "desktop/people/people_model.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"

#include <QHeaderView>
#include <QTableWidget>

namespace chiron::desktop {

namespace {
constexpr std::size_t kMostProblems_shown = 50;
constexpr double kTableHeight = 260;
} // namespace

RosterDialog::RosterDialog(AppContext& context, const QString& fileName, std::string text, QWidget* parent)
    : FormDialog(context, QStringLiteral("roster"), tr("Import people"), parent), m_text(std::move(text)) {
    column()->addWidget(kit::label(theme(), tr("From %1. Nothing is changed before you press Import.").arg(fileName), TextStyle::body, "muted"));
    m_panel = new StatePanel(theme());
    m_panel->setObjectName(QStringLiteral("roster.panel"));
    m_panel->setMinimumHeight(theme().px(kTableHeight));
    column()->addWidget(m_panel);
    setAccept(tr("Import"));
    load();
}

void RosterDialog::load() {
    m_panel->showLoading(tr("Reading the list …"));
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), text = m_text](WorkToken&) { return database::AccountService(*database).previewCsv(actor, text); },
        [this](core::Result<database::Roster> roster) {
            if (roster)
                showRoster(*roster);
            else
                m_panel->showError(tr("The list could not be compared with the people on this site."), roster.error(), [this] { load(); });
        });
}

void RosterDialog::showRoster(const database::Roster& roster) {
    m_people = static_cast<int>(roster.rows.size());
    auto* whole = new QWidget;
    auto* parts = new QVBoxLayout(whole);
    parts->setContentsMargins(0, 0, 0, 0);
    parts->setSpacing(theme().px(12));
    if (!roster.problems.empty())
        parts->addWidget(problemList(roster));
    else
        parts->addWidget(kit::notice(theme(), "good", tr("%n people would be added. Each must choose a password of their own at the first login.", nullptr, m_people)));
    if (!roster.rows.empty())
        parts->addWidget(peopleTable(roster), 1);
    parts->addStretch();
    m_panel->setContent(whole);
    m_panel->showContent();
    setAcceptable(roster.problems.empty());
    if (roster.problems.empty())
        setAccept(tr("Import %n people", nullptr, m_people));
}

QWidget* RosterDialog::problemList(const database::Roster& roster) const {
    QStringList lines{tr("Nothing can be imported yet: correct these lines in the file, then choose it again.")};
    for (std::size_t i = 0; i < std::min(roster.problems.size(), kMostProblems_shown); ++i)
        lines << rosterProblemWords(roster.problems[i]);
    if (roster.problems.size() > kMostProblems_shown)
        lines << tr("and %n more", nullptr, static_cast<int>(roster.problems.size() - kMostProblems_shown));
    QFrame* notice = kit::notice(theme(), "bad", lines.join(QLatin1Char('\n')));
    notice->setObjectName(QStringLiteral("roster.problems"));
    return notice;
}

QWidget* RosterDialog::peopleTable(const database::Roster& roster) const {
    auto* table = new QTableWidget(m_people, 4);
    table->setObjectName(QStringLiteral("roster.people"));
    table->setAccessibleName(tr("People in the list"));
    table->setHorizontalHeaderLabels({tr("Line"), tr("Login name"), tr("Full name"), tr("Roles")});
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setTabKeyNavigation(false);
    table->verticalHeader()->hide();
    table->setMinimumHeight(theme().px(kTableHeight));
    int row = 0;
    for (const database::UserCsvRow& person : roster.rows) {
        table->setItem(row, 0, new QTableWidgetItem(QLocale().toString(person.line)));
        table->setItem(row, 1, new QTableWidgetItem(QString::fromStdString(person.name)));
        table->setItem(row, 2, new QTableWidgetItem(QString::fromStdString(person.displayName)));
        table->setItem(row, 3, new QTableWidgetItem(rolesInWords(person.roles).join(QStringLiteral(", "))));
        ++row;
    }
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    return table;
}

void RosterDialog::submit() {
    setWorking(true, true);
    database::Database* database = &context().site().database();
    auto token = context().background().run(
        this,
        [database, actor = context().actor(), text = m_text](WorkToken& work) {
            return database::AccountService(*database).importCsv(actor, text, [&work](int done, int of) {
                work.setProgress(done, of);
                return !work.cancelled();
            });
        },
        [this](core::Result<std::vector<database::PersonId>> ids) {
            setWorking(false);
            if (!ids) {
                m_panel->showContent();
                say(ids.error().code == core::ErrorCode::cancelled ? "info" : "bad", tr("Nobody was added.\n%1").arg(inWords(ids.error())));
                return;
            }
            emit changed();
            context().messages().done(tr("%n people were added.", nullptr, static_cast<int>(ids->size())));
            accept();
        });
    m_panel->showLoading(tr("Adding %n people …", nullptr, m_people), token);
}

} // namespace chiron::desktop
