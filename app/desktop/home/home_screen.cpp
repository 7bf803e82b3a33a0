// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/home/home_screen.h"

#include "desktop/debrief/debrief_data.h"
#include "desktop/frame/app_context.h"
#include "desktop/home/exercise_card.h"
#include "desktop/home/session_lines.h"
#include "desktop/sessions/session_words.h"
#include "desktop/storage/backup_place.h"
#include "desktop/widgets/kit.h"
#include "desktop/widgets/scroll_page.h"
#include "desktop/widgets/state_panel.h"

namespace chiron::desktop {

HomeScreen::HomeScreen(AppContext& context, const Place& place)
    : Screen(context, place), m_panel(new StatePanel(context.theme())) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(m_panel);
}

QString HomeScreen::title() const {
    return tr("Home");
}

QString HomeScreen::help() const {
    return tr("Your next step, depending on your role.\n\nIf you have not trained yet, you can try an "
              "exercise here in about a minute. Trainees continue with the next level at the press of a "
              "button, choose any level "
              "from the exercises, and see their latest results. Trainers see the sessions that need a "
              "review, interrupted or failed ones "
              "first, and who trained recently. Administrators see whether people, storage and station are "
              "in order.\n\nThe list on the "
              "left leads to all other screens; Ctrl+K finds any command by its name.");
}

std::vector<ScreenCommand> HomeScreen::commands() {
    if (!m_first)
        return {};
    return {{m_first->text(), {}, [this] { m_first->click(); }}};
}

void HomeScreen::enter() {
    load();
}

void HomeScreen::load() {
    m_panel->showLoading(tr("Finding your next step …"));
    DesktopSite& site = context().site();
    HomeQuestion question{context().actor(),         exerciseTitles(site.catalogue(), context().language()),
                          site.catalogue(),          site.recovered(),
                          site.file().toStdString(), backupPlace(context()).toStdString()};
    context().background().run(
        this,
        [&database = site.database(), question = std::move(question)](WorkToken&) {
            return readHome(database, question);
        },
        [this](const core::Result<HomeData>& home) {
            if (home)
                show(*home);
            else
                m_panel->showError(tr("The home screen could not be loaded."), home.error(),
                                   [this] { load(); });
        });
}

void HomeScreen::show(const HomeData& home) {
    const Theme& theme = context().theme();
    auto* page = new ScrollPage(theme, 1100);
    QVBoxLayout& column = *page->column();
    column.addWidget(
        kit::label(theme, tr("Welcome, %1").arg(QString::fromStdString(home.name)), TextStyle::heading));
    addRecovered(column, home);
    addCommented(column, home);
    addRecoveryCode(column, home);
    const bool trainee = context().has(database::Role::trainee);
    const bool nothingElse = home.accounts == 1 && home.own.empty(); // a new site with only one person
    const bool admin = context().has(database::Role::admin);
    if (nothingElse && !trainee)
        addOwnTraining(column, home);
    if (admin)
        addAdmin(column, home, true);
    if (trainee)
        addTrainee(column, home);
    if (context().has(database::Role::trainer))
        addTrainer(column, home);
    if (context().has(database::Role::trainee) || context().has(database::Role::trainer))
        addComments(column);
    if (context().has(database::Role::researcher))
        addResearcher(column);
    if (!trainee && !nothingElse)
        addOwnTraining(column, home);
    if (admin)
        addAdmin(column, home, false);
    if (admin && !context().has(database::Role::researcher))
        addStudies(column); // they may design and run some, too
    column.addStretch();
    delete m_panel->content();
    m_panel->setContent(page);
    m_panel->showContent();
    if (m_first)
        m_first->setFocus(Qt::OtherFocusReason);
}

QPushButton* HomeScreen::opener(const QString& text, const QString& screen, const QVariantMap& parameters,
                                const char* kind) {
    auto* button = kit::button(context().theme(), text, kind);
    connect(button, &QPushButton::clicked, this,
            [this, screen, parameters] { context().navigator().go(screen, parameters); });
    if (!m_first)
        m_first = button;
    return button;
}

// Shown until it is done, because the only administrator of a site has nobody to ask after forgetting the
// password.
void HomeScreen::addRecoveryCode(QVBoxLayout& column, const HomeData& home) {
    if (!home.lacksRecoveryCode)
        return;
    auto* notice = kit::notice(context().theme(), "warning",
                               tr("You are an administrator and have no recovery code yet. With one, you can "
                                  "set a new password yourself if you forget yours."));
    notice->setObjectName(QStringLiteral("home.recovery_code"));
    auto* make = kit::button(context().theme(), tr("Make one …"));
    make->setObjectName(QStringLiteral("home.make_recovery_code"));
    connect(make, &QPushButton::clicked, this, [this] {
        context().navigator().go(QStringLiteral("account"),
                                 {{QStringLiteral("focus"), QStringLiteral("recovery")}});
    });
    notice->layout()->addWidget(make);
    column.addWidget(notice);
}

// Unread comments, shown until the debrief of their session was opened.
void HomeScreen::addCommented(QVBoxLayout& column, const HomeData& home) {
    const Theme& theme = context().theme();
    int unread = 0;
    for (const CommentedSession& commented : home.commented) {
        const database::SessionSummary& session = commented.row.summary;
        if (context()
                .settings()
                .ofPerson(context().actor().personId(), commentsSeenKey(session.id), 0)
                .toInt() >= commented.comments)
            continue;
        ++unread;
        const QString author =
            commented.author.empty() ? tr("Somebody") : QString::fromStdString(commented.author);
        const QString number = QString::number(session.id),
                      level = context().locale().toString(session.level);
        const QString words = commented.own ? tr("%1 commented on your session %2 (%3, level %4).")
                                                  .arg(author, number, commented.row.exercise, level)
                                            : tr("%1 answered your comment on session %2 (%3, level %4).")
                                                  .arg(author, number, commented.row.exercise, level);
        auto* notice = kit::notice(theme, "info", words);
        notice->setObjectName(QStringLiteral("home.commented.%1").arg(session.id));
        auto* open = kit::button(theme, tr("Read"));
        connect(open, &QPushButton::clicked, this, [this, id = session.id] {
            context().navigator().go(QStringLiteral("debrief"),
                                     {{QStringLiteral("session"), static_cast<qint64>(id)}});
        });
        notice->layout()->addWidget(open);
        column.addWidget(notice);
    }
    context().setUnread(unread);
}

void HomeScreen::addComments(QVBoxLayout& column) {
    const int unread = context().unread();
    auto* open = opener(unread > 0 ? tr("Comments: unread on %n session(s)", nullptr, unread)
                                   : tr("Comments, received and written"),
                        QStringLiteral("comments"), {}, "");
    open->setObjectName(QStringLiteral("home.comments"));
    open->setIcon(context().theme().icon(QStringLiteral("edit-comment")));
    column.addWidget(open, 0, Qt::AlignLeft);
}

void HomeScreen::addRecovered(QVBoxLayout& column, const HomeData& home) {
    const Theme& theme = context().theme();
    for (const RecoveredRow& recovered : home.recovered) {
        const database::SessionSummary& session = recovered.row.summary;
        const bool whole = recovered.problem.empty();
        const QString text = whole ? tr("The program ended unexpectedly during session %1 (%2, %3). The "
                                        "session was saved as interrupted: %n sample(s) were "
                                        "kept and can be played back. The session does not count.",
                                        nullptr, static_cast<int>(session.frames))
                                         .arg(session.id)
                                         .arg(recovered.row.person, recovered.row.exercise)
                                   : tr("The program ended unexpectedly during session %1 (%2, %3). The "
                                        "session could not be fully recovered: %4")
                                         .arg(session.id)
                                         .arg(recovered.row.person, recovered.row.exercise,
                                              QString::fromStdString(recovered.problem));
        auto* notice = kit::notice(theme, whole ? "info" : "warning", text);
        notice->setObjectName(QStringLiteral("home.recovered.%1").arg(session.id));
        if (session.state != database::SessionState::running) {
            auto* open = kit::button(theme, tr("View"));
            connect(open, &QPushButton::clicked, this, [this, id = session.id] {
                context().navigator().go(QStringLiteral("debrief"),
                                         {{QStringLiteral("session"), static_cast<qint64>(id)}});
            });
            notice->layout()->addWidget(open);
        }
        column.addWidget(notice);
    }
}

} // namespace chiron::desktop
