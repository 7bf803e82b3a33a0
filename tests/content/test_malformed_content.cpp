// SPDX-License-Identifier: GPL-3.0-or-later
#include "content_mutator.h"

#include "catalogue/catalogue.h"
#include "support/content_copy.h"

#include <QMap>
#include <QtTest>

using namespace chiron;

/// Hundreds of spoiled content files: each is refused with file, place and reason, and none crashes.
class TestMalformedContent : public QObject {
    Q_OBJECT
private slots:
    void everyMutationIsRefused();
};

namespace {

bool namesPlace(const QByteArray& message, const QByteArray& file) {
    if (!message.startsWith(file + ':'))
        return false;
    const QList<QByteArray> parts = message.mid(file.size() + 1).left(40).split(':');
    bool line = false;
    bool column = false;
    return parts.size() > 2 && parts[0].toInt(&line) >= 1 && parts[1].toInt(&column) >= 1 && line && column &&
           parts[2].startsWith(" $");
}

} // namespace

void TestMalformedContent::everyMutationIsRefused() {
    constexpr int kRounds = 25;
    const QStringList files{"exercises/sphere_apex/exercise.json",
                            "exercises/sphere_apex/levels/visible.json",
                            "exercises/sphere_apex/levels/haptics_alone.json",
                            "exercises/sphere_apex/levels/varied_material.json",
                            "exercises/sphere_apex/levels/decoy_dimple.json",
                            "exercises/sphere_apex/levels/mesh_dome.json",
                            "exercises/sphere_apex/levels/soft_organ.json",
                            "exercises/urethra_insertion/levels/stricture.json",
                            "exercises/urethra_insertion/levels/unguided.json",
                            "exercises/urethra_insertion/presets/stricture.json",
                            "exercises/elastic_tube/levels/stiffening_tube.json",
                            "exercises/palpation/levels/visible_lump.json",
                            "tissues/pad.json",
                            "objects/ovary.json",
                            "meshes/organ.json"};
    ContentCopy copy;
    QVERIFY(catalogue::Catalogue::load(copy.directory()).has_value());
    core::Random random(20261120);
    QMap<QString, int> tried;
    for (int round = 0; round < kRounds; ++round)
        for (int kind = 0; kind < ContentMutator::kKinds; ++kind) {
            const QString file =
                files[static_cast<qsizetype>(random.below(static_cast<std::uint64_t>(files.size())))];
            const QByteArray valid = copy.read(file);
            const Mutation mutation = ContentMutator(valid, random).mutate(kind);
            copy.write(file, mutation.text);
            const auto catalogue = catalogue::Catalogue::load(copy.directory());
            const QByteArray about =
                mutation.kind.toUtf8() + " in " + file.toUtf8() + " at " + mutation.path.toUtf8();
            QVERIFY2(!catalogue.has_value(), (about + "\n" + mutation.text.left(3000)).constData());
            const QByteArray message = QByteArray::fromStdString(catalogue.error().message);
            QVERIFY2(namesPlace(message, copy.path(file).toUtf8()),
                     (about + ": " + message.left(500)).constData());
            QVERIFY2(message.contains(": expected "), message.left(500).constData());
            QVERIFY2(message.size() < 20000, about.constData());
            QVERIFY2(mutation.path.isEmpty() || message.contains(' ' + mutation.path.toUtf8() + ": "),
                     (about + ": " + message.left(1000)).constData());
            QVERIFY2(!mutation.syntax || message.contains(": $: "),
                     (about + ": " + message.left(500)).constData());
            ++tried[mutation.kind];
            copy.write(file, valid);
        }
    int total = 0;
    for (const int n : tried)
        total += n;
    QVERIFY(total >= 300);
    QVERIFY(catalogue::Catalogue::load(copy.directory()).has_value()); // all was put back
}

QTEST_APPLESS_MAIN(TestMalformedContent)
#include "test_malformed_content.moc"
