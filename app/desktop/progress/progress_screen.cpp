// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/progress/progress_screen.h"

#include "database/repositories/account_repository.h"
#include "database/repositories/session_reader.h"
#include "desktop/frame/app_context.h"
#include "desktop/progress/progress_table.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QComboBox>
#include <QLineEdit>
#include <algorithm>

namespace chiron::desktop {

namespace {

const QString kChosenPerson = QStringLiteral("person");
const QString kChosenExercise = QStringLiteral("exercise");

/// Reads the standings of the group. An actor who may not list people gets nothing (AccountRepository).
/// Thread: worker; blocks.
core::Result<std::vector<session::PersonStanding>> readGroup(const database::Database& database,
                                                             const database::Actor& actor,
                                                             const catalogue::Catalogue& catalogue) {
    auto reader = database.openReader();
    CHIRON_TRY(reader);
    const auto people = database::AccountRepository(**reader, actor).listPeople();
    CHIRON_TRY(people);
    const auto sessions = database::SessionReader(**reader, actor).listSessions();
    CHIRON_TRY(sessions);
    return session::groupStandings(catalogue, *people, *sessions);
}

} // namespace

ProgressScreen::ProgressScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_filter(ProgressFilter::fromMap(place.parameters)),
      m_wanted(place.parameters.value(kChosenPerson).toLongLong()),
      m_wantedExercise(place.parameters.value(kChosenExercise).toString().toStdString()) {
    const Theme& theme = context.theme();
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    auto* page = new ScrollPage(theme, 0);
    all->addWidget(page);
    QVBoxLayout* column = page->column();
    column->setSpacing(theme.px(10));
    column->addWidget(buildHead());
    column->addWidget(buildFilters());
    m_table = new ProgressTable(theme, context.locale(), context.site().catalogue(),
                                exerciseTitles(context.site().catalogue(), context.language()));
    m_panel = new StatePanel(theme);
    m_panel->setContent(m_table);
    column->addWidget(m_panel, 1);
    m_chosen = kit::label(theme, {}, TextStyle::small, "muted");
    m_chosen->setObjectName(QStringLiteral("progress.chosen"));
    column->addWidget(m_chosen);
    column->addWidget(buildActions());
    connect(m_table, &QTableWidget::currentCellChanged, this, [this] {
        showActions();
        noteState();
    });
    connect(m_table, &ProgressTable::openAsked, this, &ProgressScreen::openSessions);
    showActions();
}

QString ProgressScreen::title() const {
    return tr("Progress");
}

QString ProgressScreen::help() const {
    return tr("How far each person of the group is.\n\nA row is a person. Under each "
              "exercise you see the lowest level that the person has not passed, or \"All "
              "passed\"; a cross marks a level that they have tried. \"Last session\" says "
              "when they trained last, and \"To review\" how many of their sessions await "
              "your review. The line below the table says more about the chosen cell: the "
              "standing at every level of an exercise, or, at the name, the step that the "
              "program offers next. Trainees whose accounts are disabled are left "
              "out.\n\nThe program keeps no lists of groups: type several names with commas "
              "between them to see only these people. The list beside it shows only those "
              "who have not trained for some time, or who have not passed "
              "everything.\n\nChoose a cell with the arrow keys and press Enter to see the "
              "sessions of that person at that exercise.");
}

QWidget* ProgressScreen::buildHead() {
    auto* head = new QWidget;
    auto* row = new FlowLayout(context().theme().px(20), head);
    row->addWidget(kit::line(context().theme(), title(), TextStyle::heading));
    m_count = kit::line(context().theme(), {}, TextStyle::body, "muted");
    m_count->setObjectName(QStringLiteral("progress.count"));
    row->addWidget(m_count);
    return head;
}

QWidget* ProgressScreen::buildFilters() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    m_names = new QLineEdit(m_filter.names);
    m_names->setObjectName(QStringLiteral("progress.names"));
    m_names->setAccessibleName(tr("Names, with commas between them"));
    m_names->setPlaceholderText(tr("Names: Ada, Nikos, …"));
    m_names->setToolTip(m_names->accessibleName());
    m_names->setClearButtonEnabled(true);
    m_names->setMinimumWidth(theme.px(300));
    row->addWidget(m_names);
    m_part = new QComboBox;
    m_part->setObjectName(QStringLiteral("progress.part"));
    m_part->setAccessibleName(tr("Which people"));
    m_part->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_part->addItem(tr("Everybody"));
    m_part->addItem(tr("With sessions to review"));
    m_part->addItem(tr("No session in the last %n day(s)", nullptr, ProgressFilter::kLately_days));
    m_part->addItem(tr("Not every level passed"));
    m_part->setCurrentIndex(static_cast<int>(m_filter.part));
    row->addWidget(m_part);
    m_clear = kit::button(theme, tr("Clear the filters"), "quiet");
    m_clear->setObjectName(QStringLiteral("progress.clear"));
    row->addWidget(m_clear);
    connect(m_names, &QLineEdit::textChanged, this, &ProgressScreen::readFilter);
    connect(m_names, &QLineEdit::returnPressed, this, [this] { m_table->setFocus(Qt::TabFocusReason); });
    connect(m_part, &QComboBox::currentIndexChanged, this, &ProgressScreen::readFilter);
    connect(m_clear, &QPushButton::clicked, this, &ProgressScreen::clearFilter);
    return bar;
}

QWidget* ProgressScreen::buildActions() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    m_open = kit::button(theme, tr("Open the sessions"), "primary", QStringLiteral("view-list-details"));
    m_open->setObjectName(QStringLiteral("progress.open"));
    m_results = kit::button(theme, tr("Results of this person"), "", QStringLiteral("office-chart-line"));
    m_results->setObjectName(QStringLiteral("progress.results"));
    row->addWidget(m_open);
    row->addWidget(m_results);
    connect(m_open, &QPushButton::clicked, this, &ProgressScreen::openSessions);
    connect(m_results, &QPushButton::clicked, this, &ProgressScreen::openResults);
    return bar;
}

std::vector<ScreenCommand> ProgressScreen::commands() {
    return {{tr("Filter by name"), QKeySequence(QKeySequence::Find),
             [this] { m_names->setFocus(Qt::ShortcutFocusReason); }},
            {m_open->text(), QKeySequence(Qt::Key_Return), [this] { openSessions(); }, false},
            {m_results->text(), {}, [this] { openResults(); }}};
}

void ProgressScreen::enter() {
    load();
}

void ProgressScreen::load() {
    m_panel->showLoading(tr("Reading how far everybody is …"));
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(),
         catalogue = context().site().catalogue()](WorkToken&) {
            return readGroup(database, actor, catalogue);
        },
        [this](core::Result<std::vector<session::PersonStanding>> people) { take(std::move(people)); });
}

void ProgressScreen::take(core::Result<std::vector<session::PersonStanding>> people) {
    if (!people) {
        m_panel->showError(tr("The progress of the group could not be read."), people.error(),
                           [this] { load(); });
        return;
    }
    m_table->show({});
    m_people = std::move(*people);
    std::sort(m_people.begin(), m_people.end(), [](const auto& a, const auto& b) {
        return QString::fromStdString(a.name).localeAwareCompare(QString::fromStdString(b.name)) < 0;
    });
    showPeople();
    m_table->choose(m_wanted, m_wantedExercise);
    if (m_panel->state() == StatePanel::State::content)
        m_table->setFocus(Qt::OtherFocusReason);
}

void ProgressScreen::readFilter() {
    if (m_showing)
        return;
    m_filter = {m_names->text().trimmed(), static_cast<GroupPart>(std::max(0, m_part->currentIndex()))};
    showPeople();
    noteState();
}

void ProgressScreen::clearFilter() {
    m_showing = true;
    m_names->clear();
    m_part->setCurrentIndex(0);
    m_showing = false;
    readFilter();
    m_names->setFocus();
}

void ProgressScreen::showPeople() {
    std::vector<const session::PersonStanding*> shown;
    for (const session::PersonStanding& person : m_people)
        if (m_filter.matches(person, QDateTime::currentDateTimeUtc()))
            shown.push_back(&person);
    const int all = static_cast<int>(m_people.size());
    m_count->setText(m_filter.isEmpty()
                         ? tr("%n person(s)", nullptr, all)
                         : tr("%1 of %2 people")
                               .arg(context().locale().toString(static_cast<int>(shown.size())),
                                    context().locale().toString(all)));
    m_clear->setEnabled(!m_filter.isEmpty());
    m_table->show(std::move(shown));
    if (m_table->rowCount() > 0)
        m_panel->showContent();
    else if (all == 0)
        m_panel->showEmpty(tr("There are no trainees yet"),
                           tr("As soon as an administrator has added trainees under People, they are listed "
                              "here, even before they have trained."));
    else
        m_panel->showEmpty(tr("Nobody matches these filters"), tr("%n person(s) in all.", nullptr, all),
                           tr("Clear the filters"), [this] { clearFilter(); });
    showActions();
}

void ProgressScreen::showActions() {
    const bool any = m_panel->state() == StatePanel::State::content && m_table->chosen();
    const bool trained = any && m_table->chosen()->latest;
    const QString none =
        any && !trained ? tr("%1 has no sessions yet.").arg(QString::fromStdString(m_table->chosen()->name))
                        : QString();
    for (QPushButton* button : {m_open, m_results}) {
        button->setEnabled(trained);
        button->setToolTip(none);
    }
    m_chosen->setText(any ? m_table->chosenInWords() : QString());
}

void ProgressScreen::noteState() {
    if (context().navigator().current().screen != place().screen)
        return; // another screen has already been requested
    QVariantMap map = m_filter.toMap();
    if (const session::PersonStanding* person = m_table->chosen())
        map.insert(kChosenPerson, static_cast<qint64>(person->person));
    if (const std::string exercise = m_table->chosenExercise(); !exercise.empty())
        map.insert(kChosenExercise, QString::fromStdString(exercise));
    context().navigator().note(map);
}

void ProgressScreen::openSessions() {
    const session::PersonStanding* person = m_table->chosen();
    if (!person)
        return;
    if (!person->latest) {
        context().messages().information(
            tr("%1 has no sessions yet.").arg(QString::fromStdString(person->name)));
        return;
    }
    QVariantMap filter{{kChosenPerson, static_cast<qint64>(person->person)}};
    if (const std::string exercise = m_table->chosenExercise(); !exercise.empty())
        filter.insert(kChosenExercise, QString::fromStdString(exercise));
    noteState();
    context().navigator().go(QStringLiteral("sessions"), filter);
}

void ProgressScreen::openResults() {
    const session::PersonStanding* person = m_table->chosen();
    if (!person || !person->latest)
        return;
    QVariantMap of{{QStringLiteral("person"), static_cast<qint64>(person->person)},
                   {QStringLiteral("name"), QString::fromStdString(person->name)}};
    const std::string exercise = m_table->chosenExercise();
    for (const session::ExerciseStanding& standing : person->exercises)
        if (standing.exercise == exercise) {
            of.insert(QStringLiteral("exercise"), QString::fromStdString(exercise));
            if (standing.open)
                of.insert(QStringLiteral("level"), standing.open->level);
        }
    noteState();
    context().navigator().go(QStringLiteral("results"), of);
}

} // namespace chiron::desktop
