// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/settings/operator_table.h"
#include "operators/settings/setting_ranges.h"

#include <QtTest>
#include <cmath>

using namespace chiron;
using namespace chiron::operators;

namespace {

struct Settings {
    std::string name = "somebody";
    double force_N = 1.0;
};

Settings careful() {
    return {};
}
Settings rough() {
    Settings s = careful();
    s.force_N = 3.0;
    return s;
}

constexpr OperatorTable<Settings, 3> kThree({{"careful", &careful}, {"rough", &rough}, {"other", &careful}});
constexpr OperatorTable<Settings, 1> kOne({{"careful", &careful}});

} // namespace

class TestOperatorTable : public QObject {
    Q_OBJECT
private slots:
    void anOperatorHasTheNameOfItsLine();
    void anUnknownNameIsToldWithThoseThatExist();
    void aSettingOutOfItsRangeIsNamed();
};

void TestOperatorTable::anOperatorHasTheNameOfItsLine() {
    QCOMPARE(kThree.names().size(), std::size_t{3});
    QCOMPARE(kThree.names()[1], std::string_view("rough"));
    QCOMPARE(kThree.settings("rough")->force_N, 3.0);
    for (const std::string_view name : kThree.names())
        QVERIFY(kThree.settings(name)->name == name);
}

void TestOperatorTable::anUnknownNameIsToldWithThoseThatExist() {
    const auto unknown = kThree.settings("wizard");
    QVERIFY(!unknown && unknown.error().code == core::ErrorCode::notFound);
    QCOMPARE(unknown.error().message,
             std::string("operator 'wizard' is unknown; expected careful, rough or other"));
    QCOMPARE(kOne.settings("").error().message, std::string("operator '' is unknown; expected careful"));
}

void TestOperatorTable::aSettingOutOfItsRangeIsNamed() {
    QVERIFY(checkRanges({{"force_N", 1.0, 1.0, 2.0}, {"speed", 2.0, 1.0, 2.0}}));
    const auto wrong = checkRanges({{"force_N", 1.5, 1.0, 2.0}, {"speed", 2.5, 1.0, 2.0}});
    QVERIFY(!wrong && wrong.error().code == core::ErrorCode::badInput);
    QVERIFY(wrong.error().message.starts_with("operator: speed is 2.5"));
    QVERIFY(!checkRanges({{"force_N", std::nan(""), 1.0, 2.0}}));
}

QTEST_APPLESS_MAIN(TestOperatorTable)
#include "test_operator_table.moc"
