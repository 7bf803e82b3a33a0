// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/procedure_form.h"

#include "desktop/studies/levels_table.h"
#include "desktop/studies/study_words.h"
#include "desktop/widgets/kit.h"
#include "psychophysics/procedures/procedure_catalogue.h"
#include "session_report/procedure_words.h"

#include <QComboBox>
#include <QSpinBox>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace chiron::desktop {

using namespace psychophysics;
using session_report::procedureText;

namespace {

constexpr double kPercent = 100.0;
constexpr double kMost_percent = 10000.0; // of a difference
// √2 · 0.6745: a difference of this many σ is distinguished in three of four pairs.
constexpr double kJndOfSigma = 0.954;
constexpr double kUneven = 1e-6;

bool isEven(const std::vector<double>& values) {
    const double step = values.size() > 1 ? values[1] - values[0] : 0.0;
    for (std::size_t i = 2; i < values.size(); ++i)
        // This tolerates values written with few digits.
        if (std::abs(values[i] - values[i - 1] - step) > kUneven + 0.02 * std::abs(step))
            return false;
    return true;
}

std::vector<double> evenly(double low, double high, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i)
        values.push_back(low + (high - low) * i / std::max(1, count - 1));
    return values;
}

double numberIn(const ParameterValue& value) {
    const auto* whole = std::get_if<int>(&value);
    const auto* number = std::get_if<double>(&value);
    return whole ? *whole : number ? *number : 0.0;
}

} // namespace

struct ProcedureForm::ControlOf {
    ProcedureForm& form;
    const Parameter& row;

    void operator()(double value) const { form.numberField(row, value); }
    void operator()(int value) const { form.wholeField(row, value); }
    void operator()(bool value) const {
        form.check(procedureText(row.title), form.nameOf(row.key), value,
                   [&of = form, &on = row](bool now) { of.put(on, now); });
        form.explainRow(row);
    }
    void operator()(const std::string& value) const { form.wordField(row, value); }
    void operator()(const std::vector<double>& values) const { form.listField(row, values); }
    void operator()(const std::vector<ParameterGrid>& grids) const {
        for (std::size_t i = 0; i < grids.size(); ++i)
            form.parameterField(row, grids, i);
    }
    template <class Other> void operator()(const Other&) const {} // rows of other types are never asked
};

ProcedureForm::ProcedureForm(const Theme& theme, const QLocale& locale, bool readOnly, StudyDraft& draft,
                             ProcedurePlace place, QWidget* parent)
    : FieldGrid(theme, locale, readOnly, parent), m_draft(draft), m_place(place),
      m_units(draft.design().conditions[place.condition].scale) {
    if (condition().stimulus.attribute == Attribute::apex) { // the number of marks is its only option
        apexField();
        return;
    }
    kindField();
    for (const Parameter& row : kindFor(procedure()).rows())
        if (row.isAsked() && (!row.applies || row.applies(procedure())))
            std::visit(ControlOf{*this, row}, row.get(procedure()));
}

void ProcedureForm::kindField() {
    const std::string kind(kindOf(procedure()));
    std::vector<std::pair<QString, QVariant>> kinds;
    for (const std::string& each : kindsFor(condition().task))
        kinds.emplace_back(study_words::procedure(each), QString::fromStdString(each));
    if (std::none_of(kinds.begin(), kinds.end(),
                     [&](const auto& each) { return each.second.toString().toStdString() == kind; }))
        kinds.emplace_back(study_words::procedure(kind), QString::fromStdString(kind));
    choice(tr("Procedure"), nameOf("kind"), kinds, QString::fromStdString(kind),
           [this](const QVariant& chosen) {
               m_draft.change(
                   tr("Choice of the procedure"), {},
                   [&](StudyDesign& design) {
                       Condition& changed = design.conditions[m_place.condition];
                       ProcedureSpec& procedure = changed.procedures[m_place.procedure];
                       procedure = usualProcedureKeeping(chosen.toString().toStdString(), changed, procedure);
                   },
                   true);
           });
    wide(kit::label(gridTheme(), study_words::procedureInWords(kind), TextStyle::small,
                    kindFor(procedure()).words().legacy ? "warning" : "muted"));
}

/// The number of trials of the apex search, which is the only number of its constant stimuli.
void ProcedureForm::apexField() {
    for (const Parameter& row : kindFor(procedure()).rows())
        if (row.key == "repeats" && kindFor(procedure()).trialsAreFixed()) {
            whole(tr("Trials"), nameOf(row.key), std::get<int>(row.get(procedure())),
                  static_cast<int>(row.minimum), static_cast<int>(row.maximum),
                  [this, &row](int now) { put(row, now); });
            explain(nameOf(row.key), tr("How many times each participant searches for the apex."),
                    {row.minimum, row.maximum, 10});
        }
}

QString ProcedureForm::nameOf(std::string_view key) const {
    return QStringLiteral("procedure.%1.%2")
        .arg(m_place.procedure)
        .arg(QString::fromUtf8(key.data(), static_cast<qsizetype>(key.size())));
}

const Condition& ProcedureForm::condition() const {
    return m_draft.design().conditions[m_place.condition];
}

const ProcedureSpec& ProcedureForm::procedure() const {
    return condition().procedures[m_place.procedure];
}

void ProcedureForm::put(const Parameter& row, const ParameterValue& value) {
    put(row, nameOf(row.key), [&row, &value](ProcedureSpec& spec) { row.set(spec, value); });
}

void ProcedureForm::put(const Parameter& row, const QString& key,
                        const std::function<void(ProcedureSpec&)>& change) {
    const QString name = row.change.empty() ? tr("Change of the procedure") : procedureText(row.change);
    const QString where = row.follow ? QString() : QStringLiteral("%1.%2").arg(m_place.condition).arg(key);
    const ProcedureKind* kind = &kindFor(procedure());
    m_draft.change(
        name, where,
        [&](StudyDesign& design) {
            Condition& changed = design.conditions[m_place.condition];
            ProcedureSpec& spec = changed.procedures[m_place.procedure];
            if (&kindFor(spec) != kind)
                return;
            change(spec);
            if (row.follow)
                row.follow(spec, changed);
        },
        row.follow != nullptr);
}

LevelUnits ProcedureForm::unitsOf(const Parameter& row) const {
    return row.quantity == Quantity::factor ? LevelUnits(ProcedureScale::logDifference) : m_units;
}

ProcedureForm::Shown ProcedureForm::shownAs(const Parameter& row) const {
    const LevelUnits units = unitsOf(row);
    switch (row.quantity) {
    case Quantity::share:
        return {[](double share) { return kPercent * share; },
                [](double percent) { return percent / kPercent; }};
    case Quantity::level:
        return {[units](double x) { return units.percentOf(x); },
                [units](double percent) { return units.xOf(percent); }};
    case Quantity::spread:
    case Quantity::factor:
        return {[units](double x) { return units.spreadOf(x); },
                [units](double spread) { return units.distanceOf(spread); }};
    case Quantity::noise:
        return {[](double log10Sigma) {
                    return kPercent * study_words::ratioOf(kJndOfSigma * std::pow(10.0, log10Sigma));
                },
                [](double jnd) {
                    return std::log10(study_words::differenceOf(std::max(jnd, 0.01) / kPercent) /
                                      kJndOfSigma);
                }};
    case Quantity::plain:
        break;
    }
    return {[](double x) { return x; }, [](double x) { return x; }};
}

NumberRange ProcedureForm::rangeOf(const Parameter& row) const {
    const bool factors = unitsOf(row).spreadIsFactor();
    NumberRange range{row.minimum, row.maximum, 2, {}, 0.1};
    switch (row.quantity) {
    case Quantity::share:
        range = {kPercent * row.minimum, kPercent * row.maximum, 1, QStringLiteral("%"), 1};
        break;
    case Quantity::level:
        range = {unitsOf(row).lowestPercent(), kMost_percent, 2, QStringLiteral("%"), 1};
        break;
    case Quantity::spread:
    case Quantity::factor:
        range = factors ? NumberRange{1.0, 1000.0, 2, QStringLiteral("×"), 0.05}
                        : NumberRange{0.0, 1000.0, 2, QStringLiteral("%"), 0.5};
        break;
    case Quantity::noise:
        range = {0.01, 10000, 2, QStringLiteral("%"), 1};
        break;
    case Quantity::plain:
        break;
    }
    const auto& field = factors && row.fieldOfFactor ? row.fieldOfFactor : row.field;
    if (field)
        range = {field->lowest, field->highest, field->decimals, range.unit, field->step};
    range.zero = procedureText(row.zero);
    return range;
}

void ProcedureForm::explainRow(const Parameter& row) {
    const bool factors = unitsOf(row).spreadIsFactor() && !row.meaningOfFactor.empty();
    const QString meaning = procedureText(factors ? row.meaningOfFactor : row.meaning);
    if (!row.usual) {
        explain(nameOf(row.key), meaning);
        return;
    }
    const double usual = row.usual->value
                             ? *row.usual->value
                             : shownAs(row).to(numberIn(row.get(kindFor(procedure()).usual(condition()))));
    const NumberRange range = rangeOf(row);
    explain(nameOf(row.key), meaning, {range.minimum, range.maximum, usual});
}

void ProcedureForm::numberField(const Parameter& row, double value) {
    const Shown shown = shownAs(row);
    number(procedureText(row.title), nameOf(row.key), shown.to(value), rangeOf(row),
           [this, &row, from = shown.from](double now) { put(row, from(now)); });
    explainRow(row);
}

void ProcedureForm::wholeField(const Parameter& row, int value) {
    // The options that must not exceed this one, with their present values.
    std::vector<std::pair<const Parameter*, int>> limited;
    for (const Parameter& other : kindFor(procedure()).rows())
        if (!other.noMoreThan.empty() && other.noMoreThan == row.key && other.object == row.object)
            limited.emplace_back(&other, std::get<int>(other.get(procedure())));
    const auto taken = [this, &row, limited](int now) {
        // A limit of 0 means no limit.
        const auto within = [now](int before) { return now > 0 ? std::min(before, now) : before; };
        put(row, nameOf(row.key), [&](ProcedureSpec& spec) {
            row.set(spec, now);
            for (const auto& [other, before] : limited)
                other->set(spec, within(before));
        });
        for (const auto& [other, before] : limited)
            if (auto* field = qobject_cast<QSpinBox*>(this->field(nameOf(other->key)))) {
                const QSignalBlocker quiet(field);
                field->setValue(within(before));
            }
    };
    whole(procedureText(row.title), nameOf(row.key), value, static_cast<int>(row.minimum),
          static_cast<int>(row.maximum), taken);
    explainRow(row);
}

void ProcedureForm::wordField(const Parameter& row, const std::string& now) {
    std::vector<std::string> offered;
    if (row.wordsFor)
        offered = row.wordsFor(condition());
    else
        for (const ParameterWord& each : row.words)
            offered.emplace_back(each.word);
    if (std::find(offered.begin(), offered.end(), now) == offered.end())
        offered.push_back(now); // from an imported design
    std::vector<std::pair<QString, QVariant>> words;
    for (const std::string& word : offered)
        words.emplace_back(session_report::wordTitle(row, word), QString::fromStdString(word));
    choice(procedureText(row.title), nameOf(row.key), words, QString::fromStdString(now),
           [this, &row](const QVariant& chosen) { put(row, chosen.toString().toStdString()); });
    explainRow(row);
}

void ProcedureForm::listField(const Parameter& row, const std::vector<double>& values) {
    const QString title = procedureText(row.title);
    const QString meaning = procedureText(row.meaning);
    const auto taken = [this, &row](const std::vector<double>& now) { put(row, now); };
    switch (row.quantity) {
    case Quantity::level:
        levelsField(row, values);
        break;
    case Quantity::share:
        sharesField(title, nameOf(row.key), values, rangeOf(row), meaning, taken);
        break;
    case Quantity::spread:
    case Quantity::factor:
        stepsField(row, values);
        break;
    case Quantity::noise:
        gridFields(title, nameOf(row.key), values, rangeOf(row), shownAs(row), meaning, taken);
        break;
    case Quantity::plain:
        list(title, nameOf(row.key), values, taken, rangeOf(row));
        explain(nameOf(row.key), meaning);
        break;
    }
}

void ProcedureForm::levelsField(const Parameter& row, const std::vector<double>& levels) {
    std::vector<double> percents;
    for (const double x : levels)
        percents.push_back(m_units.percentOf(x));
    const StimulusDesign stimulus = condition().stimulus;
    auto* table = new LevelsTable(gridTheme(), gridLocale(), isReadOnly(), nameOf(row.key), percents,
                                  [stimulus, locale = gridLocale()](const std::vector<double>& of) {
                                      return objectsOf(stimulus, of, locale);
                                  });
    control(procedureText(row.title), nameOf(row.key), table);
    explain(nameOf(row.key), procedureText(row.meaning));
    connect(table, &LevelsTable::unread, this,
            [this, name = nameOf(row.key)](const QString& words) { setUnread(name, words); });
    connect(table, &LevelsTable::changed, this, [this, &row](const std::vector<double>& now) {
        std::vector<double> places;
        for (const double percent : now)
            places.push_back(m_units.xOf(percent));
        put(row, places);
    });
}

void ProcedureForm::stepsField(const Parameter& row, const std::vector<double>& steps) {
    const bool asStored = row.asStored && row.asStored(procedure());
    const Shown shown =
        asStored ? Shown{[](double x) { return x; }, [](double x) { return x; }} : shownAs(row);
    std::vector<double> shownSteps;
    for (const double step : steps)
        shownSteps.push_back(shown.to(step));
    list(
        procedureText(row.title), nameOf(row.key), shownSteps,
        [this, &row, from = shown.from](std::vector<double> now) {
            for (double& step : now)
                step = from(step);
            put(row, now);
        },
        asStored ? NumberRange{row.minimum, row.maximum} : rangeOf(row));
    const QString unit = asStored                        ? tr("Logarithmic steps of an imported design.")
                         : unitsOf(row).spreadIsFactor() ? tr("Factors of the difference, usually 1.26.")
                                                         : tr("In per cent of the reference.");
    explain(nameOf(row.key), procedureText(row.meaning) + QLatin1Char(' ') + unit);
}

void ProcedureForm::parameterField(const Parameter& row, const std::vector<ParameterGrid>& grids,
                                   std::size_t index) {
    const ParameterGrid& grid = grids[index];
    const QString key = nameOf("grid") + QString::number(index);
    const auto taken = [this, &row, key, index](const std::vector<double>& now) {
        put(row, key, [&](ProcedureSpec& spec) {
            auto changed = std::get<std::vector<ParameterGrid>>(row.get(spec));
            changed[index].values = now;
            changed[index].prior.clear(); // its length was that of the old grid
            row.set(spec, changed);
        });
    };
    const LevelUnits units = m_units;
    if (grid.name == "threshold" || grid.name == "mean")
        gridFields(tr("Threshold"), key, grid.values,
                   {units.lowestPercent(), kMost_percent, 2, QStringLiteral("%"), 1},
                   {[units](double x) { return units.percentOf(x); },
                    [units](double percent) { return units.xOf(percent); }},
                   tr("The threshold is assumed to lie between these two values."), taken);
    else if (grid.name == "sd")
        gridFields(tr("Spread"), key, grid.values,
                   {units.spreadIsFactor() ? 1.0 : 0.0, kMost_percent, 2,
                    units.spreadIsFactor() ? QStringLiteral("×") : QStringLiteral("%"), 1},
                   {[units](double x) { return units.spreadOf(x); },
                    [units](double percent) { return units.distanceOf(percent); }},
                   tr("The spread of the answers is assumed to lie between these two values."), taken);
    else if (grid.name == "lapse_rate" || grid.name == "lower_asymptote")
        sharesField(study_words::parameter(grid.name), key, grid.values,
                    {0, kPercent, 1, QStringLiteral("%")},
                    grid.name == "lapse_rate"
                        ? tr("Possible shares of wrong answers to differences that are felt.")
                        : tr("Share of answers that are right by guessing: 50 % with two alternatives."),
                    taken);
    else {
        list(study_words::parameter(grid.name), key, grid.values, taken);
        explain(key, grid.name == "slope"
                         ? tr("Slopes that are considered possible: how steeply the share of right answers "
                              "grows with the difference. Usually 1.5 to 7.")
                         : procedureText(row.meaning));
    }
}

void ProcedureForm::sharesField(const QString& label, const QString& key, const std::vector<double>& shares,
                                const NumberRange& range, const QString& meaning,
                                const std::function<void(std::vector<double>)>& taken) {
    std::vector<double> percents;
    for (const double share : shares)
        percents.push_back(kPercent * share);
    list(
        tr("%1 (%)").arg(label), key, percents,
        [taken](std::vector<double> now) {
            for (double& percent : now)
                percent /= kPercent;
            taken(std::move(now));
        },
        range);
    explain(key, meaning);
}

void ProcedureForm::gridFields(const QString& what, const QString& key, const std::vector<double>& values,
                               const NumberRange& range, const Shown& shown, const QString& meaning,
                               const std::function<void(std::vector<double>)>& taken) {
    struct Ends {
        double low, high;
        int count;
    };
    auto ends =
        std::make_shared<Ends>(Ends{values.empty() ? 0.0 : values.front(),
                                    values.empty() ? 0.0 : values.back(), static_cast<int>(values.size())});
    const auto put = [ends, taken] { taken(evenly(ends->low, ends->high, ends->count)); };
    number(tr("%1: from").arg(what), key + QStringLiteral(".low"), shown.to(ends->low), range,
           [=, from = shown.from](double now) {
               ends->low = from(now);
               put();
           });
    explain(key + QStringLiteral(".low"), meaning);
    number(tr("%1: to").arg(what), key + QStringLiteral(".high"), shown.to(ends->high), range,
           [=, from = shown.from](double now) {
               ends->high = from(now);
               put();
           });
    explain(key + QStringLiteral(".high"),
            isEven(values) ? tr("The largest value that is considered possible.")
                           : tr("The largest value. The imported design spaces these values irregularly; "
                                "after a change they are spaced regularly."));
    whole(tr("%1: steps").arg(what), key + QStringLiteral(".count"), ends->count, 1, 400, [=](int now) {
        ends->count = now;
        put();
    });
    explain(key + QStringLiteral(".count"), tr("More steps are finer, and take longer to compute."),
            {1, 400, 41});
}

} // namespace chiron::desktop
