// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/studies_screen.h"

#include "desktop/plots/fitted_table.h"
#include "desktop/studies/study_jobs.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QCheckBox>
#include <QHeaderView>

namespace chiron::desktop {

namespace {

enum Column {
    titleColumn,
    keyColumn,
    stateColumn,
    progressColumn,
    trialsColumn,
    shaColumn,
    sinceColumn,
    columns
};

const char* iconOf(database::StudyState state) {
    switch (state) {
    case database::StudyState::draft:
        return "document-edit";
    case database::StudyState::frozen:
        return "object-locked";
    case database::StudyState::closed:
        return "dialog-ok-apply";
    case database::StudyState::archived:
        return "archive-insert";
    }
    return "";
}

} // namespace

StudiesScreen::StudiesScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_wanted(place.parameters.value(QStringLiteral("study")).toLongLong()) {
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    auto* page = new ScrollPage(context.theme(), 0);
    all->addWidget(page);
    page->column()->addWidget(headRow());
    m_panel = new StatePanel(context.theme());
    m_panel->setMinimumHeight(context.theme().px(240));
    m_panel->setContent(tablePart());
    page->column()->addWidget(m_panel, 1);
    page->column()->addWidget(actionRow());
    showActions();
}

QString StudiesScreen::title() const {
    return tr("Studies");
}

QString StudiesScreen::help() const {
    return tr("All studies of this site. A draft is designed and tried out with simulated observers. Once it "
              "is frozen, its design can "
              "never be changed again: every export states its SHA-256, and participants are enrolled under "
              "random codes.\n\n\"New study\" "
              "starts from a template or from scratch; \"Import\" reads a study from a JSON file. Press "
              "Enter or double-click to open a "
              "study. \"Run\" takes a participant through it, \"Data\" shows the results.\n\n\"Close\" ends "
              "enrolment for good. "
              "\"Archive\" takes a study out of the list and can be undone.");
}

QWidget* StudiesScreen::headRow() {
    const Theme& theme = context().theme();
    auto* head = new QWidget;
    auto* row = new FlowLayout(theme.px(12), head);
    row->addWidget(kit::line(theme, title(), TextStyle::heading));
    m_count = kit::line(theme, {}, TextStyle::body, "muted");
    auto* create = kit::button(theme, tr("New study …"), "primary", QStringLiteral("list-add"));
    create->setObjectName(QStringLiteral("studies.new"));
    connect(create, &QPushButton::clicked, this, &StudiesScreen::askNew);
    auto* import = kit::button(theme, tr("Import …"), "", QStringLiteral("document-import"));
    import->setObjectName(QStringLiteral("studies.import"));
    connect(import, &QPushButton::clicked, this, &StudiesScreen::askFile);
    m_archived = new QCheckBox(tr("Show archived"));
    m_archived->setObjectName(QStringLiteral("studies.archived"));
    m_archived->setFont(theme.font(TextStyle::body));
    m_archived->setChecked(place().parameters.value(QStringLiteral("archived")).toBool());
    connect(m_archived, &QCheckBox::toggled, this, [this] { load(); });
    row->addWidget(create);
    row->addWidget(import);
    row->addWidget(m_archived);
    row->addWidget(m_count);
    return head;
}

QWidget* StudiesScreen::tablePart() {
    m_table = new FittedTable(context().theme(), columns);
    m_table->setObjectName(QStringLiteral("studies.table"));
    m_table->setAccessibleName(title());
    m_table->setHorizontalHeaderLabels(
        {tr("Study"), tr("Key"), tr("State"), tr("Participants"), tr("Trials"), tr("SHA-256"), tr("Since")});
    m_table->setMinimumHeight(context().theme().px(220));
    connect(m_table, &QTableWidget::itemSelectionChanged, this, &StudiesScreen::showActions);
    connect(m_table, &QTableWidget::activated, this, [this] { open(QStringLiteral("study")); });
    return m_table;
}

QWidget* StudiesScreen::actionRow() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    const auto add = [&](const char* name, const QString& text, const char* kind, const char* icon) {
        auto* button = kit::button(theme, text, kind, QLatin1String(icon));
        button->setObjectName(QLatin1String(name));
        row->addWidget(button);
        return button;
    };
    m_open = add("studies.open", tr("Open"), "primary", "document-open");
    m_run = add("studies.run", tr("Run"), "", "media-playback-start");
    m_data = add("studies.data", tr("Data"), "", "office-chart-line");
    m_copy = add("studies.copy", tr("Copy to new study …"), "", "edit-copy");
    m_close = add("studies.close", tr("Close …"), "", "dialog-ok-apply");
    m_archive = add("studies.archive", tr("Archive"), "", "archive-insert");
    connect(m_open, &QPushButton::clicked, this, [this] { open(QStringLiteral("study")); });
    connect(m_run, &QPushButton::clicked, this, [this] { open(QStringLiteral("study_run")); });
    connect(m_data, &QPushButton::clicked, this, [this] { open(QStringLiteral("study_data")); });
    connect(m_copy, &QPushButton::clicked, this, &StudiesScreen::askCopy);
    connect(m_close, &QPushButton::clicked, this, &StudiesScreen::close);
    connect(m_archive, &QPushButton::clicked, this, [this] {
        if (const database::StudySummary* study = selected())
            archive(*study, study->state != database::StudyState::archived, true);
    });
    return bar;
}

void StudiesScreen::enter() {
    load();
}

void StudiesScreen::load() {
    context().navigator().note({{QStringLiteral("archived"), m_archived->isChecked()}});
    m_panel->showLoading(tr("Reading the studies …"),
                         readStudies(
                             context(), this,
                             [archived = m_archived->isChecked()](database::StudyReader& reader) {
                                 return reader.listStudies(archived);
                             },
                             [this](core::Result<std::vector<database::StudySummary>> studies) {
                                 loaded(std::move(studies));
                             }));
}

void StudiesScreen::loaded(core::Result<std::vector<database::StudySummary>> studies) {
    m_studies.clear();
    if (!studies) {
        m_panel->showError(tr("The studies could not be read"), studies.error(), [this] { load(); });
        showActions();
        return;
    }
    m_studies.assign(studies->rbegin(), studies->rend()); // newest first
    m_count->setText(tr("%n stud(y/ies)", nullptr, static_cast<int>(m_studies.size())));
    if (m_studies.empty()) {
        m_count->clear();
        m_panel->showEmpty(
            tr("No studies yet"),
            tr("Start from a template and change it: a ranking of three, a staircase or constant "
               "stimuli."),
            tr("New study …"), [this] { askNew(); });
        showActions();
        return;
    }
    fill();
    m_panel->showContent();
}

void StudiesScreen::fill() {
    const Theme& theme = context().theme();
    const QLocale locale = context().locale();
    m_table->setRowCount(static_cast<int>(m_studies.size()));
    int chosen = 0;
    for (int row = 0; row < m_table->rowCount(); ++row) {
        const database::StudySummary& study = m_studies[static_cast<std::size_t>(row)];
        const auto put = [&](int column, const QString& text) {
            auto* item = new QTableWidgetItem(text);
            m_table->setItem(row, column, item);
            return item;
        };
        put(titleColumn, QString::fromStdString(study.title));
        // The key is shown because titles may be alike.
        put(keyColumn, QString::fromStdString(study.key))->setFont(theme.font(TextStyle::mono));
        put(stateColumn, study_words::state(study.state))
            ->setIcon(theme.icon(QLatin1String(iconOf(study.state))));
        put(progressColumn, study.participants == 0 ? tr("none")
                                                    : tr("%1 of %2 done")
                                                          .arg(locale.toString(study.completed),
                                                               locale.toString(study.participants)));
        put(trialsColumn, locale.toString(study.trials))->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
        put(shaColumn, study_words::shortSha(study.sha256))->setFont(theme.font(TextStyle::mono));
        put(sinceColumn,
            study_words::moment(study.frozenUtc.empty() ? study.createdUtc : study.frozenUtc, locale));
        if (study.id == m_wanted)
            chosen = row;
    }
    m_table->selectRow(chosen);
    showActions();
}

const database::StudySummary* StudiesScreen::selected() const {
    const int row = m_table->currentRow();
    return row >= 0 && row < static_cast<int>(m_studies.size()) ? &m_studies[static_cast<std::size_t>(row)]
                                                                : nullptr;
}

void StudiesScreen::showActions() {
    const database::StudySummary* study = selected();
    if (study)
        m_wanted = study->id;
    using database::StudyState;
    const bool archived = study && study->state == StudyState::archived;
    const QString none = study ? QString() : tr("Choose a study in the list first.");
    const QString draft = study && study->state == StudyState::draft
                              ? tr("The design is still a draft: freeze it first.")
                              : none;
    kit::allowUnless(*m_open, none);
    kit::allowUnless(*m_copy, none);
    kit::allowUnless(*m_run, archived ? tr("The study is archived: bring it back first.") : draft);
    kit::allowUnless(*m_data, draft);
    const bool over = draft.isEmpty() && study->state != StudyState::frozen;
    kit::allowUnless(*m_close, over ? (archived ? tr("The study is archived: bring it back first.")
                                                : tr("The study is closed already."))
                                    : draft);
    kit::allowUnless(*m_archive, none);
    m_archive->setText(archived ? tr("Bring back") : tr("Archive"));
}

void StudiesScreen::open(const QString& screen) {
    if (const database::StudySummary* study = selected())
        context().navigator().go(screen, {{QStringLiteral("study"), qlonglong(study->id)}});
}

std::vector<ScreenCommand> StudiesScreen::commands() {
    return {{tr("New study …"), QKeySequence(QKeySequence::New), [this] { askNew(); }},
            {tr("Import …"), QKeySequence(QKeySequence::Open), [this] { askFile(); }},
            {tr("Open the study"), QKeySequence(Qt::Key_Return), [this] { open(QStringLiteral("study")); },
             false}};
}

} // namespace chiron::desktop
