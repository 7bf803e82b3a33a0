// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/rules_page.h"

#include "catalogue/study_json.h"
#include "desktop/frame/app_context.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/participant_sentences.h"
#include "desktop/studies/study_words.h"
#include "desktop/studies/text_claims.h"
#include "desktop/widgets/kit.h"
#include "psychophysics/procedures/procedure_catalogue.h"
#include "session/study/participant_view.h"
#include "session/study/presentation_order.h"

#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <algorithm>

namespace chiron::desktop {

using namespace psychophysics;

namespace {

/// Adds fields of a struct in the design, each with its explanation.
template <class Part> struct PartFields {
    FieldGrid& grid;
    StudyDraft& draft;
    QString prefix;
    Part StudyDesign::*part;
    QString step;

    QString name(const char* key) const { return prefix + QLatin1Char('.') + QLatin1String(key); }
    template <class T> void put(const char* key, T Part::*member, T now) const {
        draft.change(step, name(key), [&](StudyDesign& design) { design.*part.*member = now; });
    }
    void number(const QString& label, const char* key, double Part::*member, const NumberRange& range,
                const QString& meaning, double usual) const {
        grid.number(label, name(key), draft.design().*part.*member, range,
                    [self = *this, key, member](double now) { self.put(key, member, now); });
        grid.explain(name(key), meaning, {range.minimum, range.maximum, usual});
    }
    /// A share, edited in per cent, as is its range.
    void percent(const QString& label, const char* key, double Part::*member, double lowest, double highest,
                 const QString& meaning, double usual) const {
        constexpr double kPercent = 100.0;
        grid.number(label, name(key), kPercent * (draft.design().*part.*member),
                    {lowest, highest, 2, QStringLiteral("%"), 1},
                    [self = *this, key, member](double now) { self.put(key, member, now / kPercent); });
        grid.explain(name(key), meaning, {lowest, highest, usual});
    }
    void whole(const QString& label, const char* key, int Part::*member, int minimum, int maximum,
               const QString& meaning, int usual) const {
        grid.whole(label, name(key), draft.design().*part.*member, minimum, maximum,
                   [self = *this, key, member](int now) { self.put(key, member, now); });
        grid.explain(
            name(key), meaning,
            {static_cast<double>(minimum), static_cast<double>(maximum), static_cast<double>(usual)});
    }
    void check(const QString& label, const char* key, bool Part::*member, const QString& meaning) const {
        grid.check(label, name(key), draft.design().*part.*member,
                   [self = *this, key, member](bool now) { self.put(key, member, now); });
        grid.explain(name(key), meaning);
    }
};

} // namespace

RulesPage::RulesPage(const DesignPage& page, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(page.app.theme().px(16));
    if (!page.masked) // the codes do not say how a condition is run
        column->addWidget(lengthBox(page));
    column->addWidget(rulesBox(page));
    column->addWidget(instructionsBox(page));
    column->addWidget(orderBox(page));
    column->addWidget(fidelityBox(page));
    column->addStretch();
}

namespace {

/// The field of ProcedureForm from which the number of trials of a condition follows.
QString lengthField(const Condition& condition) {
    if (!condition.procedures.empty())
        for (const Parameter& row : kindFor(condition.procedures.front()).rows())
            if (row.isAsked() && (row.key == "trials" || row.key == "repeats"))
                return QStringLiteral("procedure.0.") +
                       QString::fromUtf8(row.key.data(), static_cast<qsizetype>(row.key.size()));
    return QStringLiteral("procedure.0.kind");
}

QString lengthWords(const Condition& condition, const DesignPage& page) {
    const QString title = study_words::text(condition.title, page.app.language());
    const QString name = title.isEmpty() ? QString::fromStdString(condition.id) : title;
    const int most = session::trialsAtMost(condition);
    if (most <= 0)
        return RulesPage::tr("%1: as many trials as the answers need").arg(name);
    return (session::trialsAreFixed(condition)
                ? RulesPage::tr("%1: %n trial(s) that count", nullptr, most)
                : RulesPage::tr("%1: at most %n trial(s) that count", nullptr, most))
        .arg(name);
}

} // namespace

/// The procedure of each condition sets its number of trials. People look for it here, so each line leads to
/// the field.
QWidget* RulesPage::lengthBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Number of trials"));
    auto* lines = new QWidget;
    auto* grid = new QGridLayout(lines);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(theme.px(12));
    grid->setColumnStretch(0, 1);
    const std::vector<Condition>& conditions = page.draft.design().conditions;
    for (std::size_t i = 0; i < conditions.size(); ++i) {
        const int at = static_cast<int>(i);
        auto* words = kit::label(theme, {}, TextStyle::body);
        words->setObjectName(QStringLiteral("length.%1").arg(at));
        auto* change =
            kit::button(theme, page.readOnly ? tr("Show") : tr("Change"), "", QStringLiteral("go-next"));
        change->setObjectName(QStringLiteral("length.change.%1").arg(at));
        connect(change, &QPushButton::clicked, this, [this, at, &draft = page.draft] {
            emit lengthAsked(at, lengthField(draft.design().conditions[static_cast<std::size_t>(at)]));
        });
        const auto show = [words, change, i, page] {
            if (i >= page.draft.design().conditions.size())
                return; // it has just been removed
            words->setText(lengthWords(page.draft.design().conditions[i], page));
            change->setAccessibleName(tr("Change: %1").arg(words->text()));
        };
        connect(&page.draft, &StudyDraft::changed, words, show);
        show();
        grid->addWidget(words, at, 0);
        grid->addWidget(change, at, 1);
    }
    box.layout->addWidget(lines);
    box.layout->addWidget(kit::label(theme,
                                     tr("The procedure of each condition sets this number, on the page "
                                        "Conditions. Practice and repeated trials are not included."),
                                     TextStyle::small, "muted"));
    return box.frame;
}

QWidget* RulesPage::rulesBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Trials and breaks"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    const PartFields<TrialRules> fields{*grid, page.draft, QStringLiteral("trial"), &StudyDesign::trial,
                                        tr("Rules of a trial")};
    const QString s = QStringLiteral("s");
    const std::vector<Condition>& conditions = page.draft.design().conditions;
    const auto any = [&](auto is) { return std::any_of(conditions.begin(), conditions.end(), is); };
    const bool apex = any([](const Condition& each) { return each.stimulus.attribute == Attribute::apex; });
    const bool compares =
        any([](const Condition& each) { return each.stimulus.attribute != Attribute::apex; });
    const bool judged = apex || any([](const Condition& each) { return correctAnswer(each.task, 0) >= 0; });
    fields.number(tr("Time to explore"), "explore_limit", &TrialRules::exploreLimit_s,
                  {0, 3600, 1, s, 1, tr("no limit")},
                  apex && !compares ? tr("A trial without a mark ends after this time; 0: never.")
                                    : tr("The objects go away after this time; 0: never."),
                  30);
    if (compares)
        fields.number(tr("Time to answer"), "answer_limit", &TrialRules::answerLimit_s,
                      {0, 3600, 1, s, 1, tr("no limit")},
                      tr("Time to answer once the objects are gone. Without an answer the trial is repeated. "
                         "0: no limit."),
                      20);
    fields.number(tr("Between trials"), "between_trials", &TrialRules::betweenTrials_s, {0, 60, 1, s, 0.5},
                  tr("Time until the next objects come."), 1);
    fields.whole(tr("Practice trials"), "practice_trials", &TrialRules::practiceTrials, 0, 200,
                 tr("Trials before each condition, at the largest difference and with feedback. They are "
                    "never scored."),
                 4);
    fields.whole(tr("Trials between breaks"), "break_every", &TrialRules::breakEvery, 0, 10000,
                 tr("Participants rest before they go on; 0: never."), 40);
    fields.number(tr("Shortest break"), "break_at_least", &TrialRules::breakAtLeast_s, {0, 3600, 0, s, 10},
                  tr("Participants go on after this time at the earliest."), 30);
    if (judged)
        fields.check(tr("Feedback"), "feedback", &TrialRules::feedback,
                     tr("Participants are told after each trial how well they did. This feedback changes "
                        "what is measured."));
    fields.check(tr("Masking sound"), "masking_sound", &TrialRules::maskingSound,
                 tr("A steady noise hides the sounds of the device. Participants are told of it where it is "
                    "heard."));
    fields.check(tr("Show the objects"), "visible_objects", &TrialRules::visibleObjects,
                 tr("Objects are drawn, all alike, so that only touch tells them apart."));
    if (compares)
        fields.check(tr("Every object must be touched"), "must_touch_all", &TrialRules::mustTouchAll,
                     tr("An answer is accepted only once each object has been touched."));
    if (compares)
        fields.number(tr("Smallest force on an object"), "probe_at_least", &TrialRules::probeAtLeast_N,
                      {0, 100, 2, QStringLiteral("N"), 0.1, tr("any touch")},
                      tr("An object counts as touched only once it was pressed, pulled or lifted with this "
                         "force, so that nobody answers after barely touching it. 0: any touch counts."),
                      kUsualProbe_N);
    const auto showWhatApplies = [grid, &draft = page.draft] {
        // Its clock starts when the exploration time ends.
        grid->setShown(QStringLiteral("trial.answer_limit"), draft.design().trial.exploreLimit_s > 0.0);
        grid->setShown(QStringLiteral("trial.probe_at_least"), draft.design().trial.mustTouchAll);
        grid->setShown(QStringLiteral("trial.break_at_least"), draft.design().trial.breakEvery > 0);
    };
    connect(&page.draft, &StudyDraft::changed, grid, showWhatApplies);
    showWhatApplies();
    box.layout->addWidget(grid);
    return box.frame;
}

/// Edits the researcher's sentences, and below them shows the text that participants read.
QWidget* RulesPage::instructionsBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Instructions"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    const QString name = QStringLiteral("design.instructions");
    addStudyText(*grid, page, tr("Your own sentences"), name, 3, [](StudyDesign& design) -> StudyText& {
        if (!design.ownInstructions)
            design.ownInstructions = design.instructions;
        return *design.ownInstructions;
    });
    grid->explain(name, tr("What to do, and how to hold the instrument. Leave out time, trials, feedback and "
                           "breaks: those sentences are made from the settings and always fit them."));
    box.layout->addWidget(grid);
    if (!page.readOnly)
        box.layout->addWidget(claimsNotice(page, FalseClaim::Where::instructions));
    if (!page.readOnly && !page.draft.design().ownInstructions)
        box.layout->addWidget(
            kit::notice(theme, "info",
                        tr("These instructions were written before the program made sentences from the "
                           "settings. Remove what those sentences now say.")));
    box.layout->addWidget(kit::label(theme, tr("What participants read"), TextStyle::label));
    const kit::Box shown = kit::box(theme, "raised");
    auto* words = kit::label(theme, {}, TextStyle::body);
    words->setObjectName(QStringLiteral("design.instructions.shown"));
    words->setTextInteractionFlags(Qt::TextSelectableByMouse);
    shown.layout->addWidget(words);
    auto* limits = kit::label(theme, {}, TextStyle::body);
    limits->setObjectName(QStringLiteral("design.instructions.limits"));
    limits->setTextInteractionFlags(Qt::TextSelectableByMouse);
    shown.layout->addWidget(limits);
    if (page.masked)
        limits->hide(); // the codes do not say what is done with their objects
    box.layout->addWidget(shown.frame);
    const auto show = [words, limits, readOnly = page.readOnly, &draft = page.draft,
                       language = page.language] {
        StudyDesign design = draft.design();
        if (!readOnly)
            renewInstructions(design); // as it will be stored with the next change
        words->setText(study_words::text(shownInstructions(design), language));
        limits->setText(limitSentences(design, language).join(QLatin1Char(' ')));
    };
    connect(&page.draft, &StudyDraft::changed, words, show);
    show();
    return box.frame;
}

QWidget* RulesPage::orderBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Order and blinding"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    StudyDraft& draft = page.draft;
    const auto blinding = [&](const QString& label, const char* name, bool StudyDesign::*member,
                              const QString& meaning) {
        grid->check(label, QLatin1String(name), draft.design().*member, [&draft, member](bool now) {
            draft.change(RulesPage::tr("Blinding"), {}, [&](StudyDesign& design) { design.*member = now; });
        });
        grid->explain(QLatin1String(name), meaning);
    };
    if (draft.design().conditions.size() > 1) {
        std::vector<std::pair<QString, QVariant>> orders;
        for (const OrderDesign order :
             {OrderDesign::williams, OrderDesign::latinSquare, OrderDesign::random, OrderDesign::fixed})
            orders.emplace_back(study_words::order(order), static_cast<int>(order));
        grid->choice(tr("Order of conditions"), QStringLiteral("design.order"), orders,
                     static_cast<int>(draft.design().order), [&draft](const QVariant& now) {
                         draft.change(RulesPage::tr("Order of conditions"), {}, [&](StudyDesign& design) {
                             design.order = static_cast<OrderDesign>(now.toInt());
                         });
                     });
        grid->explain(QStringLiteral("design.order"),
                      tr("In which order each participant does the conditions. A Williams design also "
                         "balances which condition follows which."));
    }
    blinding(tr("Blind participants"), "design.blind_participant", &StudyDesign::blindParticipant,
             tr("Participants see no values and no names of conditions."));
    if (draft.design().conditions.size() > 1)
        blinding(
            tr("Blind experimenters"), "design.blind_experimenter", &StudyDesign::blindExperimenter,
            tr("Until the study is unblinded, experimenters see sealed codes instead of the conditions."));
    grid->text(
        tr("Seed"), QStringLiteral("design.seed"), QString::number(draft.design().seed),
        [grid, &draft, locale = page.app.locale()](const QString& now) {
            bool good = false;
            const qulonglong seed = now.trimmed().toULongLong(&good);
            good = good && seed <= catalogue::kLargestSeed;
            grid->setUnread(
                QStringLiteral("design.seed"),
                good ? QString()
                     : RulesPage::tr("“%1” was not accepted: enter a whole number from 0 to %2.")
                           .arg(now, locale.toString(static_cast<qulonglong>(catalogue::kLargestSeed))));
            if (good)
                draft.change(RulesPage::tr("Seed"), QStringLiteral("design.seed"),
                             [seed](StudyDesign& design) { design.seed = seed; });
        });
    grid->explain(QStringLiteral("design.seed"),
                  tr("A whole number from which all orders and random choices are drawn: the same number "
                     "gives the same study again."));
    box.layout->addWidget(grid);
    return box.frame;
}

QWidget* RulesPage::fidelityBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Fidelity of a trial"));
    box.layout->addWidget(kit::label(theme,
                                     tr("A trial outside these limits is not scored and is presented again."),
                                     TextStyle::body, "muted"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    const PartFields<FidelityLimits> fields{*grid, page.draft, QStringLiteral("fidelity"),
                                            &StudyDesign::fidelity, tr("Limits of fidelity")};
    fields.number(tr("Force error"), "force_error", &FidelityLimits::forceErrorRms_N,
                  {0.001, 100, 3, QStringLiteral("N"), 0.01},
                  tr("How far the measured force may be from the commanded one (root mean square)."), 0.15);
    fields.percent(tr("Error of the felt value"), "stiffness_error", &FidelityLimits::stiffnessError, 0.1,
                   1000, tr("How far the rendered value may be from the requested one."), 15);
    fields.percent(tr("Late ticks"), "late_ticks", &FidelityLimits::lateTicks, 0, 100,
                   tr("Share of the force's updates that may come too late."), 1);
    fields.percent(tr("Force at its limit"), "saturated", &FidelityLimits::saturated, 0, 100,
                   tr("Share of the contact time during which the device may be at its force limit."), 5);
    fields.number(tr("Largest force"), "peak_force", &FidelityLimits::peakForce_N,
                  {0.01, 100, 2, QStringLiteral("N"), 0.1}, tr("How hard a participant may press."), 4);
    fields.number(tr("Mean speed"), "mean_speed", &FidelityLimits::meanSpeed_m_per_s,
                  {0.001, 10, 3, QStringLiteral("m/s"), 0.01},
                  tr("How fast a participant may move, on average."), 0.2);
    fields.whole(tr("Repeats of one trial"), "repeats_at_most", &FidelityLimits::repeatsAtMost, 1, 100,
                 tr("After this many repeats the run pauses and asks the experimenter."), 5);
    box.layout->addWidget(grid);
    return box.frame;
}

} // namespace chiron::desktop
