// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/comments_screen.h"

#include "desktop/debrief/debrief_data.h"
#include "desktop/frame/app_context.h"
#include "desktop/sessions/session_words.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QPushButton>
#include <algorithm>
#include <set>

namespace chiron::desktop {

namespace {

constexpr std::size_t kCommentsAtOnce = 40;
enum CommentChoice { allComments, receivedComments, writtenComments };
const QString kWhichComments = QStringLiteral("which");

QString commentChoiceToken(int choice) {
    return choice == receivedComments  ? QStringLiteral("received")
           : choice == writtenComments ? QStringLiteral("written")
                                       : QString();
}

} // namespace

CommentsScreen::CommentsScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_panel(new StatePanel(context.theme())) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_panel);
}

QString CommentsScreen::title() const {
    return tr("Comments");
}

QString CommentsScreen::help() const {
    return tr("All comments that you received or wrote, unread ones first, then the newest.\n\nEach leads to "
              "its moment in the playback, or to the debrief "
              "where it is about the whole session. What is shown here counts as read.");
}

void CommentsScreen::enter() {
    load();
}

void CommentsScreen::load() {
    m_panel->showLoading(tr("Reading the comments …"));
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(),
         titles = exerciseTitles(context().site().catalogue(), context().language())](WorkToken&) {
            return readComments(database, actor, titles);
        },
        [this](core::Result<std::vector<FoundComment>> comments) {
            if (comments)
                show(std::move(*comments));
            else
                m_panel->showError(tr("The comments could not be read."), comments.error(),
                                   [this] { load(); });
        });
}

void CommentsScreen::show(std::vector<FoundComment> comments) {
    m_comments = std::move(comments);
    if (m_comments.empty()) {
        m_panel->showEmpty(
            tr("No comments yet"),
            tr("Comments on your sessions, and your comments on other people's sessions, will appear here."));
        return;
    }
    const auto firstRead =
        std::stable_partition(m_comments.begin(), m_comments.end(),
                              [this](const FoundComment& comment) { return isUnread(comment); });
    m_unread.assign(static_cast<std::size_t>(firstRead - m_comments.begin()), true);
    m_unread.resize(m_comments.size(), false);
    build();
    m_panel->showContent();
    m_which->setFocus(Qt::OtherFocusReason);
}

bool CommentsScreen::isUnread(const FoundComment& comment) const {
    const auto person = context().actor().personId();
    return comment.received &&
           comment.place >=
               context().settings().ofPerson(person, commentsSeenKey(comment.row.summary.id), 0).toInt();
}

void CommentsScreen::build() {
    const Theme& theme = context().theme();
    auto* page = new ScrollPage(theme);
    auto* head = new QWidget;
    auto* row = new QHBoxLayout(head);
    row->setContentsMargins(0, 0, 0, 0);
    row->addWidget(kit::label(theme, title(), TextStyle::heading), 1);
    m_which = new QComboBox;
    m_which->setObjectName(QStringLiteral("comments.which"));
    m_which->setAccessibleName(tr("Which comments"));
    m_which->addItem(tr("Received and written"));
    m_which->addItem(tr("Received"));
    m_which->addItem(tr("Written"));
    for (const int choice : {receivedComments, writtenComments})
        if (place().parameters.value(kWhichComments).toString() == commentChoiceToken(choice))
            m_which->setCurrentIndex(choice);
    connect(m_which, &QComboBox::currentIndexChanged, this, [this](int choice) {
        context().navigator().note(choice == allComments
                                       ? QVariantMap{}
                                       : QVariantMap{{kWhichComments, commentChoiceToken(choice)}});
        fill();
    });
    row->addWidget(m_which, 0, Qt::AlignBottom);
    page->column()->addWidget(head);
    m_holder = new QWidget;
    m_lines = new QVBoxLayout(m_holder);
    m_lines->setContentsMargins(0, 0, 0, 0);
    m_lines->setSpacing(theme.px(8));
    page->column()->addWidget(m_holder);
    auto* more = kit::button(theme, tr("Show older comments"), "quiet");
    more->setObjectName(QStringLiteral("comments.more"));
    connect(more, &QPushButton::clicked, this, &CommentsScreen::addMore);
    m_more = more;
    page->column()->addWidget(more, 0, Qt::AlignLeft);
    page->column()->addStretch();
    m_panel->setContent(page);
    fill();
}

void CommentsScreen::fill() {
    while (QLayoutItem* item = m_lines->takeAt(0)) {
        if (QWidget* widget = item->widget()) {
            widget->hide();
            widget->deleteLater();
        }
        delete item;
    }
    m_chosen.clear();
    m_shown = 0;
    const int choice = m_which->currentIndex();
    const auto self = context().actor().personId();
    for (const FoundComment& comment : m_comments)
        if (choice == allComments ||
            (choice == receivedComments ? comment.received : comment.named.comment.author == self))
            m_chosen.push_back(&comment);
    if (m_chosen.empty())
        m_lines->addWidget(kit::label(context().theme(),
                                      choice == receivedComments
                                          ? tr("Nobody has commented on your sessions yet.")
                                          : tr("You have not written any yet."),
                                      TextStyle::body, "muted"));
    addMore();
}

void CommentsScreen::addMore() {
    const auto person = context().actor().personId();
    const std::size_t end = std::min(m_shown + kCommentsAtOnce, m_chosen.size());
    for (; m_shown < end; ++m_shown) {
        const FoundComment& comment = *m_chosen[m_shown];
        const bool unread = m_unread[static_cast<std::size_t>(&comment - m_comments.data())];
        m_lines->addWidget(card(comment, unread));
        if (unread)
            context().settings().setOfPerson(person, commentsSeenKey(comment.row.summary.id),
                                             comment.onSession);
    }
    m_more->setVisible(m_shown < m_chosen.size());
    std::set<database::SessionId> still;
    for (const FoundComment& comment : m_comments)
        if (isUnread(comment))
            still.insert(comment.row.summary.id);
    context().setUnread(static_cast<int>(still.size()));
}

QString CommentsScreen::headOf(const FoundComment& comment) const {
    const auto self = context().actor().personId();
    const QLocale locale = context().locale();
    const QString author = comment.named.comment.author == self ? tr("You")
                           : comment.named.author.empty()       ? tr("Somebody else")
                                                          : QString::fromStdString(comment.named.author);
    const QString what = SessionWords::what(comment.row.summary, comment.row.exercise, locale);
    const QString when = SessionWords::ago(SessionWords::timeOf(comment.named.comment.utc),
                                           QDateTime::currentDateTimeUtc(), locale);
    return comment.row.summary.person == self
               ? tr("%1 on your session %2: %3 · %4")
                     .arg(author, QString::number(comment.row.summary.id), what, when)
               : tr("%1 on session %2 of %3: %4 · %5")
                     .arg(author, QString::number(comment.row.summary.id), comment.row.person, what, when);
}

bool CommentsScreen::leadsToItsMoment(const FoundComment& comment) const {
    return comment.named.comment.tick && !comment.row.summary.recordingErased;
}

QWidget* CommentsScreen::card(const FoundComment& comment, bool unread) {
    const Theme& theme = context().theme();
    const kit::Box box = kit::box(theme, unread ? "info" : "card");
    box.frame->setObjectName(QStringLiteral("comments.comment.%1").arg(comment.named.comment.id));
    auto* line = new QHBoxLayout;
    line->setSpacing(theme.px(12));
    auto* words = new QVBoxLayout;
    words->setSpacing(theme.px(4));
    if (unread) {
        auto* fresh = kit::label(theme, tr("Unread"), TextStyle::strong);
        fresh->setObjectName(QStringLiteral("comments.unread"));
        words->addWidget(fresh);
    }
    words->addWidget(kit::label(theme, headOf(comment), TextStyle::small, "muted"));
    const std::string& text = comment.named.comment.text;
    words->addWidget(kit::label(theme, text.empty() ? tr("(erased)") : QString::fromStdString(text)));
    line->addLayout(words, 1);
    const bool running = comment.row.summary.state == database::SessionState::running;
    if (!comment.row.summary.sealed && !running) { // otherwise there is nothing that may be opened
        auto* watch = leadsToItsMoment(comment)
                          ? kit::button(theme, tr("Watch"), "", QStringLiteral("go-jump"))
                          : kit::button(theme, tr("Open the debrief"), "", QStringLiteral("view-statistics"));
        watch->setObjectName(QStringLiteral("comments.open.%1").arg(comment.named.comment.id));
        connect(watch, &QPushButton::clicked, this, [this, &comment] { open(comment); });
        line->addWidget(watch, 0, Qt::AlignTop);
    }
    box.layout->addLayout(line);
    return box.frame;
}

void CommentsScreen::open(const FoundComment& comment) {
    const QVariant session = static_cast<qint64>(comment.row.summary.id);
    if (!leadsToItsMoment(comment)) {
        context().navigator().go(QStringLiteral("debrief"), {{QStringLiteral("session"), session}});
        return;
    }
    const QString author =
        comment.named.author.empty() ? tr("Somebody else") : QString::fromStdString(comment.named.author);
    context().navigator().go(
        QStringLiteral("playback"),
        {{QStringLiteral("session"), session},
         {QStringLiteral("at_tick"), static_cast<qulonglong>(*comment.named.comment.tick)},
         {QStringLiteral("caption"),
          tr("%1: %2").arg(author, QString::fromStdString(comment.named.comment.text))},
         {QStringLiteral("tab"), QStringLiteral("comments")}});
}

} // namespace chiron::desktop
