// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/source_text.h"

#include <algorithm>

namespace chiron::test {

namespace {

constexpr QChar kQuote = u'"', kApostrophe = u'\'';

/// The place after `what`, searched from `from`; the end of the text where it does not come.
qsizetype after(const QString& text, const QString& what, qsizetype from) {
    const qsizetype place = text.indexOf(what, from);
    return place < 0 ? text.size() : place + what.size();
}

/// The quote at `place` begins a raw literal: R"…, u8R"…, but not NAME_R"….
bool beginsRaw(const QString& text, qsizetype place) {
    if (place < 1 || text[place - 1] != u'R')
        return false;
    if (place < 2)
        return true;
    const QChar before = text[place - 2];
    return !(before == u'_' || before.isLetterOrNumber()) || QStringLiteral("uUL8").contains(before);
}

/// An apostrophe after a letter or digit separates digits (1'000).
bool beginsLiteral(const QString& text, qsizetype place) {
    return text[place] == kQuote ||
           (text[place] == kApostrophe && (place == 0 || !text[place - 1].isLetterOrNumber()));
}

/// Where the literal's closing quote stands; the end of the line where it has none.
qsizetype closing(const QString& text, qsizetype place) {
    const QChar quote = text[place];
    qsizetype end = place + 1;
    while (end < text.size() && text[end] != quote && text[end] != u'\n')
        end += text[end] == u'\\' ? 2 : 1;
    return std::min(end, text.size());
}

} // namespace

SourceText readSource(const QString& text) {
    SourceText source;
    for (qsizetype place = 0; place < text.size();) {
        const QStringView rest = QStringView(text).mid(place);
        if (rest.startsWith(u"//")) {
            const qsizetype end = text.indexOf(u'\n', place);
            place = end < 0 ? text.size() : end;
        } else if (rest.startsWith(u"/*")) {
            place = after(text, QStringLiteral("*/"), place + 2);
            source.code += u' ';
        } else if (text[place] == kQuote && beginsRaw(text, place)) {
            const qsizetype begin = after(text, QStringLiteral("("), place);
            const QString end = u')' + text.mid(place + 1, begin - place - 2) + kQuote;
            place = after(text, end, begin);
            source.literals << text.mid(begin, place - end.size() - begin);
            source.code += QStringLiteral("\"\"");
        } else if (beginsLiteral(text, place)) {
            const qsizetype end = closing(text, place);
            if (text[place] == kQuote)
                source.literals << text.mid(place + 1, end - place - 1);
            source.code += text.mid(place, end + 1 - place);
            place = end + 1;
        } else {
            source.code += text[place++];
        }
    }
    return source;
}

} // namespace chiron::test
