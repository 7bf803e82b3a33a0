// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/random.h"
#include "database/repositories/session_types.h"

#include <QString>
#include <QTemporaryDir>
#include <memory>
#include <sys/types.h>
#include <utility>
#include <vector>

class WitnessFile;

/// When a program is killed.
enum class KillMoment { inSession, atLaunch, beforeFirstChunk, whileFinishing, whileRecovering, twiceInARow };
inline constexpr int kKillMoments = 6;

/// One growing database whose programs die by SIGKILL at random moments, and what must hold after each death.
/// Lives on one thread; several campaigns may run beside each other.
class KillCampaign {
public:
    explicit KillCampaign(std::uint64_t seed);
    KillCampaign(const KillCampaign&) = delete;
    KillCampaign& operator=(const KillCampaign&) = delete;
    ~KillCampaign();

    /// Kills, recovers, checks. Empty if all holds, else what does not.
    QString round(KillMoment moment);
    /// A moment as the long campaign draws it: half of them anywhere in a session.
    KillMoment drawMoment();
    int kills() const noexcept { return m_kills; }             ///< training programs that died by the signal
    std::uint64_t frames() const noexcept { return m_frames; } ///< of killed sessions, stored after recovery

private:
    struct Child {
        pid_t pid = -1;
        std::unique_ptr<WitnessFile> witness;
    };
    struct Killed {
        chiron::database::SessionId session = 0; ///< 0: it died before it had one
        std::uint64_t witnessed = 0;
        bool finishing = false; ///< the exercise had come to its end
    };
    Child launch(const char* role, double limit_s);
    QString waitForDeathMoment(const Child& child, KillMoment moment);
    QString kill(Child& child);
    QString killTraining(KillMoment moment);
    QString killRecovery();
    QString noteSession(const Child& child);
    QString checkAfterRecovery();
    QString checkSession(const Killed& killed);
    void sleep(double least_s, double most_s);

    QTemporaryDir m_folder;
    QTemporaryDir m_rings; ///< in memory: a ring on a disk makes ticks wait for write-back
    chiron::core::Random m_random;
    int m_children = 0;
    int m_kills = 0;
    std::uint64_t m_frames = 0;
    chiron::database::SessionId m_lastSession = 0;
    std::vector<Killed> m_unchecked;
};
