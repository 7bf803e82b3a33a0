// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/backups/backup_keeper.h"

#include "desktop/frame/activity.h"
#include "desktop/frame/app_context.h"
#include "desktop/screen_catalogue.h"
#include "session/backup_schedule.h"

#include <QCoreApplication>
#include <QEvent>

namespace chiron::desktop {

namespace {

bool isSitting(const Place& place) {
    const ScreenEntry* entry = findScreen(place.screen);
    return entry && entry->sitting;
}

} // namespace

BackupKeeper::BackupKeeper(AppContext& context, QObject* parent)
    : QObject(parent), m_context(context), m_waits(&session::waitAfterFailures) {
    m_sinceTouch.start();
    m_timer.setInterval(kLook_ms);
    connect(&m_timer, &QTimer::timeout, this, &BackupKeeper::look);
    connect(&context.navigator(), &Navigator::moved, this, &BackupKeeper::left);
    connect(&context, &AppContext::activity, this, [this] { m_sinceTouch.start(); });
    connect(&context, &AppContext::trialRunsChanged, this, [this](bool runs) {
        if (runs)
            stop();
    });
    QCoreApplication::instance()->installEventFilter(this);
    m_timer.start();
}

bool BackupKeeper::mayBegin() const {
    const bool waited = m_failures == 0 || m_sinceFailure.elapsed() >= m_waits(m_failures).count();
    return !isRunning() && m_context.site().isOpen() && m_context.site().database().isWritable() &&
           !m_context.trialRuns() && !isSitting(m_context.navigator().current()) &&
           m_sinceTouch.elapsed() >= m_quiet_ms && waited;
}

void BackupKeeper::look() {
    if (!mayBegin())
        return;
    m_token = m_context.background().run(
        this,
        [&database = m_context.site().database(),
         station = m_context.settings().backupFolder().toStdString()](WorkToken& working) {
            return session::backUpIfDue(database, station, &working.flag());
        },
        [this](const session::DailyWork& work) {
            m_token.reset();
            if (!work.due || (!work.made && work.made.error().code == core::ErrorCode::cancelled))
                return;
            if (work.made)
                m_failures = 0;
            else
                failed(inWords(work.made.error()));
            emit m_context.backupEnded();
        });
}

void BackupKeeper::failed(const QString& why) {
    ++m_failures;
    m_sinceFailure.start();
    if (!m_context.has(database::Role::admin))
        return; // the home screen tells the next administrator
    m_context.messages().tell(
        {MessageKind::warning, tr("The automatic backup was not made; it will be tried again.\n%1").arg(why),
         tr("Open storage"), [&context = m_context] { context.navigator().go(QStringLiteral("storage")); }});
}

void BackupKeeper::left(const Place& place) {
    if (isSitting(place))
        stop();
}

void BackupKeeper::stop() {
    if (m_token)
        m_token->cancel(); // it is due again when the session is over
}

bool BackupKeeper::eventFilter(QObject* watched, QEvent* event) {
    if (isActivity(*event))
        m_sinceTouch.start();
    return QObject::eventFilter(watched, event);
}

} // namespace chiron::desktop
