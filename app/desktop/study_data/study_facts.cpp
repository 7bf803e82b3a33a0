// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/study_data/study_facts.h"

#include <algorithm>

namespace chiron::desktop {

namespace {

std::size_t indexOf(const OpenStudy& study, const database::Participant& participant) {
    const auto found =
        std::find_if(study.participants.begin(), study.participants.end(),
                     [&](const ParticipantRow& row) { return row.participant.id == participant.id; });
    return static_cast<std::size_t>(found - study.participants.begin());
}

std::optional<ApexFacts> apexFacts(const session::AnalysedCondition& condition) {
    if (!condition.apex)
        return std::nullopt;
    ApexFacts facts{*condition.apex, {}};
    for (const session::AnalysedRun& run : condition.runs)
        facts.names.push_back(QString::fromStdString(run.participant.code));
    return facts;
}

} // namespace

core::Result<StudyFacts> studyFacts(database::StudyReader& reader, database::StudyNumber study,
                                    bool withShown) {
    auto open = openStudy(reader, study);
    CHIRON_TRY(open);
    auto analysis = session::analyseStudy(reader, study, open->design.seed, {.withShown = withShown});
    CHIRON_TRY(analysis);
    StudyFacts facts;
    facts.study = std::move(*open);
    facts.quality = analysis->quality;
    facts.sealed = analysis->sealed();
    facts.withShown = withShown;
    facts.comparisons = analysis->comparisons;
    for (std::size_t i = 0; i < analysis->conditions.size(); ++i) {
        facts.designed.push_back(analysis->designed(i) ? std::optional(*analysis->designed(i))
                                                       : std::nullopt);
        facts.groups.push_back(analysis->conditions[i].group);
        facts.rolls.push_back(analysis->conditions[i].roll);
        facts.rankings.push_back(analysis->conditions[i].ranking);
        facts.apexes.push_back(apexFacts(analysis->conditions[i]));
        for (session::AnalysedRun& run : analysis->conditions[i].runs)
            if (const std::size_t participant = indexOf(facts.study, run.participant);
                participant < facts.study.participants.size())
                facts.runs.push_back({participant, i, std::move(run.run), std::move(run.trials),
                                      std::move(run.estimate), run.replayed, run.scored, run.spoiled,
                                      run.felt, std::move(run.apex), std::move(run.ranking), run.presence});
    }
    facts.anyShown = std::any_of(facts.runs.begin(), facts.runs.end(),
                                 [](const RunFacts& run) { return !run.felt.value_or(true); });
    auto answers = reader.questionnaireAnswers(study);
    CHIRON_TRY(answers);
    facts.answers = std::move(*answers);
    return facts;
}

} // namespace chiron::desktop
