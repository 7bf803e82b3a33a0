// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <QMetaObject>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <type_traits>
#include <utility>
#include <vector>

namespace chiron::desktop {

/// Lets the GUI cancel a piece of background work and read its progress. The screen and the worker share it,
/// because either may outlive the other.
class WorkToken {
public:
    void cancel() noexcept { m_cancelled.store(true, std::memory_order_relaxed); }
    bool cancelled() const noexcept { return m_cancelled.load(std::memory_order_relaxed); }
    const std::atomic<bool>& flag() const noexcept { return m_cancelled; }
    void setProgress(int done, int of) noexcept {
        m_of.store(of, std::memory_order_relaxed);
        m_done.store(done, std::memory_order_relaxed);
    }
    int done() const noexcept { return m_done.load(std::memory_order_relaxed); }
    int of() const noexcept { return m_of.load(std::memory_order_relaxed); } ///< 0 if unknown
    /// What the work is doing now, as text for the user; empty if there is nothing to add to the
    /// announcement.
    void setDoing(const QString& words) {
        const std::lock_guard lock(m_wordsMutex);
        m_words = words;
    }
    QString doing() const {
        const std::lock_guard lock(m_wordsMutex);
        return m_words;
    }

private:
    std::atomic<bool> m_cancelled{false};
    std::atomic<int> m_done{0};
    std::atomic<int> m_of{0};
    mutable std::mutex m_wordsMutex;
    QString m_words;
};

/// Runs work off the GUI thread: lists, scores, Argon2id, backups. `work` runs on a pool thread with its own
/// database connections. `done` receives the result on the GUI thread, unless `owner` has been destroyed by
/// then. Call cancelAndWait() before destroying anything that the work uses.
/// Thread: GUI.
class Background : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;
    ~Background() override; ///< waits for all work to end

    template <class Work, class Done> std::shared_ptr<WorkToken> run(QObject* owner, Work work, Done done) {
        auto token = std::make_shared<WorkToken>();
        std::erase_if(m_tokens, [](const std::weak_ptr<WorkToken>& each) { return each.expired(); });
        m_tokens.push_back(token);
        ++m_underWay;
        QPointer<QObject> alive(owner);
        m_pool.start([this, alive, token, work = std::move(work), done = std::move(done)]() mutable {
            using T = std::invoke_result_t<Work, WorkToken&>;
            auto result =
                std::make_shared<T>(work(*token)); // shared, because posted closures must be copyable
            QMetaObject::invokeMethod(this, [this, alive, result, done = std::move(done)]() mutable {
                --m_underWay;
                if (alive)
                    done(std::move(*result));
            });
        });
        return token;
    }

    /// Asks all work to end early and waits for it. Call it before the database closes.
    void cancelAndWait();
    /// True if nothing is running and every result has been delivered.
    bool idle() const { return m_underWay == 0; }

private:
    QThreadPool m_pool;
    std::vector<std::weak_ptr<WorkToken>> m_tokens;
    int m_underWay = 0; ///< started, result not yet delivered; GUI thread only
};

} // namespace chiron::desktop
