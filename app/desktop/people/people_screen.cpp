// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/people/people_screen.h"

#include "database/accounts/account_service.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/palette_search.h"
#include "desktop/people/people_model.h"
#include "desktop/people/role_chips.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QDateTime>
#include <QHeaderView>
#include <QLineEdit>
#include <QSortFilterProxyModel>
#include <QTableView>

// The list of people. The actions are in people_actions.cpp.
namespace chiron::desktop {

namespace {
constexpr double kListHeight = 320;
constexpr int kMeasuredRows = 100; // measuring a list of thousands would take too long

/// Gives a button a tool tip and an accessible description, because two buttons begin with the same word.
void tellApart(QPushButton& button, const QString& words) {
    button.setToolTip(words);
    button.setAccessibleDescription(words);
}

} // namespace

PeopleScreen::PeopleScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_chosen(place.parameters.value(QStringLiteral("person")).toLongLong()) {
    auto* page = new ScrollPage(context.theme(), 1100);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(page);
    page->column()->addWidget(headRow());
    page->column()->addWidget(listPart(), 1);
    page->column()->addWidget(actionPart());
    renewActions();
}

QString PeopleScreen::title() const {
    return tr("People");
}

QString PeopleScreen::help() const {
    return tr("Everybody who has an account on this site.\n\nChoose a person in the list, "
              "then an action below it. Changing roles and disabling take effect at once and "
              "can be undone. A person who gets a new password has to change it at the next "
              "login.\n\n\"Edit\" changes a person's name or login name; the earlier ones "
              "stay in the history.\n\n\"Import roster\" reads a CSV file as a spreadsheet "
              "saves it, with headings such as login name, full name and role (\"Save a "
              "template\" makes one), and first shows what will happen: either everything in "
              "the file is done, or nothing. Passwords are made for new people and can be "
              "printed as slips.\n\n\"Export all data\" writes all data about a person to "
              "one file. \"Erase\" permanently removes a person's identity. \"Erase a "
              "participant\" does the same for somebody who has withdrawn from a study, even "
              "if they have no account.");
}

QWidget* PeopleScreen::headRow() {
    const Theme& theme = context().theme();
    auto* head = new QWidget;
    auto* column = new QVBoxLayout(head);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(12));
    column->addWidget(kit::label(theme, title(), TextStyle::heading));
    auto* buttons = new QWidget;
    auto* row = new FlowLayout(theme.px(8), buttons);
    auto* add = kit::button(theme, tr("Add a person"), "primary", QStringLiteral("list-add-user"));
    add->setObjectName(QStringLiteral("people.add"));
    connect(add, &QPushButton::clicked, this, &PeopleScreen::addPerson);
    auto* roster = kit::button(theme, tr("Import roster …"), "", QStringLiteral("document-import"));
    roster->setObjectName(QStringLiteral("people.import"));
    connect(roster, &QPushButton::clicked, this, &PeopleScreen::askRoster);
    row->addWidget(add);
    auto* empty = kit::button(theme, tr("Save a template …"), "", QStringLiteral("document-save"));
    empty->setObjectName(QStringLiteral("people.template"));
    connect(empty, &QPushButton::clicked, this, &PeopleScreen::askTemplate);
    row->addWidget(roster);
    row->addWidget(empty);
    auto* participant = kit::button(theme, tr("Erase a participant …"), "", QStringLiteral("edit-delete"));
    participant->setObjectName(QStringLiteral("people.erase_participant"));
    connect(participant, &QPushButton::clicked, this, &PeopleScreen::eraseParticipant);
    tellApart(*participant, tr("Permanently removes the identity of somebody who took part in a study, even "
                               "if they have no account here."));
    row->addWidget(participant);
    column->addWidget(buttons);
    m_search = new QLineEdit;
    m_search->setObjectName(QStringLiteral("people.search"));
    m_search->setAccessibleName(tr("Find a person"));
    m_search->setPlaceholderText(tr("Find a person"));
    m_search->setClearButtonEnabled(true);
    m_search->setMaximumWidth(theme.px(360));
    column->addWidget(m_search);
    return head;
}

QWidget* PeopleScreen::listPart() {
    const Theme& theme = context().theme();
    m_model = new PeopleModel(theme, this);
    m_found = new QSortFilterProxyModel(this);
    m_found->setSourceModel(m_model);
    m_found->setFilterKeyColumn(0);
    m_found->setFilterRole(PeopleModel::kSearch);
    m_found->setSortCaseSensitivity(Qt::CaseInsensitive);
    m_table = new QTableView;
    m_table->setObjectName(QStringLiteral("people.table"));
    m_table->setAccessibleName(tr("People"));
    m_table->setModel(m_found);
    m_table->setItemDelegateForColumn(PeopleModel::roles, new RoleChips(theme, m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setTabKeyNavigation(false);
    m_table->setSortingEnabled(true);
    m_table->sortByColumn(PeopleModel::name, Qt::AscendingOrder);
    m_table->setIconSize(QSize(theme.px(18), theme.px(18)));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(theme.px(36));
    m_table->horizontalHeader()->setResizeContentsPrecision(kMeasuredRows);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setHighlightSections(false);
    m_panel = new StatePanel(theme);
    m_panel->setObjectName(QStringLiteral("people.panel"));
    m_panel->setMinimumHeight(theme.px(kListHeight));
    m_panel->setContent(m_table);
    m_panel->showLoading(tr("Reading the list of people …"));
    connect(m_search, &QLineEdit::textChanged, this, &PeopleScreen::find);
    connect(m_search, &QLineEdit::returnPressed, m_table, qOverload<>(&QWidget::setFocus));
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& row) {
                m_chosen = row.isValid() ? row.data(PeopleModel::kPersonId).toLongLong() : 0;
                renewActions();
            });
    return m_panel;
}

QWidget* PeopleScreen::actionPart() {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme);
    m_chosenName = kit::label(theme, {}, TextStyle::title);
    m_chosenName->setObjectName(QStringLiteral("people.chosen"));
    m_chosenWords = kit::label(theme, {}, TextStyle::body, "muted");
    box.layout->addWidget(m_chosenName);
    box.layout->addWidget(m_chosenWords);
    m_earlier = kit::label(theme, {}, TextStyle::small, "muted");
    m_earlier->setObjectName(QStringLiteral("people.earlier"));
    m_earlier->hide();
    box.layout->addWidget(m_earlier);
    auto* buttons = new QWidget;
    auto* row = new FlowLayout(theme.px(8), buttons);
    const auto add = [&](const QString& text, const QString& icon, const char* name,
                         void (PeopleScreen::*act)(), const char* kind = "") {
        auto* button = kit::button(theme, text, kind, icon);
        button->setObjectName(QLatin1String(name));
        connect(button, &QPushButton::clicked, this, act);
        row->addWidget(button);
        return button;
    };
    m_edit = add(tr("Edit"), QStringLiteral("document-edit"), "people.edit", &PeopleScreen::editPerson);
    m_roles =
        add(tr("Change roles"), QStringLiteral("user-properties"), "people.roles", &PeopleScreen::editRoles);
    m_reset = add(tr("Reset password"), QStringLiteral("dialog-password"), "people.reset",
                  &PeopleScreen::resetPassword);
    m_enable =
        add(tr("Disable"), QStringLiteral("dialog-cancel"), "people.enable", &PeopleScreen::toggleEnabled);
    m_export = add(tr("Export all data"), QStringLiteral("document-export"), "people.export",
                   &PeopleScreen::askExport);
    m_erase = add(tr("Erase"), QStringLiteral("edit-delete"), "people.erase", &PeopleScreen::erase, "danger");
    tellApart(*m_erase, tr("Permanently removes the identity of the person who is chosen in the list."));
    box.layout->addWidget(buttons);
    return box.frame;
}

void PeopleScreen::enter() {
    m_search->setFocus();
    load();
}

void PeopleScreen::load() {
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor()](WorkToken&) {
            return database::AccountService(*database).listPeople(actor);
        },
        [this](core::Result<std::vector<database::Person>> people) { loaded(std::move(people)); });
}

void PeopleScreen::loaded(core::Result<std::vector<database::Person>> people) {
    if (!people) {
        m_panel->showError(tr("The list of people could not be read."), people.error(), [this] {
            m_panel->showLoading(tr("Reading the list of people …"));
            load();
        });
        return;
    }
    const database::PersonId before = m_chosen;
    m_model->setPeople(std::move(*people));
    m_panel->showContent();
    find(m_search->text());
    fitColumns();
    choose(before);
}

void PeopleScreen::find(const QString& text) {
    m_found->setFilterFixedString(forSearch(text.trimmed()));
    if (m_panel->state() == StatePanel::State::loading || m_panel->state() == StatePanel::State::error)
        return;
    if (m_found->rowCount() > 0 || m_model->rowCount() == 0)
        m_panel->showContent();
    else
        m_panel->showEmpty(tr("Nobody was found"),
                           tr("No name and no role matches \"%1\".").arg(text.trimmed()),
                           tr("Show everybody"), [this] {
                               m_search->clear();
                               m_search->setFocus();
                           });
}

void PeopleScreen::fitColumns() {
    // The last column stretches if there is room; otherwise the table scrolls instead of cutting it off.
    QHeaderView* header = m_table->horizontalHeader();
    header->setStretchLastSection(false);
    header->setStretchLastSection(header->length() < m_table->viewport()->width());
}

void PeopleScreen::resizeEvent(QResizeEvent* event) {
    Screen::resizeEvent(event);
    fitColumns();
}

void PeopleScreen::choose(database::PersonId person) {
    m_chosen = 0;
    for (int row = 0; row < m_found->rowCount(); ++row)
        if (m_found->index(row, 0).data(PeopleModel::kPersonId).toLongLong() == person)
            m_table->selectRow(row);
    renewActions();
}

const database::Person* PeopleScreen::chosen() const {
    return m_model->find(m_chosen);
}

void PeopleScreen::showEarlierNames() {
    m_earlier->hide();
    if (!chosen())
        return;
    database::Database* database = &context().site().database();
    context().background().run(
        this,
        [database, actor = context().actor(), id = m_chosen](WorkToken&) {
            return database::AccountService(*database).earlierNames(actor, id);
        },
        [this, id = m_chosen](const core::Result<std::vector<database::EarlierName>>& names) {
            if (id != m_chosen || !names || names->empty())
                return; // somebody else has been chosen, or there are no earlier names to show
            QStringList lines;
            for (const database::EarlierName& before : *names) {
                const QString name = QString::fromStdString(before.name);
                const QString full = QString::fromStdString(before.displayName);
                const QDateTime until =
                    QDateTime::fromString(QString::fromStdString(before.untilUtc), Qt::ISODateWithMs)
                        .toLocalTime();
                lines << tr("Until %1: %2")
                             .arg(context().locale().toString(until, QLocale::ShortFormat),
                                  full.isEmpty() ? name : tr("%1 (%2)").arg(full, name));
            }
            m_earlier->setText(lines.join(QLatin1Char('\n')));
            m_earlier->show();
        });
}

void PeopleScreen::renewActions() {
    const database::Person* person = chosen();
    showEarlierNames();
    for (QPushButton* button : {m_edit, m_roles, m_reset, m_enable, m_export, m_erase})
        button->setEnabled(person != nullptr);
    if (!person) {
        m_chosenName->setText(tr("Nobody is chosen"));
        m_chosenWords->setText(tr("Choose a person in the list to change or export something."));
        return;
    }
    const QString name = QString::fromStdString(person->name);
    const QString full = QString::fromStdString(person->displayName);
    m_chosenName->setText(full.isEmpty() ? name : tr("%1 (%2)").arg(full, name));
    m_chosenWords->setText(
        tr("Code %1: what researchers see in place of the name.").arg(QString::fromStdString(person->code)));
    m_enable->setText(person->enabled ? tr("Disable") : tr("Enable"));
    m_enable->setIcon(context().theme().icon(person->enabled ? QStringLiteral("dialog-cancel")
                                                             : QStringLiteral("dialog-ok-apply")));
}

} // namespace chiron::desktop
