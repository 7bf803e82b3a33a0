// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/procedures/parameter.h"
#include "psychophysics/study/study_design.h"

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace chiron::psychophysics {

/// Why a specification does not suit a task, as a content fault says it.
struct TaskFault {
    std::string key;
    std::string found;
    std::string expected;
};

/// One kind of procedure: everything that others ask of it. Each kind is made in the file <kind>_kind.cpp; procedure_spec.h lists them.
/// Functions that take a specification take one of this kind.
class ProcedureKind {
public:
    /// For people, English, marked with QT_TRANSLATE_NOOP.
    struct Words {
        std::string_view title;
        std::string_view meaning; ///< when a researcher would choose it, in a sentence or two
        bool legacy = false;      ///< for replications only: shown as a warning
    };

    ProcedureKind(std::string_view id, Words words, std::vector<Parameter> rows) : m_id(id), m_words(words), m_rows(std::move(rows)) {}
    ProcedureKind(const ProcedureKind&) = delete;
    ProcedureKind& operator=(const ProcedureKind&) = delete;
    virtual ~ProcedureKind() = default;

    std::string_view id() const noexcept { return m_id; } ///< "staircase"; what JSON has as kind
    /// What some of its runs are called beside the kind's id, without version.
    virtual std::vector<std::string_view> runIds() const { return {}; }
    const Words& words() const noexcept { return m_words; }
    const std::vector<Parameter>& rows() const noexcept { return m_rows; } ///< in the order in which a form shows them

    virtual ProcedureSpec defaults() const = 0;
    /// Checks what concerns more than one row. Failure: badInput, "key: expected ...".
    virtual core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const = 0;
    /// Whether there is a factory; fails as that does. A kind with tables that take long does not make them here: every reader of a study asks.
    virtual core::Result<void> check(const ProcedureSpec& spec) const {
        const auto made = factory(spec);
        return made ? core::Result<void>() : tl::unexpected(made.error());
    }
    /// What somebody would begin with in this condition.
    virtual ProcedureSpec usual(const Condition& condition) const = 0;

    virtual bool drives(Task task) const = 0; ///< the answers of this task are its outcomes
    /// How warmly it is recommended for a task, above 0; 0: it is not offered. The largest stands first.
    virtual int recommended(Task task) const = 0;
    virtual std::optional<TaskFault> faultFor(const ProcedureSpec& spec, Task task) const {
        static_cast<void>(spec), static_cast<void>(task);
        return std::nullopt;
    }
    virtual std::optional<ProcedureScale> onlyScale() const { return std::nullopt; } ///< the scale that it needs, if it needs one

    virtual bool trialsAreFixed() const { return false; }              ///< their number and what they show do not depend on answers
    virtual bool ordersThree(const ProcedureSpec& spec) const {        ///< outcomes are orders of three objects
        static_cast<void>(spec);
        return false;
    }
    virtual int trialsAtMost(const ProcedureSpec& spec) const = 0;     ///< 0: no limit
    virtual bool endAfter(ProcedureSpec& spec, int trials) const = 0;  ///< makes a run about so long; false: its rule does not allow that

private:
    std::string_view m_id;
    Words m_words;
    std::vector<Parameter> m_rows;
};

/// A kind whose runs end by its StopRule or, without one, by what it says itself.
template <class Spec> class ProcedureKindOf : public ProcedureKind {
public:
    ProcedureKindOf(Words words, std::vector<Parameter> rows) : ProcedureKind(Spec::kKind, words, std::move(rows)) {}
    ProcedureSpec defaults() const final { return Spec{}; }
    int trialsAtMost(const ProcedureSpec& spec) const override {
        if constexpr (requires(const Spec& of) { of.stop; })
            return ours(spec).stop.trials;
        else
            return static_cast<int>(ours(spec).levels.size()) * ours(spec).repeats;
    }
    bool endAfter(ProcedureSpec& spec, int trials) const override {
        if constexpr (requires(Spec& of) { of.stop; }) {
            std::get<Spec>(spec).stop = StopRule{.trials = trials};
            return true;
        }
        static_cast<void>(spec), static_cast<void>(trials);
        return false;
    }

protected:
    static const Spec& ours(const ProcedureSpec& spec) { return std::get<Spec>(spec); }
};

/// A factory of a procedure that is made of its specification alone: a wrong one is refused at once, later each run is made of what was checked.
template <class Make> core::Result<ProcedureFactory> checkedFactory(Make make) {
    if (auto first = make(1); !first)
        return tl::unexpected(first.error());
    return [make](std::uint64_t seed) { return std::move(*make(seed)); };
}

/// Whether a task's answers are right or wrong, so that procedures of two outcomes can follow them.
constexpr bool isRightOrWrong(Task task) noexcept { return !ranksThree(task) && task != Task::adjustment && task != Task::magnitude; }
/// Of several objects one is to be found.
constexpr bool isForcedChoice(Task task) noexcept { return task == Task::twoAfc || task == Task::threeAfc || task == Task::oddity; }

} // namespace chiron::psychophysics
