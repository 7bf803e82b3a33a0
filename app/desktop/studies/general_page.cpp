// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/general_page.h"

#include "desktop/frame/app_context.h"
#include "desktop/studies/field_grid.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"

#include <QCoreApplication>

namespace chiron::desktop {

using namespace psychophysics;

void addStudyText(FieldGrid& grid, const DesignPage& page, const QString& label, const QString& name, int lines,
                  const std::function<StudyText&(StudyDesign&)>& text) {
    StudyDesign now = page.draft.design();
    const StudyText& texts = text(now);
    const auto found = texts.find(page.language.toStdString());
    const QString value = found == texts.end() ? QString() : QString::fromStdString(found->second);
    const auto taken = [&draft = page.draft, language = page.language.toStdString(), name, text](const QString& words) {
        draft.change(QCoreApplication::translate("StudyWords", "Text change"), name, [&](StudyDesign& design) {
            StudyText& changed = text(design);
            if (words.isEmpty() && language != "en")
                changed.erase(language);
            else
                changed[language] = words.toStdString();
        });
    };
    if (lines > 1)
        grid.longText(label, name, value, lines, taken);
    else
        grid.text(label, name, value, taken);
}

GeneralPage::GeneralPage(const DesignPage& page, QWidget* parent) : QWidget(parent) {
    const Theme& theme = page.app.theme();
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(theme.px(16));
    const kit::Box box = kit::box(theme);
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    addStudyText(*grid, page, tr("Title"), QStringLiteral("design.title"), 1, [](StudyDesign& design) -> StudyText& { return design.title; });
    grid->whole(tr("Planned participants"), QStringLiteral("design.planned"), page.draft.design().participantsPlanned, 1, 10000, [&draft = page.draft](int now) {
        draft.change(GeneralPage::tr("Number of participants"), QStringLiteral("design.planned"), [now](StudyDesign& design) { design.participantsPlanned = now; });
    });
    addStudyText(*grid, page, tr("Objective"), QStringLiteral("design.objective"), 2, [](StudyDesign& design) -> StudyText& { return design.objective; });
    addStudyText(*grid, page, tr("Instructions shown to participants"), QStringLiteral("design.instructions"), 4,
                 [](StudyDesign& design) -> StudyText& { return design.instructions; });
    addStudyText(*grid, page, tr("Consent text"), QStringLiteral("design.consent"), 5, [](StudyDesign& design) -> StudyText& { return design.consent; });
    box.layout->addWidget(grid);
    column->addWidget(box.frame);
    column->addStretch();
}

namespace {

/// Adds a field of a struct in the design: `of` finds the struct.
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
    void number(const QString& label, const char* key, double Part::*member, const NumberRange& range) const {
        grid.number(label, name(key), draft.design().*part.*member, range, [self = *this, key, member](double now) { self.put(key, member, now); });
    }
    void whole(const QString& label, const char* key, int Part::*member, int minimum, int maximum) const {
        grid.whole(label, name(key), draft.design().*part.*member, minimum, maximum, [self = *this, key, member](int now) { self.put(key, member, now); });
    }
    void check(const QString& label, const char* key, bool Part::*member) const {
        grid.check(label, name(key), draft.design().*part.*member, [self = *this, key, member](bool now) { self.put(key, member, now); });
    }
};

kit::Box titledBox(const Theme& theme, const QString& title) {
    const kit::Box box = kit::box(theme);
    box.layout->addWidget(kit::label(theme, title, TextStyle::title));
    return box;
}

} // namespace

TrialsPage::TrialsPage(const DesignPage& page, QWidget* parent) : QWidget(parent) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(page.app.theme().px(16));
    column->addWidget(orderBox(page));
    column->addWidget(rulesBox(page));
    column->addWidget(fidelityBox(page));
    column->addStretch();
}

QWidget* TrialsPage::orderBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Order and blinding"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    StudyDraft& draft = page.draft;
    std::vector<std::pair<QString, QVariant>> orders;
    for (const OrderDesign order : {OrderDesign::williams, OrderDesign::latinSquare, OrderDesign::random, OrderDesign::fixed})
        orders.emplace_back(study_words::order(order), static_cast<int>(order));
    grid->choice(tr("Order of conditions"), QStringLiteral("design.order"), orders, static_cast<int>(draft.design().order), [&draft](const QVariant& now) {
        draft.change(TrialsPage::tr("Order of conditions"), {}, [&](StudyDesign& design) { design.order = static_cast<OrderDesign>(now.toInt()); });
    });
    grid->text(tr("Seed"), QStringLiteral("design.seed"), QString::number(draft.design().seed), [&draft](const QString& now) {
        draft.change(TrialsPage::tr("Seed"), QStringLiteral("design.seed"), [&](StudyDesign& design) { design.seed = now.toULongLong(); });
    });
    const auto blinding = [&](const QString& label, const char* name, bool StudyDesign::*member) {
        grid->check(label, QLatin1String(name), draft.design().*member, [&draft, member](bool now) {
            draft.change(TrialsPage::tr("Blinding"), {}, [&](StudyDesign& design) { design.*member = now; });
        });
    };
    blinding(tr("Participants see no values or names"), "design.blind_participant", &StudyDesign::blindParticipant);
    blinding(tr("Experimenters see sealed codes"), "design.blind_experimenter", &StudyDesign::blindExperimenter);
    box.layout->addWidget(grid);
    return box.frame;
}

QWidget* TrialsPage::rulesBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Trials and breaks"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    const PartFields<TrialRules> fields{*grid, page.draft, QStringLiteral("trial"), &StudyDesign::trial, tr("Rules of a trial")};
    const QString s = QStringLiteral("s");
    fields.number(tr("Time to explore (0: no limit)"), "explore_limit", &TrialRules::exploreLimit_s, {0, 3600, 1, s, 1});
    fields.number(tr("Time to answer (0: no limit)"), "answer_limit", &TrialRules::answerLimit_s, {0, 3600, 1, s, 1});
    fields.number(tr("Between trials"), "between_trials", &TrialRules::betweenTrials_s, {0, 600, 1, s, 0.5});
    fields.whole(tr("Practice trials"), "practice_trials", &TrialRules::practiceTrials, 0, 100);
    fields.whole(tr("Break after (trials; 0: never)"), "break_every", &TrialRules::breakEvery, 0, 10000);
    fields.number(tr("Minimum break"), "break_at_least", &TrialRules::breakAtLeast_s, {0, 3600, 0, s, 10});
    fields.check(tr("Feedback: right or wrong"), "feedback", &TrialRules::feedback);
    fields.check(tr("Masking sound"), "masking_sound", &TrialRules::maskingSound);
    fields.check(tr("Show the objects, all alike"), "visible_objects", &TrialRules::visibleObjects);
    fields.check(tr("Every object must be touched"), "must_touch_all", &TrialRules::mustTouchAll);
    box.layout->addWidget(grid);
    return box.frame;
}

QWidget* TrialsPage::fidelityBox(const DesignPage& page) {
    const Theme& theme = page.app.theme();
    const kit::Box box = titledBox(theme, tr("Fidelity of a trial"));
    box.layout->addWidget(kit::label(theme, tr("A trial outside these limits is not scored and is presented again."), TextStyle::body, "muted"));
    auto* grid = new FieldGrid(theme, page.app.locale(), page.readOnly);
    const PartFields<FidelityLimits> fields{*grid, page.draft, QStringLiteral("fidelity"), &StudyDesign::fidelity, tr("Limits of fidelity")};
    fields.number(tr("Force error, RMS"), "force_error", &FidelityLimits::forceErrorRms_N, {0, 10, 3, QStringLiteral("N"), 0.01});
    fields.number(tr("Error of the felt value (share)"), "stiffness_error", &FidelityLimits::stiffnessError, {0, 10, 3, {}, 0.01});
    fields.number(tr("Late ticks (share)"), "late_ticks", &FidelityLimits::lateTicks, {0, 1, 4, {}, 0.01});
    fields.number(tr("Force at its limit (share)"), "saturated", &FidelityLimits::saturated, {0, 1, 3, {}, 0.01});
    fields.number(tr("Peak force"), "peak_force", &FidelityLimits::peakForce_N, {0, 100, 2, QStringLiteral("N"), 0.1});
    fields.number(tr("Mean speed"), "mean_speed", &FidelityLimits::meanSpeed_m_per_s, {0, 10, 3, QStringLiteral("m/s"), 0.01});
    fields.whole(tr("Maximum repeats of one trial"), "repeats_at_most", &FidelityLimits::repeatsAtMost, 0, 100);
    box.layout->addWidget(grid);
    return box.frame;
}

} // namespace chiron::desktop
