// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "desktop/training/training_screen.h"
#include "support/content_copy.h"
#include "support/desktop_fixture.h"
#include "support/patience.h"

#include <QApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QWheelEvent>

namespace chiron::tests {

/// Presses a button of the question that comes up next.
inline void pressInQuestion(const char* button) {
    QTimer::singleShot(100, qApp, [button] {
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* found = top->findChild<QPushButton*>(QLatin1String(button)); found && top->isVisible())
                return found->click();
        qFatal("no question came up");
    });
}

/// The program's window on a site whose first level is over in seconds, with somebody logged in.
struct TrainingBench {
    explicit TrainingBench(int trials = 3, double limit_s = 30.0) {
        shorten(trials, limit_s);
        auto catalogue = catalogue::Catalogue::load(content.directory());
        if (!catalogue)
            qFatal("%s", catalogue.error().message.c_str());
        desktop.site.setCatalogue(std::move(*catalogue));
        desktop.logIn("tina");
    }

    void train(const QVariantMap& more = {}) {
        show(more);
        pressGo(desktop);
    }
    /// The same up to the ready card.
    void show(const QVariantMap& more = {}) {
        QVariantMap plan{{QStringLiteral("exercise"), QStringLiteral("sphere_apex")},
                         {QStringLiteral("level"), 1}};
        plan.insert(more);
        desktop.go(QStringLiteral("training"), plan);
    }
    desktop::TrainingScreen* screen() { return desktop.screen<desktop::TrainingScreen>(); }
    /// The newest state; an empty one before the session begins.
    haptics::DisplayState state() {
        return screen() && screen()->feed() ? screen()->feed()->state() : haptics::DisplayState{};
    }
    bool runs() { return state().phase == core::TrialPhase::running; }
    bool at(const QString& place) { return desktop.context.navigator().current().screen == place; }
    void key(Qt::Key key) { QTest::keyClick(screen(), key); }
    /// Until a mark counts: one right after the trial has begun is a second press of what came before.
    bool mayMark() {
        return QTest::qWaitFor([this] { return runs() && !screen()->marksAreEarly(); }, kPatience_ms);
    }
    QString text(const char* name) {
        auto* label = desktop.find<QLabel>(QLatin1String(name));
        return label ? label->text() : QString();
    }
    /// Moves the pointer to this place, seen from the scene's middle, in small steps, as a hand does.
    void sweepTo(QPoint to) {
        const QPoint middle = screen()->scene()->widget()->rect().center();
        for (int i = 1; i <= 8; ++i)
            mouse(QEvent::MouseMove, middle + m_pointer + (to - m_pointer) * i / 8, Qt::NoButton);
        m_pointer = to;
    }
    void wheel(int eighths) {
        QWidget* widget = screen()->scene()->widget();
        const QPointF at = widget->rect().center();
        QWheelEvent event(at, widget->mapToGlobal(at), {}, QPoint(0, eighths), Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(screen()->scene()->inputSource(), &event);
    }
    void click() {
        const QPoint at = screen()->scene()->widget()->rect().center();
        mouse(QEvent::MouseButtonPress, at, Qt::LeftButton);
        mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton);
    }

    ContentCopy content;
    DesktopFixture desktop;

private:
    /// To where the events of the scene arrive: a window of its own in 3D, which no widget helper reaches.
    void mouse(QEvent::Type type, QPoint at, Qt::MouseButton button) {
        const Qt::MouseButtons held =
            type == QEvent::MouseButtonPress ? Qt::MouseButtons(button) : Qt::NoButton;
        QMouseEvent event(type, at, screen()->scene()->widget()->mapToGlobal(at), button, held,
                          Qt::NoModifier);
        QApplication::sendEvent(screen()->scene()->inputSource(), &event);
    }
    void shorten(int trials, double limit_s) {
        const QString file = QStringLiteral("exercises/sphere_apex/levels/visible.json");
        QJsonObject level = QJsonDocument::fromJson(content.read(file)).object();
        QJsonObject parameters = level[QStringLiteral("parameters")].toObject();
        parameters[QStringLiteral("trials")] = trials;
        parameters[QStringLiteral("trial_limit_s")] = limit_s;
        parameters[QStringLiteral("between_trials_s")] = 0.2;
        level[QStringLiteral("parameters")] = parameters;
        content.write(file, QJsonDocument(level).toJson());
    }

    QPoint m_pointer; ///< from the scene's middle
};

} // namespace chiron::tests
