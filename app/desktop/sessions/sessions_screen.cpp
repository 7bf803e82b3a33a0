// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/sessions/sessions_screen.h"

#include "desktop/frame/app_context.h"
#include "desktop/sessions/plain_cell_delegate.h"
#include "desktop/sessions/session_filter_bar.h"
#include "desktop/sessions/session_table_model.h"
#include "desktop/widgets/flow_layout.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QHeaderView>
#include <QLineEdit>
#include <QTableView>
#include <algorithm>
#include <array>

namespace chiron::desktop {

namespace {

const QString kSelected = QStringLiteral("selected");

const QString kOwnFilter = QStringLiteral("sessions_filter");
const QString kChosenOn = QStringLiteral("chosen_on");

/// The person's last filter, if they chose it today. A filter that remains from an earlier day would be
/// confusing.
SessionListFilter ownFilter(AppContext& context) {
    const QVariantMap kept =
        context.settings().ofPerson(context.actor().personId(), kOwnFilter, QVariantMap()).toMap();
    return kept.value(kChosenOn).toString() == QDate::currentDate().toString(Qt::ISODate)
               ? SessionListFilter::fromMap(kept)
               : SessionListFilter();
}

void keepOwnFilter(AppContext& context, const SessionListFilter& filter) {
    QVariantMap kept = filter.toMap();
    kept.insert(kChosenOn, QDate::currentDate().toString(Qt::ISODate));
    context.settings().setOfPerson(context.actor().personId(), kOwnFilter, kept);
}

database::SessionFilter pageBefore(database::SessionId before, int limit) {
    database::SessionFilter filter;
    filter.includeArchived = true; // the list's own filter hides or shows them without a new query
    filter.newestFirst = true;
    filter.afterSession = before;
    filter.limit = limit;
    return filter;
}

/// Sets column widths from the longest possible texts, which avoids measuring thousands of rows.
void setWidths(QTableView& table, const Theme& theme, const QLocale& locale, const ExerciseTitles& titles) {
    const QFontMetrics metrics(theme.font(TextStyle::body));
    const auto widest = [&metrics](const QStringList& words) {
        int width = 0;
        for (const QString& word : words)
            width = std::max(width, metrics.horizontalAdvance(word));
        return width;
    };
    using enum database::SessionState;
    QStringList outcomes;
    for (const database::SessionState state : {running, stopped, interrupted, incomplete, faulted, voided})
        outcomes << SessionWords::state(state);
    for (const Outcome outcome : {Outcome::passed, Outcome::notPassed, Outcome::notScored, Outcome::practice})
        outcomes << SessionWords::outcome(outcome);
    const int sign = theme.px(26);
    std::array<int, SessionTableModel::columns> widths{};
    widths[SessionTableModel::number] = widest({QStringLiteral("00000")});
    QStringList starts; // every hour, because a clock of twelve hours has its longest at ten and at twelve
    for (int hour = 0; hour < 24; ++hour)
        starts << locale.toString(QDateTime(QDate(2026, 10, 20), QTime(hour, 44)), QLocale::ShortFormat);
    widths[SessionTableModel::started] = widest(starts);
    widths[SessionTableModel::person] = widest({QStringLiteral("Nikos Newcomer")});
    widths[SessionTableModel::exercise] = widest(titles.values());
    widths[SessionTableModel::attempt] = widest({QStringLiteral("000")});
    database::SessionSummary expert;
    expert.operatorName = "expert";
    widths[SessionTableModel::operatorName] = widest({SessionWords::moved({}), SessionWords::moved(expert)});
    widths[SessionTableModel::result] = widest(outcomes) + sign;
    database::SessionSummary reviewed;
    reviewed.reviewed = true;
    reviewed.gates = reviewed.gatesMet = 10;
    database::SessionSummary waiting;
    waiting.toReview = true;
    widths[SessionTableModel::score] = widest({SessionWords::gates(reviewed, locale)});
    widths[SessionTableModel::review] =
        widest({SessionWords::review(reviewed), SessionWords::review(waiting)});
    widths[SessionTableModel::device] = widest({SessionWords::device(true), SessionWords::device(false)});
    widths[SessionTableModel::length] =
        widest({SessionWords::length(3'599'000, locale), SessionTableModel::tr("sealed")});
    for (int column = 0; column < SessionTableModel::columns; ++column) {
        const int arrow = theme.px(24); // room for the sort indicator, which any column may get
        const int head = table.horizontalHeader()->sectionSizeHint(column) + arrow;
        table.setColumnWidth(column, std::max(widths[static_cast<std::size_t>(column)] + theme.px(12), head));
    }
}

/// The columns that a narrow window leaves out, first to last. A row's tool tip still shows them; the
/// operator stands below the person then.
constexpr std::array<int, 5> kMayGo{SessionTableModel::length, SessionTableModel::device,
                                    SessionTableModel::operatorName, SessionTableModel::attempt,
                                    SessionTableModel::number};

} // namespace

SessionsScreen::SessionsScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_titles(exerciseTitles(context.site().catalogue(), context.language())) {
    const Theme& theme = context.theme();
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    // The page scrolls, because a large scale leaves too little room for controls and rows together.
    auto* page = new ScrollPage(theme, 0);
    all->addWidget(page);
    QVBoxLayout* column = page->column();
    column->setSpacing(theme.px(10));
    column->addWidget(buildHead());
    m_filterBar = new SessionFilterBar(theme, context.site().catalogue(), context.language());
    m_wanted = place.parameters.value(kSelected).toLongLong();
    m_filterBar->setFilter(place.parameters.isEmpty() ? ownFilter(context)
                                                      : SessionListFilter::fromMap(place.parameters));
    column->addWidget(m_filterBar);
    m_panel = new StatePanel(theme);
    m_panel->setContent(buildTable());
    column->addWidget(m_panel, 1);
    column->addWidget(buildActions());
    connectTable();
    showActions();
}

QString SessionsScreen::title() const {
    return tr("Sessions");
}

QString SessionsScreen::help() const {
    return tr("All sessions recorded at this site, newest first.\n\nType in the search field or choose from "
              "the lists beside it to narrow the list. What you choose stays for the rest of the day. A link "
              "from another screen, such as \"List of sessions to review\", shows its own list and leaves "
              "your choice as it was. Click a column header to sort by it.\n\nPress Enter or double-click to "
              "open the debrief of the selected session, Ctrl+P to play it back. \"Results of this person\" "
              "shows how this person develops at that session's exercise and level. \"Void\" asks for a "
              "reason and takes a session out of every count; the recording is kept, and \"Count it again\" "
              "takes the decision back. \"Archive\" takes it out of the usual lists and can be undone.");
}

QWidget* SessionsScreen::buildHead() {
    auto* head = new QWidget;
    // This wraps the count below the title if the window is too narrow for both.
    auto* row = new FlowLayout(context().theme().px(20), head);
    row->addWidget(kit::line(context().theme(), title(), TextStyle::heading));
    m_count = kit::line(context().theme(), {}, TextStyle::body, "muted");
    m_count->setObjectName(QStringLiteral("sessions.count"));
    row->addWidget(m_count);
    return head;
}

QWidget* SessionsScreen::buildTable() {
    const Theme& theme = context().theme();
    m_model = new SessionTableModel(theme, context().locale(), this);
    m_model->setFilter(m_filterBar->filter());
    m_table = new QTableView;
    m_table->setObjectName(QStringLiteral("sessions.table"));
    m_table->setAccessibleName(tr("Sessions"));
    m_table->setFont(theme.font(TextStyle::body));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new PlainCellDelegate(theme, m_table));
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setSelectionMode(QAbstractItemView::SingleSelection);
    m_table->setShowGrid(false);
    m_table->setAlternatingRowColors(true);
    m_table->setWordWrap(false);
    m_table->setTabKeyNavigation(false);
    m_table->setIconSize(QSize(theme.px(18), theme.px(18)));
    m_table->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->setMinimumHeight(theme.px(190));
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed); // otherwise every row is measured
    m_table->verticalHeader()->setDefaultSectionSize(theme.px(36));      // room for two lines
    QHeaderView* head = m_table->horizontalHeader();
    head->setHighlightSections(false);
    head->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    head->setStretchLastSection(true);
    head->setSortIndicator(SessionTableModel::number, Qt::DescendingOrder);
    setWidths(*m_table, theme, context().locale(), m_titles);
    for (int column = 0; column < SessionTableModel::columns; ++column)
        m_widths[static_cast<std::size_t>(column)] = m_table->columnWidth(column);
    m_table->setSortingEnabled(true);
    m_table->viewport()->installEventFilter(this);
    return m_table;
}

bool SessionsScreen::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_table->viewport() && event->type() == QEvent::Resize)
        fitColumns();
    return Screen::eventFilter(watched, event);
}

void SessionsScreen::fitColumns() {
    int wanted_px = 0;
    for (int column = 0; column < SessionTableModel::columns; ++column) {
        m_table->setColumnHidden(column, false);
        wanted_px += m_widths[static_cast<std::size_t>(column)];
    }
    for (const int column : kMayGo) {
        if (wanted_px <= m_table->viewport()->width())
            break;
        m_table->setColumnHidden(column, true);
        wanted_px -= m_widths[static_cast<std::size_t>(column)];
    }
    // What is still too wide is taken from the names, which the tool tip has whole. A width that somebody
    // chose stays where there is room.
    const int name_px = m_widths[SessionTableModel::person];
    const int lack_px = std::max(0, wanted_px - m_table->viewport()->width());
    if (lack_px > 0 || m_table->columnWidth(SessionTableModel::person) < name_px)
        m_table->setColumnWidth(SessionTableModel::person, name_px - std::min(lack_px, name_px / 4));
    m_model->setOperatorWithPerson(m_table->isColumnHidden(SessionTableModel::operatorName));
}

QWidget* SessionsScreen::buildActions() {
    const Theme& theme = context().theme();
    auto* bar = new QWidget;
    auto* row = new FlowLayout(theme.px(8), bar);
    const auto add = [&](const QString& name, const QString& text, const char* kind, const QString& icon) {
        auto* button = kit::button(theme, text, kind, icon);
        button->setObjectName(QStringLiteral("sessions.") + name);
        row->addWidget(button);
        return button;
    };
    m_open = add(QStringLiteral("open"), tr("Open the debrief"), "primary",
                 QStringLiteral("document-open-folder"));
    m_play = add(QStringLiteral("play"), tr("Play back"), "", QStringLiteral("media-playback-start"));
    m_results =
        add(QStringLiteral("results"), tr("Results of this person"), "", QStringLiteral("office-chart-line"));
    m_void = add(QStringLiteral("void"), tr("Void …"), "", QStringLiteral("dialog-cancel"));
    m_reinstate = add(QStringLiteral("reinstate"), tr("Count it again …"), "", QStringLiteral("edit-undo"));
    m_archive = add(QStringLiteral("archive"), tr("Archive"), "", QStringLiteral("archive-insert"));
    m_save = add(QStringLiteral("export"), tr("Save the list …"), "quiet", QStringLiteral("document-save"));
    connect(m_open, &QPushButton::clicked, this, [this] { open(QStringLiteral("debrief")); });
    connect(m_play, &QPushButton::clicked, this, [this] { open(QStringLiteral("playback")); });
    connect(m_results, &QPushButton::clicked, this, &SessionsScreen::openResults);
    connect(m_void, &QPushButton::clicked, this, &SessionsScreen::askDecision);
    connect(m_reinstate, &QPushButton::clicked, this, &SessionsScreen::askDecision);
    connect(m_archive, &QPushButton::clicked, this, [this] {
        if (const SessionRow* row_ = selected())
            archive(row_->summary.id, !row_->summary.archived);
    });
    connect(m_save, &QPushButton::clicked, this, &SessionsScreen::exportList);
    return bar;
}

void SessionsScreen::connectTable() {
    connect(m_table, &QTableView::activated, this, [this] { open(QStringLiteral("debrief")); });
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this, [this] {
        if (const SessionRow* row = selected())
            m_wanted = row->summary.id;
        showActions();
        noteState();
    });
    connect(m_model, &QAbstractItemModel::modelReset, this, [this] {
        selectSomething();
        showState();
    });
    connect(m_filterBar, &SessionFilterBar::changed, this, &SessionsScreen::chooseFilter);
    connect(m_filterBar, &SessionFilterBar::leaveSearch, this, [this] {
        if (m_panel->state() == StatePanel::State::content)
            m_table->setFocus(Qt::TabFocusReason);
    });
}

void SessionsScreen::chooseFilter(const SessionListFilter& filter) {
    keepOwnFilter(context(), filter);
    m_model->setFilter(filter);
    noteState();
}

void SessionsScreen::enter() {
    load();
}

void SessionsScreen::load() {
    m_complete = false;
    m_panel->showLoading(tr("Loading the sessions …"));
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(), titles = m_titles](WorkToken&) {
            return readSessionRows(database, actor, titles, pageBefore(0, kFirstPage));
        },
        [this](core::Result<std::vector<SessionRow>> rows) { take(std::move(rows), true); });
}

void SessionsScreen::loadRest(database::SessionId before) {
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(), titles = m_titles,
         before](WorkToken&) { return readSessionRows(database, actor, titles, pageBefore(before, kPage)); },
        [this](core::Result<std::vector<SessionRow>> rows) { take(std::move(rows), false); });
}

void SessionsScreen::take(core::Result<std::vector<SessionRow>> rows, bool first) {
    if (!rows) {
        m_panel->showError(tr("The sessions could not be loaded."), rows.error(), [this] { load(); });
        return;
    }
    const auto wanted = static_cast<std::size_t>(first ? kFirstPage : kPage);
    m_complete = rows->size() < wanted;
    const database::SessionId oldest = rows->empty() ? 0 : rows->back().summary.id;
    if (first)
        m_model->setRows(std::move(*rows)); // also selects and shows
    else
        m_model->append(std::move(*rows));
    if (m_table->currentIndex().row() < 0)
        selectSomething();
    showState();
    if (first)
        emit firstRowsShown();
    if (!m_complete) {
        loadRest(oldest);
        return;
    }
    m_filterBar->setPeople(m_model->all());
    emit loaded();
}

void SessionsScreen::showState() {
    const QLocale locale = context().locale();
    const auto waiting = std::count_if(m_model->all().begin(), m_model->all().end(),
                                       [](const SessionRow& row) { return row.summary.toReview; });
    const bool tells = m_complete && waiting > 0 && context().has(database::Role::trainer);
    m_count->setText(
        (tells ? tr("%n session(s) to review", nullptr, static_cast<int>(waiting)) + QStringLiteral(" · ")
               : QString()) +
        (!m_complete ? tr("Loading the older sessions …")
         : m_model->filter().isEmpty()
             ? tr("%n session(s)", nullptr, m_model->rowCount())
             : tr("%1 of %2 sessions")
                   .arg(locale.toString(m_model->rowCount()), locale.toString(m_model->total()))));
    if (m_model->rowCount() > 0) {
        const bool wasThere = m_panel->state() == StatePanel::State::content;
        m_panel->showContent();
        if (!wasThere && !m_filterBar->search()->hasFocus())
            m_table->setFocus(Qt::OtherFocusReason);
    } else if (!m_complete) {
        m_panel->showLoading(tr("Loading the sessions …"));
    } else if (m_model->total() == 0) {
        m_panel->showEmpty(tr("No session has been recorded yet"),
                           tr("As soon as somebody trains, the session is listed here."));
    } else {
        m_panel->showEmpty(tr("No session matches these filters"),
                           tr("%n session(s) in all.", nullptr, m_model->total()), tr("Clear the filters"),
                           [this] {
                               m_filterBar->setFilter({});
                               chooseFilter({});
                           });
    }
    showActions();
}

void SessionsScreen::noteState() {
    if (context().navigator().current().screen != place().screen)
        return; // another screen has already been requested
    QVariantMap map = m_filterBar->filter().toMap();
    if (m_wanted != 0)
        map.insert(kSelected, static_cast<qint64>(m_wanted));
    context().navigator().note(map);
}

} // namespace chiron::desktop
