// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/frame/instance_link.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSocketNotifier>
#include <QStandardPaths>

#include <cerrno>
#include <cstring>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

namespace chiron::desktop {

namespace {

constexpr char kKnock = 'r';

QString socketPath(const QString& databaseFile) {
    const QFileInfo info(databaseFile);
    const QString file = info.exists() ? info.canonicalFilePath() : info.absoluteFilePath();
    const QByteArray name =
        QCryptographicHash::hash(file.toUtf8(), QCryptographicHash::Sha256).toHex().left(24);
    return QDir(QStandardPaths::writableLocation(QStandardPaths::RuntimeLocation))
        .filePath(QStringLiteral("chiron-%1.socket").arg(QString::fromLatin1(name)));
}

/// Returns false if the path is longer than a socket's name may be.
bool addressOf(const QString& path, sockaddr_un& address) {
    const QByteArray bytes = QFile::encodeName(path);
    address = {};
    address.sun_family = AF_UNIX;
    if (bytes.size() >= static_cast<qsizetype>(sizeof address.sun_path))
        return false;
    std::memcpy(address.sun_path, bytes.constData(), static_cast<std::size_t>(bytes.size()));
    return true;
}

} // namespace

InstanceLink::InstanceLink(const QString& databaseFile, QObject* parent)
    : QObject(parent), m_path(socketPath(databaseFile)) {}

InstanceLink::~InstanceLink() {
    if (m_socket < 0)
        return;
    ::close(m_socket);
    QFile::remove(m_path);
}

core::Result<void> InstanceLink::listen() {
    if (m_socket >= 0)
        return {};
    sockaddr_un address;
    const std::string place = m_path.toStdString();
    if (!addressOf(m_path, address))
        return core::fail(core::ErrorCode::storage, place + ": longer than a socket's name may be");
    const int made = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (made < 0)
        return core::fail(core::ErrorCode::storage, place + ": " + std::strerror(errno));
    QFile::remove(m_path); // left by a crashed program: this process holds the lock, so nobody listens there
    if (::bind(made, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
        const std::string why = std::strerror(errno);
        ::close(made);
        return core::fail(core::ErrorCode::storage, place + ": " + why);
    }
    m_socket = made;
    m_notifier = new QSocketNotifier(m_socket, QSocketNotifier::Read, this);
    connect(m_notifier, &QSocketNotifier::activated, this, &InstanceLink::receive);
    return {};
}

void InstanceLink::receive() {
    bool knocked = false;
    char byte = 0;
    while (::recv(m_socket, &byte, 1, 0) == 1)
        knocked = knocked || byte == kKnock;
    if (knocked)
        emit raiseAsked();
}

bool InstanceLink::raiseOther(const QString& databaseFile) {
    sockaddr_un address;
    if (!addressOf(socketPath(databaseFile), address))
        return false;
    const int made = ::socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
    if (made < 0)
        return false;
    const bool sent =
        ::sendto(made, &kKnock, 1, 0, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 1;
    ::close(made);
    return sent;
}

} // namespace chiron::desktop
