// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/theme/theme.h"

#include "support/image_region.h"
#include "support/kept_text.h"
#include "support/patience.h"

#include <QCheckBox>
#include <QComboBox>
#include <QFile>
#include <QLineEdit>
#include <QMetaEnum>
#include <QPainter>
#include <QPushButton>
#include <QSpinBox>
#include <QStyle>
#include <QStyleOptionSpinBox>
#include <QTabBar>
#include <QVBoxLayout>
#include <QtTest>
#include <cmath>
#include <tuple>
#include <vector>

using chiron::tests::kPatience_ms;

using namespace chiron;
using namespace chiron::desktop;

namespace {

/// Relative luminance and contrast ratio of WCAG 2.1 (success criterion 1.4.3).
double luminance(const QColor& colour) {
    const auto linear = [](double c) {
        return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
           0.0722 * linear(colour.blueF());
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
        std::vector<Pair> pairs{{accentText, accent, most},         {accentText, accentHover, most},
                                {dangerText, danger, most},         {sidebarText, sidebar, most},
                                {sidebarText, sidebarActive, most}, {warning, warningSoft, most}};
        for (const Colour paper : {window, surface, raised})
            for (const Colour ink : {text, muted, accent, good, warning, bad})
                pairs.push_back({ink, paper, most});
        for (const Colour paper : {accentSoft, goodSoft, warningSoft, badSoft})
            pairs.push_back({text, paper, most});
        for (const Colour line :
             {borderStrong, focus, seriesA, seriesB, seriesC}) // WCAG 1.4.11: what is no text needs 3:1
            pairs.push_back({line, surface, 3.0});
        if (theme !=
            static_cast<int>(ThemeName::highContrast)) // a button that stops force is red, and never pale
            QVERIFY(loaded->color(danger).hslSaturationF() > 0.5f &&
                    loaded->color(danger).lightnessF() < 0.55f);
        pairs.push_back({danger, surface, 3.0});
        for (const Pair& pair : pairs)
            QVERIFY2(contrast(loaded->color(pair.ink), loaded->color(pair.paper)) >= pair.least,
                     qPrintable(QStringLiteral("%1 on %2: %3")
                                    .arg(loaded->color(pair.ink).name(), loaded->color(pair.paper).name())
                                    .arg(contrast(loaded->color(pair.ink), loaded->color(pair.paper)))));
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
        QVERIFY(!sheet.contains(QRegularExpression(QStringLiteral("#[0-9]{1,3}-?#"))));
        QVERIFY(sheet.contains(Theme::load(ThemeName::dark, 1.5)->color(Colour::accentSoft).name()));
    }

    /// A layout is not made anew for the focus: what has it, is pressed in or is wrong has the size that it
    /// had.
    /// The buttons that scroll tabs which have no room are as wide as other small controls, at every scale.
    void buttonsThatScrollTabsCanBeHit() {
        for (const double scale : {1.0, 2.0}) {
            const Theme theme = Theme::load(ThemeName::light, scale).value();
            QTabBar bar;
            bar.setStyleSheet(theme.styleSheet());
            bar.ensurePolished();
            QCOMPARE(bar.style()->pixelMetric(QStyle::PM_TabBarScrollButtonWidth, nullptr, &bar),
                     theme.px(28));
        }
    }

    void focusChangesNoSize_data() {
        QTest::addColumn<double>("scale");
        for (const double scale : {1.0, 1.25, 1.5, 1.75, 2.0})
            QTest::addRow("%.0f %%", 100.0 * scale) << scale;
    }

    void focusChangesNoSize() {
        QFETCH(double, scale);
        const auto theme = Theme::load(ThemeName::light, scale);
        QVERIFY(theme);
        QWidget window;
        window.setStyleSheet(theme->styleSheet());
        auto* column = new QVBoxLayout(&window);
        std::vector<QWidget*> parts{new QLineEdit, new QSpinBox, new QDoubleSpinBox, new QComboBox};
        for (const char* kind : {"", "primary", "danger", "quiet"}) {
            auto* button = new QPushButton(QStringLiteral("A button"));
            button->setProperty("kind", QLatin1String(kind));
            button->setAutoDefault(false);
            parts.push_back(button);
        }
        for (QWidget* part : parts) {
            part->setFont(theme->font(TextStyle::title)); // taller than the least height
            column->addWidget(part);
        }
        auto* elsewhere = new QCheckBox(QStringLiteral("Elsewhere"));
        column->addWidget(elsewhere);
        window.show();
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        elsewhere->setFocus();
        QTRY_VERIFY_WITH_TIMEOUT(elsewhere->hasFocus(), kPatience_ms);
        const QSize plain = parts[4]->sizeHint();
        for (QWidget* part : parts) {
            const QByteArray what =
                part->metaObject()->className() + QByteArray(" ") + part->property("kind").toByteArray();
            const QSize before = part->sizeHint();
            part->setFocus();
            QTRY_VERIFY_WITH_TIMEOUT(part->hasFocus(), kPatience_ms);
            QVERIFY2(part->sizeHint() == before, what);
            if (auto* button = qobject_cast<QPushButton*>(part)) {
                QCOMPARE(before.height(), plain.height()); // whatever its kind
                button->setCheckable(true);
                button->setChecked(true);
                QVERIFY2(part->sizeHint() == before, what);
            }
            elsewhere->setFocus();
            QTRY_VERIFY_WITH_TIMEOUT(elsewhere->hasFocus(), kPatience_ms);
        }
        auto* field = static_cast<QLineEdit*>(parts[0]);
        const QSize good = field->sizeHint();
        field->setProperty("kind", QStringLiteral("bad"));
        field->style()->unpolish(field);
        field->style()->polish(field);
        QCOMPARE(field->sizeHint(), good);
    }

    void badTokensAreNamed() {
        QByteArray without = tokens();
        without.replace("\"accentSoft\": \"#173a4c\"", "\"accentSoft\": \"blueish\"");
        const auto broken = Theme::fromJson(without, ThemeName::dark, 1.0);
        QVERIFY(!broken);
        QVERIFY2(
            QString::fromStdString(broken.error().message).contains(QStringLiteral("themes.dark.accentSoft")),
            broken.error().message.c_str());
        QVERIFY(!Theme::fromJson("not json", ThemeName::light, 1.0));
    }

    /// Colours, letters and the sheet of every theme, against what was read and kept: a disabled word that is
    /// no longer grey, a margin that does not grow with the scale. A change that is meant is kept anew with
    /// CHIRON_STORE_OUTLINES=1.
    void looksAsItDid() {
        static const QMetaEnum roles = QMetaEnum::fromType<QPalette::ColorRole>();
        tests::KeptText kept(QStringLiteral(CHIRON_SOURCE_DIR "/tests/gui/frame/kept_theme.txt"));
        for (const auto& [name, look, scale] :
             {std::tuple{"light", ThemeName::light, 1.0},
              {"dark, half as large again", ThemeName::dark, 1.5},
              {"high contrast, twice as large", ThemeName::highContrast, 2.0},
              {"light, smaller than the smallest", ThemeName::light, 0.5}}) {
            const Theme theme = Theme::load(look, scale).value();
            QStringList lines{QStringLiteral("scale %1, 7 px are %2, name %3")
                                  .arg(theme.scale())
                                  .arg(theme.px(7))
                                  .arg(static_cast<int>(theme.name()))};
            const QPalette palette = theme.palette();
            for (int i = 0; i < roles.keyCount() && roles.value(i) < QPalette::NColorRoles; ++i)
                if (const auto role = static_cast<QPalette::ColorRole>(roles.value(i));
                    palette.isBrushSet(QPalette::Active, role))
                    lines << QStringLiteral("%1 %2 disabled %3")
                                 .arg(QLatin1String(roles.key(i)),
                                      palette.color(QPalette::Active, role).name(),
                                      palette.color(QPalette::Disabled, role).name());
#define CHIRON_STYLE(style)                                                                                  \
    lines << QStringLiteral(#style " %1 px, weight %2, %3")                                                  \
                 .arg(theme.font(TextStyle::style).pixelSize())                                              \
                 .arg(theme.font(TextStyle::style).weight())                                                 \
                 .arg(theme.font(TextStyle::style).families().join(QLatin1Char('/')));
            CHIRON_TEXT_STYLES(CHIRON_STYLE)
#undef CHIRON_STYLE
            lines << theme.styleSheet().split(QLatin1Char('\n'), Qt::SkipEmptyParts);
            const QString differs = kept.differs(QLatin1String(name), lines);
            QVERIFY2(differs.isEmpty(), qPrintable(differs));
        }
        QCOMPARE(kept.unseen(), QStringList());
    }

    /// An icon is all of its one ink, in the size that is asked for; greyed where it is disabled; what is not
    /// there is a dot in the middle.
    void iconsAreOfOneInk() {
        const Theme theme = Theme::load(ThemeName::light, 1.0).value();
        for (const char* name : {"dialog-error", "no-such-icon"})
            for (const auto& [mode, ink] :
                 {std::pair{QIcon::Normal, Colour::bad}, {QIcon::Disabled, Colour::muted}}) {
                const QImage picture = theme.icon(QLatin1String(name), Colour::bad)
                                           .pixmap(QSize(36, 36), 1.0, mode)
                                           .toImage()
                                           .convertToFormat(QImage::Format_ARGB32);
                QCOMPARE(picture.size(), QSize(36, 36));
                const QRegion solid = tests::regionOfAlpha(picture, 255);
                QVERIFY2(tests::areaOf(solid) > 40, name);
                QVERIFY(solid.subtracted(tests::regionOf(picture, theme.color(ink))).isEmpty());
            }
        const QImage dot = theme.icon(QStringLiteral("no-such-icon")).pixmap(QSize(40, 20), 1.0).toImage();
        for (const auto& [x, y, there] : {std::tuple{20, 10, true},
                                          {14, 10, true},
                                          {25, 10, true},
                                          {20, 7, true},
                                          {20, 12, true},
                                          {10, 10, false},
                                          {29, 10, false},
                                          {20, 4, false},
                                          {20, 15, false}})
            QVERIFY2(tests::regionOfAlpha(dot, there ? 255 : 0).contains(QPoint(x, y)),
                     qPrintable(QStringLiteral("%1,%2").arg(x).arg(y)));
        QImage sheet(60, 60, QImage::Format_ARGB32);
        sheet.fill(Qt::transparent);
        QPainter painter(&sheet);
        theme.icon(QStringLiteral("no-such-icon"), Colour::bad).paint(&painter, QRect(20, 20, 20, 20));
        painter.end();
        const QRegion painted = tests::regionOf(sheet, theme.color(Colour::bad));
        QVERIFY(painted.contains(QPoint(30, 30)) && QRect(26, 26, 8, 8).contains(painted.boundingRect()));
        const QRegion left = tests::regionOfAlpha(sheet, 0);
        QVERIFY(left.contains(QPoint(22, 22)) && left.contains(QPoint(10, 10)));
    }

    /// What is wrong in the tokens is said with its place; what is just right is taken.
    void everyTokenIsAskedFor() {
        for (const auto& [was, is, place] : {std::tuple{"\"body\": 14", "\"body\": 7", "text_px.body"},
                                             {"\"body\": 14", "\"body\": 8", ""},
                                             {"\"display\": 700", "\"display\": 99", "text_weight.display"},
                                             {"\"display\": 700", "\"display\": 100", ""},
                                             {"\"control_px\": 36", "\"control_px\": 23.5", "control_px"},
                                             {"\"control_px\": 36", "\"control_px\": 24", ""},
                                             {"\"mono_families\"", "\"others\"", "families"},
                                             {"\"families\"", "\"others\"", "families"}}) {
            QByteArray text = tokens();
            QVERIFY2(text.contains(was), was);
            const auto theme = Theme::fromJson(text.replace(was, is), ThemeName::light, 1.0);
            QCOMPARE(theme.has_value(), *place == '\0');
            if (!theme)
                QVERIFY2(QString::fromStdString(theme.error().message).contains(QLatin1String(place)),
                         theme.error().message.c_str());
        }
    }

    /// The arrows of number fields and lists: drawings of the theme's ink, each in a half of its own at the
    /// right, which grows with the scale.
    void arrowsAreDrawings_data() {
        QTest::addColumn<int>("theme");
        QTest::addColumn<double>("scale");
        for (int theme = 0; theme < 3; ++theme)
            for (const double scale : {1.0, 2.0})
                QTest::addRow("theme %d, %.0f %%", theme, scale * 100) << theme << scale;
    }

    void arrowsAreDrawings() {
        QFETCH(int, theme);
        QFETCH(double, scale);
        const Theme look = Theme::load(static_cast<ThemeName>(theme), scale).value();
        const QString sheet = look.styleSheet();
        QStringList drawn;
        static const QRegularExpression url(QStringLiteral("url\\(([^)]*)\\)"));
        for (auto found = url.globalMatch(sheet); found.hasNext();) {
            const QString file = found.next().captured(1);
            QVERIFY2(QFile::exists(file), qPrintable(file));
            QVERIFY2(!QIcon(file).pixmap(look.px(9), look.px(9)).isNull(), qPrintable(file));
            drawn << file;
        }
        const QString ink =
            look.color(Colour::text).lightness() > 128 ? QStringLiteral("light") : QStringLiteral("dark");
        for (const char* arrow : {"arrow_up", "arrow_down", "chevron"})
            for (const char* state : {"", "_off"})
                QVERIFY2(drawn.contains(QStringLiteral(":/theme/%1_%2%3.svg")
                                            .arg(QLatin1String(arrow), ink, QLatin1String(state))),
                         arrow);
        QSpinBox field;
        field.setStyleSheet(sheet);
        field.resize(look.px(120), field.sizeHint().height());
        field.ensurePolished();
        QStyleOptionSpinBox option;
        option.initFrom(&field);
        option.subControls = QStyle::SC_All;
        option.stepEnabled = QAbstractSpinBox::StepUpEnabled | QAbstractSpinBox::StepDownEnabled;
        option.frame = true;
        const auto part = [&](QStyle::SubControl control) {
            return field.style()->subControlRect(QStyle::CC_SpinBox, &option, control, &field);
        };
        const QRect up = part(QStyle::SC_SpinBoxUp), down = part(QStyle::SC_SpinBoxDown),
                    text = part(QStyle::SC_SpinBoxEditField);
        for (const QRect& button : {up, down}) {
            QVERIFY(field.rect().contains(button) && !button.intersects(text));
            QVERIFY(button.width() >= look.px(12) && button.height() >= look.px(12)); // room for the arrow
        }
        QVERIFY(up.bottom() < down.top() + 2 && !up.adjusted(0, 0, 0, -1).intersects(down));
    }

    void iconsAreThere() {
        const auto theme = Theme::load(ThemeName::light, 1.0);
        const QImage missing = theme->icon(QStringLiteral("no-such-icon")).pixmap(22, 22).toImage();
        for (const char* name : {"configure", "search", "help-contents", "system-lock-screen", "dialog-error",
                                 "dialog-warning", "window-close"})
            QVERIFY2(theme->icon(QLatin1String(name)).pixmap(22, 22).toImage() != missing, name);
    }
};

QTEST_MAIN(TestTheme)
#include "test_theme.moc"
