// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/constant_stimuli.h"
#include "psychophysics/procedures/descending.h"
#include "psychophysics/procedures/pest.h"
#include "psychophysics/procedures/procedure_spec.h"
#include "psychophysics/procedures/quest.h"
#include "psychophysics/procedures/quest_plus.h"
#include "psychophysics/procedures/rank3_quest_plus.h"
#include "psychophysics/procedures/staircase.h"

#include "core/random.h"

namespace chiron::psychophysics {

namespace {

using Factory = core::Result<ProcedureFactory>;

/// Refuses a wrong specification at once; later each run is made of what was checked.
template <class Make> Factory checked(Make make) {
    if (auto first = make(1); !first)
        return tl::unexpected(first.error());
    return [make](std::uint64_t seed) { return std::move(*make(seed)); };
}

struct FactoryOf {
    Factory operator()(const StaircaseSpec& spec) const { return checked([spec](std::uint64_t) { return Staircase::make(spec); }); }
    Factory operator()(const PestSpec& spec) const { return checked([spec](std::uint64_t) { return Pest::make(spec); }); }
    Factory operator()(const ConstantSpec& spec) const { return checked([spec](std::uint64_t seed) { return ConstantStimuli::make(spec, seed); }); }
    Factory operator()(const DescendingSpec& spec) const { return checked([spec](std::uint64_t) { return Descending::make(spec); }); }
    Factory operator()(const QuestSpec& spec) const { return checked([spec](std::uint64_t) { return Quest::make(spec); }); }
    Factory operator()(const QuestPlusSpec& spec) const { return ofModel(questPlusModel(spec), std::to_string(spec.seed)); }
    Factory operator()(const Rank3Spec& spec) const { return ofModel(rank3Model(spec), {}); }

    static Factory ofModel(const core::Result<std::shared_ptr<const QuestPlusModel>>& model, const std::string& purpose) {
        if (!model)
            return tl::unexpected(model.error());
        return [shared = *model, purpose](std::uint64_t seed) { return std::make_unique<QuestPlus>(shared, core::Random::mix(seed, purpose)); };
    }
};

} // namespace

std::string_view kindOf(const ProcedureSpec& spec) noexcept {
    return std::visit([](const auto& of) { return of.kKind; }, spec);
}

core::Result<ProcedureFactory> procedureFactory(const ProcedureSpec& spec) { return std::visit(FactoryOf{}, spec); }

core::Result<std::unique_ptr<Procedure>> makeProcedure(const ProcedureSpec& spec, std::uint64_t seed) {
    const auto factory = procedureFactory(spec);
    if (!factory)
        return tl::unexpected(factory.error());
    return (*factory)(seed);
}

} // namespace chiron::psychophysics
