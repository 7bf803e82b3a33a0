// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/attribute_names.h"

#include "desktop/studies/study_titles.h"
#include "desktop/studies/study_words.h"

#include <QRegularExpression>
#include <algorithm>
#include <set>

namespace chiron::desktop {

using psychophysics::Attribute;
using psychophysics::Condition;
using psychophysics::StudyDesign;
using psychophysics::StudyText;

namespace {

/// "Stiffness": English, as the titles that every study has.
QString nameOf(Attribute attribute) {
    const std::string_view token = psychophysics::token(attribute);
    QString name = QString::fromUtf8(token.data(), static_cast<qsizetype>(token.size()));
    name[0] = name[0].toUpper();
    return name;
}

/// "60 N/m", with or without the space.
QRegularExpression valueAtEnd(Attribute attribute, double reference) {
    const study_words::Unit unit = study_words::unitOf(attribute);
    const QString number = QString::number(reference * unit.factor, 'g', 6);
    return QRegularExpression(
        QStringLiteral("^\\p{L}+(?:\\s\\p{L}+)?\\s%1\\s*%2$")
            .arg(QRegularExpression::escape(number), QRegularExpression::escape(unit.text)),
        QRegularExpression::UseUnicodePropertiesOption);
}

QString valueOf(Attribute attribute, double reference) {
    const study_words::Unit unit = study_words::unitOf(attribute);
    const QString number = QString::number(reference * unit.factor, 'g', 6);
    return unit.text.isEmpty() ? number : number + QLatin1Char(' ') + unit.text;
}

QString titleIn(const StudyText& title, const char* language) {
    const auto found = title.find(language);
    return found == title.end() ? QString() : QString::fromStdString(found->second);
}

/// `wanted`, numbered if another condition has it.
QString freeConditionTitle(const StudyDesign& design, std::size_t at, const QString& wanted) {
    const auto taken = [&](const QString& title) {
        for (std::size_t i = 0; i < design.conditions.size(); ++i)
            if (i != at && titleIn(design.conditions[i].title, "en") == title)
                return true;
        return false;
    };
    QString title = wanted;
    for (int n = 2; taken(title); ++n)
        title = QStringLiteral("%1 (%2)").arg(wanted, QString::number(n));
    return title;
}

/// Short names such as "stiffness_2" and "tube_60" are of the attribute or of the reference.
bool isOfValue(const QString& id, Attribute before, double referenceBefore) {
    static const QRegularExpression kNumber(QStringLiteral("_\\d{1,2}$"));
    if (id == shortNameOf(nameOf(before)) || QString(id).remove(kNumber) == shortNameOf(nameOf(before)))
        return true;
    static const QRegularExpression kNoName(QStringLiteral("[^a-z0-9]+"));
    const study_words::Unit unit = study_words::unitOf(before);
    QString number = QString::number(referenceBefore * unit.factor, 'g', 6);
    QString symbol = unit.text.toLower();
    const QRegularExpression value(
        QStringLiteral("^[a-z]+_%1(?:_?%2)?(?:_\\d{1,2})?$")
            .arg(number.replace(kNoName, QStringLiteral("_")), symbol.replace(kNoName, QStringLiteral("_"))));
    return value.match(id).hasMatch();
}

/// "Stiffness, two alternatives" becomes "Mass, two alternatives". What a template said of its objects
/// ("Stiffness of an elastic tube") is left out. Its translations tell a template's title from a typed one.
void retitleStudy(StudyDesign& design, Attribute before, Attribute after,
                  const std::function<bool(const std::string&)>& isTyped) {
    const bool remains =
        std::any_of(design.conditions.begin(), design.conditions.end(),
                    [before](const Condition& condition) { return condition.stimulus.attribute == before; });
    const QString title = titleIn(design.title, "en");
    const QRegularExpression begins(QStringLiteral("^%1\\b").arg(nameOf(before)));
    if (remains || design.title.size() < 2 || isTyped(title.toStdString()) || !title.contains(begins))
        return;
    const qsizetype comma = title.indexOf(QLatin1Char(','));
    design.title = {{"en", (nameOf(after) + (comma < 0 ? QString() : title.mid(comma))).toStdString()}};
}

} // namespace

void nameByAttribute(StudyDesign& design, std::size_t at, Attribute before, double referenceBefore,
                     const std::function<bool(const std::string&)>& isTyped) {
    Condition& condition = design.conditions[at];
    const Attribute after = condition.stimulus.attribute;
    if (after == before)
        return;
    static const QRegularExpression kNumberOfCopy(QStringLiteral("\\s\\(\\d+\\)$"));
    const QString title = titleIn(condition.title, "en");
    const QString plain = QString(title).remove(kNumberOfCopy);
    const bool ofName = plain == nameOf(before);
    const bool ofValue = plain.contains(valueAtEnd(before, referenceBefore));
    if ((ofName || ofValue) && !isTyped(title.toStdString())) {
        const QString id = QString::fromStdString(condition.id);
        const bool idFollows =
            !isTyped(condition.id) && (isMadeOf(id, title) || isOfValue(id, before, referenceBefore));
        const QString wanted =
            ofName
                ? nameOf(after)
                : QStringLiteral("%1 of %2").arg(nameOf(after), valueOf(after, condition.stimulus.reference));
        const QString made = freeConditionTitle(design, at, wanted);
        // Its translations were of the former object.
        condition.title = {{"en", made.toStdString()}};
        std::set<QString> taken;
        for (std::size_t i = 0; i < design.conditions.size(); ++i)
            if (i != at)
                taken.insert(QString::fromStdString(design.conditions[i].id));
        if (idFollows)
            condition.id = freeShortName(shortNameOf(made), taken).toStdString();
    }
    retitleStudy(design, before, after, isTyped);
}

} // namespace chiron::desktop
