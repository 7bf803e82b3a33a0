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

/// Why a specification does not suit a task, in the form of a content fault.
struct TaskFault {
    std::string key;
    std::string found;
    std::string expected;
};

/// One kind of procedure, with everything that the rest of the program needs to know about it. Each kind is
/// defined in the file <kind>_kind.cpp; procedure_spec.h lists them. A specification passed to these
/// functions must be of this kind.
class ProcedureKind {
public:
    /// Texts for people; English, marked with QT_TRANSLATE_NOOP.
    struct Words {
        std::string_view title;
        std::string_view meaning; ///< when a researcher would choose it, in a sentence or two
        bool legacy = false;      ///< for replications only: shown with a warning
    };

    ProcedureKind(std::string_view id, Words words, std::vector<Parameter> rows)
        : m_id(id), m_words(words), m_rows(std::move(rows)) {}
    ProcedureKind(const ProcedureKind&) = delete;
    ProcedureKind& operator=(const ProcedureKind&) = delete;
    virtual ~ProcedureKind() = default;

    std::string_view id() const noexcept { return m_id; } ///< "staircase"; the value of `kind` in JSON
    /// Further ids, without version, that some of its runs have instead of the kind's id.
    virtual std::vector<std::string_view> runIds() const { return {}; }
    const Words& words() const noexcept { return m_words; }
    /// In the order in which a form shows them.
    const std::vector<Parameter>& rows() const noexcept { return m_rows; }

    virtual ProcedureSpec defaults() const = 0;
    /// Makes a factory, after checks that involve more than one row.
    /// Errors: badInput, "key: expected ...".
    virtual core::Result<ProcedureFactory> factory(const ProcedureSpec& spec) const = 0;
    /// Returns whether there is a factory; fails as factory() does. A kind with expensive tables does not
    /// make them here, because every reader of a study calls this function.
    virtual core::Result<void> check(const ProcedureSpec& spec) const {
        const auto made = factory(spec);
        CHIRON_TRY(made);
        return {};
    }
    /// Returns the specification with which a new procedure starts in this condition.
    virtual ProcedureSpec usual(const Condition& condition) const = 0;

    virtual bool drives(Task task) const = 0; ///< the answers of this task can be its outcomes
    /// Strength of the recommendation for a task, above 0; 0: it is not offered. The largest is listed first.
    virtual int recommended(Task task) const = 0;
    virtual std::optional<TaskFault> faultFor(const ProcedureSpec& spec, Task task) const {
        static_cast<void>(spec), static_cast<void>(task);
        return std::nullopt;
    }
    /// The scale that it requires, if any.
    virtual std::optional<ProcedureScale> onlyScale() const { return std::nullopt; }

    /// Neither the number of trials nor their stimuli depend on the answers.
    virtual bool trialsAreFixed() const { return false; }
    /// The outcomes are orders of three objects.
    virtual bool ordersThree(const ProcedureSpec& spec) const {
        static_cast<void>(spec);
        return false;
    }
    virtual int trialsAtMost(const ProcedureSpec& spec) const = 0; ///< 0: no limit
    /// Makes a run about this long; false: its rule does not allow that.
    virtual bool endAfter(ProcedureSpec& spec, int trials) const = 0;

private:
    std::string_view m_id;
    Words m_words;
    std::vector<Parameter> m_rows;
};

/// A kind whose runs end by its StopRule or, without one, after at most levels × repeats trials.
template <class Spec> class ProcedureKindOf : public ProcedureKind {
public:
    ProcedureKindOf(Words words, std::vector<Parameter> rows)
        : ProcedureKind(Spec::kKind, words, std::move(rows)) {}
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

/// Returns a factory for a procedure that depends only on its specification. A wrong specification is refused
/// at once; later runs use the checked one.
template <class Make> core::Result<ProcedureFactory> checkedFactory(Make make) {
    CHIRON_TRY(make(1));
    return [make](std::uint64_t seed) { return std::move(*make(seed)); };
}

/// Returns whether a task's answers are right or wrong, so that procedures with two outcomes can use them.
constexpr bool isRightOrWrong(Task task) noexcept {
    return !ranksThree(task) && task != Task::adjustment && task != Task::magnitude;
}
/// Returns whether one of several objects has to be found.
constexpr bool isForcedChoice(Task task) noexcept {
    return task == Task::twoAfc || task == Task::threeAfc || task == Task::oddity;
}

} // namespace chiron::psychophysics
