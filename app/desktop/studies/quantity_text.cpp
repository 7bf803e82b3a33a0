// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/studies/quantity_text.h"

#include "desktop/studies/number_list.h"

#include <QRegularExpression>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>

namespace chiron::desktop {

namespace {

enum class Dimension { ratio, length, time, mass, force, stiffness, speed, viscosity, angle };

/// A unit as people write it, without spaces: µ as U+00B5, products with ·.
struct KnownUnit {
    const char16_t* text;
    Dimension dimension;
    double si;
};
constexpr KnownUnit kUnits[] = {{u"", Dimension::ratio, 1.0},
                                {u"%", Dimension::ratio, 1e-2},
                                {u"‰", Dimension::ratio, 1e-3},
                                {u"km", Dimension::length, 1e3},
                                {u"m", Dimension::length, 1.0},
                                {u"cm", Dimension::length, 1e-2},
                                {u"mm", Dimension::length, 1e-3},
                                {u"µm", Dimension::length, 1e-6},
                                {u"um", Dimension::length, 1e-6},
                                {u"nm", Dimension::length, 1e-9},
                                {u"h", Dimension::time, 3600.0},
                                {u"min", Dimension::time, 60.0},
                                {u"s", Dimension::time, 1.0},
                                {u"ms", Dimension::time, 1e-3},
                                {u"µs", Dimension::time, 1e-6},
                                {u"us", Dimension::time, 1e-6},
                                {u"kg", Dimension::mass, 1.0},
                                {u"g", Dimension::mass, 1e-3},
                                {u"mg", Dimension::mass, 1e-6},
                                {u"kN", Dimension::force, 1e3},
                                {u"N", Dimension::force, 1.0},
                                {u"mN", Dimension::force, 1e-3},
                                {u"kN/m", Dimension::stiffness, 1e3},
                                {u"N/mm", Dimension::stiffness, 1e3},
                                {u"N/cm", Dimension::stiffness, 1e2},
                                {u"N/m", Dimension::stiffness, 1.0},
                                {u"mN/mm", Dimension::stiffness, 1.0},
                                {u"mN/m", Dimension::stiffness, 1e-3},
                                {u"km/h", Dimension::speed, 1.0 / 3.6},
                                {u"m/s", Dimension::speed, 1.0},
                                {u"cm/s", Dimension::speed, 1e-2},
                                {u"mm/s", Dimension::speed, 1e-3},
                                {u"N·s/mm", Dimension::viscosity, 1e3},
                                {u"N·s/m", Dimension::viscosity, 1.0},
                                {u"mN·s/mm", Dimension::viscosity, 1.0},
                                {u"mN·s/m", Dimension::viscosity, 1e-3},
                                {u"rad", Dimension::angle, 1.0},
                                {u"°", Dimension::angle, std::numbers::pi / 180.0}};

const KnownUnit* unitCalled(QString text) {
    static const QRegularExpression kSpaces(QStringLiteral("[\\s\\x{00A0}\\x{202F}]+"));
    text.remove(kSpaces);
    text.replace(QChar(0x03BC), QChar(0x00B5)); // the Greek letter, which looks the same
    text.replace(QChar(0x22C5), QChar(0x00B7)); // likewise the dot operator
    text.replace(QLatin1Char('*'), QChar(0x00B7));
    text.replace(QStringLiteral("Ns/"), QStringLiteral("N\u00B7s/"));
    for (const KnownUnit& unit : kUnits)
        if (text == QStringView(unit.text))
            return &unit;
    return nullptr;
}

std::optional<double> numberTyped(const QString& digits, const QLocale& locale) {
    bool good = false;
    if (const double value = locale.toDouble(digits, &good); good && std::isfinite(value))
        return value;
    const NumberList read = readNumbers(digits, locale); // tries the other decimal separator
    return read.unread.isEmpty() && read.values.size() == 1 ? std::optional(read.values.front())
                                                            : std::nullopt;
}

} // namespace

ReadQuantity readQuantity(const QString& text, const QString& unit, const QLocale& locale) {
    using Fault = ReadQuantity::Fault;
    const QString typed = text.trimmed();
    if (typed.isEmpty())
        return {Fault::empty, 0.0};
    static const QRegularExpression kQuantity(QStringLiteral(
        "^([-+\\x{2212}]?[0-9.,'\\x{00A0}\\x{202F}]*[0-9][.,]?(?:[eE][-+]?[0-9]+)?)\\s*(\\D.*)?$"));
    const QRegularExpressionMatch match = kQuantity.match(typed);
    const std::optional<double> value =
        match.hasMatch() ? numberTyped(match.captured(1), locale) : std::nullopt;
    if (!value)
        return {Fault::noNumber, 0.0};
    const QString said = match.captured(2).trimmed();
    if (said.isEmpty() || said == unit)
        return {Fault::none, *value};
    const KnownUnit* from = unitCalled(said);
    const KnownUnit* to = unitCalled(unit);
    if (!from || !to || from->dimension != to->dimension)
        return {Fault::otherUnit, 0.0};
    return {Fault::none, *value * from->si / to->si};
}

} // namespace chiron::desktop
