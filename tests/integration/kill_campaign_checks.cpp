// SPDX-License-Identifier: GPL-3.0-or-later
#include "kill_campaign.h"

#include "database/database.h"
#include "database/repositories/score_repository.h"
#include "database/repositories/session_reader.h"
#include "session/integrity_check.h"
#include "session/recovery.h"
#include "session/replayer.h"
#include "session/session_view.h"

#include <QDir>

using namespace chiron;

namespace {

QString words(const core::Error& error) {
    return QString::fromStdString(error.message);
}

QString said(const database::VerifyReport& report) {
    const database::Finding& first = report.findings.front();
    return QString("verify: %1 findings, first: %2 %3 %4: %5")
        .arg(report.findings.size())
        .arg(QString::fromStdString(first.kind), QString::fromStdString(first.table),
             QString::fromStdString(first.row), QString::fromStdString(first.detail));
}

/// What a stored session must show by itself: an unbroken row of frames that can be re-simulated, and scores.
QString checkStored(database::Connection& connection, database::SessionId id, std::uint64_t frames) {
    auto stored = session::SessionView::open(connection, database::Actor::anonymous(), id);
    auto all = stored ? (*stored)->reader().allFrames() : tl::unexpected(stored.error());
    if (!all)
        return words(all.error());
    if (all->size() != frames)
        return QString("%1 frames are listed, %2 stored").arg(frames).arg(all->size());
    for (std::size_t i = 0; i < all->size(); ++i) {
        if ((*all)[i].header.index != i)
            return QString("frame %1 has index %2").arg(i).arg((*all)[i].header.index);
    }
    auto replay = session::replaySession(**stored);
    if (!replay)
        return words(replay.error());
    if (!replay->comparable || !replay->identical || replay->frames != frames)
        return QString("the replay differs by %1 N at most").arg(replay->maximumDifference_N);
    if (auto scores = database::ScoreRepository(connection, database::Actor::anonymous()).scores(id); !scores)
        return words(scores.error());
    return {};
}

} // namespace

QString KillCampaign::checkSession(const Killed& killed) {
    auto database = database::Database::openReadOnly(m_folder.filePath("site.db").toStdString());
    auto connection = database ? (*database)->openReader() : tl::unexpected(database.error());
    if (!connection)
        return words(connection.error());
    database::SessionFilter filter;
    filter.afterSession = killed.session - 1;
    filter.limit = 1;
    auto listed = database::SessionReader(**connection, database::Actor::anonymous()).listSessions(filter);
    if (!listed || listed->size() != 1 || listed->front().id != killed.session)
        return "is not listed";
    const database::SessionSummary& summary = listed->front();
    // Every frame the witness saw is stored. It counts after the recording: the kill may lie between the two.
    if (summary.frames < killed.witnessed || summary.frames > killed.witnessed + 1)
        return QString("%1 frames stored, %2 witnessed").arg(summary.frames).arg(killed.witnessed);
    const bool interrupted = summary.state == database::SessionState::interrupted;
    const bool completed = summary.state == database::SessionState::completed;
    if (!interrupted && !(completed && killed.finishing))
        return "is listed as " + QString::fromUtf8(database::token(summary.state).data());
    m_frames += summary.frames;
    return checkStored(**connection, killed.session, summary.frames);
}

QString KillCampaign::checkAfterRecovery() {
    const std::string file = m_folder.filePath("site.db").toStdString();
    const std::string rings = m_rings.path().toStdString();
    {
        auto database = database::Database::openForWriting(file);
        auto recovered =
            database ? session::recoverSessions(**database, rings) : tl::unexpected(database.error());
        if (!recovered)
            return "recovery: " + words(recovered.error());
        auto again = session::recoverSessions(**database, rings);
        if (!again || !again->empty())
            return "a second recovery finds something to do";
    }
    const QStringList left = QDir(m_rings.path()).entryList(QDir::Files);
    if (!left.isEmpty())
        return "left behind: " + left.join(' ');
    for (const Killed& killed : m_unchecked) {
        if (killed.session == 0)
            continue;
        if (const QString wrong = checkSession(killed); !wrong.isEmpty())
            return QString("session %1: %2").arg(killed.session).arg(wrong);
    }
    const database::VerifyReport report = session::verifyEverything(file);
    return report.ok() ? QString() : said(report);
}
