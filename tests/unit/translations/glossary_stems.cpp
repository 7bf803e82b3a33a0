// SPDX-License-Identifier: GPL-3.0-or-later
#include "unit/translations/glossary_stems.h"

#include "core/languages.h"

#include <QFile>
#include <algorithm>

namespace chiron::test {

namespace {

constexpr QChar kTaken{0x01}; ///< in the place of words that were recognised

QStringList parts(const QString& cell, QLatin1Char separator) {
    QStringList found;
    for (const QString& part : cell.split(separator))
        if (const QString plain = part.trimmed(); !plain.isEmpty())
            found << plain;
    return found;
}

/// Small letters without accents.
QString folded(const QString& text) {
    QString plain;
    for (const QChar letter : text.toLower().normalized(QString::NormalizationForm_D))
        if (letter.category() != QChar::Mark_NonSpacing)
            plain += letter;
    return plain;
}

bool beginsWordIn(const QString& text, const QString& stem) {
    for (qsizetype at = text.indexOf(stem); at >= 0; at = text.indexOf(stem, at + 1))
        if (at == 0 || !text[at - 1].isLetter())
            return true;
    return false;
}

/// Whether all words of a stem are in a folded text. German puts words together.
bool hasStem(const QString& text, const QString& stem, const QString& language) {
    const QStringList words = parts(stem, QLatin1Char(' '));
    return std::all_of(words.begin(), words.end(), [&](const QString& word) {
        return language == QLatin1String("de") ? text.contains(word) : beginsWordIn(text, word);
    });
}

} // namespace

GlossaryStems::GlossaryStems(const QString& path, QStringList& faults) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        faults << path + QStringLiteral(": cannot be read");
    for (const QString& line : QString::fromUtf8(file.readAll()).split(QLatin1Char('\n')))
        if (!line.trimmed().isEmpty() && !line.startsWith(QLatin1Char('#')))
            readLine(line, faults);
    std::stable_sort(m_forms.begin(), m_forms.end(),
                     [](const Form& a, const Form& b) { return a.words.size() > b.words.size(); });
}

void GlossaryStems::readLine(const QString& line, QStringList& faults) {
    const std::vector<std::string> languages = chiron::core::languageIds(); // a column of terms for each
    QStringList cells;
    for (const QString& cell :
         line.mid(line.startsWith(QLatin1Char('=')) || line.startsWith(QLatin1Char('!')))
             .split(QLatin1Char('|')))
        cells << cell.trimmed();
    if (line.startsWith(QLatin1Char('=')) && cells.size() == 2 && !cells[1].isEmpty()) {
        addForm(cells[0], -1);
    } else if (line.startsWith(QLatin1Char('!')) && cells.size() == 5 && !cells[4].isEmpty()) {
        m_exceptions.push_back(
            {parts(cells[0], QLatin1Char(',')), parts(cells[1], QLatin1Char(';')), cells[2], cells[3]});
    } else if (line.front().isLetter() && cells.size() == static_cast<qsizetype>(languages.size())) {
        Term term{parts(cells[0], QLatin1Char(';')), {}};
        for (std::size_t i = 1; i < languages.size(); ++i)
            term.stems.insert(QString::fromStdString(languages[i]),
                              parts(cells[static_cast<qsizetype>(i)], QLatin1Char(';')));
        for (const QString& form : term.forms)
            addForm(form, static_cast<int>(m_terms.size()));
        m_terms.push_back(std::move(term));
    } else {
        faults << line;
    }
}

void GlossaryStems::addForm(const QString& words, int term) {
    m_forms.push_back({words,
                       QRegularExpression(QStringLiteral("(?<![\\p{L}\\p{N}_])%1(s|es)?(?![\\p{L}\\p{N}_])")
                                              .arg(QRegularExpression::escape(words)),
                                          QRegularExpression::CaseInsensitiveOption |
                                              QRegularExpression::UseUnicodePropertiesOption),
                       term});
}

QStringList GlossaryStems::missingIn(const Sentence& sentence, const QString& language) {
    QString rest = sentence.source;
    QStringList missing;
    std::vector<bool> seen(m_terms.size(), false);
    for (Form& form : m_forms) {
        const qsizetype before = rest.count(kTaken);
        rest.replace(form.pattern, QString(kTaken));
        if (rest.count(kTaken) == before)
            continue;
        if (form.term < 0) {
            form.usedIn << language;
            continue;
        }
        const auto index = static_cast<std::size_t>(form.term);
        if (seen[index])
            continue;
        seen[index] = true;
        ++m_found;
        const QString term = m_terms[index].forms.front();
        if (!has(term, sentence.translation, language) && !excused(sentence, term, language))
            missing << term;
    }
    return missing;
}

bool GlossaryStems::excused(const Sentence& sentence, const QString& term, const QString& language) {
    bool found = false;
    for (Exception& each : m_exceptions)
        if (each.languages.contains(language) && each.terms.contains(term) && each.place == sentence.place &&
            sentence.source.startsWith(each.beginning)) {
            each.usedIn << language;
            found = true;
        }
    return found;
}

QStringList GlossaryStems::unused(const QString& language) const {
    QStringList left;
    for (const Form& form : m_forms)
        if (form.term < 0 && !form.usedIn.contains(language))
            left << form.words;
    for (const Exception& each : m_exceptions)
        if (each.languages.contains(language) && !each.usedIn.contains(language))
            left << each.place + QStringLiteral(": ") + each.beginning;
    return left;
}

bool GlossaryStems::has(const QString& form, const QString& text, const QString& language) const {
    const auto term = std::find_if(m_terms.begin(), m_terms.end(),
                                   [&](const Term& each) { return each.forms.contains(form); });
    if (term == m_terms.end())
        return false;
    const QString plain = folded(text);
    const QStringList stems = term->stems.value(language);
    return std::any_of(stems.begin(), stems.end(),
                       [&](const QString& stem) { return hasStem(plain, stem, language); });
}

QStringList GlossaryStems::firstForms() const {
    QStringList first;
    for (const Term& term : m_terms)
        first << term.forms.front();
    return first;
}

QStringList GlossaryStems::forms() const {
    QStringList all;
    for (const Term& term : m_terms)
        all << term.forms;
    return all;
}

} // namespace chiron::test
