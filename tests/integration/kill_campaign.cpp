// SPDX-License-Identifier: GPL-3.0-or-later
#include "kill_campaign.h"

#include "database/database.h"
#include "database/repositories/session_reader.h"
#include "recording/crash_ring.h"
#include "witness_file.h"

#include <chrono>
#include <csignal>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>

extern char** environ;

using namespace chiron;

namespace {

constexpr double kLongSession_s = 20.0; // longer than any kill waits
constexpr double kShortSession_s = 1.0; // comes to its end by itself
constexpr double kPatience_s = 120.0;   // never asserted: ends a test whose child hangs

using Clock = std::chrono::steady_clock;

QString words(const core::Error& error) {
    return QString::fromStdString(error.message);
}

bool ended(pid_t pid) {
    siginfo_t about{};
    return waitid(P_PID, static_cast<id_t>(pid), &about, WEXITED | WNOHANG | WNOWAIT) == 0 &&
           about.si_pid == pid;
}

} // namespace

KillCampaign::KillCampaign(std::uint64_t seed)
    : m_rings(QString::fromStdString(recording::defaultRingFolder().string()) + "/chiron_kills_XXXXXX"),
      m_random(core::Random::stream(seed, "kills")) {
    database::DatabaseOptions options;
    options.passwordCost = database::PasswordCost::minimalForTests();
    if (auto created = database::Database::create(m_folder.filePath("site.db").toStdString(), options);
        !created)
        qFatal("%s", created.error().message.c_str());
}

KillCampaign::~KillCampaign() = default;

KillMoment KillCampaign::drawMoment() {
    const std::uint64_t draw = m_random.below(20);
    return draw < 10 ? KillMoment::inSession : static_cast<KillMoment>(1 + (draw - 10) / 2);
}

void KillCampaign::sleep(double least_s, double most_s) {
    std::this_thread::sleep_for(std::chrono::duration<double>(m_random.uniform(least_s, most_s)));
}

KillCampaign::Child KillCampaign::launch(const char* role, double limit_s) {
    const std::string witness = m_folder.filePath(QString("witness%1").arg(++m_children)).toStdString();
    Child child;
    child.witness = WitnessFile::create(witness);
    std::vector<std::string> words{"/proc/self/exe",
                                   "--child",
                                   role,
                                   m_folder.filePath("site.db").toStdString(),
                                   m_rings.path().toStdString(),
                                   witness,
                                   std::to_string(m_random.below(1'000'000)),
                                   std::to_string(limit_s)};
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    if (posix_spawn(&child.pid, "/proc/self/exe", nullptr, nullptr, arguments.data(), environ) != 0)
        qFatal("the child cannot be started");
    return child;
}

QString KillCampaign::waitForDeathMoment(const Child& child, KillMoment moment) {
    const auto reached = [&] {
        switch (moment) {
        case KillMoment::atLaunch:
            return true;
        case KillMoment::whileRecovering:
            return (*child.witness)->stage.load() >= Stage::recovering;
        case KillMoment::whileFinishing:
            return (*child.witness)->stage.load() >= Stage::finishing;
        default:
            return (*child.witness)->frames.load() > 0;
        }
    };
    const auto start = Clock::now();
    while (!reached()) {
        if (ended(child.pid) && !reached()) // it may have reached it and ended between two looks
            return "the child ended before the moment to kill it";
        if (std::chrono::duration<double>(Clock::now() - start).count() > kPatience_s)
            return "the child hangs";
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    switch (moment) {
    case KillMoment::atLaunch:
        sleep(0.0, 0.3);
        break;
    case KillMoment::whileRecovering:
        sleep(0.0, 0.1);
        break;
    case KillMoment::whileFinishing:
        sleep(0.0, 0.08);
        break;
    case KillMoment::beforeFirstChunk:
        sleep(0.0, 0.25);
        break;
    default:
        sleep(0.0, 3.0);
        break;
    }
    return {};
}

/// By the signal, or, where the end came first, by itself and well.
QString KillCampaign::kill(Child& child) {
    ::kill(child.pid, SIGKILL);
    int status = 0;
    waitpid(child.pid, &status, 0);
    const bool byItself = WIFEXITED(status) && WEXITSTATUS(status) == 0;
    if (!byItself && !(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL))
        return QString("the child ended with wait status %1").arg(status);
    return {};
}

QString KillCampaign::killTraining(KillMoment moment) {
    Child child = launch("train", moment == KillMoment::whileFinishing ? kShortSession_s : kLongSession_s);
    const QString wrong = waitForDeathMoment(child, moment);
    if (const QString died = kill(child); !died.isEmpty() || !wrong.isEmpty())
        return wrong + died;
    ++m_kills;
    return noteSession(child);
}

QString KillCampaign::killRecovery() {
    Child child = launch("recover", kLongSession_s);
    const QString wrong = waitForDeathMoment(child, KillMoment::whileRecovering);
    return wrong + kill(child);
}

// A reader beside the wreck: it must be able to look before anybody recovers.
QString KillCampaign::noteSession(const Child& child) {
    auto database = database::Database::openReadOnly(m_folder.filePath("site.db").toStdString());
    auto connection = database ? (*database)->openReader() : tl::unexpected(database.error());
    if (!connection)
        return "reading after the kill: " + words(connection.error());
    database::SessionFilter filter;
    filter.afterSession = m_lastSession;
    auto sessions = database::SessionReader(**connection, database::Actor::anonymous()).listSessions(filter);
    if (!sessions)
        return "listing after the kill: " + words(sessions.error());
    Killed killed{0, (*child.witness)->frames.load(), (*child.witness)->stage.load() >= Stage::finishing};
    if (sessions->size() > 1)
        return "more than one session by one program";
    if ((*child.witness)->gaps.load() != 0)
        return "the loop left out an index";
    if (!sessions->empty())
        killed.session = m_lastSession = sessions->front().id;
    else if (killed.witnessed > 0)
        return "frames were produced, but there is no session";
    m_unchecked.push_back(killed);
    return {};
}

QString KillCampaign::round(KillMoment moment) {
    QString wrong = killTraining(moment == KillMoment::whileRecovering || moment == KillMoment::twiceInARow
                                     ? KillMoment::inSession
                                     : moment);
    if (wrong.isEmpty() && moment == KillMoment::twiceInARow)
        wrong = killTraining(KillMoment::inSession);
    if (wrong.isEmpty() && moment == KillMoment::whileRecovering)
        wrong = killRecovery();
    if (wrong.isEmpty())
        wrong = checkAfterRecovery();
    m_unchecked.clear();
    return wrong;
}
