// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/studies/field_grid.h"
#include "desktop/studies/level_units.h"
#include "desktop/studies/study_draft.h"

namespace chiron::desktop {

/// Where a procedure lies in a design.
struct ProcedurePlace {
    std::size_t condition = 0;
    std::size_t procedure = 0;
};

/// A new procedure of a kind ("staircase" ...) that suits a condition: levels, grids and guess rate from its table and task. x is in the
/// condition's scale.
psychophysics::ProcedureSpec usualProcedure(const std::string& kind, const psychophysics::Condition& condition);
/// The kinds that suit a task, the best one first.
std::vector<std::string> kindsFor(psychophysics::Task task);

/// The functions that QUEST+ can be given for a scale: "weibull_log10" ..., the usual one first.
std::vector<std::string> functionsFor(psychophysics::ProcedureScale scale);
/// Gives QUEST+ another function, with a grid for each of its parameters.
void takeFunction(psychophysics::QuestPlusSpec& spec, const std::string& function, const psychophysics::Condition& condition);

/// The options of one procedure, in differences in per cent of the reference; only those that apply. GUI thread; the draft outlives it.
class ProcedureForm final : public FieldGrid {
    Q_OBJECT
public:
    ProcedureForm(const Theme& theme, const QLocale& locale, bool readOnly, StudyDraft& draft, ProcedurePlace place, QWidget* parent = nullptr);

private:
    struct FieldsOf; ///< the fields of each kind of procedure
    /// How a stored number is shown: shown = to(stored), stored = from(shown).
    struct Shown {
        std::function<double(double)> to, from;
    };

    template <class Spec> const Spec* spec() const;
    template <class Spec> void edit(const QString& key, const std::function<void(Spec&)>& change);
    template <class Spec> void numberOf(const QString& label, const char* key, double Spec::*member, const NumberRange& range, const Shown& shown);
    template <class Spec> void percentOf(const QString& label, const char* key, double Spec::*member, const QString& meaning, double usual); ///< a share
    template <class Spec> void levelOf(const QString& label, const char* key, double Spec::*member, const QString& meaning); ///< a place on x
    template <class Spec> void spreadOf(const QString& label, const char* key, double Spec::*member, const QString& meaning); ///< a distance on x
    template <class Spec> void wholeOf(const QString& label, const char* key, int Spec::*member, const QString& meaning, const UsualNumber& number);
    template <class Spec> void checkOf(const QString& label, const char* key, bool Spec::*member, const QString& meaning);
    template <class Spec> void levelsOf(const QString& label, const char* key, std::vector<double> Spec::*member, const QString& meaning);
    template <class Spec> void stopFields(const UsualNumber& trials);
    template <class Spec> void repeatField();
    void stepsOf(const QString& label, const char* key, std::vector<double> psychophysics::StaircaseSpec::*member, const QString& meaning);
    void staircaseFields();
    void pestFields();
    void constantFields();
    void descendingFields();
    void questFields();
    void questPlusFields();
    void rank3Fields();
    /// From, to and how many of an evenly spaced grid.
    void gridFields(const QString& what, const QString& key, const std::vector<double>& values, const NumberRange& range, const Shown& shown,
                    const QString& meaning, const std::function<void(std::vector<double>)>& taken);
    void functionField();
    void parameterField(std::size_t index);
    void sharesField(const QString& label, const QString& key, const std::vector<double>& shares, const QString& meaning,
                     const std::function<void(std::vector<double>)>& taken);
    const psychophysics::Condition& condition() const;
    NumberRange spreadRange() const;
    QString nameOf(const char* key) const;

    StudyDraft& m_draft;
    ProcedurePlace m_place;
    LevelUnits m_units;
};

} // namespace chiron::desktop
