// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_groups.h"
#include "cli/study/study_access.h"

namespace chiron::cli {

namespace {

const OptionSpec kParticipant{QStringLiteral("participant"), QStringLiteral("CODE"),
                              QStringLiteral("the participant's code"), true};

const OptionSpec kQuestionnaire{QStringLiteral("questionnaire"), QStringLiteral("ID,..."),
                                QStringLiteral("these alone; default: all of the study")};

CommandSpec row(const char* verb, const char* summary, const char* rest, decltype(CommandSpec::run) run,
                std::vector<OptionSpec> options = {}) {
    CommandSpec command;
    command.group = QStringLiteral("study");
    command.verb = QString::fromUtf8(verb);
    command.summary = QString::fromUtf8(summary);
    command.operands = {
        {"STUDY", "number or key of a study; of run and plan also one of the content, or a JSON file"}};
    command.options = std::move(options);
    command.example = QStringLiteral("chiron-cli study %1 %2").arg(command.verb, QString::fromUtf8(rest));
    command.run = run;
    return command;
}

CommandSpec listing() {
    CommandSpec command = row("list", "the studies that you may see; without --as the simulated ones",
                              "--json", listStudies, {{"archived", {}, "archived ones too"}});
    command.operands = {};
    return command;
}

CommandSpec making() {
    CommandSpec command =
        row("new", "a draft from a study of the content or a file", "stiffness_elastic_tube --as rosa",
            newStudy, {{"id", "KEY", "another key than the design's own"}});
    command.operands = {{"FROM", "id of a study of the content, or a JSON file"}};
    return command;
}

CommandSpec importing() {
    CommandSpec command =
        row("questionnaire import",
            "answers that were given on paper, from a filled template: the whole file is checked, then all "
            "of it is stored or nothing; answers are never changed",
            "surgeons filled.csv --as rosa", importQuestionnaire,
            {{"incomplete", {}, "questions that must be answered may be left out, as on paper"},
             {"language", "CODE", "of the forms; kept with the answers"}});
    command.operands.push_back(
        {"FILE", "CSV (UTF-8) or JSON as study questionnaire template writes it, filled"});
    return command;
}

} // namespace

std::vector<CommandSpec> studyCommands() {
    return {
        listing(),
        row("show", "one study with its design and participants, by codes", "3 --as rosa --json", showStudy),
        making(),
        row("freeze", "fix the design for ever; prints its SHA-256", "3 --as rosa", freezeStudy),
        row("enrol",
            "a participant under a random code; who it is comes from CHIRON_IDENTITY, or as the line after "
            "the password's, and is kept in the key table alone",
            "3 --as rosa --password-stdin", enrolParticipant,
            {{"account", "NAME",
              "the participant has this account: their own export and erasure then reach what they do here; "
              "also kept in the key table alone"}}),
        row("consent", "record that a participant consents", "3 --participant K7M-4QX --as rosa", consentOf,
            {kParticipant, {"language", "CODE", "of the text that was shown; default: en"}}),
        row("withdraw", "a participant takes no further part", "3 --participant K7M-4QX --as rosa",
            withdrawParticipant,
            {kParticipant,
             {"erase-recordings",
              {},
              "the participant wants the recordings erased, too (an administrator does it)"}}),
        row("erase",
            "overwrite who a withdrawn participant was; cannot be undone; the administrator's password "
            "confirms it",
            "3 --participant K7M-4QX --reason \"asked to be forgotten\" --as alice", eraseParticipant,
            {kParticipant, {"reason", "TEXT", "why, kept in the tombstone", true}}),
        row("unblind",
            "conditions go by their names from now on, for ever; warns of people who are still to come",
            "3 --reason \"all participants are done\" --as rosa", unblindStudy,
            {{"reason", "TEXT", "why, without names: it is kept in the audit", true}}),
        row("close", "no more participants and runs", "3 --as rosa", closeStudy),
        row("archive", "out of the usual lists", "3 --as rosa", archiveStudy,
            {{"undo", {}, "back into them"}}),
        row("key", "who the codes are; for the study's author and administrators, audited", "3 --as rosa",
            studyKey),
        row("run",
            "a simulated participant does the study, or goes on with it; makes a missing database, study and "
            "participant",
            "stiffness_elastic_tube --participant S01 --observer weber:0.12,lapse:0.02 --seed 7 --json",
            runStudy,
            {{"participant", "CODE", "the participant's code"},
             {"observer", "SPEC",
              "weber:W[,lapse:L][,bias:B][,ties:T]: W the Weber fraction at 75 % correct in 2AFC; apex: "
              "operator:NAME, a scripted trainee of sphere_apex, which feels for itself (default: "
              "intermediate)"},
             {"person", "CODE", "instead: opens the window at this person's next trial; needs a display"},
             {"seed", "S", "of participant and runs; default: 1"},
             {"quick",
              {},
              "without rendering: the observer is told the values; apex: marks of a simulated observer"},
             {"condition", "ID",
              "this one alone, where the experimenter is not blind; default: all that are not completed, in "
              "order"},
             {"trials", "N", "stop after this many presentations of a run, which can be continued later"}}),
        row("rerun", "run the log again: exit 1 where a stimulus would be chosen differently",
            "3 --as rosa --json", rerunStudy),
        row("plan", "expected bias, precision and minutes before anyone is tested",
            "stiffness_elastic_tube --observer weber:0.12,lapse:0.02 --runs 100 --json", planStudy,
            {{"observer", "SPEC", "weber:W[,lapse:L][,bias:B][,ties:T]", true},
             {"runs", "N", "simulated runs a condition, 0: information alone; default: 100"},
             {"seed", "S", "default: 1"},
             {"power",
              {},
              "also the smallest ratio of two conditions' JNDs that is found, and with --ratio how many "
              "participants find it"},
             {"ratio", "R", "--power: a true ratio of JNDs, e.g. 1.3"},
             {"participants", "N", "--power: how many (unpaired: in each group); default: the design's"},
             {"wanted", "P", "--power: the chance of finding it; default: 0.8"},
             {"alpha", "A", "--power: two-sided; default: 0.05"},
             {"paired", {}, "--power: each participant does both conditions (the default)"},
             {"unpaired", {}, "--power: two groups of people"},
             {"between-sd", "SD",
              "--power: log10 units, between people; paired: of the difference from person to person; "
              "default: 0.15, paired 0.05"}}),
        row("analyse",
            "what each run and each condition's group say, and whether the log chooses the same stimuli "
            "again",
            "3 --as rosa --json", analyseStudies,
            {{"seed", "S", "of bootstraps; default: 1"},
             {"with-shown", {}, "runs on devices that render no force belong to the group, too"}}),
        row("questionnaire template",
            "an empty table to be filled, with a row for each participant who has not answered",
            "surgeons --out answers.csv --as rosa", questionnaireTemplate,
            {{"out", "FILE", "must not be there yet", true},
             {"format", "csv|json", "default: csv"},
             kQuestionnaire,
             {"language", "CODE", "of the questions; default: en"}}),
        importing(),
        row("questionnaire summary", "what was answered: medians, agreement, content validity",
            "surgeons --as rosa --json", summariseQuestionnaires,
            {kQuestionnaire,
             {"texts", {}, "free texts, too: they may tell who wrote them"},
             {"performance",
              {},
              "how answers go with the participants' own results (Kendall's tau; more agreement with better "
              "touch: above 0)"}}),
        row("export", "pseudonymised data with a data dictionary",
            "3 --format csv,bids --out folder --as rosa", exportStudy,
            {{"format", "csv,bids", "which; with both each gets a folder of its own in --out; default: csv"},
             {"out", "FOLDER", "must not be there yet", true}})};
}

} // namespace chiron::cli
