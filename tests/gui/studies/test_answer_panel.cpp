// SPDX-License-Identifier: GPL-3.0-or-later
// How a participant answers: every task by its keys, rankings with ties and without, nothing while closed;
// and where the focus goes when a control closes.
#include "desktop/study_run/answer_panel.h"
#include "desktop/study_run/participant_page.h"

#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>
#include <QtTest>
#include <algorithm>
#include <cmath>

using namespace chiron;
using psychophysics::Task;

class TestAnswerPanel : public QObject {
    Q_OBJECT
private slots:
    void rankingsBecomeAnswers();
    void tiesBecomeAnswers();
    void everyTaskIsAnswered();
    void nothingIsTakenWhileClosed();
    void everyAnswerIsReadable();
    void objectsGoByTheirNumbers();
    void theFocusStaysWithTheTask();

private:
    desktop::Theme m_theme = *desktop::Theme::load(desktop::ThemeName::light, 1.0);
};

namespace {

struct Given {
    int answer = -1;
    std::optional<double> value;
    int count = 0;
};

void listen(desktop::AnswerPanel& panel, Given& given) {
    QObject::connect(&panel, &desktop::AnswerPanel::answered, &panel,
                     [&given](int answer, std::optional<double> value) {
                         given.answer = answer;
                         given.value = value;
                         ++given.count;
                     });
}

} // namespace

void TestAnswerPanel::rankingsBecomeAnswers() {
    const auto& all = psychophysics::arrangements(Task::rank3);
    for (std::size_t i = 0; i < all.size(); ++i) { // the person says exactly what lies there
        desktop::AnswerPanel panel(m_theme, Task::rank3, psychophysics::Attribute::stiffness);
        Given given;
        listen(panel, given);
        panel.setOpen(true);
        for (int rank = 0; rank < 2; ++rank)
            for (int place = 0; place < 3; ++place)
                if (all[i][static_cast<std::size_t>(place)] == rank)
                    QVERIFY(panel.key(Qt::Key_1 + place));
        QCOMPARE(given.count, 0); // said, not confirmed
        panel.enterKey();
        QCOMPARE(given.answer, static_cast<int>(i));
        QCOMPARE(psychophysics::outcomeOf(Task::rank3, static_cast<int>(i), given.answer), 0);
    }
}

/// Every ranking of three, with ties: places from least to most, "=" before one that equals the last.
void TestAnswerPanel::tiesBecomeAnswers() {
    for (int answer = 0; answer < psychophysics::kRankings; ++answer) {
        const psychophysics::Ranking& said = psychophysics::rankings()[static_cast<std::size_t>(answer)];
        desktop::AnswerPanel panel(m_theme, Task::rank3Ties, psychophysics::Attribute::stiffness);
        Given given;
        listen(panel, given);
        panel.setOpen(true);
        QVERIFY(panel.key(Qt::Key_Equal)); // equal to nothing: no meaning, and none taken
        for (int rank = 0; rank < 3; ++rank)
            for (int place = 0, first = 1; place < 3; ++place) {
                if (said[static_cast<std::size_t>(place)] != rank)
                    continue;
                if (first == 0)
                    QVERIFY(panel.key(Qt::Key_Equal));
                panel.enterKey();
                QCOMPARE(given.count, 0); // not all three yet
                QVERIFY(panel.key(Qt::Key_1 + place));
                first = 0;
            }
        QCOMPARE(panel.marks().filter(QStringLiteral("=")).size(),
                 std::count_if(said.begin(), said.end(),
                               [&](int own) { return std::count(said.begin(), said.end(), own) > 1; }));
        panel.enterKey();
        QCOMPARE(given.answer, answer);
    }
    desktop::AnswerPanel panel(m_theme, Task::rank3Ties, psychophysics::Attribute::stiffness);
    panel.setOpen(true);
    for (const int key : {Qt::Key_1, Qt::Key_Equal, Qt::Key_Backspace, Qt::Key_2, Qt::Key_Backspace,
                          Qt::Key_3}) // back takes "=" and places one by one
        QVERIFY(panel.key(key));
    QCOMPARE(panel.marks(), (QStringList{"1", "", "2"}));
}

void TestAnswerPanel::everyTaskIsAnswered() {
    for (int t = 0; t < psychophysics::kTasks; ++t) {
        const Task task = static_cast<Task>(t);
        desktop::AnswerPanel panel(m_theme, task, psychophysics::Attribute::mass);
        Given given;
        listen(panel, given);
        panel.setOpen(true);
        if (task == Task::yesNo) {
            QVERIFY(panel.key(Qt::Key_Y));
            QCOMPARE(given.answer, 1);
        } else if (task == Task::magnitude) {
            panel.enterKey(); // nothing said yet
            QCOMPARE(given.count, 0);
            auto* number = panel.findChild<QLineEdit*>(QStringLiteral("answer.number"));
            QVERIFY(number);
            QTest::keyClicks(number, QStringLiteral("0.1234567"));
            QCOMPARE(number->text(), QStringLiteral("0.123456")); // no more than six decimals
            number->setText(QStringLiteral("12"));
            panel.enterKey();
            QCOMPARE(given.value.value_or(0.0), 12.0);
        } else if (task == Task::adjustment) {
            int steps = 0;
            connect(&panel, &desktop::AnswerPanel::adjusted, &panel, [&steps](int by) { steps += by; });
            QVERIFY(panel.key(Qt::Key_Plus) && panel.key(Qt::Key_Plus) && panel.key(Qt::Key_Minus));
            QCOMPARE(steps, 1);
            panel.enterKey();
            QCOMPARE(given.answer, 0);
        } else if (!psychophysics::ranksThree(task)) {
            QVERIFY(panel.key(Qt::Key_2));
            QCOMPARE(given.answer, 1);
            QCOMPARE(panel.key(Qt::Key_3), psychophysics::answers(task) > 2);
        }
        QVERIFY(!panel.question().isEmpty());
    }
}

void TestAnswerPanel::nothingIsTakenWhileClosed() {
    desktop::AnswerPanel panel(m_theme, Task::twoAfc, psychophysics::Attribute::stiffness);
    Given given;
    listen(panel, given);
    panel.setOpen(false, QStringLiteral("Touch every object first."));
    QVERIFY(!panel.key(Qt::Key_1));
    QCOMPARE(given.count, 0);
}

/// At every scale, also beside the experimenter's panel: what does not fit into a line goes into the next.
void TestAnswerPanel::everyAnswerIsReadable() {
    for (const double scale : {1.0, 2.0})
        for (const int width : {1240, 640}) {
            const desktop::Theme theme = *desktop::Theme::load(desktop::ThemeName::light, scale);
            QWidget stage;
            auto* column = new QVBoxLayout(&stage);
            column->setContentsMargins(0, 0, 0, 0);
            column->addStretch();
            auto* panel = new desktop::AnswerPanel(theme, Task::rank3Ties, psychophysics::Attribute::mass);
            column->addWidget(panel);
            stage.resize(width, 700);
            stage.show();
            QTest::qWait(50);
            QCOMPARE(stage.width(), width);
            int left = width;
            int right = 0;
            for (const QPushButton* button : panel->findChildren<QPushButton*>()) {
                QVERIFY2(button->width() >= button->sizeHint().width(), qPrintable(button->text()));
                const QRect at(button->mapTo(&stage, QPoint()), button->size());
                QVERIFY2(stage.rect().contains(at), qPrintable(button->text()));
                left = std::min(left, at.left());
                right = std::max(right, at.right());
            }
            if (scale == 1.0 && width == 1240) // one line, in the middle
                QVERIFY2(std::abs(left + right - width) < 12,
                         qPrintable(QStringLiteral("%1 to %2").arg(left).arg(right)));
        }
}

/// One name for an object: its number is on the button, at the object and on the key.
void TestAnswerPanel::objectsGoByTheirNumbers() {
    QCOMPARE(desktop::AnswerPanel::placeNames(2), (QStringList{"1", "2"}));
    QCOMPARE(desktop::AnswerPanel::placeNames(3), (QStringList{"1", "2", "3"}));
    for (const Task task : {Task::twoAfc, Task::threeAfc, Task::oddity, Task::rank3, Task::rank3Ties}) {
        desktop::AnswerPanel panel(m_theme, task, psychophysics::Attribute::stiffness);
        const int places = psychophysics::placesOf(task);
        for (int place = 0; place < places; ++place) {
            const auto* button = panel.findChild<QPushButton*>(QStringLiteral("answer.%1").arg(place));
            QVERIFY(button);
            QCOMPARE(button->text(), QString::number(place + 1));
            QVERIFY2(button->accessibleName().startsWith(QString::number(place + 1)),
                     qPrintable(button->accessibleName()));
        }
        QVERIFY(panel.findChild<QPushButton*>(QStringLiteral("answer.0"))
                    ->accessibleName()
                    .contains(QStringLiteral("left")));
        QVERIFY(panel.findChild<QPushButton*>(QStringLiteral("answer.%1").arg(places - 1))
                    ->accessibleName()
                    .contains(QStringLiteral("right")));
    }
}

/// A control that is disabled or hidden gives the focus to the page and not to the next button, which may be
/// anybody's; Tab moves it as ever.
void TestAnswerPanel::theFocusStaysWithTheTask() {
    QWidget window;
    auto* column = new QVBoxLayout(&window);
    auto* page = new desktop::ParticipantPage;
    column->addWidget(page);
    auto* inner = new QVBoxLayout(page);
    auto* another = new QPushButton(QStringLiteral("another"));
    auto* number = new desktop::AnswerPanel(m_theme, Task::magnitude, psychophysics::Attribute::stiffness);
    auto* order = new desktop::AnswerPanel(m_theme, Task::rank3, psychophysics::Attribute::stiffness);
    for (QWidget* part : std::initializer_list<QWidget*>{another, number, order})
        inner->addWidget(part);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    auto* field = number->findChild<QLineEdit*>(QStringLiteral("answer.number"));
    number->setOpen(true);
    QVERIFY(field->hasFocus());
    number->setOpen(false);
    QVERIFY(page->hasFocus());
    order->setOpen(true);
    auto* first = order->findChild<QPushButton*>(QStringLiteral("answer.0"));
    first->setFocus();
    first->click(); // it has its rank, and cannot be pressed again
    QVERIFY(!first->isEnabled() && page->hasFocus());
    another->setFocus();
    another->hide();
    QVERIFY(page->hasFocus());
    another->show();
    another->setFocus();
    number->setOpen(true);
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Tab);
    QVERIFY(number->findChild<QPushButton*>(QStringLiteral("answer.confirm"))->hasFocus());
}

QTEST_MAIN(TestAnswerPanel)
#include "test_answer_panel.moc"
