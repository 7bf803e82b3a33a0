// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/theme/theme.h"

#include <QFile>
#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::desktop;

namespace {

/// Relative luminance and contrast ratio of WCAG 2.1 (success criterion 1.4.3).
double luminance(const QColor& colour) {
    const auto linear = [](double c) { return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
}

double contrast(const QColor& a, const QColor& b) {
    const double x = luminance(a);
    const double y = luminance(b);
    return (std::max(x, y) + 0.05) / (std::min(x, y) + 0.05);
}

QByteArray tokens() {
    QFile file(QStringLiteral(CHIRON_SOURCE_DIR "/resources/theme/tokens.json"));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class TestTheme : public QObject {
    Q_OBJECT
private slots:
    void contrastIsEnough_data() {
        QTest::addColumn<int>("theme");
        QTest::newRow("light") << static_cast<int>(ThemeName::light);
        QTest::newRow("dark") << static_cast<int>(ThemeName::dark);
        QTest::newRow("high contrast") << static_cast<int>(ThemeName::highContrast);
    }

    void contrastIsEnough() {
        QFETCH(int, theme);
        const auto loaded = Theme::load(static_cast<ThemeName>(theme), 1.0);
        QVERIFY2(loaded, loaded ? "" : loaded.error().message.c_str());
        using enum Colour;
        struct Pair {
            Colour ink, paper;
            double least;
        };
        const double most = theme == static_cast<int>(ThemeName::highContrast) ? 7.0 : 4.5;
        std::vector<Pair> pairs{{accentText, accent, most}, {accentText, accentHover, most}, {badText, bad, most}, {sidebarText, sidebar, most}, {sidebarText, sidebarActive, most}, {warning, warningSoft, most}};
        for (const Colour paper : {window, surface, raised})
            for (const Colour ink : {text, muted, accent, good, warning, bad})
                pairs.push_back({ink, paper, most});
        for (const Colour paper : {accentSoft, goodSoft, warningSoft, badSoft})
            pairs.push_back({text, paper, most});
        for (const Colour line : {borderStrong, focus, seriesA, seriesB, seriesC}) // WCAG 1.4.11: what is no text needs 3:1
            pairs.push_back({line, surface, 3.0});
        for (const Pair& pair : pairs)
            QVERIFY2(contrast(loaded->color(pair.ink), loaded->color(pair.paper)) >= pair.least,
                     qPrintable(QStringLiteral("%1 on %2: %3").arg(loaded->color(pair.ink).name(), loaded->color(pair.paper).name()).arg(contrast(loaded->color(pair.ink), loaded->color(pair.paper)))));
    }

    void scalesLengthsAndText() {
        const auto one = Theme::load(ThemeName::light, 1.0);
        const auto two = Theme::load(ThemeName::light, 2.0);
        QCOMPARE(two->px(12), 2 * one->px(12));
        QCOMPARE(two->font(TextStyle::body).pixelSize(), 2 * one->font(TextStyle::body).pixelSize());
        QCOMPARE(Theme::load(ThemeName::light, 9.0)->scale(), 2.0); // never so large that nothing fits
    }

    void styleSheetHasNoTokenLeft() {
        const QString sheet = Theme::load(ThemeName::dark, 1.5)->styleSheet();
        QVERIFY(!sheet.contains(QLatin1Char('@')));
        QVERIFY(!sheet.contains(QRegularExpression(QStringLiteral("#[0-9]{1,3}#"))));
        QVERIFY(sheet.contains(Theme::load(ThemeName::dark, 1.5)->color(Colour::accentSoft).name()));
    }

    void badTokensAreNamed() {
        QByteArray without = tokens();
        without.replace("\"accentSoft\": \"#173a4c\"", "\"accentSoft\": \"blueish\"");
        const auto broken = Theme::fromJson(without, ThemeName::dark, 1.0);
        QVERIFY(!broken);
        QVERIFY2(QString::fromStdString(broken.error().message).contains(QStringLiteral("themes.dark.accentSoft")), broken.error().message.c_str());
        QVERIFY(!Theme::fromJson("not json", ThemeName::light, 1.0));
    }

    void iconsAreThere() {
        const auto theme = Theme::load(ThemeName::light, 1.0);
        const QImage missing = theme->icon(QStringLiteral("no-such-icon")).pixmap(22, 22).toImage();
        for (const char* name : {"configure", "search", "help-contents", "system-lock-screen", "dialog-error", "dialog-warning", "window-close"})
            QVERIFY2(theme->icon(QLatin1String(name)).pixmap(22, 22).toImage() != missing, name);
    }
};

QTEST_MAIN(TestTheme)
#include "test_theme.moc"
