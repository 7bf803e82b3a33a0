// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "database/write_context.h"

#include <future>
#include <optional>
#include <type_traits>
#include <utility>

namespace chiron::database {

/// A job in the writer thread's queue, and whether it needs a transaction.
class IWriterJob {
public:
    virtual ~IWriterJob() = default;
    /// Does the work; false: the transaction is rolled back.
    virtual bool execute(WriteContext& context) = 0;
    /// Passes the outcome to the waiting thread: the job's own, or this error if begin or commit failed.
    virtual void finish(std::optional<core::Error> transactionError) = 0;
    virtual bool wantsTransaction() const = 0;
};

/// A job made from a function that returns a core::Result.
template <class F> class WriterJob final : public IWriterJob {
public:
    using Outcome = std::invoke_result_t<F, WriteContext&>;
    WriterJob(F work, bool transaction) : m_work(std::move(work)), m_transaction(transaction) {}
    std::future<Outcome> future() { return m_promise.get_future(); }
    bool execute(WriteContext& context) override {
        m_outcome.emplace(m_work(context));
        return m_outcome->has_value();
    }
    void finish(std::optional<core::Error> error) override {
        if (error) {
            m_promise.set_value(tl::unexpected<core::Error>(*std::move(error)));
        } else {
            m_promise.set_value(*std::move(m_outcome));
        }
    }
    bool wantsTransaction() const override { return m_transaction; }

private:
    F m_work;
    bool m_transaction;
    std::optional<Outcome> m_outcome;
    std::promise<Outcome> m_promise;
};

} // namespace chiron::database
