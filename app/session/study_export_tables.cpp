// SPDX-License-Identifier: GPL-3.0-or-later
#include "session/study_export_tables.h"

#include "core/languages.h"
#include "psychophysics/measures/instrument_score.h"
#include "session/study/questionnaire_replies.h"
#include "session/study/trial_fidelity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace chiron::session {

namespace {

using psychophysics::QuestionnaireItem;

const std::vector<std::pair<QString, QString>> kYesNo{{"1", "yes"}, {"0", "no"}};

QString text(std::string_view words) {
    return words.empty() ? kNotAvailable
                         : QString::fromUtf8(words.data(), static_cast<qsizetype>(words.size()));
}

std::vector<ExportColumn> ownerColumns() {
    return {{"protocol_sha256", "",
             "SHA-256 of the frozen protocol (design.json, which is left out while the study is blinded)"},
            {"participant", "", "random code; who it is stays in the study's key table"}};
}

std::vector<ExportColumn> runOwnerColumns() {
    auto columns = ownerColumns();
    columns.push_back(
        {"condition", "", "id of the condition in design.json; its sealed code while the study is blinded"});
    columns.push_back({"run", "1", "from 1: among this participant's runs of this condition"});
    return columns;
}

QStringList runOwner(const StudyExportData& data, const ExportedParticipant& participant,
                     const ExportedRun& run) {
    return {data.sha256(), QString::fromStdString(participant.participant.code), run.label,
            QString::number(run.index)};
}

QString stateWord(database::StudyRunState state) {
    return state == database::StudyRunState::open        ? QStringLiteral("open")
           : state == database::StudyRunState::completed ? QStringLiteral("completed")
                                                         : QStringLiteral("stopped");
}

QString stateWord(database::ParticipantState state) {
    constexpr std::array<const char*, 4> words{"enrolled", "consented", "completed", "withdrawn"};
    return QLatin1String(words[static_cast<std::size_t>(state)]);
}

/// Total pauses of the trials that store them; NaN if none does.
double pausedIn(const std::vector<database::StudyTrial>& trials) {
    double sum = std::numeric_limits<double>::quiet_NaN();
    for (const database::StudyTrial& trial : trials)
        if (const double paused_s = pausedOf(trial.fidelityJson); std::isfinite(paused_s))
            sum = (std::isfinite(sum) ? sum : 0.0) + paused_s;
    return sum;
}

/// The distinct values of a circumstance over a run's trials.
QString eachOf(const std::vector<database::StudyTrial>& trials, std::string TrialCircumstances::*member) {
    QStringList words;
    for (const database::StudyTrial& trial : trials) {
        const QString word = QString::fromStdString(circumstancesOf(trial.fidelityJson).*member);
        if (!word.isEmpty() && !words.contains(word))
            words << word;
    }
    return words.isEmpty() ? kNotAvailable : words.join(u'|');
}

QString forceWord(const std::optional<bool>& felt) {
    return !felt ? kNotAvailable : *felt ? QStringLiteral("felt") : QStringLiteral("shown");
}

/// The devices of all sessions of a run. That of a single trial is in the trials table.
QStringList deviceCells(const StudyExportData& data, const std::vector<database::StudyTrial>& trials) {
    QStringList devices;
    std::optional<bool> felt;
    for (const database::StudyTrial& trial : trials) {
        if (!trial.felt)
            continue;
        felt = felt.value_or(true) && *trial.felt;
        if (const QString device = QString::fromStdString(trial.device); !devices.contains(device))
            devices << device;
    }
    return {data.sealed || devices.isEmpty() ? kNotAvailable : devices.join(QStringLiteral(", ")),
            data.sealed ? kNotAvailable : forceWord(felt)};
}

const QuestionnaireItem* itemOf(const StudyExportData& data, const database::QuestionnaireAnswer& answer) {
    for (const auto& questionnaire : data.design->questionnaires)
        for (const QuestionnaireItem& item : questionnaire.items)
            if (questionnaire.id == answer.questionnaire && item.id == answer.item)
                return &item;
    return nullptr;
}

/// A question of those asked at enrolment. Free texts are not exported, as elsewhere.
struct EnrolmentField {
    const psychophysics::Questionnaire* of;
    const QuestionnaireItem* item;
};

std::vector<EnrolmentField> enrolmentFields(const StudyExportData& data) {
    std::vector<EnrolmentField> fields;
    for (const psychophysics::Questionnaire& questionnaire : data.design->questionnaires)
        if (questionnaire.when == psychophysics::Questionnaire::When::enrolment)
            for (const QuestionnaireItem& item : questionnaire.items)
                if (item.kind != QuestionnaireItem::Kind::text)
                    fields.push_back({&questionnaire, &item});
    return fields;
}

QString fieldWords(const psychophysics::StudyText& words) {
    const auto found = words.find("en");
    return found == words.end() ? QString() : QString::fromStdString(found->second);
}

/// The column is named like the question, preceded by the questionnaire's name if that name is taken.
ExportColumn enrolmentColumn(const EnrolmentField& field, const std::vector<ExportColumn>& taken) {
    const QString id = QString::fromStdString(field.item->id);
    const bool free = std::none_of(taken.begin(), taken.end(),
                                   [&](const ExportColumn& column) { return column.name == id; });
    ExportColumn column{free ? id : QString::fromStdString(field.of->id) + u'_' + id, "",
                        fieldWords(field.item->text) +
                            QStringLiteral("; as written down at the enrolment, n/a where it was not")};
    for (std::size_t i = 0; i < field.item->choices.size(); ++i)
        column.levels.emplace_back(QString::number(i), fieldWords(field.item->choices[i]));
    return column;
}

QString enrolmentCell(const StudyExportData& data, const EnrolmentField& field,
                      database::ParticipantNumber participant) {
    for (const database::QuestionnaireAnswer& answer : data.answers)
        if (answer.participant == participant && answer.questionnaire == field.of->id &&
            answer.item == field.item->id && answer.number)
            return exportNumber(*answer.number);
    return kNotAvailable;
}

/// Empty if the participant did not answer this part.
std::optional<psychophysics::QuestionnaireReply> replyOf(const AnsweredPart& part,
                                                         database::ParticipantNumber participant) {
    psychophysics::QuestionnaireReply reply;
    for (const database::QuestionnaireAnswer& answer : part.answers)
        if (answer.participant == participant && answer.number)
            reply.numbers[answer.item] = *answer.number;
    return reply.numbers.empty() ? std::nullopt : std::optional(std::move(reply));
}

/// The columns with the condition that an answer is about, and with the score of answers.
const ExportColumn kAbout{"condition", "",
                          "that it is about, where the questionnaire is asked after each: its id in "
                          "design.json, its sealed code while blinded; n/a where it is asked once"};

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
    const std::vector<ExportColumn> more{
        {"position", "1", "in the participant's order of conditions, from 0; n/a while blinded"},
        {"task", "", "what was asked; n/a while blinded where conditions differ in it"},
        {"attribute", "", "what differed; n/a while blinded"},
        {"reference", "SI", "value of the reference, in `unit`; n/a while blinded"},
        {"unit", "", "of the attribute; n/a while blinded"},
        {"procedures", "", "kind and version of the adaptive procedures; n/a while blinded"},
        {"seed", "", "of everything drawn in the run, 64 bits; n/a while blinded"},
        {"state",
         "",
         "how far it went",
         {{"open", "not finished; it can be resumed"},
          {"completed", "ended by its stop rule"},
          {"stopped", "ended before that"}}},
        {"presentations", "1",
         "all of them; n/a, as the counts that follow, while blinded where conditions differ"},
        {"practice", "1", "of these, practice"},
        {"spoiled", "1", "of these, spoiled and presented again"},
        {"interrupted", "1", "of these, interrupted because the run was stopped"},
        {"scored", "1", "of these, scored"},
        {"paused_s", "s",
         "pauses within presentations, in which no clock ran; n/a where it was not measured"},
        {"language", "",
         "that the participant read, of several sittings separated by |; n/a in simulated runs, where it was "
         "not recorded yet, and while blinded where conditions differ"},
        {"masking_sound", "", "what was heard (as in trials), of several separated by |; n/a as language"}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    for (const ExportColumn& column : deviceColumns())
        table.columns.push_back(column);
    for (const ExportedParticipant& participant : data.participants) {
        for (const ExportedRun& run : participant.runs) {
            const auto count = [&](auto&& which) {
                return data.sealed
                           ? kNotAvailable
                           : QString::number(std::count_if(run.trials.begin(), run.trials.end(), which));
            };
            const auto& stimulus = run.condition->stimulus;
            table.rows.push_back(
                runOwner(data, participant, run) +
                QStringList{
                    data.blinded ? kNotAvailable : QString::number(run.run.position),
                    data.blinded && !data.oneTask ? kNotAvailable
                                                  : text(psychophysics::token(run.condition->task)),
                    data.blinded ? kNotAvailable : text(psychophysics::token(stimulus.attribute)),
                    data.blinded ? kNotAvailable : exportNumber(stimulus.reference),
                    data.blinded ? kNotAvailable : text(psychophysics::unitOf(stimulus.attribute)),
                    data.blinded ? kNotAvailable : text(run.run.procedures),
                    data.blinded ? kNotAvailable : QString::number(run.run.seed), stateWord(run.run.state),
                    count([](const auto&) { return true; }), count([](const auto& t) { return t.practice; }),
                    count([](const auto& t) { return database::isRepeated(t); }),
                    count([](const auto& t) { return !t.practice && t.spoiled == database::kInterrupted; }),
                    data.sealed ? kNotAvailable : QString::number(scoredTrialsOf(run.trials).size()),
                    exportNumber(pausedIn(run.trials)), eachOf(run.trials, &TrialCircumstances::language),
                    eachOf(run.trials, &TrialCircumstances::masking)} +
                deviceCells(data, run.trials));
        }
    }
    return table;
}

std::vector<ExportColumn> deviceColumns() {
    return {{"device", "", "what it was done on; n/a without rendering (quick runs)"},
            {"force_class",
             "",
             "whether force was felt; n/a without rendering",
             {{"felt", "the device renders force"},
              {"shown", "it renders none in at least one trial: objects were shown, not felt, and groups "
                        "leave the run out"}}}};
}

ExportTable qualityTable(const StudyExportData& data) {
    ExportTable table{"quality",
                      "how well each participant's trials went, over all conditions together",
                      ownerColumns(),
                      {}};
    const QString later = QStringLiteral("; n/a while blinded until every condition is completed");
    const std::vector<ExportColumn> more{
        {"conditions_done", "1", "completed runs"},
        {"conditions", "1", "of the study"},
        {"late_ticks", "1",
         "share of ticks that were late, mean over trials; n/a where nothing was rendered"},
        {"worst_lateness", "us", "of a tick"}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    for (const ExportColumn& column : deviceColumns())
        table.columns.push_back(column);
    const std::vector<ExportColumn> whole{
        {"presentations", "1", "all of them" + later},
        {"practice", "1", "of these, practice" + later},
        {"scored", "1", "of these, scored" + later},
        {"repeated", "", "why and how often trials were repeated, separated by |" + later},
        {"exploration_time", "s", "until the answer, median over scored trials" + later}};
    table.columns.insert(table.columns.end(), whole.begin(), whole.end());
    for (const ExportedParticipant& each : data.participants)
        for (const database::ParticipantQuality& quality : data.quality) {
            if (quality.participant != each.participant.id)
                continue;
            const auto told = [&](int count) {
                return quality.whole ? QString::number(count) : kNotAvailable;
            };
            QStringList reasons;
            for (const auto& [reason, count] : quality.spoiled)
                reasons << QStringLiteral("%1: %2").arg(QString::fromStdString(reason)).arg(count);
            table.rows.push_back(
                {data.sha256(), QString::fromStdString(each.participant.code),
                 QString::number(quality.conditionsDone), QString::number(quality.conditions),
                 exportNumber(quality.lateTicks), exportNumber(quality.worstLateness_us),
                 quality.device.empty() ? kNotAvailable : QString::fromStdString(quality.device),
                 forceWord(quality.felt), told(quality.presentations), told(quality.practice),
                 told(quality.scored),
                 reasons.isEmpty() ? kNotAvailable : reasons.join(QStringLiteral(" | ")),
                 exportNumber(quality.exploration_s)});
        }
    return table;
}

ExportTable scoresTable(const StudyExportData& data) {
    ExportTable table{
        "scores", "what instruments make of their answers, by their published rules", ownerColumns(), {}};
    const std::vector<ExportColumn> more{
        {"questionnaire", "", "its id in design.json"},
        {"rule",
         "",
         "by which it is scored",
         {{"sus", "System Usability Scale, 0 to 100 (Brooke 1996)"},
          {"nasa_tlx_raw", "mean of the six scales, 0 to 100 (Hart 2006)"},
          {"nasa_tlx_weighted", "weighted by the 15 pairs, 0 to 100 (Hart & Staveland 1988)"},
          {"laterality_quotient", "-100 left to 100 right (Oldfield 1971)"}}},
        {"score", "", "which figure: workload the index, and each of its scales by the question's id"},
        {"value", "1", "n/a where an answer that it takes was not given"},
        kAbout};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    for (const psychophysics::Questionnaire& questionnaire : data.design->questionnaires)
        for (const AnsweredPart& part : answeredParts(*data.design, questionnaire, data.answers))
            for (const ExportedParticipant& each : data.participants) {
                const auto reply = replyOf(part, each.participant.id);
                if (!reply)
                    continue;
                for (const psychophysics::InstrumentScore& score :
                     psychophysics::instrumentScores(questionnaire, *reply))
                    table.rows.push_back({data.sha256(), QString::fromStdString(each.participant.code),
                                          text(questionnaire.id), text(questionnaire.score), text(score.id),
                                          exportNumber(score.value), text(part.label)});
            }
    return table;
}

ExportTable participantsTable(const StudyExportData& data) {
    ExportTable table{"participants", "who took part, by random code", ownerColumns(), {}};
    const std::vector<ExportColumn> more{{"simulated", "", "an observer in software, not a person", kYesNo},
                                         {"observer", "", "of a simulated one: what it is made of"},
                                         {"order", "1", "row of the order design, from 0; n/a while blinded"},
                                         {"state",
                                          "",
                                          "how far",
                                          {{"enrolled", "no consent yet"},
                                           {"consented", "taking part"},
                                           {"completed", "all done"},
                                           {"withdrawn", "took no further part"}}},
                                         {"consented", "", "consent is recorded", kYesNo}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    const auto fields = enrolmentFields(data);
    for (const EnrolmentField& field : fields)
        table.columns.push_back(enrolmentColumn(field, table.columns));
    for (const ExportedParticipant& each : data.participants) {
        const database::Participant& p = each.participant;
        QStringList row{data.sha256(),
                        QString::fromStdString(p.code),
                        exportFlag(p.simulated),
                        text(p.observer),
                        data.blinded ? kNotAvailable : QString::number(p.order),
                        stateWord(p.state),
                        exportFlag(!p.consentUtc.empty())};
        for (const EnrolmentField& field : fields)
            row << enrolmentCell(data, field, p.id);
        table.rows.push_back(row);
    }
    return table;
}

ExportTable questionnairesTable(const StudyExportData& data) {
    ExportTable table{"questionnaires", "answers to the study's questionnaires", ownerColumns(), {}};
    const std::vector<ExportColumn> more{
        {"questionnaire", "", "its id in design.json"},
        {"item", "", "the question's id"},
        {"construct", "", "what it is summarised under"},
        {"kind",
         "",
         "of the question",
         {{"likert", "1 to the scale's end"},
          {"number", "a number"},
          {"choice", "index of the choice, from 0"},
          {"text", "free text, which stays behind"}}},
        {"answer", "1",
         "n/a for free text and what was not answered; of conditions also while blinded where they differ"},
        {"text_given", "", "a free text was written; n/a while blinded as the answer", kYesNo},
        kAbout,
        {"language", "",
         QStringLiteral("in which the question was shown (%1); n/a where it was not recorded")
             .arg(QString::fromStdString(core::listOfLanguages()))}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    std::map<database::ParticipantNumber, QString> codes;
    for (const ExportedParticipant& each : data.participants)
        codes[each.participant.id] = QString::fromStdString(each.participant.code);
    for (const database::QuestionnaireAnswer& answer : data.answers) {
        const QuestionnaireItem* item = itemOf(data, answer);
        table.rows.push_back(
            {data.sha256(),
             codes.count(answer.participant) > 0 ? codes.at(answer.participant) : kNotAvailable,
             text(answer.questionnaire), text(answer.item), item ? text(item->construct) : kNotAvailable,
             item ? kindWord(item->kind) : kNotAvailable,
             answer.number ? exportNumber(*answer.number) : kNotAvailable,
             answer.withheld ? kNotAvailable : exportFlag(!answer.text.empty()), text(labelOf(answer)),
             text(answer.language)});
    }
    return table;
}

ExportTable estimatesTable(const StudyExportData& data) {
    ExportTable table{"estimates", "what each run says", runOwnerColumns(), {}};
    const std::vector<ExportColumn> more{
        {"trials", "1",
         "scored ones that it rests on; n/a, as all that follows, while blinded where conditions differ"},
        {"weber", "1", "Weber fraction, of 75 % correct in 2AFC whatever the task and its criterion"},
        {"weber_low", "1", "lower end of its 95 % interval"},
        {"weber_high", "1", "upper end"},
        {"jnd", "SI", "just noticeable difference at the reference; n/a while blinded"},
        {"unit", "", "of jnd and pse; n/a while blinded"},
        {"sigma_log10", "log10", "internal noise, standard deviation"},
        {"sigma_low", "log10", "lower end of its 95 % interval"},
        {"sigma_high", "log10", "upper end"},
        {"pse", "SI", "point of subjective equality, where the task has one; n/a while blinded"},
        {"tie", "1",
         "difference felt, in sigma, below which objects are called equal (rank3_ties alone); n/a while "
         "blinded where conditions differ in the task"},
        {"tie_low", "1", "lower end of its 95 % interval"},
        {"tie_high", "1", "upper end"},
        {"exponent", "1",
         "of the power law that numbers follow (magnitude estimation alone); n/a while blinded where "
         "conditions differ in the task"},
        {"exponent_low", "1", "lower end of its 95 % interval"},
        {"exponent_high", "1", "upper end"},
        {"criterion", "1",
         "proportion correct that the condition's own procedure and curve go by; weber, jnd and sigma are of "
         "75 % correct in 2AFC whatever it is"},
        {"method", "", "how it was got"},
        {"warnings", "", "what to know before using it, separated by |"}};
    table.columns.insert(table.columns.end(), more.begin(), more.end());
    for (const ExportedParticipant& participant : data.participants) {
        for (const ExportedRun& run : participant.runs) {
            const psychophysics::RunEstimate& e = run.estimate;
            QStringList warnings;
            for (const psychophysics::Warning& warning : e.warnings)
                warnings << (data.blinded ? QString::fromUtf8(warningToken(warning.kind))
                                          : text(warningText(warning)));
            const bool sameWay = !data.blinded || data.oneTask;
            table.rows.push_back(
                runOwner(data, participant, run) +
                QStringList{data.sealed ? kNotAvailable : QString::number(e.trials), exportNumber(e.weber),
                            exportNumber(e.weber95.low), exportNumber(e.weber95.high),
                            data.blinded ? kNotAvailable : exportNumber(e.jnd),
                            data.blinded ? kNotAvailable : text(e.unit), exportNumber(e.sigma_log10),
                            exportNumber(e.sigma95.low), exportNumber(e.sigma95.high),
                            data.blinded ? kNotAvailable : exportNumber(e.pse),
                            sameWay ? exportNumber(e.tie) : kNotAvailable,
                            sameWay ? exportNumber(e.tie95.low) : kNotAvailable,
                            sameWay ? exportNumber(e.tie95.high) : kNotAvailable,
                            sameWay ? exportNumber(e.exponent) : kNotAvailable,
                            sameWay ? exportNumber(e.exponent95.low) : kNotAvailable,
                            sameWay ? exportNumber(e.exponent95.high) : kNotAvailable,
                            sameWay ? exportNumber(e.criterion) : kNotAvailable,
                            sameWay ? QString::fromUtf8(methodText(e.method)) : kNotAvailable,
                            warnings.isEmpty() ? kNotAvailable : warnings.join(u'|')});
        }
    }
    return table;
}

} // namespace chiron::session
