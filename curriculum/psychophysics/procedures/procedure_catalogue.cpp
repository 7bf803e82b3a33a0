// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/procedure_catalogue.h"

#include <algorithm>
#include <type_traits>
#include <utility>
#include <variant>

namespace chiron::psychophysics {

namespace {

template <std::size_t... Place> std::vector<const ProcedureKind*> kindsOfAll(std::index_sequence<Place...>) {
    return {&std::variant_alternative_t<Place, ProcedureSpec>::kind()...};
}

} // namespace

const std::vector<const ProcedureKind*>& procedureKinds() {
    static const std::vector<const ProcedureKind*> kinds =
        kindsOfAll(std::make_index_sequence<std::variant_size_v<ProcedureSpec>>());
    return kinds;
}

const ProcedureKind& kindFor(const ProcedureSpec& spec) {
    return std::visit([](const auto& of) -> const ProcedureKind& { return of.kind(); }, spec);
}

const ProcedureKind* findProcedureKind(std::string_view id) {
    id = id.substr(0, id.find('@'));
    const ProcedureKind* found = nullptr;
    for (const ProcedureKind* kind : procedureKinds()) {
        if (kind->id() == id)
            return kind;
        for (const std::string_view variant : kind->runIds())
            if (variant == id)
                found = kind;
    }
    return found;
}

std::string procedureKindIds(std::string_view last) {
    std::string ids;
    for (std::size_t i = 0; i < procedureKinds().size(); ++i) {
        if (i > 0)
            ids += i + 1 == procedureKinds().size() ? last : std::string_view(", ");
        ids += procedureKinds()[i]->id();
    }
    return ids;
}

std::vector<std::string> kindsFor(Task task) {
    std::vector<const ProcedureKind*> offered;
    for (const ProcedureKind* kind : procedureKinds())
        if (kind->recommended(task) > 0)
            offered.push_back(kind);
    std::stable_sort(offered.begin(), offered.end(), [task](const ProcedureKind* a, const ProcedureKind* b) {
        return a->recommended(task) > b->recommended(task);
    });
    std::vector<std::string> ids;
    for (const ProcedureKind* kind : offered)
        ids.emplace_back(kind->id());
    return ids;
}

ProcedureSpec usualProcedure(const std::string& kind, const Condition& condition) {
    const ProcedureKind* known = findProcedureKind(kind);
    if (!known)
        known = findProcedureKind(kindsFor(condition.task).front());
    return known->usual(condition);
}

ProcedureSpec usualProcedureKeeping(const std::string& kind, const Condition& condition,
                                    const ProcedureSpec& earlier) {
    ProcedureSpec spec = usualProcedure(kind, condition);
    const bool sameKind = spec.index() == earlier.index();
    for (const Parameter& row : kindFor(spec).rows()) {
        const bool dependsOnTheTable = row.quantity != Quantity::plain && row.quantity != Quantity::share;
        const bool maybeKept =
            sameKind || row.object == "stop"; // another kind may mean another thing by a key
        for (const Parameter& old : kindFor(earlier).rows()) {
            if (dependsOnTheTable || !maybeKept || old.key != row.key || old.object != row.object)
                continue;
            const ParameterValue value = old.get(earlier);
            const bool isNumber = std::visit(
                [](const auto& of) { return std::is_arithmetic_v<std::decay_t<decltype(of)>>; }, value);
            if (isNumber && value.index() == row.get(spec).index())
                row.set(spec, value);
        }
    }
    return spec;
}

std::string_view kindOf(const ProcedureSpec& spec) noexcept {
    return std::visit([](const auto& of) { return of.kKind; }, spec);
}

core::Result<ProcedureFactory> procedureFactory(const ProcedureSpec& spec) {
    return kindFor(spec).factory(spec);
}

core::Result<std::unique_ptr<Procedure>> makeProcedure(const ProcedureSpec& spec, std::uint64_t seed) {
    const auto factory = procedureFactory(spec);
    CHIRON_TRY(factory);
    return (*factory)(seed);
}

} // namespace chiron::psychophysics
