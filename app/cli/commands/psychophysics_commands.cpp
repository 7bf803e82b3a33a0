// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_groups.h"
#include "cli/psychophysics/fit_data.h"
#include "cli/psychophysics/handlers.h"
#include "psychophysics/procedures/procedure_catalogue.h"

namespace chiron::cli {

namespace {

CommandSpec command(const char* verb, const char* summary, const char* example,
                    decltype(CommandSpec::run) run) {
    CommandSpec row;
    row.group = QStringLiteral("psychophysics");
    row.verb = QString::fromUtf8(verb);
    row.summary = QString::fromUtf8(summary);
    row.example = QString::fromUtf8(example);
    row.run = run;
    return row;
}

void append(std::vector<OptionSpec>& options, const std::vector<OptionSpec>& more) {
    options.insert(options.end(), more.begin(), more.end());
}

CommandSpec fitting() {
    CommandSpec row = command("fit", "fit a psychometric function",
                              "chiron-cli psychophysics fit DATA.csv --function weibull --method bayes "
                              "--guess 0.5 --lapse free --json",
                              fitCurve);
    row.operands = {{"DATA.csv", "columns intensity,n_correct,n_total; rows of one intensity are put "
                                 "together; or single trials, see --correct"}};
    row.options = curveOptions();
    append(row.options,
           {{"by", "COLUMN[,COLUMN]", "one fit for each value there (participants, conditions)"}});
    append(row.options, answerOptions());
    append(
        row.options,
        {{"method", "WORD", "bayes (psignifit's priors) or ml; default: bayes"},
         {"prior", "WORD",
          "bayes, of the width: psignifit, open_below (down to a step), open_above (to nine ranges), wide "
          "(both), or auto (psignifit's, and intervals open at the ends at which it, and not the answers, "
          "would decide); default: auto"},
         {"confidence", "C", "of the intervals; default: 0.95"},
         {"threshold-at", "P", "also the intensity at this proportion (of the curve with guess and lapse)"},
         {"unscaled", {}, "--threshold-at means the curve without guess and lapse"},
         {"reference", "R", "also the Weber fraction JND/R"},
         {"bootstrap", "N",
          "ml: intervals from this many bootstrap fits (BCa) instead of the likelihood's profile"},
         {"nonparametric", {}, "--bootstrap draws from each level's answers, not from the fitted curve"},
         {"monte-carlo", "N", "p_value from this many simulated data sets, not from chi-square"},
         {"curve", "N", "also the fitted curve and its band at this many points"},
         {"seed", "S", "of what is drawn; default: 1"}});
    return row;
}

CommandSpec comparing() {
    CommandSpec row = command("compare",
                              "do groups differ in threshold, width, lapse or guess: likelihood ratio and "
                              "AIC of two models, of answers at intensities that were fixed beforehand",
                              "chiron-cli psychophysics compare TRIALS.csv --by condition --test threshold "
                              "--shared width,lapse --monte-carlo 1000 --json",
                              compareModels);
    row.operands = {{"DATA.csv", "as of fit: columns intensity,n_correct,n_total, or single trials"}};
    row.options = {
        {"by", "COLUMN[,COLUMN]", "the groups that are compared, 2 to 50", true},
        {"test", "A,B,...",
         "what may differ: threshold, width, lapse, guess; the smaller model has it in common, the larger "
         "each group's own; default: threshold"},
        {"shared", "A,B,...",
         "what groups have in common in both models: the same words, or none; default: lapse,guess"}};
    append(row.options, curveOptions());
    append(row.options, answerOptions());
    append(row.options,
           {{"monte-carlo", "N",
             "p_value from this many sets of answers drawn from the smaller model, not from chi-square"},
            {"seed", "S", "of what is drawn; default: 1"}});
    return row;
}

CommandSpec adapting() {
    CommandSpec row = command(
        "adaptive",
        "run an adaptive procedure over lines: one response in, one JSON line with the next stimulus out",
        "printf '1\\n0\\nundo\\n' | chiron-cli psychophysics adaptive --procedure SPEC.json", runAdaptive);
    row.options = {{"procedure", "SPEC.json",
                    QString::fromStdString(psychophysics::procedureKindIds(" or ")) +
                        "; keys: curriculum/content/schema/procedure.json",
                    true},
                   {"seed", "S", "of what the procedure draws; default: 1"}};
    return row;
}

CommandSpec detecting() {
    CommandSpec row = command("dprime", "d' of counts or proportions",
                              "chiron-cli psychophysics dprime --task 2afc --correct 38 --total 50 --json",
                              detectionTables);
    row.operands = {{"TABLE.csv",
                     "hits,misses,false_alarms,correct_rejections (yes-no, same-different), else "
                     "n_correct,n_total; a row a case",
                     false}};
    row.options = {{"task", "NAME",
                    "yes-no, 2afc, mafc, same-different, triangle, oddity, abx or tetrad; default: yes-no"},
                   {"m", "M", "alternatives of mafc; default: 3"},
                   {"rule", "WORD",
                    "differencing or independent (triangle, oddity, abx, same-different); default: "
                    "differencing, oddity: independent"},
                   {"hits", "N", "yes (different) where it was there (different)"},
                   {"misses", "N", "no (same) where it was there"},
                   {"false-alarms", "N", "yes (different) where it was not"},
                   {"correct-rejections", "N", "no (same) where it was not"},
                   {"correct", "N", "right answers"},
                   {"total", "N", "of this many"},
                   {"proportion", "P", "proportion right, instead of --correct and --total"},
                   {"uncorrected", {}, "without the log-linear correction (Hautus 1995) of yes-no rates"}};
    return row;
}

CommandSpec ranking() {
    CommandSpec row = command(
        "rank",
        "Kendall's W and tau, Page's L, Thurstone and Plackett-Luce of rankings; Bradley-Terry of pairs",
        "chiron-cli psychophysics rank RANKINGS.csv --order soft,medium,hard --json", rankings);
    row.operands = {{"RANKINGS.csv", "a row a judge, a column an object, ranks from 1 (best), ties alike; or "
                                     "pairs: winner,loser[,count]"}};
    row.options = {
        {"order", "A,B,...",
         "the order expected for Page's L and Kendall's tau, lowest rank first; default: as the columns "
         "stand"},
        {"regularise", "X",
         "this many wins of each over each are added where data alone give no finite worths; default: 0"}};
    return row;
}

} // namespace

std::vector<CommandSpec> psychophysicsCommands() {
    return {fitting(), comparing(), adapting(), detecting(), ranking()};
}

} // namespace chiron::cli
