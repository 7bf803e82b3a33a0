// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study_export_tables.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace chiron::session {

namespace {

using psychophysics::QuestionnaireItem;

const std::vector<std::pair<QString, QString>> kYesNo{{"1", "yes"}, {"0", "no"}};

QString text(std::string_view words) {
    return words.empty() ? kNotAvailable : QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

std::vector<ExportColumn> ownerColumns() {
    return {{"protocol_sha256", "", "SHA-256 of the frozen protocol (design.json, which is left out while the study is blinded)"}, {"participant", "", "random code; who it is stays in the study's key table"}};
}

std::vector<ExportColumn> runOwnerColumns() {
    auto columns = ownerColumns();
    columns.push_back({"condition", "", "id of the condition in design.json; its sealed code while the study is blinded"});
    columns.push_back({"run", "1", "from 1: among this participant's runs of this condition"});
    return columns;
}

QStringList runOwner(const StudyExportData& data, const ExportedParticipant& participant, const ExportedRun& run) {
    return {data.sha256(), QString::fromStdString(participant.participant.code), run.label, QString::number(run.index)};
}

QString stateWord(database::StudyRunState state) {
    return state == database::StudyRunState::open ? QStringLiteral("open") : state == database::StudyRunState::completed ? QStringLiteral("completed") : QStringLiteral("stopped");
}

QString stateWord(database::ParticipantState state) {
    constexpr std::array<const char*, 4> words{"enrolled", "consented", "completed", "withdrawn"};
    return QLatin1String(words[static_cast<std::size_t>(state)]);
}

const QuestionnaireItem* itemOf(const StudyExportData& data, const database::QuestionnaireAnswer& answer) {
    for (const auto& questionnaire : data.design->questionnaires)
        for (const QuestionnaireItem& item : questionnaire.items)
            if (questionnaire.id == answer.questionnaire && item.id == answer.item)
                return &item;
    return nullptr;
}

QString kindWord(QuestionnaireItem::Kind kind) {
    constexpr std::array<const char*, 4> words{"likert", "number", "choice", "text"};
    return QLatin1String(words[static_cast<std::size_t>(kind)]);
}

} // namespace

ExportTable trialsTable(const StudyExportData& data) {
    ExportTable table{"trials", "every presentation of every run", runOwnerColumns(), {}};
    const auto columns = trialColumns();
    table.columns.insert(table.columns.end(), columns.begin(), columns.end());
    for (const ExportedParticipant& participant : data.participants)
        for (const ExportedRun& run : participant.runs)
            for (const database::StudyTrial& trial : run.trials)
                table.rows.push_back(runOwner(data, participant, run) + trialCells(data, run, trial));
    return table;
}

ExportTable runsTable(const StudyExportData& data) {
    ExportTable table{"runs", "one condition done by one participant", runOwnerColumns(), {}};
    const std::vector<ExportColumn> more{{"position", "1", "in the participant's order of conditions, from 0; n/a while blinded"},
                                         {"task", "", "what was asked; n/a while blinded where conditions differ in it"},
                                         {"attribute", "", "what differed; n/a while blinded"},
                                         {"reference", "SI", "value of the reference, in `unit`; n/a while blinded"},
                                         {"unit", "", "of the attribute; n/a while blinded"},
                                         {"procedures", "", "kind and version of the adaptive procedures; n/a while blinded"},
                                         {"seed", "", "of everything drawn in the run, 64 bits; n/a while blinded"},
                                         {"state", "", "how far it went", {{"open", "to be gone on with"}, {"completed", "by its stop rule"}, {"stopped", "before"}}},
                                         {"presentations", "1", "all of them"},
                                         {"practice", "1", "of these, practice"},
                                         {"spoiled", "1", "of these, spoiled and presented again"},
                                         {"scored", "1", "of these, scored"}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    for (const ExportedParticipant& participant : data.participants) {
        for (const ExportedRun& run : participant.runs) {
            const auto count = [&](auto&& which) { return QString::number(std::count_if(run.trials.begin(), run.trials.end(), which)); };
            const auto& stimulus = run.condition->stimulus;
            table.rows.push_back(runOwner(data, participant, run) +
                                 QStringList{data.blinded ? kNotAvailable : QString::number(run.run.position),
                                             data.blinded && !data.oneTask ? kNotAvailable : text(psychophysics::token(run.condition->task)),
                                             data.blinded ? kNotAvailable : text(psychophysics::token(stimulus.attribute)),
                                             data.blinded ? kNotAvailable : exportNumber(stimulus.reference),
                                             data.blinded ? kNotAvailable : text(psychophysics::unitOf(stimulus.attribute)), data.blinded ? kNotAvailable : text(run.run.procedures),
                                             data.blinded ? kNotAvailable : QString::number(run.run.seed), stateWord(run.run.state),
                                             QString::number(run.trials.size()), count([](const auto& t) { return t.practice; }),
                                             count([](const auto& t) { return !t.practice && !t.spoiled.empty(); }),
                                             QString::number(scoredTrialsOf(run.trials).size())});
        }
    }
    return table;
}

ExportTable participantsTable(const StudyExportData& data) {
    ExportTable table{"participants", "who took part, by random code", ownerColumns(), {}};
    const std::vector<ExportColumn> more{{"simulated", "", "an observer in software, not a person", kYesNo},
                                         {"observer", "", "of a simulated one: what it is made of"},
                                         {"order", "1", "row of the order design, from 0; n/a while blinded"},
                                         {"state", "", "how far", {{"enrolled", "no consent yet"}, {"consented", "taking part"}, {"completed", "all done"}, {"withdrawn", "took no further part"}}},
                                         {"consented", "", "consent is recorded", kYesNo}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    for (const ExportedParticipant& each : data.participants) {
        const database::Participant& p = each.participant;
        table.rows.push_back({data.sha256(), QString::fromStdString(p.code), exportFlag(p.simulated), text(p.observer),
                              data.blinded ? kNotAvailable : QString::number(p.order),
                              stateWord(p.state), exportFlag(!p.consentUtc.empty())});
    }
    return table;
}

ExportTable questionnairesTable(const StudyExportData& data) {
    ExportTable table{"questionnaires", "answers to the study's questionnaires", ownerColumns(), {}};
    const std::vector<ExportColumn> more{{"questionnaire", "", "its id in design.json"},
                                         {"item", "", "the question's id"},
                                         {"construct", "", "what it is summarised under"},
                                         {"kind", "", "of the question", {{"likert", "1 to the scale's end"}, {"number", "a number"}, {"choice", "index of the choice, from 0"}, {"text", "free text, which stays behind"}}},
                                         {"answer", "1", "n/a for free text and what was not answered"},
                                         {"text_given", "", "a free text was written", kYesNo}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    std::map<database::ParticipantNumber, QString> codes;
    for (const ExportedParticipant& each : data.participants)
        codes[each.participant.id] = QString::fromStdString(each.participant.code);
    for (const database::QuestionnaireAnswer& answer : data.answers) {
        const QuestionnaireItem* item = itemOf(data, answer);
        table.rows.push_back({data.sha256(), codes.count(answer.participant) > 0 ? codes.at(answer.participant) : kNotAvailable, text(answer.questionnaire),
                              text(answer.item), item ? text(item->construct) : kNotAvailable, item ? kindWord(item->kind) : kNotAvailable,
                              answer.number ? exportNumber(*answer.number) : kNotAvailable, exportFlag(!answer.text.empty())});
    }
    return table;
}

ExportTable estimatesTable(const StudyExportData& data) {
    ExportTable table{"estimates", "what each run says", runOwnerColumns(), {}};
    const std::vector<ExportColumn> more{{"trials", "1", "scored ones that it rests on"},
                                         {"weber", "1", "Weber fraction, of 75 % correct in 2AFC whatever the task and its criterion"},
                                         {"weber_low", "1", "lower end of its 95 % interval"},
                                         {"weber_high", "1", "upper end"},
                                         {"jnd", "SI", "just noticeable difference at the reference; n/a while blinded"},
                                         {"unit", "", "of jnd and pse; n/a while blinded"},
                                         {"sigma_log10", "log10", "internal noise, standard deviation"},
                                         {"sigma_low", "log10", "lower end of its 95 % interval"},
                                         {"sigma_high", "log10", "upper end"},
                                         {"pse", "SI", "point of subjective equality, where the task has one; n/a while blinded"},
                                         {"tie", "1", "difference felt, in sigma, below which objects are called equal (rank3_ties alone); n/a while blinded where conditions differ in the task"},
                                         {"tie_low", "1", "lower end of its 95 % interval"},
                                         {"tie_high", "1", "upper end"},
                                         {"exponent", "1", "of the power law that numbers follow (magnitude estimation alone); n/a while blinded where conditions differ in the task"},
                                         {"exponent_low", "1", "lower end of its 95 % interval"},
                                         {"exponent_high", "1", "upper end"},
                                         {"criterion", "1", "proportion correct that the condition's own procedure and curve go by; weber, jnd and sigma are of 75 % correct in 2AFC whatever it is"},
                                         {"method", "", "how it was got"},
                                         {"warnings", "", "what to know before using it, separated by |"}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    for (const ExportedParticipant& participant : data.participants) {
        for (const ExportedRun& run : participant.runs) {
            const psychophysics::RunEstimate& e = run.estimate;
            QStringList warnings;
            for (const psychophysics::Warning& warning : e.warnings)
                warnings << (data.blinded ? QString::fromUtf8(warningToken(warning.kind)) : text(warningText(warning)));
            const bool sameWay = !data.blinded || data.oneTask;
            table.rows.push_back(runOwner(data, participant, run) +
                                 QStringList{QString::number(e.trials), exportNumber(e.weber), exportNumber(e.weber95.low), exportNumber(e.weber95.high),
                                             data.blinded ? kNotAvailable : exportNumber(e.jnd), data.blinded ? kNotAvailable : text(e.unit),
                                             exportNumber(e.sigma_log10), exportNumber(e.sigma95.low), exportNumber(e.sigma95.high),
                                             data.blinded ? kNotAvailable : exportNumber(e.pse),
                                             sameWay ? exportNumber(e.tie) : kNotAvailable, sameWay ? exportNumber(e.tie95.low) : kNotAvailable,
                                             sameWay ? exportNumber(e.tie95.high) : kNotAvailable,
                                             sameWay ? exportNumber(e.exponent) : kNotAvailable, sameWay ? exportNumber(e.exponent95.low) : kNotAvailable,
                                             sameWay ? exportNumber(e.exponent95.high) : kNotAvailable, sameWay ? exportNumber(e.criterion) : kNotAvailable, sameWay ? QString::fromUtf8(methodText(e.method)) : kNotAvailable,
                                             warnings.isEmpty() ? kNotAvailable : warnings.join(u'|')});
        }
    }
    return table;
}

} // namespace chiron::session
