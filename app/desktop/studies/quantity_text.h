// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLocale>
#include <QString>

namespace chiron::desktop {

/// The result of reading a number field.
struct ReadQuantity {
    enum class Fault {
        none,
        empty,
        noNumber, ///< "abc", "1,5,2"
        otherUnit ///< unknown unit, or one of another dimension: "0.3 kg" for a stiffness
    };
    Fault fault = Fault::none;
    double value = 0.0; ///< in the field's unit
};

/// Reads a number, with or without a unit of the same dimension: "0.3 N/mm" for N/m is 300. Without a unit it
/// is in `unit` (empty: a plain number). Numbers may be written as in the locale, and with points or commas
/// if that is not ambiguous. Pure.
ReadQuantity readQuantity(const QString& text, const QString& unit, const QLocale& locale);

} // namespace chiron::desktop
