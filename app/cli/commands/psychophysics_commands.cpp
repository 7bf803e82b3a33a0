// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command_groups.h"
#include "cli/psychophysics/handlers.h"

namespace chiron::cli {

namespace {

CommandSpec command(const char* verb, const char* summary, const char* example, decltype(CommandSpec::run) run) {
    CommandSpec row;
    row.group = QStringLiteral("psychophysics");
    row.verb = QString::fromUtf8(verb);
    row.summary = QString::fromUtf8(summary);
    row.example = QString::fromUtf8(example);
    row.run = run;
    return row;
}

CommandSpec fitting() {
    CommandSpec row = command("fit", "fit a psychometric function", "chiron-cli psychophysics fit DATA.csv --function weibull --method bayes --guess 0.5 --lapse free --json", fitCurve);
    row.operands = {{"DATA.csv", "columns intensity,n_correct,n_total; rows of one intensity are put together"}};
    row.options = {{"function", "NAME", "logistic, gauss, weibull, gumbel, rgumbel, logn, hyperbolic or tdist; default: gauss"},
                   {"method", "WORD", "bayes (psignifit's priors) or ml; default: bayes"},
                   {"prior", "WORD", "bayes, of the width: psignifit, wide (from a step to nine ranges), or auto (psignifit's, and intervals of the wide one where the answers disagree with it); default: auto"},
                   {"guess", "G", "a proportion, free, or equal (as the lapse); default: 0.5"},
                   {"lapse", "L", "a proportion or free; default: free"},
                   {"scale", "WORD", "axis it is fitted on: linear, ln, log10, db; default: ln for weibull and logn, else linear"},
                   {"confidence", "C", "of the intervals; default: 0.95"},
                   {"threshold-at", "P", "also the intensity at this proportion (of the curve with guess and lapse)"},
                   {"unscaled", {}, "--threshold-at means the curve without guess and lapse"},
                   {"reference", "R", "also the Weber fraction JND/R"},
                   {"bootstrap", "N", "ml: intervals from so many bootstrap fits (BCa) instead of the likelihood's profile"},
                   {"nonparametric", {}, "--bootstrap draws from each level's answers, not from the fitted curve"},
                   {"monte-carlo", "N", "p_value from so many simulated data sets, not from chi-square"},
                   {"curve", "N", "also the fitted curve and its band at so many points"},
                   {"seed", "S", "of what is drawn; default: 1"}};
    return row;
}

CommandSpec adapting() {
    CommandSpec row = command("adaptive", "run an adaptive procedure over lines: one response in, one JSON line with the next stimulus out",
                              "printf '1\\n0\\nundo\\n' | chiron-cli psychophysics adaptive --procedure SPEC.json", runAdaptive);
    row.options = {{"procedure", "SPEC.json", "staircase, pest, constant, descending, quest, quest_plus or rank3_quest_plus; keys: app/cli/README.md", true},
                   {"seed", "S", "of what the procedure draws; default: 1"}};
    return row;
}

CommandSpec detecting() {
    CommandSpec row = command("dprime", "d' of counts or proportions", "chiron-cli psychophysics dprime --task 2afc --correct 38 --total 50 --json", detectionTables);
    row.operands = {{"TABLE.csv", "hits,misses,false_alarms,correct_rejections (yes-no, same-different), else n_correct,n_total; a row a case", false}};
    row.options = {{"task", "NAME", "yes-no, 2afc, mafc, same-different, triangle, oddity, abx or tetrad; default: yes-no"},
                   {"m", "M", "alternatives of mafc; default: 3"},
                   {"rule", "WORD", "differencing or independent (triangle, oddity, abx, same-different); default: differencing, oddity: independent"},
                   {"hits", "N", "yes (different) where it was there (different)"},
                   {"misses", "N", "no (same) where it was there"},
                   {"false-alarms", "N", "yes (different) where it was not"},
                   {"correct-rejections", "N", "no (same) where it was not"},
                   {"correct", "N", "right answers"},
                   {"total", "N", "of so many"},
                   {"proportion", "P", "proportion right, instead of --correct and --total"},
                   {"uncorrected", {}, "without the log-linear correction (Hautus 1995) of yes-no rates"}};
    return row;
}

CommandSpec ranking() {
    CommandSpec row = command("rank", "Kendall's W and tau, Page's L, Thurstone and Plackett-Luce of rankings; Bradley-Terry of pairs",
                              "chiron-cli psychophysics rank RANKINGS.csv --order soft,medium,hard --json", rankings);
    row.operands = {{"RANKINGS.csv", "a row a judge, a column an object, ranks from 1 (best), ties alike; or pairs: winner,loser[,count]"}};
    row.options = {{"order", "A,B,...", "the order expected for Page's L and Kendall's tau, lowest rank first; default: as the columns stand"},
                   {"regularise", "X", "so many wins of each over each are added where data alone give no finite worths; default: 0"}};
    return row;
}

} // namespace

std::vector<CommandSpec> psychophysicsCommands() {
    return {fitting(), adapting(), detecting(), ranking()};
}

} // namespace chiron::cli
