// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/roster_dialog.h"

#include "database/accounts/account_service.h"
#include "desktop/frame/app_context.h"
#include "desktop/people/people_model.h"
#include "desktop/people/roster_preview.h"
#include "desktop/people/slips_panel.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/state_panel.h"

#include <QComboBox>
#include <QRadioButton>
#include <algorithm>
#include <array>

namespace chiron::desktop {

namespace {

using Kind = database::RosterStep::Kind;

constexpr std::size_t kMostProblems_shown = 50;
constexpr std::size_t kMostWords = 8; // more unknown roles mean that the column is wrong
constexpr double kPanelHeight = 260;

} // namespace

RosterDialog::RosterDialog(AppContext& context, const QString& fileName, std::string bytes, QWidget* parent)
    : FormDialog(context, QStringLiteral("roster"), tr("Import people"), parent), m_bytes(std::move(bytes)) {
    column()->addWidget(kit::label(theme(),
                                   tr("From %1. Nothing is changed before you press Import.").arg(fileName),
                                   TextStyle::body, "muted"));
    m_read = kit::label(theme(), {}, TextStyle::small, "muted");
    m_read->setObjectName(QStringLiteral("roster.read"));
    m_read->hide();
    column()->addWidget(m_read);
    m_existing = existingChoice();
    column()->addWidget(m_existing);
    m_panel = new StatePanel(theme());
    m_panel->setObjectName(QStringLiteral("roster.panel"));
    m_panel->setMinimumHeight(theme().px(kPanelHeight));
    column()->addWidget(m_panel);
    setAccept(tr("Import"));
    load();
}

/// Shown if anybody in the list already has an account.
QWidget* RosterDialog::existingChoice() {
    auto* choice = new QWidget;
    auto* rows = new QVBoxLayout(choice);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(theme().px(4));
    rows->addWidget(kit::label(theme(), tr("People who have an account already"), TextStyle::label));
    auto* skip = new QRadioButton(tr("Leave them as they are"));
    skip->setObjectName(QStringLiteral("roster.skip"));
    skip->setChecked(true);
    m_update = new QRadioButton(tr("Update full name and roles"));
    m_update->setObjectName(QStringLiteral("roster.update"));
    rows->addWidget(skip);
    rows->addWidget(m_update);
    connect(m_update, &QRadioButton::toggled, this, &RosterDialog::load);
    choice->hide();
    return choice;
}

database::RosterExisting RosterDialog::existing() const {
    return m_update->isChecked() ? database::RosterExisting::update : database::RosterExisting::skip;
}

void RosterDialog::load() {
    setAcceptable(false);
    m_panel->showLoading(tr("Reading the list …"));
    database::Database* database = &context().site().database();
    const int asked = ++m_asked;
    context().background().run(
        this,
        [database, actor = context().actor(), bytes = m_bytes, chosen = existing(),
         roles = m_roleWords](WorkToken&) {
            return database::AccountService(*database).previewCsv(actor, bytes, chosen, roles);
        },
        [this, asked](core::Result<database::RosterPlan> plan) {
            if (asked != m_asked)
                return; // a choice has changed in the meantime, so another result follows
            if (plan)
                showPlan(*plan);
            else
                m_panel->showError(tr("The list could not be compared with the people on this site."),
                                   plan.error(), [this] { load(); });
        });
}

/// Offers a role for each word of the list that is not a role, as long as the dialog is open.
void RosterDialog::askRoles(const database::Roster& roster) {
    if (m_roles || roster.unknownRoles.empty() || roster.unknownRoles.size() > kMostWords)
        return;
    m_roles = new QWidget;
    m_roles->setObjectName(QStringLiteral("roster.roles"));
    auto* rows = new QVBoxLayout(m_roles);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(theme().px(4));
    rows->addWidget(kit::label(theme(),
                               tr("The list has words that are not roles here. Choose what each of them "
                                  "stands for, or correct the file."),
                               TextStyle::label));
    for (const std::string& word : roster.unknownRoles)
        rows->addWidget(roleChoice(word));
    column()->insertWidget(column()->indexOf(m_panel), m_roles);
}

QWidget* RosterDialog::roleChoice(const std::string& word) {
    auto* line = new QWidget;
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(theme().px(8));
    const QString shown =
        word.empty() ? tr("No role is given") : tr("“%1”").arg(QString::fromStdString(word));
    row->addWidget(kit::label(theme(), shown), 1);
    auto* choice = new QComboBox;
    choice->setObjectName(QStringLiteral("roster.role.%1").arg(QString::fromStdString(word)));
    choice->setAccessibleName(tr("Role that %1 stands for").arg(shown));
    choice->addItem(tr("Choose a role …"));
    constexpr std::array kRoles{database::Role::trainee, database::Role::trainer, database::Role::researcher,
                                database::Role::admin};
    for (const database::Role role : kRoles)
        choice->addItem(rolesInWords({role}).join(QString()));
    row->addWidget(choice, 2);
    connect(choice, &QComboBox::currentIndexChanged, this, [this, word, kRoles](int index) {
        m_roleWords.erase(word);
        if (index > 0)
            m_roleWords.emplace(word, kRoles.at(static_cast<std::size_t>(index - 1)));
        load();
    });
    return line;
}

void RosterDialog::showPlan(const database::RosterPlan& plan) {
    const database::Roster& roster = plan.roster;
    askRoles(roster);
    m_changes = plan.count(Kind::add) + plan.count(Kind::update);
    m_read->setText(rosterReadWords(roster));
    m_read->setVisible(!m_read->text().isEmpty());
    m_existing->setVisible(static_cast<int>(plan.steps.size()) > plan.count(Kind::add) &&
                           roster.problems.empty());
    auto* whole = new QWidget;
    auto* parts = new QVBoxLayout(whole);
    parts->setContentsMargins(0, 0, 0, 0);
    parts->setSpacing(theme().px(12));
    if (!roster.problems.empty()) {
        parts->addWidget(problemList(roster));
    } else {
        QFrame* notice = kit::notice(theme(),
                                     rosterLeavesDoubts(plan) ? "warning"
                                     : m_changes > 0          ? "good"
                                                              : "info",
                                     rosterPlanWords(plan).join(QLatin1Char('\n')));
        notice->setObjectName(QStringLiteral("roster.summary"));
        parts->addWidget(notice);
    }
    if (!plan.steps.empty())
        parts->addWidget(rosterTable(theme(), plan), 1);
    parts->addStretch();
    delete m_panel->content(); // from the previous choice
    m_panel->setContent(whole);
    m_panel->showContent();
    setAccept(roster.problems.empty() && m_changes > 0 ? tr("Import %n people", nullptr, m_changes)
                                                       : tr("Import"));
    setAcceptable(roster.problems.empty() && m_changes > 0);
    leaveOnly(roster.problems.empty() && m_changes == 0);
}

QWidget* RosterDialog::problemList(const database::Roster& roster) const {
    QStringList lines;
    for (std::size_t i = 0; i < std::min(roster.problems.size(), kMostProblems_shown); ++i)
        lines << rosterProblemWords(roster.problems[i]);
    if (roster.problems.size() > kMostProblems_shown)
        lines << tr("and %n more", nullptr, static_cast<int>(roster.problems.size() - kMostProblems_shown));
    lines.prepend(
        roster.encoding.empty() ? tr("Nothing can be imported from this file.")
        : m_roles
            ? tr("Nothing can be imported yet: choose above what the words stand for, or correct these lines "
                 "in the file and choose it again.")
            : tr("Nothing can be imported yet: correct these lines in the file, then choose it again."));
    QFrame* notice = kit::notice(theme(), "bad", lines.join(QLatin1Char('\n')));
    notice->setObjectName(QStringLiteral("roster.problems"));
    return notice;
}

void RosterDialog::submit() {
    setWorking(true, true);
    m_existing->setEnabled(false);
    if (m_roles)
        m_roles->setEnabled(false);
    database::Database* database = &context().site().database();
    auto token = context().background().run(
        this,
        [database, actor = context().actor(), bytes = m_bytes, chosen = existing(),
         roles = m_roleWords](WorkToken& work) {
            return database::AccountService(*database).importCsv(
                actor, bytes, chosen,
                [&work](int done, int of) {
                    work.setProgress(done, of);
                    return !work.cancelled();
                },
                roles);
        },
        [this](core::Result<database::RosterOutcome> outcome) {
            setWorking(false);
            m_existing->setEnabled(true);
            if (m_roles)
                m_roles->setEnabled(true);
            if (outcome) {
                showDone(*std::move(outcome));
                return;
            }
            m_panel->showContent();
            // This is the only rule that a list without errors can violate.
            const bool last = outcome.error().code == core::ErrorCode::wrongUse;
            say(outcome.error().code == core::ErrorCode::cancelled ? "info" : "bad",
                last ? tr("Nothing was changed: the site needs at least one administrator who can log in, "
                          "and the list would leave none.")
                     : tr("Nothing was changed.\n%1").arg(inWords(outcome.error())));
        });
    m_panel->showLoading(tr("Importing %n people …", nullptr, m_changes), token);
}

void RosterDialog::showDone(database::RosterOutcome outcome) {
    emit changed();
    QStringList words;
    if (!outcome.added.empty())
        words << tr("%n people were added.", nullptr, static_cast<int>(outcome.added.size()));
    if (outcome.updated > 0)
        words << tr("%n people were updated.", nullptr, outcome.updated);
    std::erase_if(outcome.added,
                  [](const database::ImportedPerson& person) { return person.madePassword.empty(); });
    if (outcome.added.empty()) {
        context().messages().done(words.join(QLatin1Char(' ')));
        accept();
        return;
    }
    m_slips = new SlipsPanel(context(), words.join(QLatin1Char(' ')), std::move(outcome.added));
    connect(m_slips, &SlipsPanel::told, this, [this](QWidget* notice) {
        // Deferred until the notice has its size.
        QMetaObject::invokeMethod(
            this, [this, notice] { reveal(*notice); }, Qt::QueuedConnection);
    });
    showSecret(m_slips, m_slips->findChild<QPushButton*>(QStringLiteral("slips.print")));
}

void RosterDialog::reject() {
    if (m_slips && !m_slips->isTaken() && !m_warned) {
        m_warned = true;
        say("warning", tr("The slips have been neither printed nor saved. If you close this window again, "
                          "the passwords are gone; you can then only set "
                          "new ones, one by one."));
        return;
    }
    FormDialog::reject();
}

} // namespace chiron::desktop
