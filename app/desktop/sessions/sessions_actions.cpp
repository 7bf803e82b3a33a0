// SPDX-License-Identifier: GPL-3.0-or-later
#include "database/repositories/session_repository.h"
#include "desktop/frame/app_context.h"
#include "desktop/frame/file_folder.h"
#include "desktop/results/results_place.h"
#include "desktop/sessions/session_filter_bar.h"
#include "desktop/sessions/session_table_model.h"
#include "desktop/sessions/session_words.h"
#include "desktop/sessions/sessions_csv.h"
#include "desktop/sessions/sessions_screen.h"
#include "desktop/widgets/state_panel.h"

#include <QFileDialog>
#include <QLineEdit>
#include <QPointer>
#include <QPushButton>
#include <QTableView>
#include <algorithm>

namespace chiron::desktop {

namespace {

/// Runs one short write on a worker and passes its result to the GUI thread. It works as long as the program
/// runs, because "Undo" may be pressed on another screen.
template <class Job, class Done>
void writeInBackground(AppContext& context, QObject* owner, Job job, Done done) {
    context.background().run(
        owner,
        [&database = context.site().database(), actor = context.actor(), job](WorkToken&) {
            return database.write([&](database::WriteContext& writing) -> core::Result<void> {
                database::SessionRepository sessions(writing.connection(), actor);
                return job(sessions);
            });
        },
        done);
}

} // namespace

std::vector<ScreenCommand> SessionsScreen::commands() {
    std::vector<ScreenCommand> list{
        {tr("Search in the list"), QKeySequence(QKeySequence::Find),
         [this] { m_filterBar->search()->setFocus(Qt::ShortcutFocusReason); }},
        {m_open->text(), QKeySequence(Qt::Key_Return), [this] { open(QStringLiteral("debrief")); }, false},
        {m_play->text(), QKeySequence(Qt::CTRL | Qt::Key_P), [this] { open(QStringLiteral("playback")); }},
        {tr("Save the list …"), QKeySequence(QKeySequence::Save), [this] { exportList(); }}};
    if (m_results->isEnabled())
        list.push_back({m_results->text(), {}, [this] { openResults(); }});
    if (!m_archive->isHidden()) {
        if (m_reinstate->isHidden())
            list.push_back({m_void->text(), {}, [this] { askDecision(); }});
        else
            list.push_back({m_reinstate->text(), {}, [this] { askDecision(); }});
        list.push_back({m_archive->text(), {}, [this] { m_archive->click(); }});
    }
    return list;
}

const SessionRow* SessionsScreen::selected() const {
    const int row = m_table->currentIndex().row();
    return row >= 0 && row < m_model->rowCount() ? &m_model->at(row) : nullptr;
}

void SessionsScreen::selectSomething() {
    if (m_model->rowCount() == 0)
        return;
    const int row = m_wanted != 0 ? m_model->rowOf(m_wanted) : -1;
    const database::SessionId wanted = m_wanted;
    m_table->setCurrentIndex(m_model->index(std::max(row, 0), 0));
    if (row < 0 && wanted != 0 && !m_complete)
        m_wanted = wanted; // it may be among the sessions that have not been read yet
}

QString SessionsScreen::sealedWords() {
    return tr("A session of a blinded study can be opened once the study is unblinded.");
}

void SessionsScreen::showActions() {
    const SessionRow* row = m_panel->state() == StatePanel::State::content ? selected() : nullptr;
    const bool ended = row && row->summary.state != database::SessionState::running;
    const bool changes = context().has(database::Role::trainer) || context().has(database::Role::admin);
    const bool sealed = row && row->summary.sealed;
    m_open->setEnabled(ended && !sealed);
    m_play->setEnabled(ended && !sealed && !row->summary.recordingErased && row->summary.frames > 0);
    for (QPushButton* button : {m_open, m_play})
        button->setToolTip(sealed ? sealedWords() : QString());
    m_results->setEnabled(row && hasResults(row->summary));
    const bool voided = row && row->summary.state == database::SessionState::voided;
    m_void->setVisible(changes && !voided);
    m_void->setEnabled(ended && !voided);
    m_reinstate->setVisible(changes && voided);
    m_archive->setVisible(changes);
    m_archive->setEnabled(ended);
    m_save->setEnabled(m_model->rowCount() > 0);
    m_archive->setText(row && row->summary.archived ? tr("Bring back from the archive") : tr("Archive"));
}

void SessionsScreen::open(const QString& screen) {
    const SessionRow* row = selected();
    if (!row)
        return;
    if (row->summary.state == database::SessionState::running) {
        context().messages().information(
            tr("Session %1 is still running. It can be opened as soon as it has ended.")
                .arg(row->summary.id));
        return;
    }
    if (row->summary.sealed) {
        context().messages().information(sealedWords());
        return;
    }
    noteState();
    context().navigator().go(screen, {{QStringLiteral("session"), static_cast<qint64>(row->summary.id)}});
}

void SessionsScreen::openResults() {
    const SessionRow* row = selected();
    if (!row || !hasResults(row->summary))
        return;
    noteState();
    context().navigator().go(resultsPlace(row->summary, row->person));
}

void SessionsScreen::askDecision() {
    const SessionRow* row = selected();
    if (!row || row->summary.state == database::SessionState::running)
        return;
    const auto decision = row->summary.state == database::SessionState::voided
                              ? VoidSessionDialog::Decision::countAgain
                              : VoidSessionDialog::Decision::voidIt;
    auto* dialog = new VoidSessionDialog(context().theme(), row->summary.id, row->person,
                                         SessionWords::which(row->summary, row->exercise, context().locale()),
                                         this, decision);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, decision, id = row->summary.id] { decide(id, decision, dialog->reason()); });
    dialog->open();
}

void SessionsScreen::decide(database::SessionId session, VoidSessionDialog::Decision decision,
                            const QString& reason) {
    const bool voids = decision == VoidSessionDialog::Decision::voidIt;
    writeInBackground(
        context(), this,
        [session, voids, words = reason.toStdString()](database::SessionRepository& sessions) {
            return voids ? sessions.voidSession(session, words) : sessions.reinstateSession(session, words);
        },
        [this, session, voids](const core::Result<void>& done) {
            if (!done) {
                context().messages().error(voids ? tr("Session %1 was not voided.").arg(session)
                                                 : tr("Session %1 is still void.").arg(session),
                                           done.error());
                return;
            }
            context().messages().done(
                voids
                    ? tr("Session %1 is voided. Its recording is kept; it no longer counts.").arg(session)
                    : tr("Session %1 counts again. Its history still shows that it was void.").arg(session));
            reload(session);
        });
}

void SessionsScreen::archive(database::SessionId session, bool archived) {
    AppContext& app = context();
    const QPointer<SessionsScreen> screen(this);
    const auto put = [&app, screen, session](bool to, std::function<void()> undo) {
        writeInBackground(
            app, &app,
            [session, to](database::SessionRepository& sessions) {
                return sessions.setArchived(session, to);
            },
            [&app, screen, session, to, undo](const core::Result<void>& done) {
                if (!done) {
                    app.messages().error(SessionsScreen::tr("Session %1 was not changed.").arg(session),
                                         done.error());
                    return;
                }
                app.messages().tell(
                    {MessageKind::done,
                     to ? SessionsScreen::tr("Session %1 is archived: nothing was deleted.").arg(session)
                        : SessionsScreen::tr("Session %1 is back in the list.").arg(session),
                     undo ? SessionsScreen::tr("Undo") : QString(), undo});
                if (screen)
                    screen->reload(session);
            });
    };
    put(archived, [put, archived] { put(!archived, {}); });
}

void SessionsScreen::reload(database::SessionId session) {
    context().background().run(
        this,
        [&database = context().site().database(), actor = context().actor(), titles = m_titles,
         session](WorkToken&) -> core::Result<std::vector<SessionRow>> {
            auto row = readSessionRow(database, actor, titles, session);
            CHIRON_TRY(row);
            database::SessionFilter siblings;
            siblings.person = row->summary.person;
            siblings.exercise = row->summary.exercise;
            siblings.level = row->summary.level;
            siblings.includeArchived = true;
            return readSessionRows(database, actor, titles, siblings);
        },
        [this](core::Result<std::vector<SessionRow>> rows) {
            if (rows)
                m_model->replace(std::move(*rows));
            else
                context().messages().error(tr("The session could not be read again."), rows.error(),
                                           Tried::reading);
        });
}

void SessionsScreen::exportList() {
    if (m_model->rowCount() == 0) { // by its shortcut, because the button is disabled
        context().messages().information(tr("The list is empty, so there is nothing to save."));
        return;
    }
    auto* dialog =
        new QFileDialog(this, tr("Save the list"), QString(), tr("Comma-separated values (*.csv)"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    beginInLastFolder(context().settings(), *dialog, QStringLiteral("session_lists"));
    dialog->selectFile(QStringLiteral("sessions.csv"));
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& file) {
        std::vector<SessionRow> rows;
        for (int i = 0; i < m_model->rowCount(); ++i)
            rows.push_back(m_model->at(i));
        context().background().run(
            this, [rows = std::move(rows), file](WorkToken&) { return writeSessionsCsv(rows, file); },
            [this, file](const core::Result<void>& done) {
                if (done)
                    context().messages().done(tr("The list is saved in %1.").arg(file));
                else
                    context().messages().error(tr("The list was not saved."), done.error());
            });
    });
    dialog->open();
}

} // namespace chiron::desktop
